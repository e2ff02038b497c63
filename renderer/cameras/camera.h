// SPDX-License-Identifier: Apache-2.0
// From a place on the film to a ray: perspective and orthographic cameras.
#pragma once

#include "renderer/core/result.h"
#include "renderer/core/vec3.h"
#include "renderer/scene/description.h"

namespace bouguer::renderer {

/// A small value; copy it at will. Thread-safe.
///
/// One formula serves both kinds: over the film the origin of rays moves (orthographic) or their
/// direction turns (perspective), and the other stays.
class Camera {
  public:
    /// `origin` is Geometry::origin(): rays come out relative to it, subtracted in double.
    /// Error{InvalidInput} with pointers below the camera: /from (where `at` is, or not finite),
    /// /up (along the view, zero or not finite), /fov_deg, /height.
    [[nodiscard]] static Result<Camera> create(const CameraDescription& description,
                                               Resolution resolution, Vec3 origin);

    /// The ray through a point of the film in pixels: (0, 0) is the upper left corner of the
    /// picture, (width, height) the lower right one; pixel (column, row) has its middle at
    /// (column + 0.5, row + 0.5). Points outside give rays too.
    [[nodiscard]] Ray generate(Vec2 film) const {
        return {corner_ + film.x * step_x_ + film.y * step_y_,
                normalize(direction_ + film.x * turn_x_ + film.y * turn_y_)};
    }

  private:
    Camera() = default;

    Vec3 corner_, step_x_, step_y_;     ///< of the origins: at film (0, 0), and a pixel further
    Vec3 direction_, turn_x_, turn_y_;  ///< of the directions, not normalised
};

}  // namespace bouguer::renderer
