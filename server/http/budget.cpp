// SPDX-License-Identifier: Apache-2.0
#include "server/http/budget.h"

namespace bouguer::server {

std::size_t Budget::used_by(const std::string& client) const {
    const auto found = clients_.find(client);
    return found == clients_.end() ? 0 : found->second;
}

bool Budget::has_room(const std::string& client, std::size_t more) const {
    // what was counted without asking may have gone over a bound
    const auto fits = [more](std::size_t used, std::size_t bound) {
        return used <= bound && more <= bound - used;
    };
    return fits(used_, total_) && fits(used_by(client), share_);
}

void Budget::add(const std::string& client, std::size_t bytes) {
    clients_[client] += bytes;
    used_ += bytes;
}

void Budget::subtract(const std::string& client, std::size_t bytes) {
    used_ -= bytes;
    const auto found = clients_.find(client);
    found->second -= bytes;
    if (found->second == 0) clients_.erase(found);
}

bool Reservation::try_resize(std::size_t bytes) {
    if (bytes > bytes_ && (budget_ == nullptr || !budget_->has_room(client_, bytes - bytes_))) {
        return false;
    }
    resize(bytes);
    return true;
}

void Reservation::resize(std::size_t bytes) {
    if (budget_ == nullptr) return;
    if (bytes > bytes_) budget_->add(client_, bytes - bytes_);
    if (bytes < bytes_) budget_->subtract(client_, bytes_ - bytes);
    bytes_ = bytes;
}

}  // namespace bouguer::server
