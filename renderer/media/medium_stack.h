// SPDX-License-Identifier: Apache-2.0
// Which bodies a ray is inside of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace bouguer::renderer {

/// The bodies that hold the ray, innermost last. What the ray passes through is the innermost one.
/// A small value, copied with the ray. Bodies are named by a number that is unique to object and
/// instance.
class MediumStack {
  public:
    static constexpr std::size_t kCapacity = 8;
    static constexpr std::uint64_t kOutside = ~std::uint64_t{0};

    [[nodiscard]] std::uint64_t innermost() const {
        return size_ == 0 ? kOutside : bodies_[size_ - 1];
    }
    [[nodiscard]] bool holds(std::uint64_t body) const { return find(body) < size_; }

    /// False when there is no room: the caller counts it.
    bool enter(std::uint64_t body) {
        if (size_ == kCapacity) return false;
        bodies_[size_++] = body;
        return true;
    }

    /// False when the ray was not inside `body`.
    bool leave(std::uint64_t body) {
        const std::size_t at = find(body);
        if (at == size_) return false;
        for (std::size_t i = at + 1; i < size_; ++i) bodies_[i - 1] = bodies_[i];
        --size_;
        return true;
    }

  private:
    /// The last entry of `body`; size_ when there is none.
    [[nodiscard]] std::size_t find(std::uint64_t body) const {
        for (std::size_t i = size_; i > 0; --i) {
            if (bodies_[i - 1] == body) return i - 1;
        }
        return size_;
    }

    std::array<std::uint64_t, kCapacity> bodies_{};
    std::size_t size_ = 0;
};

}  // namespace bouguer::renderer
