// SPDX-License-Identifier: Apache-2.0
#include "api/camera_reader.h"

#include <array>
#include <string_view>

#include "api/json_reader.h"

namespace bouguer::api {
namespace {

using renderer::Vec3;
using MaybeCamera = std::optional<renderer::CameraDescription>;

constexpr Interval kFov_deg{0, 180, true, true};

/// Where a camera stands and looks, for both types.
struct View {
    Vec3 from, at, up;
};

/// from, at (not the same), up (not along the view; default [0, 1, 0]).
std::optional<View> read_view(JsonReader& reader) {
    const auto from = reader.require_vec3("from");
    const auto at = reader.require_vec3("at");
    const auto up_at = reader.find("up");
    const auto up = up_at ? up_at->direction() : Vec3{0, 1, 0};
    if (!from || !at || !up) return std::nullopt;
    const Vec3 look = *at - *from;
    if (!(renderer::length(look) > 0)) {
        reader.find("at")->report("degenerate", "the camera looks nowhere",
                                  "a point other than \"from\"");
        return std::nullopt;
    }
    constexpr double kLeastSine = 1e-9;
    const double sine =
        renderer::length(renderer::cross(renderer::normalize(look), renderer::normalize(*up)));
    if (sine > kLeastSine) return View{*from, *at, *up};
    const JsonValue& where = up_at ? *up_at : reader.value();
    where.report("degenerate", "\"up\" is along the line of sight",
                 "a direction that is not that from \"from\" to \"at\"");
    return std::nullopt;
}

/// perspective: the view and fov_deg, the full vertical angle, in (0, 180), default 40.
MaybeCamera read_perspective(JsonReader& reader) {
    const auto view = read_view(reader);
    const double fov_deg =
        reader.number("fov_deg", kFov_deg, renderer::PerspectiveCamera{}.fov_deg);
    if (!view) return std::nullopt;
    return renderer::PerspectiveCamera{view->from, view->at, view->up, fov_deg};
}

/// orthographic: the view and height, what the picture's height shows, in scene units.
MaybeCamera read_orthographic(JsonReader& reader) {
    const auto view = read_view(reader);
    const auto height = reader.require_number("height", kPositiveLength);
    if (!view || !height) return std::nullopt;
    return renderer::OrthographicCamera{view->from, view->at, view->up, *height};
}

struct CameraType {
    std::string_view name;
    MaybeCamera (*read)(JsonReader&);
};

/// To add a camera, write its function and its line here.
constexpr std::array kCameras{
    CameraType{"perspective", &read_perspective},
    CameraType{"orthographic", &read_orthographic},
};

}  // namespace

std::optional<renderer::Resolution> read_resolution(const JsonValue& value, const Limits& limits) {
    if (!value.is_tuple(2, "numbers")) return std::nullopt;
    const auto width = value.element(0).integer(1, limits.resolution, true);
    const auto height = value.element(1).integer(1, limits.resolution, true);
    if (!width || !height) return std::nullopt;
    if (*width * *height <= limits.pixels) {
        return renderer::Resolution{static_cast<int>(*width), static_cast<int>(*height)};
    }
    value.problems().add({value.pointer(), "over-limit", "the picture has too many pixels",
                          std::to_string(*width * *height) + " pixels",
                          "at most " + std::to_string(limits.pixels) + " pixels"});
    return std::nullopt;
}

std::optional<ReadCamera> read_camera(const JsonValue& value, const Limits& limits) {
    JsonReader reader(value);
    const CameraType* type = find_type(reader, kCameras);
    if (type == nullptr) return std::nullopt;
    const auto camera = type->read(reader);
    std::optional<renderer::Resolution> resolution = renderer::Resolution{};
    if (const auto at = reader.find("resolution")) resolution = read_resolution(*at, limits);
    reader.reject_unknown_keys();
    if (!camera || !resolution) return std::nullopt;
    return ReadCamera{*camera, *resolution};
}

}  // namespace bouguer::api
