// SPDX-License-Identifier: Apache-2.0
#include "renderer/media/body_table.h"

#include <algorithm>
#include <numeric>

namespace bouguer::renderer {
namespace {

bool is_within(const Bounds& box, Vec3 p, Real reach) {
    const Vec3 margin = reach * Vec3{1, 1, 1};
    return min(box.lo - margin, p) == box.lo - margin && max(box.hi + margin, p) == box.hi + margin;
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
        for (std::uint32_t i = 0; i < objects[object].instances; ++i) {
            bodies_.push_back({object, i, geometry.bounds(object, i), objects[object].is_closed});
            if (bodies_.back().is_half_space()) continue;
            all_.add(bodies_.back().bounds);
            ++num_bounded_;
        }
    }
}

MediumStack BodyTable::around(Vec3 p) const {
    MediumStack media;
    for (BodyId body = 0; body < bodies_.size(); ++body) {
        const Placed& placed = bodies_[body];
        if (is_within(placed.bounds, p, 0) && placed.is_closed &&
            geometry_.contains(placed.object, placed.instance, p)) {
            media.enter(body);
        }
    }
    return media;
}

bool BodyTable::is_near(Vec3 p, Real reach) const {
    // Many boxes are not asked one by one: to look where nothing is costs time, nothing else.
    constexpr std::size_t kMany = 16;
    if (num_bounded_ > 0 && is_within(all_, p, reach)) {
        if (num_bounded_ > kMany) return true;
        for (const Placed& body : bodies_) {
            if (!body.is_half_space() && is_within(body.bounds, p, reach)) return true;
        }
    }
    return num_bounded_ < bodies_.size() &&
           std::any_of(bodies_.begin(), bodies_.end(), [&](const Placed& body) {
               return body.is_half_space() && is_at_boundary(body, p, reach);
           });
}

/// Whether a step of `reach` along some axis leads from one side to the other.
bool BodyTable::is_at_boundary(const Placed& body, Vec3 p, Real reach) const {
    const bool inside = geometry_.contains(body.object, body.instance, p);
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (const Real step : {-2 * reach, 2 * reach}) {
            if (geometry_.contains(body.object, body.instance, p + step * axis) != inside)
                return true;
        }
    }
    return false;
}

bool BodyTable::may_end_at(BodyId body, Vec3 p, Real reach) const {
    const Placed& placed = bodies_[body];
    return placed.is_closed && is_within(placed.bounds, p, reach);
}

bool BodyTable::may_leave_along(BodyId body, Vec3 d) const {
    const Placed& placed = bodies_[body];
    if (!placed.is_half_space()) return false;
    // Far enough along d the ray is inside, however the plane lies.
    return geometry_.contains(placed.object, placed.instance, 1e30 * d);
}

}  // namespace bouguer::renderer
