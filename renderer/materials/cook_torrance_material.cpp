// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/cook_torrance_material.h"

#include "renderer/materials/fresnel.h"
#include "renderer/materials/microfacet_model.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

class CookTorranceModel final : public MicrofacetModel {
  public:
    CookTorranceModel(const CookTorranceMaterial& material, BoundSpectrum diffuse,
                      BoundSpectrum tint, BoundIndex index)
        : MicrofacetModel(material.k_d, material.k_s, material.mirror, diffuse, tint, index),
          m_(material.m) {}

    /// As the authors have it: the facets' share counts with its colour at normal incidence.
    [[nodiscard]] Response ambient(SurfaceColours& colours) const override {
        const Response matt = MicrofacetModel::ambient(colours);
        return {matt[0], Term{k_s(), colour(1, colours)}};
    }

  protected:
    [[nodiscard]] Real gloss_of(const MicrofacetAngles& a) const override {
        return kPi * beckmann(a.nh) * v_cavity_shadowing(a) / (4 * a.nv);
    }
    [[nodiscard]] Vec3 draw_half(Vec2 u) const override { return sample_beckmann(u, m_); }
    [[nodiscard]] Real half_pdf(Real nh) const override { return beckmann(nh) * nh; }

  private:
    [[nodiscard]] Real beckmann(Real nh) const {
        const Real cos2 = nh * nh, m2 = m_ * m_;
        const Real tan2 = (1 - nh) * (1 + nh) / cos2;
        return std::exp(-tan2 / m2) / (kPi * m2 * cos2 * cos2);
    }

    Real m_;
};

/// What a distant viewer sees of it as a whole.
SurfaceSpectrum colour_as_neighbour(const CookTorranceMaterial& material) {
    if (material.k_d > 0) return material.diffuse;
    return {product_spectrum(material.specular.spectrum, normal_reflectance(material.index)),
            material.specular.texture};
}

}  // namespace

MaterialNeeds needs_of(const CookTorranceMaterial& material) {
    MaterialNeeds needs{{material.diffuse, material.specular}};
    if (material.k_s > 0) needs.colours.emplace_back(normal_reflectance(material.index));
    needs.mirror = material.mirror && material.k_s > 0;
    return needs;
}

Surface bind(const CookTorranceMaterial& material, const SpectralBasis& basis,
             SpectralTable& table) {
    Surface s;
    s.mirror = needs_of(material).mirror;
    s.model = std::make_unique<CookTorranceModel>(
        material, bind_factor(material.diffuse, basis, table),
        bind_factor(material.specular, basis, table), bind_index(material.index, basis, table));
    s.neighbour_reflectance = bind_neighbour(true, colour_as_neighbour(material), 1, basis, table);
    s.neighbour_transmittance = bind_neighbour(false, {}, 1, basis, table);
    return s;
}

}  // namespace bouguer::renderer
