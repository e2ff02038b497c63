// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/analytic_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "renderer/geometry/surface_coordinates.h"

namespace bouguer::renderer {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/// The part of a line that lies inside a convex body; empty when near >= far.
struct Interval {
    Real near = -kInfinity, far = kInfinity;
    std::uint8_t near_part = 0, far_part = 0;

    void clip(Real a, Real b, std::uint8_t part) {
        if (a > near) {
            near = a;
            near_part = part;
        }
        if (b < far) {
            far = b;
            far_part = part;
        }
    }
    void clear() { far = -kInfinity; }

    [[nodiscard]] bool empty() const { return !(near < far); }
    [[nodiscard]] AnalyticHit in() const { return {near, CrossingRank::Enters, near_part}; }
    [[nodiscard]] AnalyticHit out() const { return {far, CrossingRank::Leaves, far_part}; }

    /// The first crossing in front of the ray's origin.
    [[nodiscard]] AnalyticHit first() const {
        if (empty() || !(far > 0)) return {};
        return near > 0 ? in() : out();
    }
};

/// Clips by |x| <= 1 along one axis.
void clip_slab(Interval& inside, Real lo, Real hi, Real o, Real d, std::uint8_t part) {
    if (d == 0) {
        if (o < lo || o > hi) inside.clear();
        return;
    }
    const Real a = (lo - o) / d;
    const Real b = (hi - o) / d;
    inside.clip(std::min(a, b), std::max(a, b), part);
}

/// Clips by |o + t d| <= 1, where o and d are projected to the space in which the body is round: a
/// = d.d, b = o.d, c = o.o - 1. The discriminant comes from the point of closest approach, which
/// keeps it exact for bodies that are small and far away [Haines et al., Ray Tracing Gems 2019,
/// ch. 7].
void clip_round(Interval& inside, Vec3 o, Vec3 d, std::uint8_t part) {
    const Real a = dot(d, d);
    const Real c = dot(o, o) - 1;
    if (a == 0) {
        if (c > 0) inside.clear();
        return;
    }
    const Real b = dot(o, d);
    const Vec3 closest = o - (b / a) * d;
    const Real discriminant = a * (1 - dot(closest, closest));
    if (!(discriminant > 0)) return inside.clear();
    // Of the two roots, the one whose terms have the same sign; the other from their product c / a.
    const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
    const Real r0 = q / a;
    const Real r1 = c / q;
    inside.clip(std::min(r0, r1), std::max(r0, r1), part);
}

/// Before or behind the ray's origin.
AnalyticHit cross_disk(Vec3 o, Vec3 d) {
    const Real t = -o.z / d.z;
    const Real x = o.x + t * d.x;
    const Real y = o.y + t * d.y;
    if (!std::isfinite(t) || !(x * x + y * y <= 1)) return {};
    return {t, CrossingRank::Open, 0};
}

/// The part of the line inside a unit shape that has an inside.
Interval inside_of(UnitShape kind, Vec3 o, Vec3 d) {
    Interval inside;
    if (kind == UnitShape::Sphere) {
        clip_round(inside, o, d, 0);
    } else if (kind == UnitShape::Box) {
        clip_slab(inside, -1, 1, o.x, d.x, 0);
        clip_slab(inside, -1, 1, o.y, d.y, 1);
        clip_slab(inside, -1, 1, o.z, d.z, 2);
    } else {
        clip_round(inside, {o.x, o.y, 0}, {d.x, d.y, 0}, 0);
        clip_slab(inside, 0, 1, o.z, d.z, 1);
    }
    return inside;
}

/// The point of the unit shape's surface nearest to `q`, on the given part, and the normal there,
/// outwards.
std::pair<Vec3, Vec3> on_surface(UnitShape kind, std::uint8_t part, Vec3 q) {
    switch (kind) {
        case UnitShape::Sphere: {
            const Vec3 n = normalize(q);
            return {n, n};
        }
        case UnitShape::Disk:
            return {{q.x, q.y, 0}, {0, 0, 1}};
        case UnitShape::Box: {
            const Real side = std::copysign(Real(1), q[part]);
            if (part == 0) return {{side, q.y, q.z}, {side, 0, 0}};
            if (part == 1) return {{q.x, side, q.z}, {0, side, 0}};
            return {{q.x, q.y, side}, {0, 0, side}};
        }
        case UnitShape::Cylinder:
            if (part == 1) {
                const bool top = q.z > 0.5;
                return {{q.x, q.y, top ? 1.0 : 0.0}, {0, 0, top ? 1.0 : -1.0}};
            }
            const Vec3 n = normalize({q.x, q.y, 0});
            return {{n.x, n.y, q.z}, n};
    }
    return {q, q};
}

/// Whether an edge is near `q`, which lies on the given part of the surface.
bool is_at_edge(UnitShape kind, std::uint8_t part, Vec3 q) {
    constexpr Real kNear = 1e-5;
    if (kind == UnitShape::Box) {
        const Real x = part == 0 ? 0 : std::abs(q.x);
        const Real y = part == 1 ? 0 : std::abs(q.y);
        const Real z = part == 2 ? 0 : std::abs(q.z);
        return std::max({x, y, z}) >= 1 - kNear;
    }
    if (kind != UnitShape::Cylinder) return false;
    if (part == 1) return q.x * q.x + q.y * q.y >= 1 - kNear;
    return q.z <= kNear || q.z >= 1 - kNear;
}

Vec3 column(const Transform& m, int i) { return {m.a[0][i], m.a[1][i], m.a[2][i]}; }

/// A unit shape that is scaled, turned and moved, and the way back. Both are put together from
/// their parts: a fibre a million times longer than thick is no trouble then.
struct Placement {
    UnitShape kind;
    Transform to_world;
    Transform to_unit;
    Vec2 bottom_u;
};

Placement place(UnitShape kind, Vec3 at, const Frame& frame, Vec3 scale) {
    Transform turned;
    turned.a = {Vec3{frame.x.x, frame.y.x, frame.z.x}, Vec3{frame.x.y, frame.y.y, frame.z.y},
                Vec3{frame.x.z, frame.y.z, frame.z.z}};
    Transform back;
    back.a = {frame.x, frame.y, frame.z};
    return {kind,
            Transform::translate(at) * turned * Transform::scale(scale),
            Transform::scale({1 / scale.x, 1 / scale.y, 1 / scale.z}) * back *
                Transform::translate(-at),
            {}};
}

/// The first axis of a disk that looks the other way as one that looks along frame.z, in the axes
/// of the latter.
Vec2 u_of_bottom(const Frame& frame) {
    const Vec3 u = upright_frame(-frame.z).x;
    return {dot(frame.x, u), dot(frame.y, u)};
}

const Frame kUpright{{0, 0, 1}};

struct Place {
    std::optional<Placement> operator()(const Sphere& s) const {
        return place(UnitShape::Sphere, s.center, kUpright, Vec3{1, 1, 1} * s.radius);
    }
    std::optional<Placement> operator()(const Disk& s) const {
        return place(UnitShape::Disk, s.center, upright_frame(normalize(s.normal)),
                     Vec3{1, 1, 1} * s.radius);
    }
    std::optional<Placement> operator()(const Box& s) const {
        const Bounds b{s.min, s.max};
        return place(UnitShape::Box, b.middle(), kUpright, b.half_size());
    }
    std::optional<Placement> operator()(const Cylinder& s) const {
        const Vec3 axis = s.to - s.from;
        const Frame frame = upright_frame(normalize(axis));
        Placement placement =
            place(UnitShape::Cylinder, s.from, frame, {s.radius, s.radius, length(axis)});
        placement.bottom_u = u_of_bottom(frame);
        return placement;
    }
    std::optional<Placement> operator()(const Plane& /*s*/) const { return std::nullopt; }
    std::optional<Placement> operator()(const std::shared_ptr<const TriangleMesh>& /*s*/) const {
        return std::nullopt;
    }
};

bool is_finite(const Transform& m) {
    return renderer::is_finite(m.a[0]) && renderer::is_finite(m.a[1]) &&
           renderer::is_finite(m.a[2]) && renderer::is_finite(m.t);
}

}  // namespace

