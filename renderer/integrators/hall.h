// SPDX-License-Identifier: Apache-2.0
// The seed's integrator: recursive backward ray tracing with the improved Hall model [Lee et al.,
// equations 1 to 4], and with the other models of reflection in its place.
//
// At a surface met by a ray from the side of unit normal N (turned to the viewer), the radiance
// that goes back is
//
//     I = sum over lamps l  k_sr I_l F_sr (L.N)^n'     lamp on the viewer's side (eq. 4, local)
//       + sum over lamps l  k_st I_l F_st (-L.N)^n'    lamp behind the surface   (eq. 3, local)
//       + k_sr F_sr I(reflected ray)                   where it is followed      (eq. 4, recursive)
//       + k_st F_st I(refracted ray)                                             (eq. 3, recursive)
//       + K_a sum over i  k_i R_i^{n_i} I_a            neighbours i              (eq. 2)
//
// and everything that comes through a body is multiplied by T = t^b, b being the distance travelled
// inside it (eq. 1), analytic and never sampled. Readings of the printed text, each stated here and
// nowhere else:
//
// - (L.N) is clamped at 0 and shapes the light of lamps only: along a reflected or refracted ray
//   the lobe is at its peak. Other materials have their own local terms and shares in its place
//   (renderer/materials).
// - I_l is what arrives: inverse square of the distance in metres for point lamps, times the
//   transmittance of the bodies in between (k_st F_st a face and t^b inside, straight through) and
//   zero behind anything opaque.
// - Total reflection: the transmitted share goes with the reflected ray, k_sr F_sr + k_st F_st.
// - Ambient: eq. 4 sums the reflectances R_i = F_sr^i where light meets the outside of the shaded
//   body, eq. 3 the transmittances R_i = F_st^i where it comes out of it; n_i is the neighbour's
//   n'. The weights k_i are given, or are the share of the cosine-weighted hemisphere outside the
//   body that neighbour i covers. I_a is the scene's ambient illuminant, or the light that arrives
//   unshadowed from all lamps. The body itself is no neighbour. For comparison the sum can be
//   replaced by the constant ambient term of older models, the surface's own matt reflectance.
// - A constant environment reaches a surface by its reflected or refracted ray; what that does not
//   bring is gathered by one random direction from the surface's lobe.
// - What a surface emits is seen, directly, mirrored and through glass; it lights nothing else.
//
// Where the index of refraction varies with the wavelength, a refracted ray goes on with one
// wavelength, drawn once a sample; the others end there, and its weight makes up for them.
#pragma once

#include <memory>

#include "renderer/integrators/integrator.h"
#include "renderer/plan/plan.h"

namespace bouguer::renderer {

/// A sample's tree of rays never has more nodes than this, whatever depth is asked for; what is cut
/// counts as depth.
inline constexpr int kMaxNodesPerSample = 20'000;
/// A shadow ray passes at most this many transparent surfaces.
inline constexpr int kMaxShadowSurfaces = 64;

/// What a kernel is compiled with. Leaving a feature out that the scene does not need leaves the
/// picture as it is.
struct HallFeatures {
    bool transparency = true;
    bool ambient = true;
};

/// `scene` must outlive the integrator. Immutable and thread-safe.
[[nodiscard]] std::unique_ptr<Integrator> make_hall(const Scene& scene, SpectralBasis basis,
                                                    const RenderSettings& settings,
                                                    HallFeatures features);

/// The kernel that `needs` call for; the general one when `settings.specialise` is false.
[[nodiscard]] HallFeatures choose_hall_features(const SceneNeeds& needs,
                                                const RenderSettings& settings);
[[nodiscard]] std::string hall_kernel_name(HallFeatures features);

}  // namespace bouguer::renderer
