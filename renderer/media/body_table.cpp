// SPDX-License-Identifier: Apache-2.0
#include "renderer/media/body_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bouguer::renderer {
namespace {

bool is_within(const Bounds& box, Vec3 p, Real reach) {
    const Vec3 margin = reach * Vec3{1, 1, 1};
    return min(box.lo - margin, p) == box.lo - margin && max(box.hi + margin, p) == box.hi + margin;
}

/// Whether two boxes come near each other: by a millionth of their size.
bool is_overlapping(const Bounds& a, const Bounds& b) {
    const auto margin = [](const Bounds& box) {
        const Real size = max_abs(box.hi - box.lo) + max_abs(box.lo);
        return std::isfinite(size) ? 1e-5 * size : 0;
    };
    const Vec3 m = (margin(a) + margin(b)) * Vec3{1, 1, 1};
    const Vec3 lo = max(a.lo, b.lo) - m;
    const Vec3 hi = min(a.hi, b.hi) + m;
    return lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z;
}

}  // namespace

BodyTable::BodyTable(std::span<const BodyDescription> objects, const Geometry& geometry)
    : geometry_(geometry), first_body_(objects.size(), MediumStack::kOutside) {
    for (const BodyDescription& object : objects) {
        matter_.push_back(object.matter);
        flat_.push_back(object.is_flat);
    }
    std::vector<std::uint32_t> order(objects.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return objects[a].priority > objects[b].priority;
    });
    for (const std::uint32_t object : order) {
        if (matter_[object] != Matter::Body) continue;
        first_body_[object] = static_cast<BodyId>(bodies_.size());
        for (std::uint32_t i = 0; i < objects[object].instances; ++i)
            bodies_.push_back({{object, i}, geometry.bounds(object, i), objects[object].is_closed});
    }
    find_neighbours(objects);
}

/// What light goes through is compared with everything. Not done where that is too much; then every
/// hit is taken for one near others.
void BodyTable::find_neighbours(std::span<const BodyDescription> objects) {
    constexpr std::size_t kMostPairs = 4'000'000;
    std::vector<Placed> all;
    std::vector<Bounds> bounds;
    for (std::uint32_t object = 0; object < objects.size(); ++object) {
        first_instance_.push_back(all.size());
        for (std::uint32_t i = 0; i < objects[object].instances; ++i) {
            all.push_back({object, i});
            bounds.push_back(geometry_.bounds(object, i));
        }
    }
    std::vector<std::size_t> passed;  // what light goes through
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (matter_[all[i].object] != Matter::Opaque) passed.push_back(i);
    }
    is_unknown_ = all.size() * passed.size() > kMostPairs;
    if (is_unknown_) return;
    neighbourhoods_.resize(all.size());
    for (const std::size_t own : passed) {
        neighbourhoods_[own].is_thin = geometry_.is_thin(all[own].object, all[own].instance);
        for (std::size_t other = 0; other < all.size(); ++other) {
            if (other == own || !is_overlapping(bounds[own], bounds[other])) continue;
            neighbourhoods_[own].neighbours.push_back(all[other]);
            if (matter_[all[other].object] == Matter::Opaque)
                neighbourhoods_[other].neighbours.push_back(all[own]);
        }
    }
}

MediumStack BodyTable::around(Vec3 p) const {
    MediumStack media;
    for (BodyId body = 0; body < bodies_.size(); ++body) {
        const PlacedBody& placed = bodies_[body];
        if (is_within(placed.bounds, p, 0) && placed.is_closed &&
            geometry_.contains(placed.object, placed.instance, p)) {
            media.enter(body);
        }
    }
    return media;
}

bool BodyTable::is_near_others(const Hit& hit, Real reach) const {
    if (is_unknown_) return true;
    const Neighbourhood& around = neighbourhoods_[first_instance_[hit.object] + hit.instance];
    return around.is_thin ||
           std::any_of(around.neighbours.begin(), around.neighbours.end(), [&](const Placed& n) {
               return geometry_.touches(n.object, n.instance, hit.p, reach);
           });
}

bool BodyTable::may_end_at(BodyId body, Vec3 p, Real reach) const {
    const PlacedBody& placed = bodies_[body];
    return placed.is_closed && is_within(placed.bounds, p, reach);
}

bool BodyTable::may_hold(BodyId body, Vec3 p) const {
    const PlacedBody& placed = bodies_[body];
    return !placed.is_closed || geometry_.contains(placed.object, placed.instance, p);
}

bool BodyTable::may_touch(BodyId body, Vec3 p, Real reach) const {
    const PlacedBody& placed = bodies_[body];
    return is_within(placed.bounds, p, reach) &&
           geometry_.touches(placed.object, placed.instance, p, reach);
}

Real BodyTable::way_inside(BodyId body, const Ray& ray) const {
    constexpr int kHalvings = 24;
    Real outside = way_in_bounds(body, ray);
    if (!is_closed(body) || outside == std::numeric_limits<Real>::infinity()) return outside;
    Real inside = 0;
    for (int i = 0; i < kHalvings; ++i) {
        const Real middle = (inside + outside) / 2;
        (may_hold(body, ray.at(middle)) ? inside : outside) = middle;
    }
    return inside;
}

Real BodyTable::way_in_bounds(BodyId body, const Ray& ray) const {
    const Bounds& box = bodies_[body].bounds;
    Real way = std::numeric_limits<Real>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const Real d = ray.d[axis];
        if (d != 0) way = std::min(way, ((d > 0 ? box.hi : box.lo)[axis] - ray.o[axis]) / d);
    }
    return std::max(way, Real{0});
}

bool BodyTable::may_leave_along(BodyId body, Vec3 d) const {
    const PlacedBody& placed = bodies_[body];
    if (!placed.is_half_space()) return false;
    // Far enough along d the ray is inside, however the plane lies.
    return geometry_.contains(placed.object, placed.instance, 1e30 * d);
}

}  // namespace bouguer::renderer
