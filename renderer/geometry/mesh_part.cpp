// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_part.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bouguer::renderer {
namespace {

/// Roundings of the ray's origin and of the vertices relative to it, and of a normal: eight units
/// in the last place of single precision; two are the least with which tests find no ray that meets
/// its own triangle again.
constexpr Real kRounding = 0x1p-21;
/// Half a unit in the last place of single precision, in which most mesh files are written: two
/// meshes that share a face agree on where it is only to about this, of their size.
constexpr Real kFileRounding = 0x1p-25;
/// Coordinates in a buffer of its own lie about zero and reach less than this.
constexpr Real kBufferReach = 2;

/// How much a transform and its inverse amplify rounding, >= 1: 1 for turns and scales.
Real condition(const Transform& m, const Transform& inverse) {
    Real worst = 1;
    for (int i = 0; i < 3; ++i) {
        const Vec3 column{m.a[0][i], m.a[1][i], m.a[2][i]};
        worst = std::max(worst, length(column) * length(inverse.a[static_cast<std::size_t>(i)]));
    }
    return worst;
}

/// Of a triangle that is met edge-on, single precision may say anything, numbers or not.
TriangleHit inside(TriangleHit at) {
    at.u = at.u > 0 ? std::min(at.u, 1.0F) : 0;
    at.v = at.v > 0 ? std::min(at.v, 1 - at.u) : 0;
    return at;
}

TrianglePlane plane_of(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 n = cross(ab, ac);
    const Real size = length(n);
    TrianglePlane plane;
    plane.n = size > 0 ? n / size : Vec3{0, 0, 1};  // rays do not meet what rounding made flat
    plane.offset = dot(plane.n, a);
    plane.extent = static_cast<float>(max_abs(ab) + max_abs(ac));
    return plane;
}

Vec3 interpolate(const std::vector<Vec3>& values, const std::array<std::uint32_t, 3>& corners,
                 Real u, Real v) {
    return (1 - u - v) * values[corners[0]] + u * values[corners[1]] + v * values[corners[2]];
}

}  // namespace

MeshBuffer::MeshBuffer(const TriangleMesh& mesh, const Transform& transform, Real over)
    : occupancy(mesh), scale(over) {
    xyz.reserve(3 * mesh.positions.size() + 1);
    for (const Vec3& position : mesh.positions) {
        const Vec3 p = transform.point(position) / scale;
        for (const Real x : {p.x, p.y, p.z}) xyz.push_back(static_cast<float>(x));
    }
    xyz.push_back(0);
    planes.reserve(mesh.triangles.size());
    const bool mirrored = transform.determinant() < 0;
    const auto exact = [&](std::uint32_t i) { return transform.point(mesh.positions[i]); };
    for (const auto& [a, b, c] : mesh.triangles) {
        planes.push_back(mirrored ? plane_of(exact(a), exact(c), exact(b))
                                  : plane_of(exact(a), exact(b), exact(c)));
    }
}

Vec3 MeshBuffer::vertex(std::uint32_t i) const {
    const float* p = &xyz[3 * std::size_t{i}];
    return scale * Vec3{p[0], p[1], p[2]};
}

std::uint64_t MeshBuffer::bytes() const {
    return xyz.capacity() * sizeof(float) + planes.capacity() * sizeof(TrianglePlane) +
           occupancy.bytes();
}

MeshPart::MeshPart(std::shared_ptr<const TriangleMesh> mesh,
                   std::shared_ptr<const MeshBuffer> buffer, const Transform& to_scene, Vec3 origin)
    : mesh_(std::move(mesh)),
      buffer_(std::move(buffer)),
      to_scene_(to_scene),
      to_mesh_(to_scene.inverse().value_or(Transform{})) {
    Bounds bounds;
    for (const Vec3& p : mesh_->positions) bounds.add(p);
    const Transform to_world = Transform::translate(origin) * to_scene;
    resolution_ =
        to_world.rounding(max_abs(max(bounds.hi, -bounds.lo))) +
        kFileRounding * max_abs(bounds.half_size()) *
            std::max({length(to_scene.a[0]), length(to_scene.a[1]), length(to_scene.a[2])});
}

MeshPart::MeshPart(std::shared_ptr<const TriangleMesh> mesh,
                   std::shared_ptr<const MeshBuffer> buffer, const Transform& to_scene, Vec3 origin,
                   const Transform& from_buffer)
    : MeshPart(std::move(mesh), std::move(buffer), to_scene, origin) {
    const Transform to_buffer = from_buffer.inverse().value_or(Transform{});
    const Real size =
        std::max({length(from_buffer.a[0]), length(from_buffer.a[1]), length(from_buffer.a[2])});
    own_ = std::make_unique<const OwnCoordinates>(
        OwnCoordinates{from_buffer, to_buffer, size * condition(from_buffer, to_buffer)});
}

Real MeshPart::worst_error(Real size) const {
    Real extent = 0;
    for (const TrianglePlane& plane : buffer_->planes) {
        extent = std::max(extent, static_cast<Real>(plane.extent));
    }
    return kRounding * (own_ ? own_->size * (kBufferReach + extent) : size + extent);
}

bool MeshPart::touches(Vec3 p, Real reach) const {
    const Real growth =
        std::max({length(to_mesh_.a[0]), length(to_mesh_.a[1]), length(to_mesh_.a[2])});
    return buffer_->occupancy.is_near(to_mesh_.point(p), 2 * growth * reach);
}

