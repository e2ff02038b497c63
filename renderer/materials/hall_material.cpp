// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/hall_material.h"

#include <cmath>

#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

class HallModel final : public ReflectionModel {
  public:
    HallModel(const HallMaterial& material, BoundSpectrum reflectance, BoundSpectrum transmittance)
        : k_sr_(static_cast<float>(material.k_sr)),
          k_st_(static_cast<float>(material.k_st)),
          n_(material.n),
          mirror_(material.mirror),
          reflectance_(reflectance),
          transmittance_(transmittance) {}

    [[nodiscard]] Response reflect(Vec3 n, Vec3 /*wo*/, Vec3 wi,
                                   SurfaceColours& colours) const override {
        if (k_sr_ == 0) return {};
        return {Term{k_sr_ * cosine_power(dot(n, wi), n_), f_sr(colours)}};
    }

    [[nodiscard]] Response transmit(Vec3 n, Vec3 /*wo*/, Vec3 wi, const Boundary& /*boundary*/,
                                    SurfaceColours& colours) const override {
        if (k_st_ == 0) return {};
        return {Term{k_st_ * cosine_power(-dot(n, wi), n_), f_st(colours)}};
    }

    /// From the lobe itself, whose integral is 2 pi / (n' + 1).
    [[nodiscard]] std::optional<DirectionSample> sample(Vec3 n, Vec3 /*wo*/, Vec2 u,
                                                        SurfaceColours& colours) const override {
        if (k_sr_ == 0 || mirror_) return std::nullopt;
        const Vec3 wi = Frame(n).to_world(sample_cosine_power(u, n_));
        const auto scale = static_cast<float>(k_sr_ * 2 * kPi / (n_ + 1));
        return DirectionSample{wi, {Term{scale, f_sr(colours)}}};
    }

    /// Along a ray the lobe is at its peak.
    [[nodiscard]] Shares shares(Real /*cosine*/, const Boundary& /*boundary*/,
                                SurfaceColours& colours) const override {
        return {{k_sr_, f_sr(colours)}, {k_st_, f_st(colours)}};
    }

    [[nodiscard]] Response ambient(SurfaceColours& colours) const override {
        return {Term{k_sr_, f_sr(colours)}};
    }

  private:
    [[nodiscard]] const Float8* f_sr(SurfaceColours& colours) const {
        return colours.row(reflectance_, SurfaceColours::kFirst);
    }
    [[nodiscard]] const Float8* f_st(SurfaceColours& colours) const {
        return colours.row(transmittance_, SurfaceColours::kSecond);
    }

    float k_sr_, k_st_;
    Real n_;
    bool mirror_;
    BoundSpectrum reflectance_, transmittance_;
};

}  // namespace

float cosine_power(Real cosine, Real n) {
    constexpr Real kManySquarings = 1024;
    if (n > kManySquarings || n != std::floor(n)) return static_cast<float>(std::pow(cosine, n));
    Real power = 1;
    for (auto rest = static_cast<unsigned>(n); rest != 0; rest >>= 1U, cosine *= cosine) {
        if ((rest & 1U) != 0) power *= cosine;
    }
    return static_cast<float>(power);
}

MaterialNeeds needs_of(const HallMaterial& material) {
    MaterialNeeds needs{{material.reflectance, material.transmittance}};
    needs.transmits = material.k_st > 0;
    needs.mirror = material.mirror && material.k_sr > 0;
    if (!needs.transmits) return needs;
    needs.ior = material.ior;
    needs.absorbs = material.absorption.has_value();
    if (needs.absorbs) needs.colours.emplace_back(material.absorption->transmittance);
    return needs;
}

Surface bind(const HallMaterial& material, const SpectralBasis& basis, SpectralTable& table) {
    Surface s;
    s.mirror = material.mirror && material.k_sr > 0;
    if (material.k_st > 0) bind_inside(s, *material.ior, material.absorption, basis, table);
    s.model = std::make_unique<HallModel>(material, bind_factor(material.reflectance, basis, table),
                                          bind_factor(material.transmittance, basis, table));
    // An opaque neighbour transmits nothing and one without reflection reflects nothing, whatever
    // spectrum stands there.
    s.neighbour_reflectance =
        bind_neighbour(material.k_sr > 0, material.reflectance, material.n, basis, table);
    s.neighbour_transmittance =
        bind_neighbour(material.k_st > 0, material.transmittance, material.n, basis, table);
    return s;
}

}  // namespace bouguer::renderer
