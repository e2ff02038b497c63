// SPDX-License-Identifier: Apache-2.0
// What the models with a matt and a glossy part have in common.
#pragma once

#include "renderer/materials/reflection_model.h"

namespace bouguer::renderer {

/// The answer k_d R_d (n.wi) + k_s C gloss(wi): a model says what its gloss is, how to draw from it
/// and which colour C it has.
class GlossyModel : public ReflectionModel {
  public:
    [[nodiscard]] Response reflect(Vec3 n, Vec3 wo, Vec3 wi, SurfaceColours& colours) const final;
    /// From the matt or from the glossy part, weighted by the density of both.
    [[nodiscard]] std::optional<DirectionSample> sample(Vec3 n, Vec3 wo, Vec2 u,
                                                        SurfaceColours& colours) const final;
    /// k_d R_d.
    [[nodiscard]] Response ambient(SurfaceColours& colours) const override;

  protected:
    /// `mirror`: a mirrored ray is followed in the place of gathering light over the gloss.
    GlossyModel(Real k_d, Real k_s, bool mirror, BoundSpectrum diffuse)
        : k_d_(static_cast<float>(k_d)),
          k_s_(static_cast<float>(k_s)),
          mirror_(mirror),
          diffuse_(diffuse) {}
    [[nodiscard]] float k_s() const { return k_s_; }

    /// The scale of the glossy term, >= 0, without k_s.
    [[nodiscard]] virtual Real gloss(Vec3 n, Vec3 wo, Vec3 wi) const = 0;
    /// A direction for the glossy part, anywhere; its density per solid angle is gloss_pdf().
    [[nodiscard]] virtual Vec3 draw_gloss(Vec3 n, Vec3 wo, Vec2 u) const = 0;
    [[nodiscard]] virtual Real gloss_pdf(Vec3 n, Vec3 wo, Vec3 wi) const = 0;
    /// C, in slot kSecond where it is not a row of the table.
    [[nodiscard]] virtual const Float8* gloss_colour(Vec3 wo, Vec3 wi,
                                                     SurfaceColours& colours) const = 0;

  private:
    [[nodiscard]] Response terms(Real matt, Real gloss, Vec3 wo, Vec3 wi,
                                 SurfaceColours& colours) const;

    float k_d_, k_s_;
    bool mirror_;
    BoundSpectrum diffuse_;
};

}  // namespace bouguer::renderer
