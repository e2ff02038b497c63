// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_nesting.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "renderer/geometry/bounds.h"

namespace bouguer::renderer {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/// Triangles in coordinates whose z axis is the direction that is looked along, in a tree of boxes.
class TriangleTree {
  public:
    using Corners = std::array<Vec3, 3>;

    TriangleTree(std::vector<Corners> triangles, std::vector<std::uint32_t> pieces,
                 std::uint64_t most_steps)
        : triangles_(std::move(triangles)), pieces_(std::move(pieces)), steps_left_(most_steps) {
        order_.resize(triangles_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
    }

    /// The first triangle above `from` that is not of `piece`; empty when there is none, or no
    /// steps are left to find it.
    std::optional<std::uint32_t> nearest_above(Vec3 from, std::uint32_t piece) {
        std::optional<std::uint32_t> found;
        Real best = kInfinity;
        std::vector<std::uint32_t> open{0};
        while (!open.empty() && steps_left_ > 0) {
            const std::uint32_t at = open.back();
            const Node& node = nodes_[at];
            open.pop_back();
            --steps_left_;
            const Bounds& box = node.box;
            if (from.x < box.lo.x || from.x > box.hi.x || from.y < box.lo.y || from.y > box.hi.y ||
                from.z > box.hi.z || box.lo.z > best)
                continue;
            if (node.right != 0) {
                const bool right_is_lower = nodes_[node.right].box.lo.z < nodes_[at + 1].box.lo.z;
                open.push_back(right_is_lower ? at + 1 : node.right);
                open.push_back(right_is_lower ? node.right : at + 1);
                continue;
            }
            for (std::uint32_t i = node.first; i < node.end; ++i) {
                const std::uint32_t t = order_[i];
                if (pieces_[t] == piece) continue;
                const Real z = height_over(triangles_[t], from);
                if (!(z > from.z && z < best)) continue;
                best = z;
                found = t;
            }
        }
        return is_exhausted() ? std::nullopt : found;
    }
    [[nodiscard]] bool is_exhausted() const { return steps_left_ == 0; }

    /// Whether a triangle's corners run counter-clockwise as seen from above.
    [[nodiscard]] bool faces_up(std::uint32_t t) const {
        const auto& [a, b, c] = triangles_[t];
        return cross(b - a, c - a).z > 0;
    }

  private:
    struct Node {
        Bounds box;
        std::uint32_t first = 0, end = 0;
        std::uint32_t right = 0;  ///< the left child follows; 0: a leaf
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t end) {
        constexpr std::uint32_t kLeaf = 4;
        const auto at = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({{}, first, end, 0});
        Bounds middles;
        for (std::uint32_t i = first; i < end; ++i) {
            for (const Vec3& p : triangles_[order_[i]]) nodes_[at].box.add(p);
            middles.add(middle(order_[i]));
        }
        if (end - first <= kLeaf) return at;
        const Vec3 size = middles.hi - middles.lo;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = first + (end - first) / 2;
        std::nth_element(
            order_.begin() + first, order_.begin() + half, order_.begin() + end,
            [&](std::uint32_t a, std::uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
        build(first, half);
        const std::uint32_t right = build(half, end);
        nodes_[at].right = right;
        return at;
    }

    [[nodiscard]] Vec3 middle(std::uint32_t t) const {
        const auto& [a, b, c] = triangles_[t];
        return a + b + c;
    }

    /// Where the line along z through p meets a triangle; NaN when it passes by.
    static Real height_over(const Corners& triangle, Vec3 p) {
        const Vec3 a = triangle[0] - p;
        const Vec3 b = triangle[1] - p;
        const Vec3 c = triangle[2] - p;
        const Real u = b.x * c.y - c.x * b.y;
        const Real v = c.x * a.y - a.x * c.y;
        const Real w = a.x * b.y - b.x * a.y;
        const bool is_hit = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        const Real sum = u + v + w;
        if (!is_hit || sum == 0) return std::numeric_limits<Real>::quiet_NaN();
        return p.z + (u * a.z + v * b.z + w * c.z) / sum;
    }

    std::vector<Corners> triangles_;
    std::vector<std::uint32_t> pieces_;
    std::uint64_t steps_left_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// Along no axis, no edge and no diagonal of what people make.
Frame viewing_frame() { return Frame(normalize(Vec3{0.5318620911, 0.6973440233, 0.4805519172})); }

/// Finds the outermost piece around each, piece by piece.
class Nesting {
  public:
    Nesting(const TriangleMesh& mesh, const MeshPieces& pieces)
        : found_(pieces.count), states_(pieces.count, State::New), outermost_(pieces.count) {
        std::vector<Vec3> tips(pieces.count, Vec3{0, 0, -kInfinity});
        starts_.resize(pieces.count);
        std::vector<TriangleTree::Corners> triangles;
        const Frame frame = viewing_frame();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const std::uint32_t piece = pieces.of[t];
            if (piece == MeshPieces::kNone) continue;
            auto& corners = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 p = mesh.positions[mesh.triangles[t][k]];
                corners[k] = {dot(frame.x, p), dot(frame.y, p), dot(frame.z, p)};
            }
            for (const Vec3& p : corners) {
                if (!(p.z > tips[piece].z)) continue;
                tips[piece] = p;
                starts_[piece] = near_tip(p, corners);
            }
            piece_of_.push_back(piece);
            faces_in_.push_back(pieces.faces_in[t]);
        }
        constexpr std::uint64_t kStepsATriangle = 60;
        const std::uint64_t most_steps = kStepsATriangle * piece_of_.size() + 1'000'000;
        tree_.emplace(std::move(triangles), piece_of_, most_steps);
    }

    std::vector<std::uint32_t> run() {
        std::vector<std::uint32_t> waiting;
        for (std::uint32_t piece = 0; piece < states_.size(); ++piece) {
            // What is found above a piece has to be known first, and what is above that.
            for (std::uint32_t at = piece; at != MeshPieces::kNone && states_[at] == State::New;) {
                states_[at] = State::Waits;
                waiting.push_back(at);
                found_[at] = look_up_from(at);
                at = found_[at].piece;
            }
            for (; !waiting.empty(); waiting.pop_back()) decide(waiting.back());
        }
        return std::move(outermost_);
    }

  private:
    enum class State : std::uint8_t { New, Waits, Done };
    struct Above {
        std::uint32_t piece = MeshPieces::kNone;  ///< the nearest; kNone when there is none
        bool is_around = false;
        bool is_known = true;
    };

    /// A point inside a triangle: other pieces may touch the tip itself.
    static Vec3 near_tip(Vec3 tip, const TriangleTree::Corners& corners) {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        return tip + 1e-3 * (middle - tip);
    }

    Above look_up_from(std::uint32_t piece) {
        const auto t = tree_->nearest_above(starts_[piece], piece);
        Above above;
        above.is_known = !tree_->is_exhausted();
        if (!t) return above;
        above.piece = piece_of_[*t];
        above.is_around = tree_->faces_up(*t) != faces_in_[*t];
        return above;
    }

    void decide(std::uint32_t piece) {
        const Above& above = found_[piece];
        states_[piece] = State::Done;
        outermost_[piece] = above.is_known ? piece : MeshPieces::kNone;
        // Pieces that cross each other may wait for each other.
        if (above.piece == MeshPieces::kNone || states_[above.piece] != State::Done) return;
        // Beside one that lies in a third, it lies in the third; beside an outermost one, in none.
        const std::uint32_t other = outermost_[above.piece];
        if (above.is_around || other != above.piece) outermost_[piece] = other;
    }

    std::vector<std::uint32_t> piece_of_;  ///< by triangle of the tree
    std::vector<bool> faces_in_;
    std::optional<TriangleTree> tree_;
    std::vector<Vec3> starts_;  ///< by piece, near its highest point
    std::vector<Above> found_;
    std::vector<State> states_;
    std::vector<std::uint32_t> outermost_;
};

}  // namespace

std::vector<std::uint32_t> outermost_pieces(const TriangleMesh& mesh, const MeshPieces& pieces) {
    if (pieces.count <= 1) return std::vector<std::uint32_t>(pieces.count, 0);
    return Nesting(mesh, pieces).run();
}

}  // namespace bouguer::renderer
