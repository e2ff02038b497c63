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
Real condition(const Transform& m) {
    const auto inverse = m.inverse();
    if (!inverse) return 1;
    Real worst = 1;
    for (int i = 0; i < 3; ++i) {
        const Vec3 column{m.a[0][i], m.a[1][i], m.a[2][i]};
        worst = std::max(worst, length(column) * length(inverse->a[static_cast<std::size_t>(i)]));
    }
    return worst;
}

Vec3 interpolate(const std::vector<Vec3>& values, const std::array<std::uint32_t, 3>& corners,
                 Real u, Real v) {
    return (1 - u - v) * values[corners[0]] + u * values[corners[1]] + v * values[corners[2]];
}

}  // namespace

VertexBuffer make_vertex_buffer(const TriangleMesh& mesh, const Transform& transform) {
    VertexBuffer buffer;
    buffer.xyz.reserve(3 * mesh.positions.size() + 1);
    for (const Vec3& position : mesh.positions) {
        const Vec3 p = transform.point(position);
        for (const Real x : {p.x, p.y, p.z}) buffer.xyz.push_back(static_cast<float>(x));
    }
    buffer.xyz.push_back(0);
    return buffer;
}

MeshPart::MeshPart(std::shared_ptr<const TriangleMesh> mesh,
                   std::shared_ptr<const VertexBuffer> buffer, std::optional<Transform> from_buffer,
                   Real scale, const Transform& to_scene)
    : mesh_(std::move(mesh)),
      buffer_(std::move(buffer)),
      from_buffer_(from_buffer),
      scale_(scale),
      rounding_(from_buffer ? kInstanceRounding * condition(*from_buffer) : kRounding),
      outwards_(to_scene.determinant() < 0 ? -1 : 1),
      to_mesh_(to_scene.inverse().value_or(Transform{})) {}

bool MeshPart::refine(const Ray& ray, const TriangleHit& at, Hit& hit) const {
    const auto& corners = mesh_->triangles[at.primitive];
    Vec3 a = buffer_->vertex(corners[0]);
    Vec3 b = buffer_->vertex(corners[1]);
    Vec3 c = buffer_->vertex(corners[2]);
    if (from_buffer_) {
        a = from_buffer_->point(a);
        b = from_buffer_->point(b);
        c = from_buffer_->point(c);
    } else {
        a = scale_ * a;
        b = scale_ * b;
        c = scale_ * c;
    }
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 n = cross(ab, ac);
    const Real extent = max_abs(ab) + max_abs(ac);

    Real t = dot(a - ray.o, n) / dot(ray.d, n);
    hit.p = ray.at(t);
    // Nearly in the triangle's plane the quotient means little; the place in the triangle still
    // does.
    if (!(std::abs(t - at.t) <= 1e-3 * (at.t + extent))) {
        hit.p = a + static_cast<Real>(at.u) * ab + static_cast<Real>(at.v) * ac;
        t = dot(hit.p - ray.o, ray.d);
    }
    if (!(t > 0)) return false;
    hit.t = t;
    hit.ng = (outwards_ / length(n)) * n;
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
