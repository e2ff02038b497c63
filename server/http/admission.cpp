// SPDX-License-Identifier: Apache-2.0
#include "server/http/admission.h"

#include <mutex>
#include <unordered_map>

namespace bouguer::server {

struct Place::Book {
    std::mutex mutex;
    std::size_t taken = 0;                                 ///< guarded by mutex
    std::unordered_map<std::string, std::size_t> clients;  ///< guarded by mutex; none with 0
};

Place::Place(std::shared_ptr<Book> book, std::string client)
    : book_(std::move(book)), client_(std::move(client)) {}

Place::~Place() {
    if (book_ == nullptr) return;
    const std::lock_guard lock(book_->mutex);
    --book_->taken;
    const auto found = book_->clients.find(client_);
    if (--found->second == 0) book_->clients.erase(found);
}

Admission::Admission(std::size_t places, std::size_t share)
    : places_(places), share_(share), book_(std::make_shared<Place::Book>()) {}

std::optional<Place> Admission::admit(const std::string& client) {
    std::string name = client;  // before anything is counted: it may throw
    const std::lock_guard lock(book_->mutex);
    if (book_->taken >= places_) return std::nullopt;
    const auto entry = book_->clients.try_emplace(client, 0).first;
    if (entry->second >= share_) return std::nullopt;
    ++entry->second;
    ++book_->taken;
    return Place(book_, std::move(name));
}

std::size_t Admission::taken() const {
    const std::lock_guard lock(book_->mutex);
    return book_->taken;
}

}  // namespace bouguer::server
