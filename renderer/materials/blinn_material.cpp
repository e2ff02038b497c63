// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/blinn_material.h"

#include "renderer/materials/fresnel.h"
#include "renderer/materials/microfacet_model.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

class BlinnModel final : public MicrofacetModel {
  public:
    BlinnModel(const BlinnMaterial& material, BoundSpectrum diffuse, BoundSpectrum tint,
               BoundIndex index)
        : MicrofacetModel(material.k_d, material.k_s, material.mirror, diffuse, tint, index),
          c3_(material.c3) {}

  protected:
    [[nodiscard]] Real gloss_of(const MicrofacetAngles& a) const override {
        return distribution(a.nh) * v_cavity_shadowing(a) / a.nv;
    }
    [[nodiscard]] Vec3 draw_half(Vec2 u) const override { return sample_trowbridge_reitz(u, c3_); }
    [[nodiscard]] Real half_pdf(Real nh) const override {
        return distribution(nh) * nh / (kPi * c3_ * c3_);
    }

  private:
    [[nodiscard]] Real distribution(Real nh) const {
        const Real c2 = c3_ * c3_;
        const Real ratio = c2 / ((1 - nh) * (1 + nh) + nh * nh * c2);
        return ratio * ratio;
    }

    Real c3_;
};

}  // namespace

MaterialNeeds needs_of(const BlinnMaterial& material) {
    MaterialNeeds needs{{material.diffuse, material.specular}};
    if (material.k_s > 0) needs.colours.emplace_back(normal_reflectance(material.index));
    needs.mirror = material.mirror && material.k_s > 0;
    return needs;
}

Surface bind(const BlinnMaterial& material, const SpectralBasis& basis, SpectralTable& table) {
    Surface s;
    s.mirror = needs_of(material).mirror;
    s.model = std::make_unique<BlinnModel>(material, bind_factor(material.diffuse, basis, table),
                                           bind_factor(material.specular, basis, table),
                                           bind_index(material.index, basis, table));
    s.neighbour_reflectance = bind_neighbour(material.k_d > 0, material.diffuse, 1, basis, table);
    s.neighbour_transmittance = bind_neighbour(false, {}, 1, basis, table);
    return s;
}

}  // namespace bouguer::renderer
