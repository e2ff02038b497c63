// SPDX-License-Identifier: Apache-2.0
// Who may connect: a number of places for all together and a share of them for each client.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace bouguer::server {

/// A connection's place; given back with the object, by whichever thread owns it then.
class Place {
  public:
    struct Book;
    Place(std::shared_ptr<Book> book, std::string client);
    Place(Place&& other) noexcept = default;
    Place& operator=(Place&& other) noexcept {
        std::swap(book_, other.book_);
        client_.swap(other.client_);
        return *this;
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place();

  private:
    std::shared_ptr<Book> book_;  ///< null: moved from
    std::string client_;
};

/// Thread-safe. Places may outlive it.
class Admission {
  public:
    /// `share`: the most of `places` that one client can have.
    Admission(std::size_t places, std::size_t share);

    /// Empty: all places are taken, or all of this client's share.
    [[nodiscard]] std::optional<Place> admit(const std::string& client);
    [[nodiscard]] std::size_t taken() const;

  private:
    const std::size_t places_, share_;
    std::shared_ptr<Place::Book> book_;
};

}  // namespace bouguer::server
