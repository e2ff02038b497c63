// SPDX-License-Identifier: Apache-2.0
// All server-sent event streams, on one thread: thousands of watchers cost a socket and a small
// buffer each, and no handler thread.
#pragma once

#include <atomic>
#include <thread>
#include <unordered_map>

#include "server/http/admission.h"
#include "server/http/exchange.h"
#include "server/http/mailbox.h"

namespace bouguer::server {

class EventHub {
  public:
    EventHub(const HttpOptions& options, AccessLog log);
    ~EventHub();  ///< closes every stream and joins
    EventHub(const EventHub&) = delete;
    EventHub& operator=(const EventHub&) = delete;

    /// Takes over a client's socket. `exchange` has a stream; its answer, the head, is sent first.
    /// From any thread.
    void adopt(FileDescriptor fd, Place place, std::unique_ptr<Exchange> exchange);

    /// Ends every stream, and every one that comes later, after what is buffered. From any thread.
    void close_all();

    [[nodiscard]] std::size_t streams() const { return count_.load(); }

  private:
    struct Stream {
        FileDescriptor fd;
        Place place;
        std::unique_ptr<Exchange> exchange;
        std::string out;  ///< received from the inbox and not yet sent
        std::uint64_t sent_bytes = 0, received_bytes = 0;
        std::chrono::steady_clock::time_point last_sent;
        bool dead = false;
    };
    /// A new stream, or, without one, the id of a stream whose inbox has something.
    struct Message {
        std::uint64_t id = 0;
        std::unique_ptr<Stream> stream;
    };
    using Streams = std::unordered_map<std::uint64_t, std::unique_ptr<Stream>>;

    void run();
    void read_mail();
    void add(std::uint64_t id, std::unique_ptr<Stream> stream);
    void on_socket(std::uint64_t id, std::uint32_t events);
    void sweep();
    /// Moves events from the inbox to the socket; marks the stream dead when it is over.
    void pump(Stream& stream);
    /// The most that a stream may leave unsent: less where there are many.
    [[nodiscard]] std::size_t allowance() const;
    void send_some(Stream& stream);
    Streams::iterator drop(Streams::iterator it);
    /// Does what concerns one stream; when memory runs out there, the stream is gone.
    template <class Step>
    void guarded(std::uint64_t id, Step step);
    void log(const Stream& stream) const;
    [[nodiscard]] int timeout_ms() const;

    const HttpLimits limits_;
    const HttpDeadlines deadlines_;
    const AccessLog log_;
    FileDescriptor epoll_;
    std::shared_ptr<Mailbox<Message>> mail_ = std::make_shared<Mailbox<Message>>();
    std::atomic<std::uint64_t> next_id_{1};
    std::atomic<std::size_t> count_{0};
    std::atomic<bool> closing_{false}, stopping_{false};
    Streams streams_;            ///< the hub's thread only
    bool some_pending_ = false;  ///< likewise: a progress event waits for its time
    std::thread thread_;
};

}  // namespace bouguer::server
