// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/hall_greenberg_material.h"

#include "renderer/materials/fresnel.h"
#include "renderer/materials/microfacet_model.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

class HallGreenbergModel final : public MicrofacetModel {
  public:
    HallGreenbergModel(const HallGreenbergMaterial& material, BoundSpectrum diffuse,
                       BoundSpectrum tint, BoundSpectrum transmittance, BoundIndex index,
                       std::size_t reciprocal)
        : MicrofacetModel(material.k_dr, material.k_sr, material.mirror, diffuse, tint, index),
          k_st_(static_cast<float>(material.k_st)),
          n_(material.n),
          n_t_(material.n_t),
          transmittance_(transmittance),
          reciprocal_(reciprocal) {}

    [[nodiscard]] Response transmit(Vec3 n, Vec3 wo, Vec3 wi, const Boundary& boundary,
                                    SurfaceColours& colours) const override {
        const Real cosine = dot(refracting_facet(n, wo, wi, boundary), n);
        if (k_st_ == 0 || !(cosine > 0)) return {};
        Term refracted = shares(dot(n, wo), boundary, colours).refracted;
        refracted.scale *= static_cast<float>(std::pow(std::min(cosine, 1.0), n_t_));
        return {refracted};
    }

    [[nodiscard]] Shares shares(Real cosine, const Boundary& boundary,
                                SurfaceColours& colours) const override {
        const std::size_t blocks = colours.blocks();
        Float8* reflected = colours.blank(SurfaceColours::kSecond);
        Float8* refracted = colours.blank(SurfaceColours::kThird);
        // The relative index, in the place of what goes through, which comes last.
        const float scale =
            static_cast<float>(boundary.entering ? 1 / boundary.here : boundary.beyond);
        std::fill_n(refracted, blocks, splat(0));
        accumulate(refracted, scale, colours.row(boundary.entering ? index().n : reciprocal_),
                   blocks);
        fresnel_reflectances(reflected, cosine, refracted, colours.row(index().k), blocks);
        for (std::size_t i = 0; i < blocks; ++i) refracted[i] = 1.0F - reflected[i];
        multiply(refracted, 1, colours.row(transmittance_, SurfaceColours::kFirst), blocks);
        multiply(reflected, 1, colours.row(tint(), SurfaceColours::kFirst), blocks);
        return {{k_s(), reflected}, {k_st_, refracted}};
    }

  protected:
    [[nodiscard]] Real gloss_of(const MicrofacetAngles& a) const override {
        return std::pow(a.nh, n_);
    }
    [[nodiscard]] Vec3 draw_half(Vec2 u) const override { return sample_cosine_power(u, n_); }
    [[nodiscard]] Real half_pdf(Real nh) const override { return cosine_power_pdf(nh, n_); }

  private:
    /// H_t, on the viewer's side where it exists [Walter et al. 2007, eq. 16]. Between equal
    /// indices: the normal, tilted as far as wi is from going straight through.
    static Vec3 refracting_facet(Vec3 n, Vec3 wo, Vec3 wi, const Boundary& boundary) {
        constexpr Real kEqual = 1e-6;
        if (std::abs(boundary.beyond - boundary.here) < kEqual) return -dot(wi, wo) * n;
        const Vec3 h = boundary.here * wo + boundary.beyond * wi;
        const Real size = length(h);
        if (!(size > 0)) return n;
        return h / (boundary.beyond > boundary.here ? -size : size);
    }

    float k_st_;
    Real n_, n_t_;
    BoundSpectrum transmittance_;
    std::size_t reciprocal_;  ///< 1 / n, for light that comes out
};

std::size_t bind_reciprocal(const BoundIndex& index, const SpectralBasis& basis,
                            SpectralTable& table) {
    const auto* n = reinterpret_cast<const float*>(table.row(index.n));
    std::vector<float> reciprocal(n, n + basis.size());
    for (float& value : reciprocal) value = 1 / value;
    return table.add(reciprocal);
}

}  // namespace

MaterialNeeds needs_of(const HallGreenbergMaterial& material) {
    MaterialNeeds needs{{material.diffuse, material.specular, material.transmittance,
                         normal_reflectance(material.index)}};
    needs.mirror = material.mirror && material.k_sr > 0;
    needs.transmits = material.k_st > 0;
    if (!needs.transmits) return needs;
    needs.ior = material.index.n;
    needs.absorbs = material.absorption.has_value();
    if (needs.absorbs) needs.colours.emplace_back(material.absorption->transmittance);
    return needs;
}

Surface bind(const HallGreenbergMaterial& material, const SpectralBasis& basis,
             SpectralTable& table) {
    Surface s;
    s.mirror = needs_of(material).mirror;
    if (material.k_st > 0) bind_inside(s, *material.index.n, material.absorption, basis, table);
    const BoundIndex index = bind_index(material.index, basis, table);
    s.model =
        std::make_unique<HallGreenbergModel>(material, bind_factor(material.diffuse, basis, table),
                                             bind_factor(material.specular, basis, table),
                                             bind_factor(material.transmittance, basis, table),
                                             index, bind_reciprocal(index, basis, table));
    s.neighbour_reflectance = bind_neighbour(material.k_dr > 0, material.diffuse, 1, basis, table);
    s.neighbour_transmittance =
        bind_neighbour(material.k_st > 0, material.transmittance, 1, basis, table);
    return s;
}

}  // namespace bouguer::renderer