std::optional<AnalyticShape> AnalyticShape::create(const Shape& shape, const Transform& instance) {
    const auto placement = std::visit(Place{}, shape);
    const auto inverse = instance.inverse();
    if (!placement || !inverse) return std::nullopt;
    AnalyticShape result;
    result.kind_ = placement->kind;
    result.bottom_u_ = placement->bottom_u;
    result.to_scene_ = instance * placement->to_world;
    result.to_unit_ = placement->to_unit * *inverse;
    if (!is_finite(result.to_scene_) || !is_finite(result.to_unit_)) return std::nullopt;
    Real reach = max_abs(placement->to_world.t);
    for (int i = 0; i < 3; ++i) {
        reach += length(column(placement->to_world, i));
        const Real axis = length(column(result.to_scene_, i));
        const Real inverse_axis = length(result.to_unit_.a[static_cast<std::size_t>(i)]);
        result.size_ = std::max(result.size_, axis);
        result.thinnest_ = i == 0 ? axis : std::min(result.thinnest_, axis);
        result.condition_ = std::max(result.condition_, axis * inverse_axis);
    }
    result.placing_ = instance.rounding(reach);
    if (result.kind_ == UnitShape::Disk) result.thinnest_ = 0;
    result.growth_ = std::sqrt(dot(result.to_unit_.a[0], result.to_unit_.a[0]) +
                               dot(result.to_unit_.a[1], result.to_unit_.a[1]) +
                               dot(result.to_unit_.a[2], result.to_unit_.a[2]));
    return result;
}

