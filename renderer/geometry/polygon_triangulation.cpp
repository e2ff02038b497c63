// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/polygon_triangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/geometry/orientation.h"

namespace bouguer::renderer {
namespace {

using Triangle = PolygonCutter::Triangle;

Real length(Vec2 a) { return std::hypot(a.x, a.y); }
Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }

/// Whether a triangle of that doubled area is one that meshes leave out (see mesh_file.cpp), or
/// nearly.
bool is_flat(Real area, Vec2 a, Vec2 b, Vec2 c) {
    return !(std::abs(area) > 1e-13 * length(b - a) * length(c - a));
}

/// The two coordinates of every corner in which the polygon is largest, in the order that shows it
/// counter-clockwise; as they are, but for a power of two.
void flatten(std::span<const Vec3> corners, Vec3 area, std::vector<Vec2>& flat) {
    Real size = 0;
    for (const Vec3& p : corners) size = std::max(size, max_abs(p));
    const Real scale = std::ldexp(1.0, -std::ilogb(size));
    const Real most = max_abs(area);
    const int axis = std::abs(area.x) == most ? 0 : std::abs(area.y) == most ? 1 : 2;
    int u = (axis + 1) % 3;
    int v = (axis + 2) % 3;
    if (area[axis] < 0) std::swap(u, v);
    flat.clear();
    for (const Vec3& p : corners) flat.push_back({scale * p[u], scale * p[v]});
}

/// Whether the polygon turns left at every corner, goes round once, and its fan about the first
/// corner has no flat triangle.
bool is_fan(const std::vector<Vec2>& p) {
    const std::size_t n = p.size();
    const auto points_back = [&](std::size_t i) {
        const Vec2 edge = p[(i + 1) % n] - p[i % n];
        return edge.y < 0 || (edge.y == 0 && edge.x < 0);
    };
    std::size_t rounds = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (orientation(p[i], p[(i + 1) % n], p[(i + 2) % n]) < 0) return false;
        if (points_back(i) && !points_back(i + 1)) ++rounds;
        if (i < 1 || i + 1 == n) continue;
        const Real area = orientation(p[0], p[i], p[i + 1]);
        if (area <= 0 || is_flat(area, p[0], p[i], p[i + 1])) return false;
    }
    return rounds == 1;
}

/// Whether two edges cross between their ends.
bool cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
        return false;
    const auto parts = [](Real s, Real t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
    return parts(orientation(a, b, c), orientation(a, b, d)) &&
           parts(orientation(c, d, a), orientation(c, d, b));
}

bool crosses_itself(const std::vector<Vec2>& p) {
    const std::size_t n = p.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
        for (std::size_t k = i + 2; k < n; ++k) {
            if (cross(p[i], p[i + 1], p[k], p[(k + 1) % n])) return true;
        }
    }
    return false;
}

