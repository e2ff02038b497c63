// SPDX-License-Identifier: Apache-2.0
// Which bodies a ray is inside of.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace bouguer::renderer {

/// A body that light goes through: an instance of an object. Bodies are numbered by priority: where
/// several overlap, the one with the lowest number is there (see BodyTable).
using BodyId = std::uint32_t;

/// The bodies around a ray, by number; a body whose parts overlap counts once for each. What the
/// ray passes through is the first [Schmidt and Budge 2002]. A small value, copied with the ray.
class MediumStack {
  public:
    static constexpr std::size_t kCapacity = 64;
    static constexpr BodyId kOutside = ~BodyId{0};

    MediumStack() = default;
    MediumStack(const MediumStack& other) { *this = other; }
    /// Copies what is in use only: most rays are in one body or none.
    MediumStack& operator=(const MediumStack& other) {
        size_ = other.size_;
        std::copy(other.begin(), other.end(), bodies_.data());
        return *this;
    }
    ~MediumStack() = default;

    /// The body that is where the ray is; kOutside when there is none.
    [[nodiscard]] BodyId current() const { return size_ == 0 ? kOutside : bodies_[0]; }
    [[nodiscard]] bool holds(BodyId body) const { return count(body) > 0; }
    [[nodiscard]] std::size_t count(BodyId body) const {
        return static_cast<std::size_t>(std::count(begin(), end(), body));
    }

    /// False when there is no room: the caller counts it.
    bool enter(BodyId body) {
        if (size_ == kCapacity) return false;
        BodyId* const at = std::upper_bound(bodies_.data(), bodies_.data() + size_, body);
        std::copy_backward(at, bodies_.data() + size_, bodies_.data() + size_ + 1);
        *at = body;
        ++size_;
        return true;
    }

    /// False when the ray was not inside `body`.
    bool leave(BodyId body) {
        BodyId* const end = bodies_.data() + size_;
        BodyId* const at = std::find(bodies_.data(), end, body);
        if (at == end) return false;
        std::copy(at + 1, end, at);
        --size_;
        return true;
    }

    [[nodiscard]] const BodyId* begin() const { return bodies_.data(); }
    [[nodiscard]] const BodyId* end() const { return bodies_.data() + size_; }

  private:
    std::array<BodyId, kCapacity> bodies_;  // only the first size_ mean anything
    std::size_t size_ = 0;
};

}  // namespace bouguer::renderer