Vec3 MeshPart::middle_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_->triangles[triangle];
    const auto& at = mesh_->positions;
    return to_scene_.point(1.0 / 3 * (at[a] + at[b] + at[c]));
}

Vec3 MeshPart::point_in(const TriangleHit& at) const {
    const auto& corners = mesh_->triangles[at.primitive];
    const Vec3 a = mesh_->positions[corners[0]];
    return to_scene_.point(a + static_cast<Real>(at.u) * (mesh_->positions[corners[1]] - a) +
                           static_cast<Real>(at.v) * (mesh_->positions[corners[2]] - a));
}

void MeshPart::refine(const Ray& ray, const TriangleHit& found, Hit& hit) const {
    constexpr Real kEdge = 4;  // errors
    const TriangleHit at = inside(found);
    const TrianglePlane& plane = buffer_->planes[at.primitive];
    Real extent = static_cast<Real>(plane.extent);
    if (own_) {
        const Vec3 o = own_->to_buffer.point(ray.o);
        const Vec3 d = own_->to_buffer.direction(ray.d);
        hit.t = (plane.offset - dot(plane.n, o)) / dot(plane.n, d);
        const Vec3 p = o + hit.t * d;
        hit.p = own_->from_buffer.point(p + (plane.offset - dot(plane.n, p)) * plane.n);
        hit.ng = normalize(own_->to_buffer.transposed(plane.n));
        extent *= own_->size;
    } else {
        hit.t = (plane.offset - dot(plane.n, ray.o)) / dot(plane.n, ray.d);
        const Vec3 p = ray.at(hit.t);
        hit.p = p + (plane.offset - dot(plane.n, p)) * plane.n;
        hit.ng = plane.n;
    }
    // Nearly in the triangle's plane the quotient means little; the place in the triangle still
    // does.
    if (!(std::abs(hit.t - at.t) <= 1e-3 * (std::abs(at.t) + extent))) {
        hit.p = point_in(at);
        hit.t = dot(hit.p - ray.o, ray.d);
    }
    hit.ns = hit.ng;
    hit.resolution = resolution_;
    const Real size = own_ ? own_->size * kBufferReach : max_abs(hit.p);
    hit.error = std::max(kRounding * (size + extent), resolution_);
    hit.u = at.u;
    hit.v = at.v;
    const float to_edge = std::min({at.u, at.v, 1 - at.u - at.v});
    hit.is_at_edge = static_cast<Real>(to_edge) * extent <= kEdge * hit.error;
    hit.primitive = at.primitive;
    hit.is_alone = false;
}

void MeshPart::shade(Hit& hit) const {
    if (mesh_->normals.empty()) return;
    const Vec3 n = to_mesh_.transposed(
        interpolate(mesh_->normals, mesh_->triangles[hit.primitive], hit.u, hit.v));
    const Real squared = dot(n, n);
    if (!(squared > 0)) return;
    hit.ns = (std::copysign(Real(1), dot(n, hit.ng)) / std::sqrt(squared)) * n;
}

Vec3 MeshPart::smooth_point(const Hit& hit) const {
    if (mesh_->normals.empty()) return hit.p;
    const auto& corners = mesh_->triangles[hit.primitive];
    const std::array<Real, 3> weights{1 - Real{hit.u} - Real{hit.v}, hit.u, hit.v};
    Vec3 lift;
    for (std::size_t i = 0; i < 3; ++i) {
        Vec3 n = normalize(to_mesh_.transposed(mesh_->normals[corners[i]]));
        if (dot(n, hit.ns) < 0) n = -n;
        const Vec3 corner = to_scene_.point(mesh_->positions[corners[i]]);
        // Over the tangent plane of each corner, as far as the facet lies below it.
        const Real below = std::min(Real{0}, dot(hit.p - corner, n));
        lift += -weights[i] * below * n;
    }
    return is_finite(lift) ? hit.p + lift : hit.p;
}

bool MeshPart::is_beside(const Hit& hit) const {
    std::array<Vec3, 3> corners;
    std::transform(mesh_->triangles[hit.primitive].begin(), mesh_->triangles[hit.primitive].end(),
                   corners.begin(),
                   [&](std::uint32_t i) { return to_scene_.point(mesh_->positions[i]); });
    const auto [a, b, c] = corners;
    const Vec3 n = cross(b - a, c - a);
    const auto is_left = [&](Vec3 from, Vec3 to) {
        return dot(cross(to - from, hit.p - from), n) >= 0;
    };
    return !(is_left(a, b) && is_left(b, c) && is_left(c, a));
}

bool MeshPart::share_corner(const Hit& a, const Hit& b) const {
    for (const std::uint32_t i : mesh_->triangles[a.primitive]) {
        for (const std::uint32_t j : mesh_->triangles[b.primitive]) {
            if (i == j || mesh_->positions[i] == mesh_->positions[j]) return true;
        }
    }
    return false;
}

Vec2 MeshPart::uv(const Hit& hit) const {
    if (mesh_->uvs.empty()) return {hit.u, hit.v};
    const auto& corners = mesh_->triangles[hit.primitive];
    const Vec2 a = mesh_->uvs[corners[0]];
    const Vec2 b = mesh_->uvs[corners[1]];
    const Vec2 c = mesh_->uvs[corners[2]];
    const Real u = hit.u;
    const Real v = hit.v;
    const Real w = 1 - u - v;
    return {w * a.x + u * b.x + v * c.x, w * a.y + u * b.y + v * c.y};
}

}  // namespace bouguer::renderer
