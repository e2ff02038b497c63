// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/glossy_model.h"

#include "renderer/samplers/warp.h"

namespace bouguer::renderer {

Response GlossyModel::reflect(Vec3 n, Vec3 wo, Vec3 wi, SurfaceColours& colours) const {
    return terms(dot(n, wi), k_s_ > 0 ? gloss(n, wo, wi) : 0, wo, wi, colours);
}

std::optional<DirectionSample> GlossyModel::sample(Vec3 n, Vec3 wo, Vec2 u,
                                                   SurfaceColours& colours) const {
    const Real k_gloss = mirror_ ? 0 : k_s_;
    if (k_d_ + k_gloss == 0) return std::nullopt;
    const Real share = k_gloss / (k_d_ + k_gloss);
    const bool is_gloss = u.x < share;
    u.x = is_gloss ? u.x / share : (u.x - share) / (1 - share);
    const Vec3 wi = is_gloss ? draw_gloss(n, wo, u) : Frame(n).to_world(sample_cosine_power(u, 1));
    const Real cosine = dot(n, wi);
    if (!(cosine > 0)) return std::nullopt;
    const Real pdf =
        (share > 0 ? share * gloss_pdf(n, wo, wi) : 0) + (1 - share) * cosine_power_pdf(cosine, 1);
    if (!(pdf > 0)) return std::nullopt;
    return DirectionSample{
        wi, terms(cosine / pdf, share > 0 ? gloss(n, wo, wi) / pdf : 0, wo, wi, colours)};
}

Response GlossyModel::ambient(SurfaceColours& colours) const {
    return {Term{k_d_, colours.row(diffuse_, SurfaceColours::kFirst)}};
}

Response GlossyModel::terms(Real matt, Real gloss, Vec3 wo, Vec3 wi,
                            SurfaceColours& colours) const {
    Response response;
    if (k_d_ > 0)
        response[0] = {k_d_ * static_cast<float>(matt),
                       colours.row(diffuse_, SurfaceColours::kFirst)};
    if (gloss > 0) response[1] = {k_s_ * static_cast<float>(gloss), gloss_colour(wo, wi, colours)};
    return response;
}

}  // namespace bouguer::renderer
