// SPDX-License-Identifier: Apache-2.0
#include "renderer/media/interface.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bouguer::renderer {
namespace {

/// How many places without an interface a ray goes through before it is given up: faces hidden in
/// bodies of higher priority.
constexpr int kMaxPlaces = 4096;

/// How many times the reach of queries a point lies on one side of a surface for certain.
constexpr Real kPast = 8;

/// The point `way` along `d` from p, and a little aside, off the plane of walls that a ray runs in.
Vec3 beside(Vec3 p, Real way, Vec3 d) {
    constexpr Vec3 kAside{0.48e-3, 0.64e-3, 0.6e-3};
    return p + way * d + std::abs(way) * kAside;
}

/// How far along `d` to look for what queries may confuse with a surface of unit normal `ng`. At
/// grazing incidence more, but not without end.
Real reach_along(Vec3 ng, Vec3 d, Real reach) {
    constexpr Real kLeastCosine = 1.0 / 64;
    return 4 * reach / std::max(std::abs(dot(ng, d)), kLeastCosine);
}

/// How far along `d` a point lies on one side of the surface for certain.
Real past(Vec3 ng, Vec3 d, Real reach) { return 2 * reach_along(ng, d, reach); }

/// resolution_along() for the surface that a ray starts on.
Real resolution_along(const RayStart& start, Vec3 d) {
    constexpr Real kLeastCosine = 0x1p-20;
    return start.resolution / std::max(std::abs(dot(start.ng, d)), kLeastCosine);
}

/// How far along `d` to look for what lies about a start: also, at grazing incidence, for facets
/// that go on where the start's own ends.
Real reach_from(const RayStart& start, Vec3 d) {
    return std::max(reach_along(start.ng, d, start.reach), resolution_along(start, d));
}

bool is_entering(const Hit& hit, Vec3 d) { return dot(hit.ng, d) < 0; }

/// Whether two faces, in the order along `d`, are the two sides of a blunt edge that is grazed.
bool is_grazed(const Hit& first, const Hit& second, Vec3 d) {
    if (first.object != second.object || first.instance != second.instance) return false;
    constexpr Real kBlunt = 0.1;  // right angles are not, however they are rounded
    if (is_entering(first, d) == is_entering(second, d) || dot(first.ng, second.ng) <= kBlunt)
        return false;
    const Real steepest = std::min(std::abs(dot(first.ng, d)), std::abs(dot(second.ng, d)));
    return (second.t - first.t) * steepest <= first.error + second.error;
}

bool is_same_plane(Vec3 n, Vec3 m) {
    constexpr Real kParallel = 1 - 1e-6;
    return std::abs(dot(n, m)) > kParallel;
}

}  // namespace

bool InterfaceFinder::next(const RayStart& start, Vec3 d, Real t_max, MediumStack& media,
                           Interface& found, LostBodies& lost) {
    RayStart from = start;
    start_ = start.p;
    // What is beyond an edge depends on the way that the ray was bent there.
    if (start.skip > 0) {
        from.skip = past(start.ng, d, start.reach);
        media = around(start.p, from.skip, d, media);
    }
    Real way = 0;
    for (int i = 0; i < kMaxPlaces; ++i) {
        found.is_crowded = false;
        found.asked = 0;
        if (!find_place(from, d, t_max - way, media, found)) return false;
        way += found.hit.t;
        const bool is_interface = found.is_crowded ? resolve_place(d, media, found, lost)
                                                   : resolve_alone(d, media, found, lost);
        if (is_interface) {
            found.hit.t = way;
            return true;
        }
        from = found.start(true);
    }
    return false;
}

/// What to make of a hit that shares its place with nothing. False: nothing changes there; `media`
/// are then those beyond.
bool InterfaceFinder::resolve_alone(Vec3 d, MediumStack& media, Interface& found,
                                    LostBodies& lost) {
    found.place = Place(found.hit);
    found.matter = bodies_.matter_of(found.hit.object);
    found.entering = is_entering(found.hit, d);
    if (found.matter != Matter::Body) {
        found.beyond = media;
        return true;
    }
    const BodyId body = bodies_.body_of(found.hit);
    // Where a ray only touches the edge of a body, one of the two sides may go unseen.
    const Real step = kPast * found.reach;
    if (found.hit.is_at_edge && !is_near_others_ && found.entering &&
        !bodies_.may_hold(body, beside(found.hit.p, step, d)))
        return false;
    const bool is_asked = found.hit.is_at_edge && is_near_others_ && !found.entering;
    if (!is_asked && !found.entering && !media.holds(body)) {
        if (!is_missing(found.hit, d, found.reach, lost)) return false;
        add_missing(found.hit, media, lost);
    }
    found.beyond = media;
    if (is_asked) {
        found.beyond = ask(found, d, media);
    } else if (!found.entering) {
        found.beyond.leave(body);
    } else if (!found.beyond.enter(body)) {
        ++overflows_;
    }
    // Behind a sharp edge the way out may be nearer than single precision tells.
    found.is_crowded = found.hit.is_at_edge;
    if (media.current() != found.beyond.current()) return true;
    media = found.beyond;
    return false;
}

