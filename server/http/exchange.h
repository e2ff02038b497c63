// SPDX-License-Identifier: Apache-2.0
// One request and what becomes of it, on its way from the front to a handler thread and back.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "server/content.h"
#include "server/http/event_inbox.h"
#include "server/http/http_options.h"
#include "server/http/request_head.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

using Clock = std::chrono::steady_clock;

/// An answer that goes on: the connection is handed to the event hub after the head.
struct EventStream {
    std::shared_ptr<EventInbox> inbox;
    std::unique_ptr<Subscription> subscription;  ///< destroyed before the inbox is forgotten
};

/// A request that waits for a job to end, without a thread (`Prefer: wait`).
struct Waiting {
    std::shared_ptr<std::atomic<bool>> ended;  ///< set by the listener before it calls wake
    std::unique_ptr<Subscription> subscription;
    std::chrono::seconds at_most{};
};

struct Exchange {
    std::uint64_t connection = 0;  ///< the front's name for it
    RequestHead head;
    std::string body;
    std::string client;      ///< numeric address of the peer
    std::string client_key;  ///< whose share it counts to: client_key() of that
    std::string request_id;  ///< the client's own, if it is a short token, or ours
    Clock::time_point arrived;
    bool close = false;          ///< the connection ends with this answer
    bool waited = false;         ///< back from waiting: answer now
    std::function<void()> wake;  ///< ends a wait; from any thread, any time

    int status = 0;
    std::string answer;  ///< head and body as they go over the wire
    Content content;     ///< more of the body, sent after `answer`
    std::string error;   ///< for the log alone
    std::unique_ptr<EventStream> stream;
    std::unique_ptr<Waiting> waiting;
};

/// What the log gets of a finished exchange.
[[nodiscard]] AccessRecord access_record(const Exchange& exchange);

}  // namespace bouguer::server
