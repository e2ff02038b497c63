// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/phong_material.h"

#include "renderer/materials/glossy_model.h"
#include "renderer/media/refraction.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

class PhongModel final : public GlossyModel {
  public:
    PhongModel(const PhongMaterial& material, BoundSpectrum diffuse, BoundSpectrum specular)
        : GlossyModel(material.k_d, material.k_s, material.mirror, diffuse),
          n_(material.n),
          specular_(specular) {}

    [[nodiscard]] Shares shares(Real /*cosine*/, const Boundary& /*boundary*/,
                                SurfaceColours& colours) const override {
        return {{k_s(), colours.row(specular_, SurfaceColours::kSecond)}, {}};
    }

  protected:
    [[nodiscard]] Real gloss(Vec3 n, Vec3 wo, Vec3 wi) const override {
        const Real cosine = dot(reflect_about(n, wo), wi);
        return cosine > 0 ? std::pow(cosine, n_) : 0;
    }
    [[nodiscard]] Vec3 draw_gloss(Vec3 n, Vec3 wo, Vec2 u) const override {
        return Frame(reflect_about(n, wo)).to_world(sample_cosine_power(u, n_));
    }
    [[nodiscard]] Real gloss_pdf(Vec3 n, Vec3 wo, Vec3 wi) const override {
        return cosine_power_pdf(dot(reflect_about(n, wo), wi), n_);
    }
    [[nodiscard]] const Float8* gloss_colour(Vec3 /*wo*/, Vec3 /*wi*/,
                                             SurfaceColours& colours) const override {
        return colours.row(specular_, SurfaceColours::kSecond);
    }

  private:
    /// The mirrored direction of w; both point away from the surface.
    static Vec3 reflect_about(Vec3 n, Vec3 w) { return renderer::reflect(-w, n); }

    Real n_;
    BoundSpectrum specular_;
};

}  // namespace

MaterialNeeds needs_of(const PhongMaterial& material) {
    MaterialNeeds needs{{material.diffuse, material.specular}};
    needs.mirror = material.mirror && material.k_s > 0;
    return needs;
}

Surface bind(const PhongMaterial& material, const SpectralBasis& basis, SpectralTable& table) {
    Surface s;
    s.mirror = needs_of(material).mirror;
    s.model = std::make_unique<PhongModel>(material, bind_factor(material.diffuse, basis, table),
                                           bind_factor(material.specular, basis, table));
    s.neighbour_reflectance = bind_neighbour(material.k_d > 0, material.diffuse, 1, basis, table);
    s.neighbour_transmittance = bind_neighbour(false, {}, 1, basis, table);
    return s;
}

}  // namespace bouguer::renderer
