// SPDX-License-Identifier: Apache-2.0
// The thread that owns every connection: it accepts, collects requests, sends answers and keeps the
// deadlines. Nothing that a client does or leaves undone can hold up another.
#pragma once

#include <atomic>
#include <thread>
#include <unordered_map>

#include "server/http/connection.h"
#include "server/http/connection_plan.h"
#include "server/http/content_reader.h"
#include "server/http/door.h"
#include "server/http/event_hub.h"
#include "server/http/handler_pool.h"
#include "server/http/host_policy.h"
#include "server/http/mailbox.h"
#include "server/http/request_ids.h"

namespace bouguer::server {

/// What the front asks of the rest. All outlive it.
struct FrontParts {
    /// On a handler thread: fills the exchange's answer. Must not throw but for memory.
    std::function<void(Exchange&)> handle;
    /// On the front's own thread, so that it answers when all else is busy: fills the answer, or
    /// returns false when the request is not about health. Must be quick.
    std::function<bool(Exchange&)> answer_health;
    EventHub* hub = nullptr;
    AccessLog log;
};

struct FrontListeners {
    Listener all;
    std::optional<Listener> health;  ///< answers about health and nothing else, to the end
};

class ConnectionFront {
  public:
    ConnectionFront(FrontListeners listeners, const HttpOptions& options,
                    const ConnectionPlan& plan, FrontParts parts);
    ~ConnectionFront();  ///< closes everything and joins
    ConnectionFront(const ConnectionFront&) = delete;
    ConnectionFront& operator=(const ConnectionFront&) = delete;

    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] int health_port() const { return health_port_; }  ///< 0: there is none
    /// Open connections, those of the event hub included, without those that only may ask about
    /// health.
    [[nodiscard]] std::size_t connections() const { return admission_.taken(); }

    /// Accepts nothing more, ends connections as soon as they are idle. From any thread.
    void begin_drain();

  private:
    /// An exchange that a handler has finished with, a window of an answer, or, without either, the
    /// end of a wait.
    struct Message {
        std::uint64_t connection = 0;
        std::unique_ptr<Exchange> exchange;
        std::optional<Result<std::string>> window;
    };
    using Connections = std::unordered_map<std::uint64_t, std::unique_ptr<Connection>>;

    // connection_front.cpp: the loop, and who comes and goes
    void run();
    void look_around();
    void on_event(std::uint64_t id);
    void accept_some(Door& door, bool for_health);
    void add(Accepted accepted, bool for_health);
    void seat(Connection& c);
    void read_mail();
    void on_mail(Connection& c, Message message);
    void keep_deadlines();
    void drain();
    [[nodiscard]] int patience_ms() const;
    /// Does what concerns one connection; when memory runs out there, the connection is gone.
    template <class Step>
    void guarded(std::uint64_t id, Step step);
    void forget(std::uint64_t id) noexcept;
    void work(std::unique_ptr<Exchange> exchange) noexcept;  ///< on a handler thread

    // connection_steps.cpp: what becomes of one connection
    /// Brings a connection as far as it gets without waiting; closes it when it is over.
    void advance(std::uint64_t id);
    [[nodiscard]] bool step(Connection& c);        ///< false: wait for something to happen
    [[nodiscard]] bool read_some(Connection& c);   ///< likewise
    [[nodiscard]] bool write_some(Connection& c);  ///< likewise
    [[nodiscard]] bool linger(Connection& c);      ///< likewise
    [[nodiscard]] bool hold_request(Connection& c);
    void take_bytes(Connection& c);
    void on_head(Connection& c);
    void on_request(Connection& c);
    void on_timeout(Connection& c);
    void on_window(Connection& c, Result<std::string> window);
    void on_sent(Connection& c);
    void start_reading(Connection& c);
    void start_writing(Connection& c, Outgoing out);
    void fetch(Connection& c);
    void refuse(Connection& c, const Refusal& refusal);
    void dispatch(Connection& c, std::unique_ptr<Exchange> exchange);
    void finish(Connection& c, std::unique_ptr<Exchange> exchange);
    void answer(Connection& c, Exchange& exchange);
    [[nodiscard]] bool hold_answer(Connection& c, const Exchange& exchange);
    void park(Connection& c, std::unique_ptr<Exchange> exchange);
    void resume(Connection& c);
    [[nodiscard]] std::unique_ptr<Exchange> new_exchange(Connection& c);
    void log(const Exchange& exchange) const;

    const HttpOptions options_;
    const FrontParts parts_;
    FileDescriptor epoll_;
    std::shared_ptr<Mailbox<Message>> mail_ = std::make_shared<Mailbox<Message>>();
    Admission admission_;
    std::atomic<bool> draining_{false}, stopping_{false};

    // the front's thread only
    std::optional<Door> door_;  ///< empty once draining
    std::optional<Door> health_door_;
    HealthPlaces reserved_, at_health_door_;
    Budget buffered_, uploading_;
    Connections connections_;
    std::vector<std::uint64_t> unfinished_;  ///< have more to do, but others have their turn
    bool drain_begun_ = false;
    std::uint64_t next_id_;
    RequestIds request_ids_;

    const int port_, health_port_;
    const HostPolicy hosts_;
    ContentReader reader_;
    HandlerPool pool_;
    std::thread thread_;
};

}  // namespace bouguer::server
