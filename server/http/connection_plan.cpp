// SPDX-License-Identifier: Apache-2.0
#include "server/http/connection_plan.h"

#include <sys/resource.h>

#include <algorithm>

namespace bouguer::server {
namespace {

constexpr std::size_t kDefaultConnections = 16'384;
constexpr std::size_t kReserve = 128;  // descriptors for the store, the workers and the log
constexpr std::size_t kHealthPlaces = 64;
constexpr std::size_t kSmallestShare = 64;  // of connections, where the quarter is less

}  // namespace

std::size_t descriptor_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return 1024;
    return limit.rlim_cur;
}

std::size_t ConnectionPlan::share_of(std::size_t whole) const {
    const std::size_t quarter = (whole + 3) / 4;
    const double fraction = static_cast<double>(share) / static_cast<double>(connections);
    const auto alike = static_cast<std::size_t>(fraction * static_cast<double>(whole));
    return std::min(whole, std::max(quarter, alike));
}

ConnectionPlan plan_connections(const HttpOptions& options, std::size_t descriptors) {
    const std::size_t free = descriptors - std::min(kReserve, descriptors / 2);
    ConnectionPlan plan;
    plan.health_places = std::clamp<std::size_t>(free / 8, 1, kHealthPlaces);
    const std::size_t possible = std::max<std::size_t>((free - 2 * plan.health_places) / 2, 1);
    const std::size_t asked =
        options.max_connections > 0 ? options.max_connections : kDefaultConnections;
    plan.is_cut = asked > possible;
    plan.connections = std::min(asked, possible);
    const std::size_t quarter = std::max(plan.connections / 4, kSmallestShare);
    const std::size_t share =
        options.max_connections_per_client > 0 ? options.max_connections_per_client : quarter;
    plan.share = std::min(share, plan.connections);
    return plan;
}

}  // namespace bouguer::server
