// SPDX-License-Identifier: Apache-2.0
// How many connections there may be, and how much of everything one client may have.
#pragma once

#include <cstddef>

#include "server/http/http_options.h"

namespace bouguer::server {

struct ConnectionPlan {
    std::size_t connections = 1;    ///< of all clients, event streams included
    std::size_t share = 1;          ///< of one client
    std::size_t health_places = 1;  ///< beyond them, and as many again at the door for health
    bool is_cut = false;            ///< fewer than the options ask for: descriptors are short

    /// The part of `whole` (bytes, waiting requests) that one client may have: as much as of the
    /// connections, but at least a quarter.
    [[nodiscard]] std::size_t share_of(std::size_t whole) const;
};

/// `descriptors`: how many files the process may have open. Some of them are kept for the store and
/// the workers, and each connection may need two, one for its socket and one for the file that it
/// is sent.
[[nodiscard]] ConnectionPlan plan_connections(const HttpOptions& options, std::size_t descriptors);

/// RLIMIT_NOFILE as it is now.
[[nodiscard]] std::size_t descriptor_limit();

}  // namespace bouguer::server
