// SPDX-License-Identifier: Apache-2.0
// What the models of a rough surface made of small mirrors have in common: a gloss about the half
// vector H between light and viewer, and Fresnel's colour at its angle.
#pragma once

#include "renderer/materials/glossy_model.h"

namespace bouguer::renderer {

/// The cosines that a gloss depends on; all above 0.
struct MicrofacetAngles {
    Real nh = 1, nv = 1, nl = 1, vh = 1;
};

/// The part of the facets that neither light nor viewer lose to other facets
/// [Torrance and Sparrow 1967; Blinn 1977]: min(1, 2 nh nv / vh, 2 nh nl / vh).
[[nodiscard]] Real v_cavity_shadowing(const MicrofacetAngles& a);

/// C is Fresnel's reflectance for the angle between V and H, times a tint.
class MicrofacetModel : public GlossyModel {
  public:
    /// Opaque, unless a model says otherwise; Fresnel's reflectance at the smooth surface.
    [[nodiscard]] Shares shares(Real cosine, const Boundary& boundary,
                                SurfaceColours& colours) const override;

  protected:
    MicrofacetModel(Real k_d, Real k_s, bool mirror, BoundSpectrum diffuse, BoundSpectrum tint,
                    BoundIndex index)
        : GlossyModel(k_d, k_s, mirror, diffuse), tint_(tint), index_(index) {}

    [[nodiscard]] virtual Real gloss_of(const MicrofacetAngles& a) const = 0;
    /// A half vector about +z, and its density per solid angle.
    [[nodiscard]] virtual Vec3 draw_half(Vec2 u) const = 0;
    [[nodiscard]] virtual Real half_pdf(Real nh) const = 0;

    [[nodiscard]] const BoundSpectrum& tint() const { return tint_; }
    [[nodiscard]] const BoundIndex& index() const { return index_; }

    [[nodiscard]] Real gloss(Vec3 n, Vec3 wo, Vec3 wi) const final;
    [[nodiscard]] Vec3 draw_gloss(Vec3 n, Vec3 wo, Vec2 u) const final;
    [[nodiscard]] Real gloss_pdf(Vec3 n, Vec3 wo, Vec3 wi) const final;
    [[nodiscard]] const Float8* gloss_colour(Vec3 wo, Vec3 wi, SurfaceColours& colours) const final;

    /// C at an angle, in slot kSecond.
    [[nodiscard]] const Float8* colour(Real cosine, SurfaceColours& colours) const;

  private:
    BoundSpectrum tint_;
    BoundIndex index_;
};

}  // namespace bouguer::renderer
