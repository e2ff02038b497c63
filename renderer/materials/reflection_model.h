// SPDX-License-Identifier: Apache-2.0
// How a surface answers light: the seam between the integrators and the models of reflection.
#pragma once

#include <array>
#include <optional>

#include "renderer/core/vec3.h"
#include "renderer/materials/surface_colours.h"

namespace bouguer::renderer {

/// A number times a colour.
struct Term {
    float scale = 0;
    const Float8* colour = nullptr;  ///< a row; not read where scale is 0
};

/// What a surface makes of light: the sum of its terms. Rows stay valid until the model is asked
/// again.
using Response = std::array<Term, 2>;

/// A direction that was drawn, and the response to light from it over the density of drawing it.
struct DirectionSample {
    Vec3 wi;
    Response response;
};

/// How light that goes on is divided at a smooth boundary.
struct Shares {
    Term reflected, refracted;
};

/// The two sides of a boundary, by index of refraction at 587.6 nm: where the ray is, and beyond.
struct Boundary {
    Real here = 1, beyond = 1;
    bool entering = true;  ///< the ray goes into the body whose surface this is
};

/// One kind of reflection with the numbers of one surface. All directions are unit and point away
/// from the surface; n is on the side of the viewer, wo.
///
/// One convention for all models, that of the seed's equation 4: a response is what stands behind
/// I_l there, the cosine included. A matt white surface that faces the light answers it with 1; so
/// a response is pi times a BRDF times the cosine. Immutable and thread-safe; a caller brings its
/// own SurfaceColours.
class ReflectionModel {
  public:
    ReflectionModel() = default;
    ReflectionModel(const ReflectionModel&) = delete;
    ReflectionModel& operator=(const ReflectionModel&) = delete;
    virtual ~ReflectionModel() = default;

    /// To light from wi on the viewer's side: n.wi > 0, n.wo > 0.
    [[nodiscard]] virtual Response reflect(Vec3 n, Vec3 wo, Vec3 wi,
                                           SurfaceColours& colours) const = 0;

    /// To light from wi behind the surface, n.wi < 0. Opaque surfaces give nothing.
    [[nodiscard]] virtual Response transmit(Vec3 /*n*/, Vec3 /*wo*/, Vec3 /*wi*/,
                                            const Boundary& /*boundary*/,
                                            SurfaceColours& /*colours*/) const {
        return {};
    }

    /// Draws wi, in proportion to what reflect() gives or nearly so, from `u`, uniform on [0, 1)^2.
    /// What the mirrored ray brings, where one is followed, is left out. Empty: nothing is
    /// reflected, or wi fell below the surface.
    [[nodiscard]] virtual std::optional<DirectionSample> sample(Vec3 n, Vec3 wo, Vec2 u,
                                                                SurfaceColours& colours) const = 0;

    /// Of what comes along the mirrored and the refracted ray, by the cosine between wo and n.
    [[nodiscard]] virtual Shares shares(Real cosine, const Boundary& boundary,
                                        SurfaceColours& colours) const = 0;

    /// The surface's own colour in light from everywhere: for a constant ambient term.
    [[nodiscard]] virtual Response ambient(SurfaceColours& colours) const = 0;
};

}  // namespace bouguer::renderer