/// Cuts ears off a ring of corners.
class EarClipper {
  public:
    explicit EarClipper(const std::vector<Vec2>& points) : points_(points) {
        const auto n = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_.push_back((i + 1) % n);
            before_.push_back((i + n - 1) % n);
        }
        for (std::uint32_t i = 0; i < n; ++i) ears_.push_back(ear_at(i));
    }

    /// False when a corner had to go that is no ear.
    bool run(std::vector<Triangle>& triangles) {
        bool is_good = true;
        std::uint32_t at = 0;
        for (std::size_t left = points_.size(); left > 3; --left) {
            std::uint32_t ear = best_ear(at, left);
            if (ears_[ear] == Ear::None && looks_left_ > 0) {
                // Where the border touches itself, an ear may come of a cut that is not beside it.
                --looks_left_;
                for (std::size_t i = 0; i < left; ++i, at = next_[at]) ears_[at] = ear_at(at);
                ear = best_ear(at, left);
            }
            is_good = is_good && ears_[ear] != Ear::None;
            triangles.push_back({before_[ear], ear, next_[ear]});
            at = remove(ear);
        }
        triangles.push_back({before_[at], at, next_[at]});
        return is_good && ear_at(at) != Ear::None;
    }

  private:
    /// The better the higher.
    enum class Ear : std::uint8_t {
        None,
        Flat,     ///< of no area
        Touched,  ///< other corners lie on its border
        Good
    };

    /// The next good ear from `at` on; where there is none, the best there is.
    [[nodiscard]] std::uint32_t best_ear(std::uint32_t at, std::size_t left) const {
        std::uint32_t best = at;
        for (std::size_t i = 0; i < left; ++i, at = next_[at]) {
            if (ears_[at] == Ear::Good) return at;
            if (ears_[at] > ears_[best]) best = at;
        }
        return best;
    }

    std::uint32_t remove(std::uint32_t i) {
        const std::uint32_t a = before_[i];
        const std::uint32_t b = next_[i];
        next_[a] = b;
        before_[b] = a;
        ears_[a] = ear_at(a);
        ears_[b] = ear_at(b);
        return b;
    }

    using Corners = std::array<Vec2, 3>;
    using Sides = std::array<Real, 3>;

    /// On which side of each edge of a triangle p lies: above zero inside.
    static Sides sides_of(const Corners& t, Vec2 p) {
        return {orientation(t[0], t[1], p), orientation(t[1], t[2], p), orientation(t[2], t[0], p)};
    }

    /// Whether the way to q from a point on a triangle's border goes into the triangle. `from` are
    /// that point's sides.
    static bool enters(const Corners& t, const Sides& from, Vec2 q) {
        const Sides to = sides_of(t, q);
        for (std::size_t i = 0; i < 3; ++i) {
            if (from[i] == 0 && to[i] <= 0) return false;
        }
        return true;
    }

    [[nodiscard]] Ear ear_at(std::uint32_t i) const {
        const Vec2 a = points_[before_[i]];
        const Vec2 b = points_[i];
        const Vec2 c = points_[next_[i]];
        const Real area = orientation(a, b, c);
        if (is_flat(area, a, b, c)) return Ear::Flat;
        if (area < 0) return Ear::None;
        const Vec2 lo{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
        const Vec2 hi{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
        const Corners corners{a, b, c};
        Ear ear = Ear::Good;
        for (std::uint32_t k = next_[next_[i]]; k != before_[i]; k = next_[k]) {
            const Vec2 p = points_[k];
            if (p.x < lo.x || p.x > hi.x || p.y < lo.y || p.y > hi.y) continue;
            const Sides sides = sides_of(corners, p);
            const Real least = std::min({sides[0], sides[1], sides[2]});
            if (least < 0) continue;
            if (least > 0 || enters(corners, sides, points_[before_[k]]) ||
                enters(corners, sides, points_[next_[k]]))
                return Ear::None;
            if (p != a && p != b && p != c) ear = Ear::Touched;
        }
        return ear;
    }

    const std::vector<Vec2>& points_;
    std::vector<std::uint32_t> next_, before_;
    std::vector<Ear> ears_;  ///< of the corners that are left
    int looks_left_ = 8;     ///< at all of them: each takes the time of a whole polygon
};

void add_fan(std::uint32_t n, std::vector<Triangle>& triangles) {
    for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
}

}  // namespace

Vec3 area_vector(std::span<const Vec3> corners) {
    Real size = 0;
    for (const Vec3& p : corners) size = std::max(size, max_abs(0.5 * p - 0.5 * corners[0]));
    Vec3 sum;
    if (size == 0) return sum;
    const auto side = [&](std::size_t i) { return (0.5 * corners[i] - 0.5 * corners[0]) / size; };
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += cross(side(i), side(i + 1));
    return sum;
}

PolygonFault PolygonCutter::cut(std::span<const Vec3> corners, std::vector<Triangle>& triangles) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    if (n == 3) {
        triangles.push_back({0, 1, 2});
        return PolygonFault::None;
    }
    const Vec3 area = area_vector(corners);
    if (!(max_abs(area) > 0)) {
        add_fan(n, triangles);
        return PolygonFault::NotSimple;
    }
    flatten(corners, area, flat_);
    if (is_fan(flat_)) {
        add_fan(n, triangles);
        return PolygonFault::None;
    }
    if (n > kMaxConcaveCorners) return PolygonFault::TooManyCorners;
    steps_ += std::uint64_t{n} * n;
    const bool is_simple = !crosses_itself(flat_);
    const bool is_cut = EarClipper(flat_).run(triangles);
    return is_simple && is_cut ? PolygonFault::None : PolygonFault::NotSimple;
}

}  // namespace bouguer::renderer