AnalyticShape AnalyticShape::relative_to(Vec3 origin) const {
    AnalyticShape result = *this;
    result.to_scene_.t = to_scene_.t - origin;
    result.to_unit_.t = -to_unit_.direction(result.to_scene_.t);
    return result;
}

AnalyticHit AnalyticShape::intersect(const Ray& ray) const {
    const Vec3 o = to_unit_.point(ray.o);
    const Vec3 d = to_unit_.direction(ray.d);
    if (kind_ != UnitShape::Disk) return inside_of(kind_, o, d).first();
    const AnalyticHit hit = cross_disk(o, d);
    return hit.t > 0 ? hit : AnalyticHit{};
}

std::array<AnalyticHit, 2> AnalyticShape::crossings(const Ray& ray) const {
    const Vec3 o = to_unit_.point(ray.o);
    const Vec3 d = to_unit_.direction(ray.d);
    if (kind_ == UnitShape::Disk) return {cross_disk(o, d), {}};
    const Interval inside = inside_of(kind_, o, d);
    if (inside.empty()) return {};
    return {inside.in(), inside.out()};
}

bool AnalyticShape::contains(Vec3 p) const {
    const Vec3 q = to_unit_.point(p);
    switch (kind_) {
        case UnitShape::Sphere:
            return dot(q, q) < 1;
        case UnitShape::Disk:
            return false;
        case UnitShape::Box:
            return max_abs(q) < 1;
        case UnitShape::Cylinder:
            return q.x * q.x + q.y * q.y < 1 && q.z > 0 && q.z < 1;
    }
    return false;
}

bool AnalyticShape::touches(Vec3 p, Real reach) const {
    const Vec3 q = to_unit_.point(p);
    const Real r = reach * growth_;
    const auto is_between = [r](Real squared) {
        const Real least = std::max(1 - r, Real{0});
        return squared >= least * least && squared <= (1 + r) * (1 + r);
    };
    const Real round = q.x * q.x + q.y * q.y;
    switch (kind_) {
        case UnitShape::Sphere:
            return is_between(round + q.z * q.z);
        case UnitShape::Disk:
            return std::abs(q.z) <= r && round <= (1 + r) * (1 + r);
        case UnitShape::Box:
            return std::abs(max_abs(q) - 1) <= r;
        case UnitShape::Cylinder:
            if (q.z < -r || q.z > 1 + r || round > (1 + r) * (1 + r)) return false;
            return q.z <= r || q.z >= 1 - r || is_between(round);
    }
    return true;
}

void AnalyticShape::complete(const Ray& ray, AnalyticHit at, Hit& hit) const {
    const auto [q, n] = on_surface(kind_, at.part, to_unit_.point(ray.at(at.t)));
    hit.t = at.t;
    hit.p = to_scene_.point(q);
    hit.ng = normalize(to_unit_.transposed(n));
    hit.ns = hit.ng;
    hit.error = resolution_at(max_abs(hit.p));
    hit.resolution = hit.error;
    hit.is_at_edge = is_at_edge(kind_, at.part, q);
    hit.primitive = at.part;
}

Vec2 AnalyticShape::uv(const Hit& hit) const {
    const auto part = static_cast<std::uint8_t>(hit.primitive);
    const auto [q, n] = on_surface(kind_, part, to_unit_.point(hit.p));
    switch (kind_) {
        case UnitShape::Sphere:
            return sphere_uv(q);
        case UnitShape::Disk:
            return disk_uv(q.x, q.y);
        case UnitShape::Box:
            return box_uv(n, q);
        case UnitShape::Cylinder:
            if (part == 0) return cylinder_side_uv(q);
            if (n.z > 0) return disk_uv(q.x, q.y);
            return disk_uv(bottom_u_.x * q.x + bottom_u_.y * q.y,
                           bottom_u_.y * q.x - bottom_u_.x * q.y);
    }
    return {};
}

Bounds AnalyticShape::bounds() const {
    // Half the extent along a world axis: the largest value of (row of A).q over the unit shape.
    Bounds box;
    for (const Real z : {0.0, 1.0}) {
        if (kind_ != UnitShape::Cylinder && z > 0) break;
        const auto extent = [&](Vec3 row) {
            switch (kind_) {
                case UnitShape::Sphere:
                    return length(row);
                case UnitShape::Box:
                    return std::abs(row.x) + std::abs(row.y) + std::abs(row.z);
                default:
                    return std::hypot(row.x, row.y);
            }
        };
        const Vec3 half{extent(to_scene_.a[0]), extent(to_scene_.a[1]), extent(to_scene_.a[2])};
        const Vec3 middle = to_scene_.point({0, 0, z});
        box.add(middle - half);
        box.add(middle + half);
    }
    return box;
}

}  // namespace bouguer::renderer
