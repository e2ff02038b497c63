// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "renderer/geometry/mesh_edges.h"
#include "renderer/geometry/mesh_nesting.h"
#include "renderer/geometry/winding_sets.h"

namespace bouguer::renderer {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Sides = std::span<const TriangleSide>;

/// What is known of a piece: triangles that hang together.
struct Piece {
    bool is_closed = true;
    std::uint64_t triangles = 0, turned = 0;
    Real volume = 0;     ///< six times it, as the first triangle winds
    Real magnitude = 0;  ///< of what was added up
    Vec3 origin;

    void add(const std::array<Vec3, 3>& corners, bool is_turned) {
        if (triangles++ == 0) origin = corners[0];
        if (is_turned) ++turned;
        const Real part = dot(corners[0] - origin, cross(corners[1] - origin, corners[2] - origin));
        volume += is_turned ? -part : part;
        magnitude += std::abs(part);
    }
    /// Whether most triangles stand against the first.
    [[nodiscard]] bool first_is_odd() const { return 2 * turned > triangles; }
    /// Whether it is inside out, as most of its triangles wind.
    [[nodiscard]] bool is_inside_out() const {
        const Real least = 64 * std::numeric_limits<Real>::epsilon() * magnitude;
        return first_is_odd() ? volume > least : volume < -least;
    }
};

class Topology {
  public:
    explicit Topology(const TriangleMesh& mesh) : mesh_(mesh) {
        const auto first = welded(mesh.positions);
        corners_.reserve(mesh.triangles.size() + mesh.flat_triangles.size());
        for (const auto* list : {&mesh.triangles, &mesh.flat_triangles}) {
            for (const Triangle& t : *list)
                corners_.push_back({first[t[0]], first[t[1]], first[t[2]]});
        }
        kept_.assign(corners_.size(), true);
        sets_ = WindingSets(corners_.size());
    }

    std::shared_ptr<const TriangleMesh> mend() {
        leave_out_doubled();
        find_pieces();
        turn_outwards();
        put_together();
        return std::make_shared<const TriangleMesh>(std::move(mesh_));
    }

  private:
    [[nodiscard]] std::vector<TriangleSide> sides() const {
        return sorted_sides(corners_, kept_, mesh_.positions.size());
    }

    void leave_out_doubled() {
        std::vector<std::pair<Triangle, std::uint32_t>> order;
        order.reserve(corners_.size());
        for (const Triangle& triangle : corners_) {
            Triangle key = triangle;
            std::sort(key.begin(), key.end());
            order.emplace_back(key, static_cast<std::uint32_t>(order.size()));
        }
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> in_pairs;  // the first of each place that has an even number
        for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
            if (order[i].first != order[first].first) first = i;
            if (i > first) kept_[order[i].second] = false;
            const bool is_last = i + 1 == order.size() || order[i + 1].first != order[i].first;
            if (is_last && (i - first) % 2 != 0) in_pairs.push_back(order[first].second);
        }
        if (!in_pairs.empty()) dissolve_walls(in_pairs);
    }

    /// Leaves out triangles that lie in one place in pairs altogether, wherever what hangs together
    /// is open with them and closed without.
    void dissolve_walls(const std::vector<std::uint32_t>& in_pairs) {
        WindingSets together(corners_.size());
        const auto before = sides();
        for_each_edge(before, [&](Sides edge) {
            for (const TriangleSide& side : edge)
                together.join(edge[0].triangle, side.triangle, false);
        });
        const auto open_sets = [&](const std::vector<TriangleSide>& all) {
            std::vector<bool> is_open(corners_.size());
            for_each_edge(all, [&](Sides edge) {
                if (edge.size() % 2 != 0) is_open[together.find(edge[0].triangle).set] = true;
            });
            return is_open;
        };
        const auto set_of = [&](std::uint32_t t) { return together.find(t).set; };
        const auto is_open = open_sets(before);
        for (const std::uint32_t t : in_pairs) kept_[t] = kept_[t] && !is_open[set_of(t)];
        const auto is_still_open = open_sets(sides());
        std::vector<bool> is_left(corners_.size());
        for (std::uint32_t t = 0; t < corners_.size(); ++t) {
            if (kept_[t]) is_left[set_of(t)] = true;
        }
        for (const std::uint32_t t : in_pairs)
            kept_[t] = kept_[t] || is_still_open[set_of(t)] || !is_left[set_of(t)];
    }

