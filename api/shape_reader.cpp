// SPDX-License-Identifier: Apache-2.0
#include "api/shape_reader.h"

#include <array>
#include <string_view>

#include "api/json_reader.h"
#include "api/mesh_reader.h"

namespace bouguer::api {
namespace {

using renderer::Shape;
using renderer::Vec3;
using MaybeShape = std::optional<Shape>;

std::optional<Vec3> require_direction(JsonReader& reader, std::string_view key) {
    const auto member = reader.require(key);
    return member ? member->direction() : std::nullopt;
}

/// sphere: center [x, y, z], radius > 0.
MaybeShape read_sphere(JsonReader& reader, const ReadContext& /*context*/) {
    const auto center = reader.require_vec3("center");
    const auto radius = reader.require_number("radius", kPositiveLength);
    if (!center || !radius) return std::nullopt;
    return renderer::Sphere{*center, *radius};
}

/// plane, infinite: point, normal (any length but zero).
MaybeShape read_plane(JsonReader& reader, const ReadContext& /*context*/) {
    const auto point = reader.require_vec3("point");
    const auto normal = require_direction(reader, "normal");
    if (!point || !normal) return std::nullopt;
    return renderer::Plane{*point, *normal};
}

/// disk: center, normal, radius > 0.
MaybeShape read_disk(JsonReader& reader, const ReadContext& /*context*/) {
    const auto center = reader.require_vec3("center");
    const auto normal = require_direction(reader, "normal");
    const auto radius = reader.require_number("radius", kPositiveLength);
    if (!center || !normal || !radius) return std::nullopt;
    return renderer::Disk{*center, *normal, *radius};
}

/// box, axis-parallel: min, max; every component of min below that of max.
MaybeShape read_box(JsonReader& reader, const ReadContext& /*context*/) {
    const auto min = reader.require_vec3("min");
    const auto max = reader.require_vec3("max");
    if (!min || !max) return std::nullopt;
    if (min->x < max->x && min->y < max->y && min->z < max->z) return renderer::Box{*min, *max};
    reader.find("max")->report("degenerate", "the box is flat or inside out",
                               "every number above that of \"min\"");
    return std::nullopt;
}

/// cylinder, closed: from, to (not the same), radius > 0.
MaybeShape read_cylinder(JsonReader& reader, const ReadContext& /*context*/) {
    const auto from = reader.require_vec3("from");
    const auto to = reader.require_vec3("to");
    const auto radius = reader.require_number("radius", kPositiveLength);
    if (!from || !to || !radius) return std::nullopt;
    if (renderer::length(*to - *from) > 0) return renderer::Cylinder{*from, *to, *radius};
    reader.find("to")->report("degenerate", "the cylinder has no length",
                              "a point other than \"from\"");
    return std::nullopt;
}

struct ShapeType {
    std::string_view name;
    MaybeShape (*read)(JsonReader&, const ReadContext&);
};

/// To add a shape, write its function and its line here.
constexpr std::array kShapes{
    ShapeType{"sphere", &read_sphere},     ShapeType{"plane", &read_plane},
    ShapeType{"disk", &read_disk},         ShapeType{"box", &read_box},
    ShapeType{"cylinder", &read_cylinder}, ShapeType{"mesh", &read_mesh_shape},
    ShapeType{"file", &read_file_shape},
};

}  // namespace

MaybeShape read_shape(const JsonValue& value, const ReadContext& context) {
    JsonReader reader(value);
    const ShapeType* type = find_type(reader, kShapes);
    if (type == nullptr) return std::nullopt;
    auto shape = type->read(reader, context);
    reader.reject_unknown_keys();
    return shape;
}

}  // namespace bouguer::api
