// SPDX-License-Identifier: Apache-2.0
// What a ray passes at a point: the bodies on this side, the bodies beyond, and the surface between
// them. No surface is stepped over.
//
// The rules, which the users' documentation repeats:
// - A ray starts where it hit, leaves out what it has just left, and meets what lies in the same
//   place.
// - Faces in one place are one interface, in optical contact: from the body that is left straight
//   into the one that is entered, with the surface of the one of the two that counts more. One
//   refraction, one share of what goes through.
// - The two sides of one body are two places, however thin it is.
// - Faces between which nothing changes (inside a body of higher priority) are no interface.
// - What is opaque is met first, then sheets, then bodies.
// - At edges and corners, where it depends on rounding which faces a ray meets, the bodies are
//   asked which of them are there beyond.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/media/body_table.h"

namespace bouguer::renderer {

/// The faces that lie in one place. Of very many, the first.
class Place {
  public:
    Place() = default;
    explicit Place(const Hit& only) : size_(1) { faces_[0] = {only.part, only.primitive}; }
    explicit Place(const std::vector<Hit>& hits) {
        for (; size_ < std::min(hits.size(), kCapacity); ++size_)
            faces_[size_] = {hits[size_].part, hits[size_].primitive};
    }
    [[nodiscard]] bool has(const Hit& hit) const {
        return std::any_of(faces_.begin(), faces_.begin() + size_, [&](const Face& face) {
            return face.part == hit.part && face.primitive == hit.primitive;
        });
    }

  private:
    static constexpr std::size_t kCapacity = 4;
    struct Face {
        std::uint32_t part, primitive;
    };
    std::array<Face, kCapacity> faces_;  // only the first size_ mean anything
    std::size_t size_ = 0;
};

/// Where a ray starts: in the open, or on a surface that it leaves or has gone through.
struct RayStart {
    Vec3 p;
    Vec3 ng;                                    ///< unit normal of the surface, on either side
    Real error = 0, resolution = 0, reach = 0;  ///< of the hit there (see Hit, Geometry::reach)
    std::uint32_t object = 0, instance = 0;     ///< whose surface it is
    bool is_on_surface = false;
    bool has_gone_through = false;  ///< else it goes back to where it came from
    bool is_crowded = false;        ///< other surfaces are within reach of p
    Real skip = 0;                  ///< how far all is left out: the bodies there are known
    Place place;                    ///< what lies in the same place, the surface itself among it

    /// Along the ray the way off the surface would be much longer than along the normal.
    [[nodiscard]] bool is_left_aslant(Vec3 d) const { return std::abs(dot(d, ng)) < 0.7; }
    /// The origin of a ray along `d` that does not meet the surface again (see leave_surface()): on
    /// the ray, unless that leaves it aslant.
    [[nodiscard]] Vec3 origin(Vec3 d) const {
        const Real cosine = dot(d, ng);
        if (!is_left_aslant(d)) return p + (error / std::abs(cosine)) * d;
        return p + (cosine < 0 ? -error : error) * ng;
    }
};

/// What the next ray has to know of the surface between two sides.
struct Interface {
    Hit hit;         ///< on the surface that counts; t from the ray's start
    Place place;     ///< all that is gone through with it, or in front of it
    Real reach = 0;  ///< Geometry::reach(hit)
    Matter matter = Matter::Opaque;
    bool entering = true;     ///< the ray comes from outside the surface's body
    bool is_crowded = false;  ///< other surfaces are within reach
    Real asked = 0;           ///< how far along the ray the bodies were asked; 0: not
    MediumStack beyond;       ///< the bodies around a ray that goes through

    [[nodiscard]] RayStart start(bool goes_through) const {
        return {hit.p,
                hit.ng,
                hit.error,
                hit.resolution,
                reach,
                hit.object,
                hit.instance,
                true,
                goes_through,
                is_crowded,
                goes_through ? asked : 0,
                place};
    }
};

/// Rays that lost track of the bodies around them, by object.
using LostBodies = std::map<std::uint32_t, std::uint64_t>;

/// Finds interfaces. Not thread-safe: it keeps working memory; scene and tables are shared.
class InterfaceFinder {
  public:
    InterfaceFinder(const Geometry& geometry, const BodyTable& bodies)
        : geometry_(geometry), bodies_(bodies) {}

    /// The first interface along the unit `d`, nearer than `t_max`. `media` are the bodies around
    /// the ray; what turns out to be missing there is added and counted in `lost`, and bodies that
    /// come and go behind others are kept up. False: there is none; `media` are then those at the
    /// end.
    bool next(const RayStart& start, Vec3 d, Real t_max, MediumStack& media, Interface& found,
              LostBodies& lost);

    /// How often a body did not fit into a stack.
    [[nodiscard]] std::uint64_t overflows() const { return overflows_; }
    [[nodiscard]] std::uint64_t queries() const { return queries_; }
    void reset_counts() { overflows_ = queries_ = 0; }

  private:
    bool find_place(const RayStart& start, Vec3 d, Real t_max, const MediumStack& media,
                    Interface& found);
    bool find_nearby(const RayStart& start, Vec3 d, Real t_max, const MediumStack& media,
                     Interface& found);
    Real look_around(const RayStart& start, const Ray& line, Real t_max, const MediumStack& media,
                     Interface& found);
    [[nodiscard]] bool is_left(const RayStart& start, Vec3 d, const MediumStack& media,
                               const Hit& hit) const;
    bool is_only_grazed(Vec3 d);
    void keep_first_place(Vec3 d, Interface& found);
    [[nodiscard]] bool is_far_side(std::size_t index, Vec3 d) const;

    bool resolve_alone(Vec3 d, MediumStack& media, Interface& found, LostBodies& lost);
    bool resolve_place(Vec3 d, MediumStack& media, Interface& found, LostBodies& lost);
    [[nodiscard]] const Hit* opaque_in_place(Vec3 d) const;
    [[nodiscard]] const Hit* sheet_in_place() const;
    [[nodiscard]] bool is_missing(const Hit& hit, Vec3 d, Real reach, LostBodies& lost) const;
    void add_missing(const Hit& hit, MediumStack& media, LostBodies& lost);
    void add_all_missing(Vec3 d, MediumStack& media, Real reach, LostBodies& lost);
    [[nodiscard]] bool is_edge() const;
    [[nodiscard]] bool is_uncertain() const;
    [[nodiscard]] MediumStack ask(Interface& at, Vec3 d, const MediumStack& media) const;
    [[nodiscard]] MediumStack around(Vec3 p, Real way, Vec3 d, const MediumStack& media) const;
    [[nodiscard]] MediumStack cross_place(Interface& at, Vec3 d, const MediumStack& media);
    bool find_boundary(Vec3 d, MediumStack& media, Interface& found);

    const Geometry& geometry_;
    const BodyTable& bodies_;
    Vec3 start_;                      ///< of the ray that is followed
    bool is_near_others_ = false;     ///< what find_place() has found
    std::vector<Hit> place_;          ///< what lies in one place, in front of the ray
    std::vector<const Hit*> grazed_;  ///< of place_
    std::uint64_t overflows_ = 0, queries_ = 0;
};

}  // namespace bouguer::renderer
