// SPDX-License-Identifier: Apache-2.0
#include "renderer/plan/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "renderer/film/film.h"
#include "renderer/integrators/integrator_registry.h"
#include "renderer/materials/material_textures.h"
#include "renderer/spectrum/refractive_index.h"

namespace bouguer::renderer {
namespace {

/// Pairs of lamp and surface that quadrature_error() looks at; of the lamps beyond, their own light
/// only.
constexpr std::size_t kMaxPairs = 20'000;

std::vector<const MaterialDescription*> materials_in_use(const Scene& scene) {
    const std::set<std::uint32_t> used(scene.object_materials().begin(),
                                       scene.object_materials().end());
    std::vector<const MaterialDescription*> materials;
    for (const std::uint32_t m : used) materials.push_back(&scene.materials()[m]);
    return materials;
}

/// Everything that gives out light. The spectra live as long as the scene or the answer.
std::vector<SpectrumPtr> emissions(const Scene& scene) {
    std::vector<SpectrumPtr> all;
    for (const Light& light : scene.lights()) all.push_back(light.spectrum());
    if (scene.environment()) all.push_back(scene.environment()->radiance);
    if (scene.ambient() && scene.ambient()->illuminant) all.push_back(scene.ambient()->illuminant);
    for (const MaterialDescription* m : materials_in_use(scene))
        if (m->emission.spectrum)
            for (SpectrumPtr& part : m->emission.parts()) all.push_back(std::move(part));
    return all;
}

/// Whether all emissions have one colour and every material is grey: then one number stands for the
/// spectrum.
bool is_grey(const Scene& scene) {
    const auto is_constant = [](const SpectrumPtr& s) { return s->is_constant(); };
    for (const MaterialDescription* m : materials_in_use(scene)) {
        const MaterialNeeds needs = needs_of(*m);
        if (needs.ior && !needs.ior->is_constant()) return false;
        for (const SurfaceSpectrum& colour : needs.colours) {
            const auto parts = colour.parts();
            if (!std::all_of(parts.begin(), parts.end(), is_constant)) return false;
        }
    }
    const auto all = emissions(scene);
    return std::all_of(all.begin(), all.end(), [&](const SpectrumPtr& s) {
        return s->as_multiple().base == all.front()->as_multiple().base;
    });
}

PlanItem item(std::string feature, bool needed, std::string reason_if_needed,
              std::string reason_if_not) {
    return {std::move(feature), needed,
            needed ? std::move(reason_if_needed) : std::move(reason_if_not)};
}

std::vector<PlanItem> list(const SceneNeeds& needs, const SpectralBasis& basis) {
    return {
        item("transparency", needs.transparency, "a material in use has k_st > 0",
             "no material in use transmits: no refracted rays, and shadow rays stop at the first "
             "surface"),
        item("refraction", needs.refraction, "a transmitting material has an index other than 1",
             "no transmitting material has an index other than 1"),
        item("absorption", needs.absorption,
             "a transmitting material absorbs: path lengths are kept",
             "no transmitting material absorbs"),
        item("reflected rays", needs.mirrors, "a material in use is followed by its reflected ray",
             "no material in use sends reflected rays"),
        item("ambient", needs.ambient, "k_a > 0", "no ambient term, or k_a = 0"),
        item("hemisphere rays", needs.hemisphere,
             "ambient weights are the covered share of the hemisphere",
             "no ambient weights to find by rays"),
        item("environment", needs.environment, "rays that leave the scene see light",
             "rays that leave the scene see black"),
        item("shadow rays", needs.shadows,
             "there are lamps, or an environment that matt surfaces see",
             "nothing to be in the shadow of"),
        item("light selection", needs.several_lights,
             "more than one lamp: every lamp is asked at every point", "at most one lamp"),
        item("wavelengths", basis.name() == "wavelengths",
             needs.wavelengths ? "colours differ: a path carries the whole quadrature"
                               : "one number would do, but the general form was asked for",
             basis.name() == "rgb" ? "the baseline carries three channels"
                                   : "every material is grey and the lamps have one colour: one "
                                     "number stands for the spectrum"),
        item("textures", needs.textures, "a colour of a material in use varies over its surface",
             "no colour varies over a surface: no surface coordinates, no look-ups"),
        item("dispersion", needs.dispersion && basis.has_wavelengths(),
             "an index of refraction varies: refracted rays go on with one wavelength",
             needs.dispersion ? "without wavelengths the index at 587.6 nm stands for all"
                              : "every index of refraction is one number"),
        item("emission", needs.emission, "a material in use gives out light",
             "no material in use gives out light"),
    };
}

/// Of every texture in use, once.
std::uint64_t texture_memory_bytes(const Scene& scene) {
    TextureSet textures;
    for (const MaterialDescription* m : materials_in_use(scene)) textures.merge(textures_of(*m));
    return memory_bytes_of(textures);
}

}  // namespace

SceneNeeds analyse(const Scene& scene) {
    SceneNeeds needs;
    for (const MaterialDescription* m : materials_in_use(scene)) {
        const MaterialNeeds of = needs_of(*m);
        needs.transparency |= of.transmits;
        needs.refraction |= of.ior && (!of.ior->is_constant() || of.ior->at(kLineD_nm) != 1);
        needs.dispersion |= of.ior && !of.ior->is_constant();
        needs.absorption |= of.absorbs;
        needs.mirrors |= of.mirror;
        needs.emission |= m->emission.spectrum != nullptr;
        needs.textures |= !textures_of(*m).empty();
    }
    needs.ambient = scene.ambient() && scene.ambient()->k_a > 0;
    needs.hemisphere =
        needs.ambient && std::holds_alternative<HemisphereWeights>(scene.ambient()->weights);
    needs.environment = scene.environment().has_value();
    needs.several_lights = scene.lights().size() > 1;
    needs.shadows = !scene.lights().empty() || needs.environment;
    needs.wavelengths = !is_grey(scene);
    return needs;
}

SpectralBasis choose_basis(const Scene& scene, const SceneNeeds& needs,
                           const RenderSettings& settings) {
    if (settings.integrator == IntegratorType::Rgb) return SpectralBasis::rgb();
    const auto all = emissions(scene);
    if (needs.wavelengths || !settings.specialise || all.empty()) {
        return SpectralBasis::wavelengths(settings.wavelength_step_nm, observer_of(settings));
    }
    return SpectralBasis::grey(*all.front()->as_multiple().base, settings.wavelength_step_nm,
                               observer_of(settings));
}

std::uint64_t film_memory_bytes(const RenderSettings& settings) {
    const auto pixels =
        settings.crop
            ? std::uint64_t(settings.crop->width) * std::uint64_t(settings.crop->height)
            : std::uint64_t(settings.resolution.width) * std::uint64_t(settings.resolution.height);
    return Film::memory_bytes(pixels, static_cast<std::uint32_t>(settings.replicates));
}

const Observer& observer_of(const RenderSettings& settings) {
    const Observer* observer = find_observer(settings.observer);
    return observer != nullptr ? *observer : standard_observer();
}

double quadrature_error(const Scene& scene, double step_nm, const Observer& observer) {
    const std::array bases{SpectralBasis::wavelengths(1, observer),
                           SpectralBasis::wavelengths(step_nm, observer)};
    using Pair = std::array<std::vector<float>, 2>;  // the same spectrum in both bases
    std::vector<Pair> lamps;
    std::set<const Spectrum*> seen;
    const auto all = emissions(scene);
    for (const SpectrumPtr& s : all) {
        if (seen.insert(s->as_multiple().base).second)
            lamps.push_back({bases[0].emission(*s), bases[1].emission(*s)});
    }
    std::vector<Pair> surfaces{
        {std::vector<float>(bases[0].size(), 1), std::vector<float>(bases[1].size(), 1)}};
    std::vector<SpectrumPtr> kept;  // so that no two have one address
    for (const MaterialDescription* m : materials_in_use(scene)) {
        for (const SurfaceSpectrum& colour : needs_of(*m).colours) {
            for (const SpectrumPtr& s : colour.parts()) {
                kept.push_back(s);
                if (!s->is_constant() && seen.insert(s.get()).second)
                    surfaces.push_back({bases[0].factor(*s), bases[1].factor(*s)});
            }
        }
    }
    double worst = 0;
    std::size_t pairs = 0;
    for (const Pair& lamp : lamps) {
        for (const Pair& surface : surfaces) {
            if (++pairs > kMaxPairs && &surface != &surfaces.front()) break;
            std::array<Xyz, 2> colour;
            for (std::size_t b = 0; b < 2; ++b) {
                std::vector<float> product = lamp[b];
                for (std::size_t i = 0; i < product.size(); ++i) product[i] *= surface[b][i];
                colour[b] = bases[b].to_xyz(product.data());
            }
            if (colour[0].y <= 0) continue;
            worst = std::max({worst, std::abs(colour[1].x - colour[0].x) / colour[0].y,
                              std::abs(colour[1].y - colour[0].y) / colour[0].y,
                              std::abs(colour[1].z - colour[0].z) / colour[0].y});
        }
    }
    return worst;
}

Plan make_plan(const Scene& scene, const RenderSettings& settings) {
    const SceneNeeds needs = analyse(scene);
    const SpectralBasis basis = choose_basis(scene, needs, settings);
    Plan plan;
    plan.items = list(needs, basis);
    plan.kernel = integrator_entry(settings.integrator).kernel_name(needs, settings);
    plan.basis = basis.name();
    plan.values_per_path = basis.size();
    plan.triangles = scene.geometry().num_triangles();
    plan.objects = scene.object_materials().size();
    plan.lights = scene.lights().size();
    plan.memory_bytes_estimate =
        film_memory_bytes(settings) + scene.geometry().memory_bytes() + texture_memory_bytes(scene);
    return plan;
}

}  // namespace bouguer::renderer
