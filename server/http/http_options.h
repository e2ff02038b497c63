// SPDX-License-Identifier: Apache-2.0
// What the HTTP side may be told: addresses, bounds and deadlines. Plain data.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/http/authority.h"

namespace bouguer::server {

/// Bounds on what one client, or all together, may make the daemon hold. Each has a test that hits
/// it.
struct HttpLimits {
    std::size_t head_bytes = 16U << 10U;   ///< request line and header fields together; beyond: 431
    std::size_t header_fields = 100;       ///< beyond: 431
    std::size_t target_bytes = 2048;       ///< path and query; beyond: 414
    std::size_t body_bytes = 8U << 20U;    ///< after removal of the chunked coding; beyond: 413
    std::size_t asset_bytes = 64U << 20U;  ///< the same, of an uploaded file
    // Of these three a client has a share (ConnectionPlan::share_of); beyond either: 503.
    std::size_t upload_bytes = 256U << 20U;    ///< bodies of uploads, as far as they have arrived
    std::size_t buffered_bytes = 512U << 20U;  ///< likewise other bodies; answers in memory
    std::size_t waiting_requests = 4096;       ///< for a handler thread
    std::size_t event_buffer_bytes = 64U << 10U;  ///< unsent events of a watcher; beyond: dropped
    std::size_t event_bytes = 64U << 20U;         ///< of all watchers; then each has less
    int requests_per_connection = 10'000;
};

/// Nothing that a client sends or reads prolongs them, but for a transfer, whose least rate it has
/// to keep (Pace).
struct HttpDeadlines {
    std::chrono::milliseconds head{5'000};   ///< from the first byte of a request to its last field
    std::chrono::milliseconds idle{60'000};  ///< between requests, and before the first byte
    std::chrono::milliseconds reserved_place{1'000};  ///< to ask about health beyond the limit
    std::chrono::milliseconds body{3'000};            ///< in hand when a body begins
    std::chrono::milliseconds body_pause{10'000};     ///< the longest that a body may come to rest
    std::chrono::milliseconds answer_pause{20'000};   ///< likewise the reading of an answer
    std::size_t bytes_per_second = 16U << 10U;        ///< least rate of bodies and of answers
    std::chrono::milliseconds linger{1'000};  ///< for the peer to read the answer before a close
    std::chrono::milliseconds drain{10'000};  ///< for requests under way when the daemon stops
    std::chrono::milliseconds heartbeat{15'000};       ///< comment on a silent event stream
    std::chrono::milliseconds progress_interval{250};  ///< least time between progress events
    std::chrono::seconds longest_wait{30};             ///< that `Prefer: wait` may ask for
};

struct HealthAddress {
    std::string host;
    int port = 0;  ///< 0: any free one
};

struct HttpOptions {
    std::string host = "127.0.0.1";
    int port = 8080;  ///< 0: any free one
    int handler_threads = 4;
    /// Hosts that this server goes by beside those that its address implies (HostPolicy).
    std::vector<Authority> allowed_hosts;
    /// Event streams included; beyond: 503. 0: 16,384. Never more than descriptors allow.
    std::size_t max_connections = 0;
    std::size_t max_connections_per_client = 0;  ///< beyond: 503. 0: a quarter of them
    /// A listener of its own for /livez and /readyz; empty: there is none.
    std::optional<HealthAddress> health;
    /// Origins of web pages elsewhere that may call the API, e.g. "https://example.org"; "*" is
    /// every one, but for reading only, "null" a page opened from a file.
    std::vector<std::string> cors_origins;
    HttpLimits limits;
    HttpDeadlines deadlines;
};

/// One request, answered. Event streams are reported when they end.
struct AccessRecord {
    std::string method;
    std::string path;  ///< with the query; printable ASCII only
    int status = 0;
    double milliseconds = 0;  ///< from the last byte of the request to the answer
    std::uint64_t bytes = 0;  ///< of the answer, its head included
    std::string request_id;
    std::string client;  ///< numeric address
    std::string error;   ///< what went wrong inside; never sent to the client
};

/// Called from several threads; must not throw and should not block. May be empty.
using AccessLog = std::function<void(const AccessRecord&)>;

}  // namespace bouguer::server
