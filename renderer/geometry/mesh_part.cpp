// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_part.h"

#include <cmath>
#include <utility>

namespace bouguer::renderer {
namespace {

/// Roundings of the ray's origin and of the vertices relative to it, and of a normal: eight units
/// in the last place of single precision; two are the least with which tests find no ray that meets
/// its own triangle again. Instances add a transform that Embree inverts in single precision.
constexpr Real kRounding = 0x1p-21;
constexpr Real kInstanceRounding = 0x1p-19;

/// How much a transform and its inverse amplify rounding, >= 1: 1 for turns and scales.
Real condition(const Transform& m, const Transform& inverse) {
    Real worst = 1;
    for (int i = 0; i < 3; ++i) {
        const Vec3 column{m.a[0][i], m.a[1][i], m.a[2][i]};
        worst = std::max(worst, length(column) * length(inverse.a[static_cast<std::size_t>(i)]));
    }
    return worst;
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
    : scale(over) {
    xyz.reserve(3 * mesh.positions.size() + 1);
    for (const Vec3& position : mesh.positions) {
        const Vec3 p = transform.point(position) / scale;
        for (const Real x : {p.x, p.y, p.z}) xyz.push_back(static_cast<float>(x));
    }
    xyz.push_back(0);
    planes.reserve(mesh.triangles.size());
    const bool mirrored = transform.determinant() < 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        planes.push_back(mirrored ? plane_of(vertex(a), vertex(c), vertex(b))
                                  : plane_of(vertex(a), vertex(b), vertex(c)));
    }
}

Vec3 MeshBuffer::vertex(std::uint32_t i) const {
    const float* p = &xyz[3 * std::size_t{i}];
    return scale * Vec3{p[0], p[1], p[2]};
}

std::uint64_t MeshBuffer::bytes() const {
    return xyz.capacity() * sizeof(float) + planes.capacity() * sizeof(TrianglePlane);
}

MeshPart::MeshPart(std::shared_ptr<const TriangleMesh> mesh,
                   std::shared_ptr<const MeshBuffer> buffer, const Transform& to_scene)
    : mesh_(std::move(mesh)),
      buffer_(std::move(buffer)),
      rounding_(kRounding),
      to_mesh_(to_scene.inverse().value_or(Transform{})) {}

MeshPart::MeshPart(std::shared_ptr<const TriangleMesh> mesh,
                   std::shared_ptr<const MeshBuffer> buffer, const Transform& to_scene,
                   const Transform& from_buffer)
    : MeshPart(std::move(mesh), std::move(buffer), to_scene) {
    const Transform to_buffer = from_buffer.inverse().value_or(Transform{});
    const Real size =
        std::max({length(from_buffer.a[0]), length(from_buffer.a[1]), length(from_buffer.a[2])});
    instance_ = std::make_unique<const Instance>(Instance{from_buffer, to_buffer, size});
    rounding_ = kInstanceRounding * condition(from_buffer, to_buffer);
}

Vec3 MeshPart::point_in(const TriangleHit& at) const {
    const auto& corners = mesh_->triangles[at.primitive];
    const Vec3 a = buffer_->vertex(corners[0]);
    const Vec3 p = a + static_cast<Real>(at.u) * (buffer_->vertex(corners[1]) - a) +
                   static_cast<Real>(at.v) * (buffer_->vertex(corners[2]) - a);
    return instance_ ? instance_->from_buffer.point(p) : p;
}

bool MeshPart::refine(const Ray& ray, const TriangleHit& at, Hit& hit) const {
    const TrianglePlane& plane = buffer_->planes[at.primitive];
    Real extent = static_cast<Real>(plane.extent);
    Real t = 0;
    if (instance_) {
        const Transform& to_buffer = instance_->to_buffer;
        t = (plane.offset - dot(plane.n, to_buffer.point(ray.o))) /
            dot(plane.n, to_buffer.direction(ray.d));
        hit.ng = normalize(to_buffer.transposed(plane.n));
        extent *= instance_->size;
    } else {
        t = (plane.offset - dot(plane.n, ray.o)) / dot(plane.n, ray.d);
        hit.ng = plane.n;
    }
    hit.p = ray.at(t);
    // Nearly in the triangle's plane the quotient means little; the place in the triangle still
    // does.
    if (!(std::abs(t - at.t) <= 1e-3 * (at.t + extent))) {
        hit.p = point_in(at);
        t = dot(hit.p - ray.o, ray.d);
    }
    if (!(t > 0)) return false;
    hit.t = t;
    hit.ns = hit.ng;
    hit.error = rounding_ * (max_abs(hit.p) + extent);
    hit.u = at.u;
    hit.v = at.v;
    hit.primitive = at.primitive;
    return true;
}

void MeshPart::shade(Hit& hit) const {
    if (mesh_->normals.empty()) return;
    const Vec3 n = to_mesh_.transposed(
        interpolate(mesh_->normals, mesh_->triangles[hit.primitive], hit.u, hit.v));
    const Real squared = dot(n, n);
    if (!(squared > 0)) return;
    hit.ns = (std::copysign(Real(1), dot(n, hit.ng)) / std::sqrt(squared)) * n;
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
