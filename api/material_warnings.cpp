// SPDX-License-Identifier: Apache-2.0
#include "api/material_warnings.h"

#include <algorithm>
#include <set>
#include <variant>

#include "api/json_value.h"
#include "renderer/materials/fresnel.h"
#include "renderer/spectrum/colour.h"

namespace bouguer::api {
namespace {

using renderer::ComplexIndex;
using renderer::MaterialDescription;
using renderer::SpectrumPtr;
using renderer::SurfaceSpectrum;

/// Rounding of shares that are meant to be the whole.
constexpr double kSlack = 1e-6;

/// The largest value at a wavelength of the spectra that a texture mixes.
class Colour {
  public:
    explicit Colour(const SurfaceSpectrum& s) : parts_(s.parts()) {}
    [[nodiscard]] double at(double lambda_nm) const {
        double most = 0;
        for (const SpectrumPtr& part : parts_) most = std::max(most, part->at(lambda_nm));
        return most;
    }

  private:
    std::vector<SpectrumPtr> parts_;
};

/// By 5 nm.
template <class Function>
double largest(Function at) {
    double most = 0;
    for (double nm = renderer::kLambdaMin_nm; nm <= renderer::kLambdaMax_nm; nm += 5)
        most = std::max(most, at(nm));
    return most;
}

/// Fresnel's reflectance for light from all sides, by the middle rule in the square of the cosine.
double mean_reflectance(const ComplexIndex& index, double lambda_nm) {
    constexpr int kAngles = 16;
    const double n = index.n->at(lambda_nm), k = index.k->at(lambda_nm);
    double sum = 0;
    for (int i = 0; i < kAngles; ++i)
        sum += renderer::fresnel_reflectance(std::sqrt((i + 0.5) / kAngles), n, k);
    return sum / kAngles;
}

// ---- the most that a surface gives back of light of one wavelength ----

/// The lobe (L.N)^n holds 2 / (n + 1) of a matt surface's light: more than the whole for n < 1.
double most_given(const renderer::HallMaterial& m) {
    const double lobe = m.mirror ? 1 : std::max(1.0, 2 / (m.n + 1));
    const Colour reflectance(m.reflectance), transmittance(m.transmittance);
    return largest([&](double nm) {
        return m.k_sr * lobe * reflectance.at(nm) + m.k_st * transmittance.at(nm);
    });
}

/// `gloss` is the share of light that the highlight's facets mirror.
template <class Glossy, class Gloss>
double most_of_matt_and(const Glossy& m, Gloss gloss) {
    const Colour diffuse(m.diffuse), specular(m.specular);
    return largest(
        [&](double nm) { return m.k_d * diffuse.at(nm) + m.k_s * specular.at(nm) * gloss(nm); });
}
template <class Glossy>
double most_of_matt_and_facets(const Glossy& m) {
    return most_of_matt_and(m, [&](double nm) { return mean_reflectance(m.index, nm); });
}
double most_given(const renderer::PhongMaterial& m) {
    return most_of_matt_and(m, [](double) { return 1; });
}
double most_given(const renderer::BlinnMaterial& m) { return most_of_matt_and_facets(m); }
double most_given(const renderer::CookTorranceMaterial& m) { return most_of_matt_and_facets(m); }

/// Fresnel's reflectance divides what is mirrored and what goes through.
double most_given(const renderer::HallGreenbergMaterial& m) {
    const Colour diffuse(m.diffuse), specular(m.specular), transmittance(m.transmittance);
    return largest([&](double nm) {
        const double mirrored = mean_reflectance(m.index, nm);
        return m.k_dr * diffuse.at(nm) + m.k_sr * specular.at(nm) * mirrored +
               m.k_st * transmittance.at(nm) * (1 - mirrored);
    });
}

}  // namespace

void warn_of_materials(const renderer::SceneDescription& scene, WarningSink& sink) {
    std::set<std::size_t> used;
    for (const auto& object : scene.objects) used.insert(object.material);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const MaterialDescription& material = scene.materials[i];
        const std::string at = "/materials/" + pointer_token(material.name);
        if (!used.contains(i)) {
            sink.warn(at, "unused-material", "no object has this material",
                      "remove it, or give it to an object");
        }
        const double most = std::visit([](const auto& m) { return most_given(m); }, material.model);
        if (most > 1 + kSlack) {
            sink.warn(at, "gains-energy",
                      "at some wavelength this surface gives back " + number_text(most) +
                          " times the light that it gets",
                      "let its shares times its spectra be at most 1 in sum");
        }
    }
}

}  // namespace bouguer::api
