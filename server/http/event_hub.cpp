// SPDX-License-Identifier: Apache-2.0
#include "server/http/event_hub.h"

#include <sys/epoll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>

namespace bouguer::server {
namespace {

constexpr std::uint64_t kMailId = 0;
constexpr std::uint64_t kMostReceived = 64U << 10U;  // a watcher has nothing to say
constexpr std::chrono::milliseconds kSweepPending{50}, kSweepIdle{500};

}  // namespace

EventHub::EventHub(const HttpOptions& options, AccessLog log)
    : limits_(options.limits),
      deadlines_(options.deadlines),
      log_(std::move(log)),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = kMailId;
    ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, mail_->fd(), &event);
    thread_ = std::thread([this] { run(); });
}

EventHub::~EventHub() {
    stopping_ = true;
    mail_->signal();
    thread_.join();
}

void EventHub::adopt(FileDescriptor fd, Place place, std::unique_ptr<Exchange> exchange) {
    auto out = std::move(exchange->answer);
    mail_->post({next_id_++, std::make_unique<Stream>(Stream{.fd = std::move(fd),
                                                             .place = std::move(place),
                                                             .exchange = std::move(exchange),
                                                             .out = std::move(out),
                                                             .last_sent = Clock::now()})});
}

void EventHub::close_all() {
    closing_ = true;
    mail_->signal();
}

int EventHub::timeout_ms() const {
    if (streams_.empty()) return -1;
    const auto interval = some_pending_ ? kSweepPending : kSweepIdle;
    return static_cast<int>(std::min(interval, deadlines_.heartbeat).count());
}

void EventHub::run() {
    auto last_sweep = Clock::now();
    while (!stopping_) {
        std::array<epoll_event, 256> events{};
        const int n = ::epoll_wait(epoll_.get(), events.data(), events.size(), timeout_ms());
        for (int i = 0; i < n; ++i) {
            const std::uint64_t id = events[i].data.u64;
            if (id == kMailId) {
                read_mail();
            } else {
                guarded(id, [&] { on_socket(id, events[i].events); });
            }
        }
        if (closing_ ||
            Clock::now() - last_sweep >= std::min(kSweepPending, deadlines_.heartbeat)) {
            sweep();
            last_sweep = Clock::now();
        }
    }
    for (auto it = streams_.begin(); it != streams_.end();) it = drop(it);
}

void EventHub::read_mail() {
    for (Message& message : mail_->take()) {
        guarded(message.id, [&] {
            if (message.stream) add(message.id, std::move(message.stream));
            const auto it = streams_.find(message.id);
            if (it == streams_.end()) return;
            pump(*it->second);
            if (it->second->dead) drop(it);
        });
    }
}

template <class Step>
void EventHub::guarded(std::uint64_t id, Step step) {
    try {
        step();
    } catch (const std::bad_alloc&) {
        if (const auto it = streams_.find(id); it != streams_.end()) drop(it);
    }
}

void EventHub::add(std::uint64_t id, std::unique_ptr<Stream> stream) {
    epoll_event event{};
    event.events = EPOLLIN | EPOLLOUT | EPOLLRDHUP | EPOLLET;
    event.data.u64 = id;
    stream->dead = ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, stream->fd.get(), &event) != 0;
    const auto it = streams_.emplace(id, std::move(stream)).first;
    count_ = streams_.size();
    EventInbox& inbox = *it->second->exchange->stream->inbox;
    // the mailbox is shared with the listener: it may outlive the hub by a call
    inbox.on_push([mail = mail_, id] { mail->try_post({id, nullptr}); });
}

void EventHub::on_socket(std::uint64_t id, std::uint32_t events) {
    const auto it = streams_.find(id);
    if (it == streams_.end()) return;
    Stream& stream = *it->second;
    if ((events & (EPOLLHUP | EPOLLERR)) != 0) stream.dead = true;
    std::array<char, 4096> ignored{};
    while (!stream.dead && (events & (EPOLLIN | EPOLLRDHUP)) != 0) {
        const auto n = ::recv(stream.fd.get(), ignored.data(), ignored.size(), MSG_DONTWAIT);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
        if (n > 0) stream.received_bytes += static_cast<std::uint64_t>(n);
        stream.dead = n <= 0 || stream.received_bytes > kMostReceived;
    }
    if (!stream.dead) pump(stream);
    if (stream.dead) drop(it);
}

void EventHub::pump(Stream& stream) {
    const EventInbox::Taken taken = stream.exchange->stream->inbox->take(Clock::now());
    stream.out += taken.text;
    if (taken.pending) some_pending_ = true;
    send_some(stream);
    if (taken.overflow || stream.out.size() > allowance()) {
        stream.exchange->error = "slow event reader dropped";
        stream.dead = true;
    }
    if (stream.out.empty() && (taken.ended || closing_)) {
        ::shutdown(stream.fd.get(), SHUT_WR);
        stream.dead = true;
    }
}

std::size_t EventHub::allowance() const {
    return std::min(limits_.event_buffer_bytes,
                    limits_.event_bytes / std::max<std::size_t>(streams_.size(), 1));
}

void EventHub::send_some(Stream& stream) {
    std::size_t sent = 0;
    while (sent < stream.out.size()) {
        const auto n = ::send(stream.fd.get(), stream.out.data() + sent, stream.out.size() - sent,
                              MSG_DONTWAIT | MSG_NOSIGNAL);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno != EAGAIN && errno != EWOULDBLOCK) stream.dead = true;
        if (n < 0) break;
        sent += static_cast<std::size_t>(n);
    }
    if (sent == 0) return;
    stream.out.erase(0, sent);
    stream.sent_bytes += sent;
    stream.last_sent = Clock::now();
}

void EventHub::sweep() {
    some_pending_ = false;
    const auto now = Clock::now();
    for (auto it = streams_.begin(); it != streams_.end();) {
        Stream& stream = *it->second;
        try {
            if (stream.out.empty() && now - stream.last_sent >= deadlines_.heartbeat) {
                stream.out = ":\n\n";
            }
            pump(stream);
        } catch (const std::bad_alloc&) {
            stream.dead = true;
        }
        it = stream.dead ? drop(it) : std::next(it);
    }
}

void EventHub::log(const Stream& stream) const {
    if (!log_) return;
    try {
        AccessRecord record = access_record(*stream.exchange);
        record.bytes = stream.sent_bytes;
        log_(record);
    } catch (const std::bad_alloc&) {
        // goes unsaid
    }
}

EventHub::Streams::iterator EventHub::drop(Streams::iterator it) {
    Stream& stream = *it->second;
    // ends the subscription: no listener of this stream runs any more
    stream.exchange->stream->subscription.reset();
    log(stream);
    const auto next = streams_.erase(it);
    count_ = streams_.size();
    return next;
}

}  // namespace bouguer::server
