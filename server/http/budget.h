// SPDX-License-Identifier: Apache-2.0
// Memory that the clients make us hold: a bound for all together and a share for each.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>

namespace bouguer::server {

class Reservation;

/// Counts bytes; nothing is allocated here. One thread only; outlives its reservations.
class Budget {
  public:
    /// `share`: the most of `total` that one client can have.
    Budget(std::size_t total, std::size_t share) : total_(total), share_(share) {}
    Budget(const Budget&) = delete;
    Budget& operator=(const Budget&) = delete;

    [[nodiscard]] std::size_t used() const { return used_; }
    [[nodiscard]] std::size_t used_by(const std::string& client) const;

  private:
    friend class Reservation;
    [[nodiscard]] bool has_room(const std::string& client, std::size_t more) const;
    void add(const std::string& client, std::size_t bytes);
    void subtract(const std::string& client, std::size_t bytes);

    const std::size_t total_, share_;
    std::size_t used_ = 0;
    std::unordered_map<std::string, std::size_t> clients_;  ///< only those that hold something
};

/// What one connection holds of a budget; given back with the object.
class Reservation {
  public:
    Reservation() = default;  ///< of nothing: cannot grow
    Reservation(Budget& budget, std::string client)
        : budget_(&budget), client_(std::move(client)) {}
    Reservation(Reservation&& other) noexcept { swap(other); }
    Reservation& operator=(Reservation&& other) noexcept {
        Reservation taken(std::move(other));
        swap(taken);
        return *this;
    }
    Reservation(const Reservation&) = delete;
    Reservation& operator=(const Reservation&) = delete;
    ~Reservation() { resize(0); }

    [[nodiscard]] std::size_t bytes() const { return bytes_; }

    /// False, and nothing changes, when that is more than there is or than the client's share. To
    /// hold less is always granted.
    [[nodiscard]] bool try_resize(std::size_t bytes);
    /// For what is small, bounded otherwise, and must not be refused: counts it without asking.
    void resize(std::size_t bytes);

  private:
    void swap(Reservation& other) noexcept {
        std::swap(budget_, other.budget_);
        client_.swap(other.client_);
        std::swap(bytes_, other.bytes_);
    }

    Budget* budget_ = nullptr;
    std::string client_;
    std::size_t bytes_ = 0;
};

}  // namespace bouguer::server
