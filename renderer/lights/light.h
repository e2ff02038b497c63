// SPDX-License-Identifier: Apache-2.0
// Lamps without extent: what arrives from them at a point.
#pragma once

#include <limits>

#include "renderer/core/vec3.h"
#include "renderer/scene/description.h"

namespace bouguer::renderer {

/// What a lamp sends to a point, before anything stands in between.
struct LightSample {
    Vec3 wi;            ///< unit, to the lamp
    Real distance = 0;  ///< scene units; infinite for directional lamps
    Real scale = 0;     ///< irradiance on a surface that faces the lamp is scale * the lamp's
                        ///< spectrum, W m^-2 nm^-1
};

/// A lamp where it stands, its coordinates relative to the geometry's origin. A small value: one
/// branch, no virtual call.
class Light {
  public:
    /// `metres_per_unit` turns distances to metres.
    static Light make(const LightDescription& description, Vec3 origin, Real metres_per_unit);

    /// Light arriving at `p`. At the lamp's own position nothing arrives: scale is 0.
    [[nodiscard]] LightSample sample(Vec3 p) const {
        if (is_directional_) return {vector_, std::numeric_limits<Real>::infinity(), 1};
        const Vec3 to_light = vector_ - p;
        const Real squared = dot(to_light, to_light);
        if (squared == 0) return {};
        const Real distance = std::sqrt(squared);
        return {to_light / distance, distance, inverse_square_ / squared};
    }

    [[nodiscard]] const SpectrumPtr& spectrum() const { return spectrum_; }

  private:
    Vec3 vector_;  ///< position, or the unit direction to the lamp
    Real inverse_square_ = 1;
    bool is_directional_ = false;
    SpectrumPtr spectrum_;
};

}  // namespace bouguer::renderer