/// The same for all that lies in place_.
bool InterfaceFinder::resolve_place(Vec3 d, MediumStack& media, Interface& found,
                                    LostBodies& lost) {
    const Hit* opaque = opaque_in_place(d);
    const Hit* only = opaque != nullptr ? opaque : sheet_in_place();
    if (only == nullptr) {
        if (!is_edge()) add_all_missing(d, media, found.reach, lost);
        return find_boundary(d, media, found);
    }
    found.hit = *only;
    found.place = Place(*only);
    found.matter = bodies_.matter_of(only->object);
    found.entering = is_entering(*only, d);
    found.beyond = media;
    return true;
}

/// Finds what the ray meets first, t from its start: found.hit, and where that is crowded all of
/// place_. False: nothing.
bool InterfaceFinder::find_place(const RayStart& start, Vec3 d, Real t_max,
                                 const MediumStack& media, Interface& found) {
    // All questions are put along one line: at a silhouette two lines meet different surfaces.
    Ray line{start.p, d};
    Real from = start.skip;
    if (start.is_on_surface && start.skip == 0 && start.is_crowded) {
        if (find_nearby(start, d, t_max, media, found)) return true;
        // What comes next is nowhere near: half of the way that has been looked through.
        from = reach_from(start, d);
    } else if (start.is_on_surface && start.skip == 0) {
        line.o = start.origin(d);
        // A ray that has an end gets there also from beside its start.
        if (std::isfinite(t_max) && start.is_left_aslant(d))
            line.d = normalize(start.p + t_max * d - line.o);
    }
    const Real shift = dot(line.o - start.p, d);
    for (int i = 0; i < kMaxPlaces; ++i) {
        ++queries_;
        is_near_others_ = false;
        if (!geometry_.nearest({line.at(from), line.d}, t_max - shift - from, found.hit))
            return false;
        found.hit.t += shift + from;
        found.reach = found.hit.error;
        if (found.hit.is_alone) return true;
        found.reach = geometry_.reach(found.hit);
        is_near_others_ = bodies_.is_near_others(found.hit, 4 * found.reach);
        if (!is_near_others_) return true;
        const Real seen_to = look_around(start, line, t_max, media, found);
        if (seen_to == 0) return true;
        from = seen_to;
    }
    return false;
}

/// Looks for what is within reach of the start.
bool InterfaceFinder::find_nearby(const RayStart& start, Vec3 d, Real t_max,
                                  const MediumStack& media, Interface& found) {
    const Real reach = reach_from(start, d);
    ++queries_;
    geometry_.crossings({start.p, d}, -reach, 2 * reach, place_);
    std::erase_if(place_, [&](const Hit& hit) {
        return hit.t >= t_max - resolution_along(hit, d) || is_left(start, d, media, hit);
    });
    if (place_.empty()) return false;
    keep_first_place(d, found);
    return true;
}

/// found.hit is what single precision took for the nearest; finds what really is, and what lies in
/// the same place. Usually 0; else how far along the line there is nothing: at a silhouette two
/// queries may differ, and this one, which sees all that shares the place, is believed.
Real InterfaceFinder::look_around(const RayStart& start, const Ray& line, Real t_max,
                                  const MediumStack& media, Interface& found) {
    const Vec3 d = line.d;
    const Real reach = reach_along(found.hit.ng, d, found.reach);
    const Real shift = dot(line.o - start.p, d);
    const Real middle = found.hit.t - shift;
    ++queries_;
    geometry_.crossings(line, middle - reach, middle + reach, place_);
    for (Hit& hit : place_) hit.t += shift;
    // Near the start only what the ray has not left; without a start, only what is in front.
    const Real near =
        start.is_on_surface ? reach_along(start.ng, d, std::max(start.reach, start.error)) : 0;
    std::erase_if(place_, [&](const Hit& hit) {
        if (hit.t >= t_max - resolution_along(hit, d)) return true;
        return hit.t <= start.skip ||
               (hit.t <= near && (!start.is_on_surface || is_left(start, d, media, hit)));
    });
    if (place_.empty() || is_only_grazed(d)) return middle + reach;
    if (place_.size() > 1 || place_.front().part != found.hit.part) keep_first_place(d, found);
    return 0;
}

