// SPDX-License-Identifier: Apache-2.0
#include "server/http/health_places.h"

#include <algorithm>

namespace bouguer::server {

HealthPlaces::Line::iterator HealthPlaces::who_gives_way(const std::string& client) {
    const auto is_own = [&](const Sitting& s) { return s.client == client; };
    const auto own = std::count_if(sitting_.begin(), sitting_.end(), is_own);
    if (static_cast<std::size_t>(own) >= share_) {
        return std::find_if(sitting_.begin(), sitting_.end(), is_own);
    }
    return sitting_.size() >= places_ ? sitting_.begin() : sitting_.end();
}

HealthPlaces::Taken HealthPlaces::take(std::uint64_t connection, const std::string& client) {
    Taken taken;
    if (const auto leaving = who_gives_way(client); leaving != sitting_.end()) {
        taken.gives_way = leaving->connection;
        sitting_.erase(leaving);
    }
    sitting_.push_back({connection, client});
    taken.seat = Seat(*this, connection);
    return taken;
}

void HealthPlaces::leave(std::uint64_t connection) {
    std::erase_if(sitting_, [&](const Sitting& s) { return s.connection == connection; });
}

}  // namespace bouguer::server
