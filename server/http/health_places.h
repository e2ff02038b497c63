// SPDX-License-Identifier: Apache-2.0
// The few places for whoever only asks how we are, when all others are taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <utility>

namespace bouguer::server {

/// There is always a place for the newest: whoever asks about health does so at once and is gone
/// again, so the oldest gives way, that of the same client first if it has its share already. One
/// thread only; outlives its seats.
class HealthPlaces {
  public:
    /// Both at least 1. `share`: the most that one client can have.
    HealthPlaces(std::size_t places, std::size_t share) : places_(places), share_(share) {}
    HealthPlaces(const HealthPlaces&) = delete;
    HealthPlaces& operator=(const HealthPlaces&) = delete;

    /// Ends with the connection that sits there.
    class Seat {
      public:
        Seat() = default;
        Seat(HealthPlaces& places, std::uint64_t connection)
            : places_(&places), connection_(connection) {}
        Seat(Seat&& other) noexcept
            : places_(std::exchange(other.places_, nullptr)), connection_(other.connection_) {}
        Seat& operator=(Seat&& other) noexcept {
            std::swap(places_, other.places_);
            std::swap(connection_, other.connection_);
            return *this;
        }
        Seat(const Seat&) = delete;
        Seat& operator=(const Seat&) = delete;
        ~Seat() {
            if (places_ != nullptr) places_->leave(connection_);
        }

      private:
        HealthPlaces* places_ = nullptr;
        std::uint64_t connection_ = 0;
    };

    struct Taken {
        Seat seat;
        std::optional<std::uint64_t> gives_way;  ///< a connection that has lost its place
    };
    [[nodiscard]] Taken take(std::uint64_t connection, const std::string& client);
    [[nodiscard]] std::size_t taken() const { return sitting_.size(); }

  private:
    struct Sitting {
        std::uint64_t connection = 0;
        std::string client;
    };
    using Line = std::list<Sitting>;

    void leave(std::uint64_t connection);
    [[nodiscard]] Line::iterator who_gives_way(const std::string& client);

    const std::size_t places_, share_;
    Line sitting_;  ///< oldest first
};

}  // namespace bouguer::server
