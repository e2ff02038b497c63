// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/microfacet_model.h"

#include <optional>

#include "renderer/materials/fresnel.h"
#include "renderer/media/refraction.h"

namespace bouguer::renderer {
namespace {

/// Empty where some cosine is not above 0: no facet lies so that it could be seen.
std::optional<MicrofacetAngles> angles(Vec3 n, Vec3 wo, Vec3 wi) {
    const Vec3 sum = wo + wi;
    const Real size = length(sum);
    if (!(size > 0)) return std::nullopt;
    const Vec3 h = sum / size;
    const MicrofacetAngles a{std::min(dot(n, h), 1.0), dot(n, wo), dot(n, wi), dot(wo, h)};
    if (a.nh > 0 && a.nv > 0 && a.nl > 0 && a.vh > 0) return a;
    return std::nullopt;
}

}  // namespace

Real v_cavity_shadowing(const MicrofacetAngles& a) {
    return std::min(1.0, 2 * a.nh * std::min(a.nv, a.nl) / a.vh);
}

Real MicrofacetModel::gloss(Vec3 n, Vec3 wo, Vec3 wi) const {
    const auto a = angles(n, wo, wi);
    return a ? gloss_of(*a) : 0;
}

Vec3 MicrofacetModel::draw_gloss(Vec3 n, Vec3 wo, Vec2 u) const {
    return renderer::reflect(-wo, Frame(n).to_world(draw_half(u)));
}

/// The mirrored direction turns twice as far as the half vector: a solid angle about wi is 4 vh
/// times that about h [Torrance and Sparrow 1967].
Real MicrofacetModel::gloss_pdf(Vec3 n, Vec3 wo, Vec3 wi) const {
    const auto a = angles(n, wo, wi);
    return a ? half_pdf(a->nh) / (4 * a->vh) : 0;
}

const Float8* MicrofacetModel::gloss_colour(Vec3 wo, Vec3 wi, SurfaceColours& colours) const {
    return colour(dot(wo, normalize(wo + wi)), colours);
}

Shares MicrofacetModel::shares(Real cosine, const Boundary& /*boundary*/,
                               SurfaceColours& colours) const {
    return {{k_s(), colour(cosine, colours)}, {}};
}

const Float8* MicrofacetModel::colour(Real cosine, SurfaceColours& colours) const {
    Float8* row = colours.blank(SurfaceColours::kSecond);
    fresnel_reflectances(row, cosine, colours.row(index_.n), colours.row(index_.k),
                         colours.blocks());
    multiply(row, 1, colours.row(tint_, SurfaceColours::kThird), colours.blocks());
    return row;
}

}  // namespace bouguer::renderer
