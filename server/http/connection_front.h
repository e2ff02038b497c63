// SPDX-License-Identifier: Apache-2.0
// The thread that owns every connection: it accepts, collects requests, sends answers and keeps the
// deadlines. Nothing that a client does or leaves undone can hold up another.
#pragma once

#include <atomic>
#include <thread>
#include <unordered_map>

#include "server/http/connection.h"
#include "server/http/event_hub.h"
#include "server/http/handler_pool.h"
#include "server/http/host_policy.h"
#include "server/http/listener.h"
#include "server/http/mailbox.h"

namespace bouguer::server {

/// What the front asks of the rest. All outlive it.
struct FrontParts {
    /// On a handler thread: fills the exchange's answer. Must not throw.
    std::function<void(Exchange&)> handle;
    /// On the front's own thread, so that it answers when all else is busy: fills the answer, or
    /// returns false when the request is not about health. Must be quick and not throw.
    std::function<bool(Exchange&)> answer_health;
    EventHub* hub = nullptr;
    AccessLog log;
};

class ConnectionFront {
  public:
    ConnectionFront(Listener listener, const HttpOptions& options, FrontParts parts);
    ~ConnectionFront();  ///< closes everything and joins
    ConnectionFront(const ConnectionFront&) = delete;
    ConnectionFront& operator=(const ConnectionFront&) = delete;

    [[nodiscard]] int port() const { return port_; }
    /// Open connections, those of the event hub included, without those that are being turned away.
    [[nodiscard]] std::size_t connections() const { return open_->load(); }

    /// Accepts nothing more, ends connections as soon as they are idle. From any thread.
    void begin_drain();

  private:
    /// An exchange that a handler has finished with, or, without one, the end of a wait.
    struct Message {
        std::uint64_t connection = 0;
        std::unique_ptr<Exchange> exchange;
    };
    using Connections = std::unordered_map<std::uint64_t, std::unique_ptr<Connection>>;

    void run();
    void accept_some();
    void add(Accepted accepted, bool welcome);
    void read_mail();
    void keep_deadlines();
    void drain();

    /// Brings a connection as far as it gets without waiting; closes it when it is over.
    void advance(std::uint64_t id);
    [[nodiscard]] bool read_some(Connection& c);   ///< false: wait for the socket
    [[nodiscard]] bool write_some(Connection& c);  ///< likewise
    [[nodiscard]] bool linger(Connection& c);      ///< likewise
    void on_head(Connection& c);
    void on_request(Connection& c);
    void on_timeout(Connection& c);
    void start_reading(Connection& c);
    void start_writing(Connection& c, std::string bytes);
    void refuse(Connection& c, const Refusal& refusal);
    void dispatch(Connection& c, std::unique_ptr<Exchange> exchange);
    void finish(Connection& c, std::unique_ptr<Exchange> exchange);
    void park(Connection& c, std::unique_ptr<Exchange> exchange);
    void resume(Connection& c);
    void reserve(Connection& c, std::size_t bytes);
    void reserve_upload(Connection& c, std::size_t bytes);
    [[nodiscard]] std::string new_request_id();
    [[nodiscard]] std::unique_ptr<Exchange> new_exchange(Connection& c);
    void log(const Exchange& exchange) const;
    void work(std::unique_ptr<Exchange> exchange);  ///< on a handler thread

    const HttpOptions options_;
    const FrontParts parts_;
    std::optional<Listener> listener_;  ///< empty once draining
    const int port_;
    const HostPolicy hosts_;
    FileDescriptor epoll_;
    std::shared_ptr<Mailbox<Message>> mail_ = std::make_shared<Mailbox<Message>>();
    ConnectionSlot::Counter open_ = std::make_shared<std::atomic<std::size_t>>(0);
    ConnectionSlot::Counter turned_away_ = std::make_shared<std::atomic<std::size_t>>(0);
    std::atomic<bool> draining_{false}, stopping_{false};

    // the front's thread only
    Connections connections_;
    std::vector<std::uint64_t> unfinished_;  ///< have more to read, but others have their turn
    bool drain_begun_ = false;
    std::uint64_t next_id_ = 2;  ///< 0 and 1 are the listener and the mailbox
    std::uint64_t request_salt_ = 0, request_count_ = 0;
    std::size_t reserved_ = 0;   ///< bytes of bodies and answers but those of uploads
    std::size_t uploading_ = 0;  ///< bytes of the bodies of uploads

    HandlerPool pool_;
    std::thread thread_;
};

}  // namespace bouguer::server
