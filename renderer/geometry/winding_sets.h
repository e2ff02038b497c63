// SPDX-License-Identifier: Apache-2.0
// Sets of triangles that hang together, and which of a set have to be turned round.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace bouguer::renderer {

/// Disjoint sets whose members each stand one of two ways round [Tarjan 1975, with parity].
class WindingSets {
  public:
    explicit WindingSets(std::size_t size) : parent_(size), turned_(size), size_(size, 1) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    struct Place {
        std::uint32_t set;
        bool is_turned;  ///< against the first of the set
    };
    [[nodiscard]] Place find(std::uint32_t i) {
        bool turned = false;
        std::uint32_t root = i;
        for (; parent_[root] != root; root = parent_[root]) turned = turned != turned_[root];
        const Place place{root, turned};
        while (parent_[i] != root) {  // makes the next way shorter
            const std::uint32_t next = parent_[i];
            const bool rest = turned != turned_[i];
            parent_[i] = root;
            turned_[i] = turned;
            turned = rest;
            i = next;
        }
        return place;
    }

    /// Joins the sets of a and b, so that they stand the same way round or opposite ones. False:
    /// they are in one set, and stand otherwise.
    bool join(std::uint32_t a, std::uint32_t b, bool opposite) {
        Place first = find(a);
        Place second = find(b);
        const bool turns = (first.is_turned != second.is_turned) != opposite;
        if (first.set == second.set) return !turns;
        if (size_[first.set] < size_[second.set]) std::swap(first, second);
        parent_[second.set] = first.set;
        turned_[second.set] = turns;
        size_[first.set] += size_[second.set];
        return true;
    }

  private:
    std::vector<std::uint32_t> parent_;
    std::vector<bool> turned_;  ///< against the parent
    std::vector<std::uint32_t> size_;
};

}  // namespace bouguer::renderer