    /// Fills sets_ and pieces_, and finds what is open.
    void find_pieces() {
        const auto all = sides();
        for_each_edge(all, [&](Sides edge) {
            if (edge.size() == 2 && !join(edge[0], edge[1])) topology_.is_one_sided = true;
        });
        for_each_edge(all, [&](Sides edge) { join_around(edge); });
        number_pieces();
        for_each_edge(all, [&](Sides edge) {
            if (balance(edge) == 0) return;
            ++topology_.open_edges;
            for (const TriangleSide& side : edge)
                pieces_[piece_of_[side.triangle]].is_closed = false;
        });
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (!kept_[t]) continue;
            const auto at = [&](std::size_t k) { return mesh_.positions[corners_[t][k]]; };
            pieces_[piece_of_[t]].add({at(0), at(1), at(2)}, is_odd(t));
        }
    }

    void number_pieces() {
        piece_of_.assign(corners_.size(), MeshPieces::kNone);
        for (std::uint32_t t = 0; t < corners_.size(); ++t) {
            const std::uint32_t set = sets_.find(t).set;
            if (piece_of_[set] == MeshPieces::kNone) {
                piece_of_[set] = static_cast<std::uint32_t>(pieces_.size());
                pieces_.emplace_back();
            }
            piece_of_[t] = piece_of_[set];
        }
    }

    /// Whether a triangle winds otherwise than the first of its piece.
    bool is_odd(std::uint32_t t) { return sets_.find(t).is_turned; }

    /// Two sides at an edge run against each other where their triangles wind alike.
    bool join(const TriangleSide& a, const TriangleSide& b) {
        return sets_.join(a.triangle, b.triangle, a.runs_up == b.runs_up);
    }

    /// How many more sides of a piece run up an edge than down it, as its first triangle winds.
    int balance(Sides edge, std::uint32_t piece = MeshPieces::kNone) {
        int sum = 0;
        for (const TriangleSide& side : edge) {
            const auto [set, is_turned] = sets_.find(side.triangle);
            if (piece == MeshPieces::kNone || piece == set)
                sum += side.runs_up != is_turned ? 1 : -1;
        }
        return sum;
    }

    /// Where more than two triangles meet, each piece may be closed by itself, as two cubes that
    /// touch along an edge are. Those that are not are one, and wind as the file has them.
    void join_around(Sides edge) {
        constexpr std::size_t kMost = 64;  // beyond, nobody knows what is meant
        if (edge.size() <= 2 || edge.size() % 2 != 0 || edge.size() > kMost) return;
        std::vector<const TriangleSide*> up, down;
        for (const TriangleSide& side : edge) {
            if (balance(edge, sets_.find(side.triangle).set) == 0) continue;
            (side.runs_up ? up : down).push_back(&side);
        }
        while (!up.empty() && !down.empty()) {
            sets_.join(up.back()->triangle, down.back()->triangle, false);
            up.pop_back();
            down.pop_back();
        }
    }

    /// Decides into turns_ which triangles of every piece are turned round.
    void turn_outwards() {
        MeshPieces closed;
        std::vector<std::uint32_t> number(pieces_.size(), MeshPieces::kNone);
        std::vector<bool> is_inside_out;
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            turns_.push_back(pieces_[i].first_is_odd());
            if (pieces_[i].triangles == 0 || !pieces_[i].is_closed) continue;
            number[i] = closed.count++;
            is_inside_out.push_back(pieces_[i].is_inside_out());
        }
        if (std::find(is_inside_out.begin(), is_inside_out.end(), true) == is_inside_out.end())
            return;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            const std::uint32_t piece = piece_of_[t];
            closed.of.push_back(kept_[t] ? number[piece] : MeshPieces::kNone);
            closed.faces_in.push_back(pieces_[piece].is_inside_out() !=
                                      (is_odd(t) != turns_[piece]));
        }
        const auto outermost = outermost_pieces(mesh_, closed);
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            if (number[i] == MeshPieces::kNone) continue;
            const std::uint32_t outer = outermost[number[i]];
            if (outer != MeshPieces::kNone && is_inside_out[outer]) turns_[i] = !turns_[i];
        }
    }

    void put_together() {
        std::size_t kept = 0;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (!kept_[t]) {
                ++topology_.doubled_triangles;
                continue;
            }
            Triangle corners = mesh_.triangles[t];
            if (is_odd(t) != turns_[piece_of_[t]]) {
                std::swap(corners[1], corners[2]);
                ++topology_.flipped_triangles;
            }
            mesh_.triangles[kept++] = corners;
        }
        const std::size_t first_flat = mesh_.triangles.size();
        mesh_.triangles.resize(kept);
        std::size_t kept_flat = 0;
        for (std::size_t i = 0; i < mesh_.flat_triangles.size(); ++i) {
            if (kept_[first_flat + i]) mesh_.flat_triangles[kept_flat++] = mesh_.flat_triangles[i];
        }
        mesh_.flat_triangles.resize(kept_flat);
        topology_.is_closed = topology_.open_edges == 0 && !topology_.is_one_sided;
        mesh_.topology = topology_;
    }

    TriangleMesh mesh_;
    std::vector<Triangle> corners_;  ///< welded; flat triangles behind the others
    std::vector<bool> kept_;
    WindingSets sets_{0};
    std::vector<std::uint32_t> piece_of_;  ///< by triangle
    std::vector<Piece> pieces_;
    std::vector<bool> turns_;  ///< by piece: whether those are turned that wind as the first, or
                               ///< else those that do not
    MeshTopology topology_;
};

}  // namespace

std::shared_ptr<const TriangleMesh> mended_mesh(const std::shared_ptr<const TriangleMesh>& mesh) {
    const auto is_out_of_range = [&](const Triangle& t) {
        return std::max({t[0], t[1], t[2]}) >= mesh->positions.size();
    };
    const bool is_unsound =
        std::any_of(mesh->triangles.begin(), mesh->triangles.end(), is_out_of_range);
    return mesh->topology || is_unsound ? mesh : Topology(*mesh).mend();
}

}  // namespace bouguer::renderer
