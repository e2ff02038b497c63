// SPDX-License-Identifier: Apache-2.0
#include "renderer/cameras/camera.h"

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace bouguer::renderer {
namespace {

/// A smaller sine between the view and `up`, or a shorter relative way from `from` to `at`, leaves
/// no digits to tell where the camera looks.
constexpr Real kMinSine = 1e-9;
constexpr Real kMinDistance = 1e-12;

/// Where the camera looks and what is right and up in the picture: unit, perpendicular.
struct View {
    Vec3 forward, right, up;
};

void check_view(Vec3 from, Vec3 at, Vec3 up, std::vector<Problem>& problems) {
    const Vec3 way = at - from;
    if (!is_finite(way) || !(length(way) > kMinDistance * std::max(max_abs(from), max_abs(at)))) {
        problems.push_back({"/from", "degenerate", "the camera stands where it looks at", "",
                            R"(a point away from "at")"});
        return;
    }
    if (!is_finite(up) || !(length(cross(way, up)) > kMinSine * length(way) * length(up))) {
        problems.push_back({"/up", "degenerate", "up is along the line of sight", "",
                            R"(a direction across the line from "from" to "at")"});
    }
}

View view_of(Vec3 from, Vec3 at, Vec3 up) {
    const Vec3 forward = normalize(at - from);
    const Vec3 right = normalize(cross(forward, normalize(up)));
    return {forward, right, cross(right, forward)};
}

}  // namespace

Result<Camera> Camera::create(const CameraDescription& description, Resolution resolution,
                              Vec3 origin) {
    std::vector<Problem> problems;
    std::visit([&](const auto& c) { check_view(c.from, c.at, c.up, problems); }, description);
    const auto* perspective = std::get_if<PerspectiveCamera>(&description);
    const auto* orthographic = std::get_if<OrthographicCamera>(&description);
    if (perspective && !(perspective->fov_deg > 0 && perspective->fov_deg < 180)) {
        problems.push_back(
            {"/fov_deg", "out-of-range", "no such angle of view", "", "a number in (0, 180)"});
    }
    if (orthographic && !(orthographic->height > 0 && std::isfinite(orthographic->height))) {
        problems.push_back(
            {"/height", "out-of-range", "the picture shows nothing", "", "a number above 0"});
    }
    if (!problems.empty()) {
        return tl::unexpected<Error>(Error{ErrorKind::InvalidInput, "the camera cannot see",
                                           std::move(problems), "bad-camera"});
    }

    Camera camera;
    const Real half_width = 0.5 * resolution.width;
    const Real half_height = 0.5 * resolution.height;
    if (perspective) {
        const View view = view_of(perspective->from, perspective->at, perspective->up);
        const Real pixel = std::tan(0.5 * degrees_to_radians(perspective->fov_deg)) / half_height;
        camera.corner_ = perspective->from - origin;
        camera.turn_x_ = pixel * view.right;
        camera.turn_y_ = -pixel * view.up;
        camera.direction_ =
            view.forward - half_width * camera.turn_x_ - half_height * camera.turn_y_;
    } else {
        const View view = view_of(orthographic->from, orthographic->at, orthographic->up);
        const Real pixel = orthographic->height / resolution.height;
        camera.direction_ = view.forward;
        camera.step_x_ = pixel * view.right;
        camera.step_y_ = -pixel * view.up;
        camera.corner_ = orthographic->from - origin - half_width * camera.step_x_ -
                         half_height * camera.step_y_;
    }
    return camera;
}

}  // namespace bouguer::renderer