/// Whether place_ holds nothing but pairs of faces at blunt edges that the ray goes in and out at
/// by less than single precision tells: once in, it might not find its way out.
bool InterfaceFinder::is_only_grazed(Vec3 d) {
    std::vector<const Hit*>& open = grazed_;
    open.clear();
    for (const Hit& hit : place_) {
        const auto before = std::find_if(
            open.begin(), open.end(), [&](const Hit* other) { return is_grazed(*other, hit, d); });
        if (before != open.end()) {
            open.erase(before);
        } else {
            open.push_back(&hit);
        }
    }
    return open.empty();
}

/// Whether a ray from `start` has left `hit` behind it, or is on its way off it.
bool InterfaceFinder::is_left(const RayStart& start, Vec3 d, const MediumStack& media,
                              const Hit& hit) const {
    const Real same_place = resolution_along(hit, d) + resolution_along(start, d);
    if (std::abs(hit.t) <= same_place && start.place.has(hit)) return true;
    // Of what is in the place of a sheet only the sheet has been met.
    const bool from_sheet = bodies_.matter_of(start.object) == Matter::Sheet;
    if (hit.t < (from_sheet ? -same_place : 0)) return true;
    const Matter matter = bodies_.matter_of(hit.object);
    if (matter == Matter::Body) return is_entering(hit, d) == media.holds(bodies_.body_of(hit));
    if (hit.object == start.object && hit.instance == start.instance) {
        return is_entering(hit, d) == (dot(start.ng, d) < 0);
    }
    if (hit.t > same_place || !is_same_plane(hit.ng, start.ng)) return false;
    if (matter == Matter::Opaque) return true;
    // Of sheets in one place the one that stands first in the scene is gone through first.
    if (!from_sheet) return start.has_gone_through;
    return (hit.object < start.object) == start.has_gone_through;
}

/// Drops from place_, which is in the order of t, what lies beyond the first place.
void InterfaceFinder::keep_first_place(Vec3 d, Interface& found) {
    const Real first = place_.front().t;
    Real end = first + resolution_along(place_.front(), d);
    std::size_t kept = 1;
    for (; kept < place_.size(); ++kept) {
        const Hit& hit = place_[kept];
        if (hit.t - resolution_along(hit, d) > end) break;
        if (is_far_side(kept, d)) {
            // What lies with the far side belongs to it.
            const Real far = hit.t;
            while (kept > 1 && place_[kept - 1].t - first > far - place_[kept - 1].t) --kept;
            break;
        }
        end = std::max(end, hit.t);
    }
    place_.resize(kept);
    found.hit = place_.front();
    found.reach = geometry_.reach(found.hit);
    found.is_crowded = true;
}

/// Whether number `index` of place_ comes out of a body that something before it goes into; at an
/// edge it is one place.
bool InterfaceFinder::is_far_side(std::size_t index, Vec3 d) const {
    const Hit& hit = place_[index];
    if (is_entering(hit, d)) return false;
    return std::any_of(place_.begin(), place_.begin() + static_cast<std::ptrdiff_t>(index),
                       [&](const Hit& other) {
                           return other.object == hit.object && other.instance == hit.instance &&
                                  is_entering(other, d) && is_same_plane(other.ng, hit.ng);
                       });
}

/// What is opaque in the place: a disk before what has an inside, what is come out of before what
/// is gone into, else what stands first in the scene.
const Hit* InterfaceFinder::opaque_in_place(Vec3 d) const {
    const auto rank = [&](const Hit& hit) {
        return std::tuple(!bodies_.is_flat(hit.object), is_entering(hit, d), hit.object);
    };
    const Hit* best = nullptr;
    for (const Hit& hit : place_) {
        if (bodies_.matter_of(hit.object) != Matter::Opaque) continue;
        if (best == nullptr || rank(hit) < rank(*best)) best = &hit;
    }
    return best;
}

const Hit* InterfaceFinder::sheet_in_place() const {
    const Hit* best = nullptr;
    for (const Hit& hit : place_) {
        if (bodies_.matter_of(hit.object) != Matter::Sheet) continue;
        if (best == nullptr || hit.object < best->object) best = &hit;
    }
    return best;
}

/// Whether a body that the ray comes out of, at `hit`, was around it from its start on. It was not
/// if the ray only touches its edge, or has gone into it unseen, which is counted.
bool InterfaceFinder::is_missing(const Hit& hit, Vec3 d, Real reach, LostBodies& lost) const {
    const BodyId body = bodies_.body_of(hit);
    if (!bodies_.may_hold(body, beside(hit.p, -kPast * reach, d))) return false;
    if (bodies_.may_hold(body, beside(start_, kPast * reach, d))) return true;
    ++lost[hit.object];
    return false;
}

