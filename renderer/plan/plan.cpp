// SPDX-License-Identifier: Apache-2.0
#include "renderer/plan/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "renderer/film/film.h"
#include "renderer/integrators/integrator_registry.h"

namespace bouguer::renderer {
namespace {

/// Pairs of lamp and surface that quadrature_error() looks at; of the lamps beyond, their own light
/// only.
constexpr std::size_t kMaxPairs = 20'000;

std::vector<const HallMaterial*> materials_in_use(const Scene& scene) {
    const std::set<std::uint32_t> used(scene.object_materials().begin(),
                                       scene.object_materials().end());
    std::vector<const HallMaterial*> materials;
    for (const std::uint32_t m : used)
        materials.push_back(&std::get<HallMaterial>(scene.materials()[m].model));
    return materials;
}

std::vector<const Spectrum*> emissions(const Scene& scene) {
    std::vector<const Spectrum*> all;
    for (const Light& light : scene.lights()) all.push_back(light.spectrum().get());
    if (scene.environment()) all.push_back(scene.environment()->radiance.get());
    if (scene.ambient() && scene.ambient()->illuminant)
        all.push_back(scene.ambient()->illuminant.get());
    return all;
}

/// Whether all emissions have one colour and every material is grey: then one number stands for the
/// spectrum.
bool is_grey(const Scene& scene) {
    for (const HallMaterial* m : materials_in_use(scene)) {
        if (!m->reflectance->is_constant() || !m->transmittance->is_constant()) return false;
        if (m->absorption && !m->absorption->transmittance->is_constant()) return false;
    }
    const auto all = emissions(scene);
    return std::all_of(all.begin(), all.end(), [&](const Spectrum* s) {
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
        item("textures", false, "", "this version has none"),
        item("dispersion", false, "", "every index of refraction is one number"),
    };
}

}  // namespace

SceneNeeds analyse(const Scene& scene) {
    SceneNeeds needs;
    for (const HallMaterial* m : materials_in_use(scene)) {
        const bool transmits = m->k_st > 0;
        needs.transparency |= transmits;
        needs.refraction |= transmits && m->ior != 1;
        needs.absorption |= transmits && m->absorption.has_value();
        needs.mirrors |= m->mirror && m->k_sr > 0;
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
        return SpectralBasis::wavelengths(settings.wavelength_step_nm);
    }
    return SpectralBasis::grey(*all.front()->as_multiple().base, settings.wavelength_step_nm);
}

std::uint64_t film_memory_bytes(const RenderSettings& settings) {
    const auto pixels =
        settings.crop
            ? std::uint64_t(settings.crop->width) * std::uint64_t(settings.crop->height)
            : std::uint64_t(settings.resolution.width) * std::uint64_t(settings.resolution.height);
    return Film::memory_bytes(pixels, static_cast<std::uint32_t>(settings.replicates));
}

double quadrature_error(const Scene& scene, double step_nm) {
    const std::array bases{SpectralBasis::wavelengths(1), SpectralBasis::wavelengths(step_nm)};
    using Pair = std::array<std::vector<float>, 2>;  // the same spectrum in both bases
    std::vector<Pair> lamps;
    std::set<const Spectrum*> seen;
    for (const Spectrum* s : emissions(scene)) {
        if (seen.insert(s->as_multiple().base).second)
            lamps.push_back({bases[0].emission(*s), bases[1].emission(*s)});
    }
    std::vector<Pair> surfaces{
        {std::vector<float>(bases[0].size(), 1), std::vector<float>(bases[1].size(), 1)}};
    for (const HallMaterial* m : materials_in_use(scene)) {
        for (const Spectrum* s : {m->reflectance.get(), m->transmittance.get(),
                                  m->absorption ? m->absorption->transmittance.get() : nullptr}) {
            if (s != nullptr && !s->is_constant() && seen.insert(s).second) {
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
    plan.memory_bytes_estimate = film_memory_bytes(settings) + scene.geometry().memory_bytes();
    return plan;
}

}  // namespace bouguer::renderer
