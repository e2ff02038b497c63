// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

#include "renderer/geometry/bounds.h"

namespace bouguer::renderer {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// For every vertex the first one at the same position.
std::vector<std::uint32_t> welded(const std::vector<Vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) {
        const Vec3 p = positions[i];
        return std::tuple(p.x, p.y, p.z);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// One side of a triangle, from the lower to the higher vertex.
struct Side {
    std::uint32_t low, high, triangle;
    bool runs_up;
};

/// How much of the piece's outline winds which way.
struct Piece {
    Bounds bounds;
    Real volume = 0;  ///< six times it; negative when wound inside out
    std::uint32_t first = 0;
};

class Topology {
  public:
    explicit Topology(const TriangleMesh& mesh) : mesh_(mesh) {
        first_at_ = welded(mesh.positions);
    }

    std::shared_ptr<const TriangleMesh> mend() {
        drop_doubled();
        find_sides();
        MeshTopology& topology = mesh_.topology.emplace();
        topology.doubled_triangles = doubled_;
        topology.open_edges = open_edges_;
        topology.is_closed = open_edges_ == 0 && wind_alike();
        if (topology.is_closed) {
            turn_outwards();
            for (std::size_t i = 0; i < flipped_.size(); ++i) {
                if (!flipped_[i]) continue;
                std::swap(mesh_.triangles[i][1], mesh_.triangles[i][2]);
                ++topology.flipped_triangles;
            }
        }
        return std::make_shared<const TriangleMesh>(std::move(mesh_));
    }

  private:
    [[nodiscard]] std::uint32_t corner(std::size_t triangle, std::size_t k) const {
        return first_at_[mesh_.triangles[triangle][k]];
    }

    void drop_doubled() {
        std::vector<std::pair<Triangle, std::uint32_t>> sorted;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            Triangle key{corner(i, 0), corner(i, 1), corner(i, 2)};
            std::sort(key.begin(), key.end());
            sorted.emplace_back(key, i);
        }
        std::sort(sorted.begin(), sorted.end());
        std::vector<bool> is_doubled(mesh_.triangles.size());
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            if (sorted[i].first != sorted[i - 1].first) continue;
            is_doubled[sorted[i].second] = true;
            ++doubled_;
        }
        if (doubled_ == 0) return;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (!is_doubled[i]) mesh_.triangles[kept++] = mesh_.triangles[i];
        }
        mesh_.triangles.resize(kept);
    }

    void find_sides() {
        sides_.reserve(3 * mesh_.triangles.size());
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = corner(i, k), b = corner(i, (k + 1) % 3);
                sides_.push_back({std::min(a, b), std::max(a, b), i, a < b});
            }
        }
        std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
            return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
        });
        neighbours_.resize(mesh_.triangles.size());
        for (std::size_t i = 0; i < sides_.size();) {
            std::size_t end = i;
            while (end < sides_.size() && sides_[end].low == sides_[i].low &&
                   sides_[end].high == sides_[i].high) {
                ++end;
            }
            if ((end - i) % 2 != 0) ++open_edges_;
            if (end - i == 2) link(sides_[i], sides_[i + 1]);
            i = end;
        }
    }

    void link(const Side& a, const Side& b) {
        const bool winds_alike = a.runs_up != b.runs_up;
        neighbours_[a.triangle].add({b.triangle, winds_alike});
        neighbours_[b.triangle].add({a.triangle, winds_alike});
    }

    /// Gives every triangle its piece and flips those that wind otherwise than its first one.
    /// False: a piece has one side only.
    bool wind_alike() {
        piece_of_.assign(mesh_.triangles.size(), kNoPiece);
        flipped_.assign(mesh_.triangles.size(), false);
        std::vector<std::uint32_t> open;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (piece_of_[i] != kNoPiece) continue;
            const auto piece = static_cast<std::uint32_t>(pieces_.size());
            pieces_.push_back({{}, 0, i});
            piece_of_[i] = piece;
            open.assign(1, i);
            while (!open.empty()) {
                const std::uint32_t t = open.back();
                open.pop_back();
                measure(t, pieces_[piece]);
                for (std::size_t k = 0; k < neighbours_[t].size; ++k) {
                    const auto [other, winds_alike] = neighbours_[t].all[k];
                    const bool flips = flipped_[t] == winds_alike;
                    if (piece_of_[other] == kNoPiece) {
                        piece_of_[other] = piece;
                        flipped_[other] = flips;
                        open.push_back(other);
                    } else if (flipped_[other] != flips) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    void measure(std::uint32_t t, Piece& piece) const {
        const Vec3 o = mesh_.positions[mesh_.triangles[piece.first][0]];
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = mesh_.positions[mesh_.triangles[t][k]];
            piece.bounds.add(p[k]);
        }
        const Real volume = dot(p[0] - o, cross(p[1] - o, p[2] - o));
        piece.volume += flipped_[t] ? -volume : volume;
    }

    /// Turns the outermost pieces that are inside out, and with each what is inside it.
    void turn_outwards() {
        std::vector<bool> turns(pieces_.size());
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const std::uint32_t outer = outermost_around(i);
            turns[i] = pieces_[outer].volume < 0;
        }
        for (std::size_t t = 0; t < flipped_.size(); ++t)
            flipped_[t] = flipped_[t] != turns[piece_of_[t]];
    }

    /// The largest piece that encloses a piece; itself when there is none. Of very many pieces the
    /// boxes must do.
    [[nodiscard]] std::uint32_t outermost_around(std::uint32_t piece) const {
        constexpr std::size_t kMany = 64;
        const bool by_box = pieces_.size() > kMany;
        std::uint32_t outer = piece;
        const auto size = [&](std::uint32_t i) { return length(pieces_[i].bounds.half_size()); };
        if (pieces_.size() > kMany * kMany) return piece;
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            if (i == piece || size(i) <= size(outer)) continue;
            const Bounds &box = pieces_[i].bounds, &own = pieces_[piece].bounds;
            if (min(box.lo, own.lo) != box.lo || max(box.hi, own.hi) != box.hi) continue;
            if (by_box || encloses(i, mesh_.positions[mesh_.triangles[pieces_[piece].first][0]]))
                outer = i;
        }
        return outer;
    }

    /// Whether a line from p crosses a piece an odd number of times, in double.
    [[nodiscard]] bool encloses(std::uint32_t piece, Vec3 p) const {
        const Vec3 d{0.48, 0.64, 0.6};  // along no axis
        bool inside = false;
        for (std::size_t t = 0; t < piece_of_.size(); ++t) {
            if (piece_of_[t] != piece) continue;
            const Vec3 a = mesh_.positions[mesh_.triangles[t][0]] - p;
            const Vec3 ab = mesh_.positions[mesh_.triangles[t][1]] - p - a;
            const Vec3 ac = mesh_.positions[mesh_.triangles[t][2]] - p - a;
            const Vec3 h = cross(d, ac);
            const Real det = dot(ab, h);
            const Real u = -dot(a, h) / det;
            const Vec3 q = cross(-a, ab);
            const Real v = dot(d, q) / det;
            if (u >= 0 && v >= 0 && u + v <= 1 && dot(ac, q) / det > 0) inside = !inside;
        }
        return inside;
    }

    struct Neighbour {
        std::uint32_t triangle;
        bool winds_alike;
    };
    struct Neighbours {
        std::array<Neighbour, 3> all;
        std::size_t size = 0;
        void add(Neighbour one) { all[size++] = one; }
    };
    static constexpr std::uint32_t kNoPiece = ~0U;

    TriangleMesh mesh_;
    std::vector<std::uint32_t> first_at_;
    std::vector<Side> sides_;
    std::vector<Neighbours> neighbours_;
    std::vector<std::uint32_t> piece_of_;
    std::vector<bool> flipped_;
    std::vector<Piece> pieces_;
    std::uint64_t doubled_ = 0, open_edges_ = 0;
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
