// SPDX-License-Identifier: Apache-2.0
// Which of a scene's objects are bodies that light goes through, and which of them counts where
// several overlap.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/media/medium_stack.h"

namespace bouguer::renderer {

/// What a ray finds in an object.
enum class Matter : std::uint8_t {
    Opaque,  ///< ends there, from whichever side it comes
    Sheet,   ///< goes through something without an inside
    Body     ///< goes into it, or out of it
};

struct BodyDescription {
    Matter matter = Matter::Opaque;
    bool is_flat = false;  ///< a disk: has no inside
    int priority = 0;
    bool is_closed = true;  ///< has an inside that can be told from the outside
    std::uint32_t instances = 1;
};

/// Immutable once built; thread-safe.
///
/// The rule: where bodies overlap, the one with the highest priority is there; at equal priority
/// the one that stands first in the scene; of the instances of one object the first. It asks for no
/// order of events, so light that goes back the same way finds the same bodies. What is opaque is
/// always met, whatever overlaps it.
class BodyTable {
  public:
    /// `objects` in the order of the geometry's, which must outlive the table.
    BodyTable(std::span<const BodyDescription> objects, const Geometry& geometry);

    [[nodiscard]] Matter matter_of(std::uint32_t object) const { return matter_[object]; }
    /// Whether an object is a disk, opaque or not.
    [[nodiscard]] bool is_flat(std::uint32_t object) const { return flat_[object]; }
    /// Of a hit on an object that is a body.
    [[nodiscard]] BodyId body_of(const Hit& hit) const {
        return first_body_[hit.object] + hit.instance;
    }
    [[nodiscard]] std::uint32_t object_of(BodyId body) const { return bodies_[body].object; }
    [[nodiscard]] bool empty() const { return bodies_.empty(); }

    /// The bodies around a point. Those that do not fit are left out.
    [[nodiscard]] MediumStack around(Vec3 p) const;
    /// Whether something that matters may lie so near to a hit that queries confuse the two: a
    /// body, or to a body anything. `reach` is Geometry::reach(hit).
    [[nodiscard]] bool is_near_others(const Hit& hit, Real reach) const;
    /// Whether a ray inside `body` may end at `p`, which rays see off by `reach`. False: it has
    /// left the body without meeting its surface; also when the body has no inside.
    [[nodiscard]] bool may_end_at(BodyId body, Vec3 p, Real reach) const;
    [[nodiscard]] bool is_closed(BodyId body) const { return bodies_[body].is_closed; }
    /// Whether `p` is inside `body`; yes of a body that has no inside to ask for.
    [[nodiscard]] bool may_hold(BodyId body, Vec3 p) const;
    /// Whether the surface of `body` may come within `reach` of `p`.
    [[nodiscard]] bool may_touch(BodyId body, Vec3 p, Real reach) const;
    /// How far a ray that starts inside `body` stays there, by asking for points of it; for rays
    /// that did not meet the surface. Of a body without an inside: how far it stays in its bounds.
    [[nodiscard]] Real way_inside(BodyId body, const Ray& ray) const;
    /// Whether a ray inside `body` may leave the scene along `d`: half-spaces have no end.
    [[nodiscard]] bool may_leave_along(BodyId body, Vec3 d) const;

  private:
    struct Placed {
        std::uint32_t object = 0, instance = 0;
    };
    struct PlacedBody : Placed {
        Bounds bounds;
        bool is_closed = true;
        [[nodiscard]] bool is_half_space() const { return bounds.hi.x > kFinite; }
        static constexpr Real kFinite = std::numeric_limits<Real>::max();
    };
    /// What may touch an instance.
    struct Neighbourhood {
        bool is_thin = false;  ///< it touches itself
        std::vector<Placed> neighbours;
    };

    [[nodiscard]] Real way_in_bounds(BodyId body, const Ray& ray) const;
    void find_neighbours(std::span<const BodyDescription> objects);

    const Geometry& geometry_;
    std::vector<Matter> matter_;
    std::vector<bool> flat_;
    std::vector<BodyId> first_body_;             ///< by object
    std::vector<PlacedBody> bodies_;             ///< by number
    std::vector<std::size_t> first_instance_;    ///< by object: in neighbourhoods_
    bool is_unknown_ = false;                    ///< what is near what: there is too much
    std::vector<Neighbourhood> neighbourhoods_;  ///< by instance, unless they are too many
};

}  // namespace bouguer::renderer