/// A body that the ray comes out of without having gone into it was around it from its start on.
void InterfaceFinder::add_missing(const Hit& hit, MediumStack& media, LostBodies& lost) {
    ++lost[hit.object];
    if (!media.enter(bodies_.body_of(hit))) ++overflows_;
}

void InterfaceFinder::add_all_missing(Vec3 d, MediumStack& media, Real reach, LostBodies& lost) {
    for (const Hit& hit : place_) {
        const BodyId body = bodies_.body_of(hit);
        std::size_t out = 0, in = media.count(body);
        for (const Hit& other : place_) {
            if (bodies_.body_of(other) != body) continue;
            ++(is_entering(other, d) ? in : out);
        }
        if (in < out && !is_missing(hit, d, reach, lost)) continue;
        for (; in < out; ++in) add_missing(hit, media, lost);
    }
}

/// Whether faces of different directions meet in the place.
bool InterfaceFinder::is_edge() const {
    return std::any_of(place_.begin(), place_.end(),
                       [&](const Hit& hit) { return !is_same_plane(hit.ng, place_.front().ng); });
}

/// Whether some face may have gone unseen because the ray runs along its edge.
bool InterfaceFinder::is_uncertain() const {
    return std::any_of(place_.begin(), place_.end(), [](const Hit& hit) { return hit.is_at_edge; });
}

/// The bodies beyond the place `at`, by asking all.
MediumStack InterfaceFinder::ask(Interface& at, Vec3 d, const MediumStack& media) const {
    at.asked = past(at.hit.ng, d, at.reach);
    return around(at.hit.p, at.asked, d, media);
}

/// The bodies around the point `way` along `d` from p. Those of `media` without an inside stay.
MediumStack InterfaceFinder::around(Vec3 p, Real way, Vec3 d, const MediumStack& media) const {
    MediumStack there = bodies_.around(beside(p, way, d));
    for (const BodyId body : media) {
        if (!bodies_.is_closed(body)) there.enter(body);
    }
    return there;
}

/// The bodies beyond the place `at`, by its faces. At an edge of a face they are asked if there
/// seems to be none, or one that ends there without having been met.
MediumStack InterfaceFinder::cross_place(Interface& at, Vec3 d, const MediumStack& media) {
    MediumStack beyond = media;
    for (const Hit& hit : place_) {
        if (is_entering(hit, d) && !beyond.enter(bodies_.body_of(hit))) ++overflows_;
    }
    for (const Hit& hit : place_) {
        if (!is_entering(hit, d)) beyond.leave(bodies_.body_of(hit));
    }
    if (!is_uncertain()) return beyond;
    const auto is_met = [&](BodyId body, bool is_left) {
        return std::any_of(place_.begin(), place_.end(), [&](const Hit& hit) {
            return bodies_.body_of(hit) == body && is_entering(hit, d) != is_left;
        });
    };
    // Gone into once more; or not met, and not there any more.
    const bool is_odd = std::any_of(media.begin(), media.end(), [&](BodyId body) {
        if (is_met(body, true)) return false;
        return is_met(body, false) ||
               (bodies_.may_touch(body, at.hit.p, at.reach) &&
                !bodies_.may_hold(body, beside(at.hit.p, kPast * at.reach, d)));
    });
    return is_odd || beyond.current() == MediumStack::kOutside ? ask(at, d, media) : beyond;
}

/// The interface between the bodies in front of the place and those beyond; false when those that
/// count are the same.
bool InterfaceFinder::find_boundary(Vec3 d, MediumStack& media, Interface& found) {
    const MediumStack beyond = is_edge() ? ask(found, d, media) : cross_place(found, d, media);
    const BodyId here = media.current(), there = beyond.current();
    found.place = Place(place_);
    if (here == there) {
        media = beyond;
        return false;
    }
    const BodyId counts = std::min(here, there);
    const auto face = std::find_if(place_.begin(), place_.end(), [&](const Hit& hit) {
        return bodies_.body_of(hit) == counts && is_entering(hit, d) == (counts == there);
    });
    found.hit = face != place_.end() ? *face : place_.front();
    found.matter = Matter::Body;
    found.entering = is_entering(found.hit, d);
    found.beyond = beyond;
    // A ray that is bent at an edge may be on the other side of it at once.
    if (is_uncertain()) found.asked = past(found.hit.ng, d, found.reach);
    return true;
}

}  // namespace bouguer::renderer
