// SPDX-License-Identifier: Apache-2.0
#include "api/mesh_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "api/asset_reader.h"
#include "renderer/geometry/mesh_file.h"

namespace bouguer::api {
namespace {

using renderer::TriangleMesh;
using renderer::Vec2;
using renderer::Vec3;

/// The mesh; a refusal is reported at `value`.
std::optional<renderer::Shape> accept(const JsonValue& value,
                                      const Result<std::shared_ptr<const TriangleMesh>>& mesh) {
    if (mesh) return *mesh;
    value.problems().add_below(value.pointer(), mesh.error());
    return std::nullopt;
}

/// Whether a row is `size` coordinates. Meshes are large: the row's place is worked out only on
/// failure.
bool is_row(std::span<const double> row, std::size_t size) {
    return row.size() == size &&
           std::all_of(row.begin(), row.end(), [](double x) { return kCoordinate.contains(x); });
}

/// The rows of [[a, b, c], ...], each made into a T by `make`; empty after a report.
template <class T, class Make>
std::optional<std::vector<T>> read_rows(const JsonValue& value, std::size_t size, std::size_t max,
                                        std::string_view of, const Make& make) {
    if (!value.is_array(0, max, of)) return std::nullopt;
    std::vector<T> rows;
    rows.reserve(value.json().size());
    for (std::size_t i = 0; i < value.json().size(); ++i) {
        const auto row = value.json()[i].packed_numbers();
        if (is_row(row, size)) {
            rows.push_back(make(row));
            continue;
        }
        // Slowly again, for the pointer of what is wrong.
        const JsonValue at = value.element(i);
        if (!at.is_tuple(size, "numbers")) continue;
        for (std::size_t k = 0; k < size; ++k) {
            static_cast<void>(at.element(k).number(kCoordinate));
        }
    }
    if (rows.size() < value.json().size()) return std::nullopt;
    return rows;
}

Vec3 make_vec3(std::span<const double> row) { return {row[0], row[1], row[2]}; }

Vec2 make_vec2(std::span<const double> row) { return {row[0], row[1]}; }

using Triangle = std::array<std::uint32_t, 3>;

/// Three whole numbers below `vertices`, as nearly all triangles of a document are.
std::optional<Triangle> plain_triangle(std::span<const double> row, std::size_t vertices) {
    if (row.size() != 3) return std::nullopt;
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double most = std::min(static_cast<double>(vertices), 0x1p32);
        if (!(row[k] >= 0 && row[k] < most && std::trunc(row[k]) == row[k])) return std::nullopt;
        corners[k] = static_cast<std::uint32_t>(row[k]);
    }
    return corners;
}

/// Any triangle; reports what is wrong with it.
std::optional<Triangle> checked_triangle(const JsonValue& value, std::size_t vertices) {
    if (!value.is_tuple(3, "vertex indices")) return std::nullopt;
    Triangle corners{};
    bool is_good = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const JsonValue corner = value.element(k);
        const auto index = corner.integer(INT64_MIN, INT64_MAX);
        const bool is_vertex =
            index && *index >= 0 && static_cast<std::uint64_t>(*index) < vertices;
        if (index && !is_vertex) {
            corner.report("index-out-of-range", "the mesh has no such vertex",
                          "an index below the number of positions, " + std::to_string(vertices));
        }
        is_good = is_good && is_vertex;
        corners[k] = is_vertex ? static_cast<std::uint32_t>(*index) : 0;
    }
    return is_good ? std::optional(corners) : std::nullopt;
}

std::optional<std::vector<Triangle>> read_triangles(const JsonValue& value, std::size_t max,
                                                    std::size_t vertices) {
    if (!value.is_array(1, max, "triangles")) return std::nullopt;
    std::vector<Triangle> triangles;
    triangles.reserve(value.json().size());
    for (std::size_t i = 0; i < value.json().size(); ++i) {
        auto corners = plain_triangle(value.json()[i].packed_numbers(), vertices);
        if (!corners) corners = checked_triangle(value.element(i), vertices);
        if (corners) triangles.push_back(*corners);
    }
    if (triangles.size() < value.json().size()) return std::nullopt;
    return triangles;
}

/// A list with one entry a position, when it is there; `is_good` becomes false after a report.
template <class T, class Make>
std::vector<T> read_per_vertex(const std::optional<JsonValue>& value, std::size_t size,
                               const std::optional<std::vector<Vec3>>& positions, bool& is_good,
                               const Make& make) {
    if (!value) return {};
    auto rows = read_rows<T>(*value, size, SIZE_MAX, "rows of numbers", make);
    if (rows && positions && rows->size() != positions->size()) {
        value->report("length-mismatch", "there must be one entry for every position",
                      std::to_string(positions->size()) + " entries");
        rows.reset();
    }
    is_good = is_good && rows;
    return std::move(rows).value_or(std::vector<T>{});
}

}  // namespace

std::optional<renderer::Shape> read_mesh_shape(JsonReader& reader, const ReadContext& context) {
    const Limits& limits = context.limits;
    const auto positions_at = reader.require("positions");
    const auto triangles_at = reader.require("triangles");
    std::optional<std::vector<Vec3>> positions;
    if (positions_at) {
        positions = read_rows<Vec3>(*positions_at, 3, limits.mesh_vertices, "positions", make_vec3);
    }
    bool is_good = true;
    TriangleMesh mesh;
    mesh.normals = read_per_vertex<Vec3>(reader.find("normals"), 3, positions, is_good, make_vec3);
    mesh.uvs = read_per_vertex<Vec2>(reader.find("uvs"), 2, positions, is_good, make_vec2);
    // Without positions that could be read, indices are judged by their type alone.
    auto triangles = triangles_at ? read_triangles(*triangles_at, limits.mesh_triangles,
                                                   positions ? positions->size() : SIZE_MAX)
                                  : std::nullopt;
    if (!positions || !triangles || !is_good) return std::nullopt;
    mesh.positions = std::move(*positions);
    mesh.triangles = std::move(*triangles);
    return accept(*triangles_at, renderer::checked_mesh(std::move(mesh)));
}

std::optional<renderer::Shape> read_file_shape(JsonReader& reader, const ReadContext& context) {
    const auto asset = require_asset(reader, context.limits);
    if (!asset) return std::nullopt;
    const auto mesh = context.assets.mesh(asset->name);
    if (mesh) return *mesh;
    report_asset(*asset, mesh.error(), "bad-mesh", "a PLY or OBJ file");
    return std::nullopt;
}

}  // namespace bouguer::api
