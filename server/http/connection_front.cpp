// SPDX-License-Identifier: Apache-2.0
#include "server/http/connection_front.h"

#include <sys/epoll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <random>

#include "renderer/core/hash.h"
#include "server/http/plain_answer.h"

namespace bouguer::server {
namespace {

constexpr std::uint64_t kListenerId = 0, kMailId = 1;
constexpr std::size_t kReadBytes = 16U << 10U;
constexpr int kStepsInARow = 32, kAcceptsInARow = 64;   // then the others have their turn
constexpr std::size_t kTurnedAwayAtOnce = 128;          // with an answer; more without
constexpr std::chrono::milliseconds kLookInterval{50};  // how exact deadlines are
constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";

constexpr Refusal kOverloaded{503, "busy", "The server is busy; try again shortly."};
constexpr Refusal kUnreadable{500, "storage-failed", "A stored file cannot be read."};
constexpr Refusal kMisdirected{421, "misdirected-request",
                               "This server does not go by the host that the request names; its "
                               "operator can allow it with --allowed-host."};
constexpr Refusal kTooSlow{408, "request-timeout", "The request did not arrive in time."};

void watch(int epoll, int fd, std::uint64_t id, std::uint32_t events) {
    epoll_event event{};
    event.events = events;
    event.data.u64 = id;
    ::epoll_ctl(epoll, EPOLL_CTL_ADD, fd, &event);
}

std::chrono::milliseconds transfer_time(std::size_t bytes, const HttpDeadlines& deadlines) {
    return deadlines.transfer +
           std::chrono::milliseconds(bytes * 1000 / deadlines.bytes_per_second);
}

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK; }

/// Ids of clients are repeated in answers and logs: short, and harmless in both.
bool is_good_request_id(const std::string& id) {
    return !id.empty() && id.size() <= 64 && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               c == '-' || c == '_' || c == '.';
    });
}

}  // namespace

ConnectionFront::ConnectionFront(Listener listener, const HttpOptions& options, FrontParts parts)
    : options_(options),
      parts_(std::move(parts)),
      listener_(std::move(listener)),
      port_(listener_->port()),
      hosts_(options.host, port_, options.allowed_hosts),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)),
      request_salt_((std::uint64_t{std::random_device{}()} << 32U) | std::random_device{}()),
      pool_(options.handler_threads, options.limits.waiting_requests,
            [this](std::unique_ptr<Exchange> exchange) { work(std::move(exchange)); }) {
    watch(epoll_.get(), listener_->fd(), kListenerId, EPOLLIN);
    watch(epoll_.get(), mail_->fd(), kMailId, EPOLLIN);
    thread_ = std::thread([this] { run(); });
}

ConnectionFront::~ConnectionFront() {
    stopping_ = true;
    mail_->signal();
    thread_.join();
    pool_.stop();
    // what was answered too late: an exchange holds the mailbox, which must not hold the exchange
    (void)mail_->take();
}

void ConnectionFront::begin_drain() {
    draining_ = true;
    mail_->signal();
}

void ConnectionFront::run() {
    auto last_look = Clock::now();
    while (!stopping_) {
        std::array<epoll_event, 256> events{};
        const int patience_ms = !unfinished_.empty()   ? 0
                                : connections_.empty() ? -1
                                                       : static_cast<int>(kLookInterval.count());
        const int n = ::epoll_wait(epoll_.get(), events.data(), events.size(), patience_ms);
        for (const std::uint64_t id : std::exchange(unfinished_, {})) advance(id);
        for (int i = 0; i < n; ++i) {
            const std::uint64_t id = events[i].data.u64;
            if (id == kListenerId) {
                accept_some();
            } else if (id == kMailId) {
                read_mail();
            } else {
                advance(id);
            }
        }
        if (draining_ && !drain_begun_) drain();
        if (Clock::now() - last_look >= kLookInterval) {
            keep_deadlines();
            last_look = Clock::now();
        }
    }
    connections_.clear();
}

void ConnectionFront::work(std::unique_ptr<Exchange> exchange) {
    exchange->waiting.reset();
    parts_.handle(*exchange);
    if (auto got = exchange->content.read(0, exchange->content.size(), exchange->answer); !got) {
        exchange->error = got.error().message;
        exchange->status = kUnreadable.status;
        exchange->answer = refusal_bytes(kUnreadable, exchange->request_id);
        exchange->close = true;
    }
    exchange->content = {};
    if (!exchange->stream && !exchange->waiting) log(*exchange);
    const std::uint64_t connection = exchange->connection;
    mail_->post({connection, std::move(exchange)});
}

void ConnectionFront::log(const Exchange& exchange) const {
    if (parts_.log) parts_.log(access_record(exchange));
}

void ConnectionFront::accept_some() {
    for (int i = 0; i < kAcceptsInARow && listener_; ++i) {
        auto accepted = listener_->accept();
        if (!accepted) return;
        const bool welcome = connections() < options_.max_connections;
        if (welcome || *turned_away_ < kTurnedAwayAtOnce) add(std::move(*accepted), welcome);
    }
}

void ConnectionFront::add(Accepted accepted, bool welcome) {
    const std::uint64_t id = next_id_++;
    auto connection = std::make_unique<Connection>(id, std::move(accepted.fd),
                                                   ConnectionSlot(welcome ? open_ : turned_away_),
                                                   std::move(accepted.client), options_.limits);
    Connection& c = *connections_.emplace(id, std::move(connection)).first->second;
    // edge-triggered and never changed again: the state says whether an edge matters
    watch(epoll_.get(), c.fd.get(), id, EPOLLIN | EPOLLOUT | EPOLLRDHUP | EPOLLET);
    start_reading(c);
    if (!welcome) refuse(c, kOverloaded);
    advance(id);
}

void ConnectionFront::read_mail() {
    for (Message& message : mail_->take()) {
        const auto it = connections_.find(message.connection);
        if (it == connections_.end()) continue;
        if (message.exchange) {
            finish(*it->second, std::move(message.exchange));
        } else {
            resume(*it->second);
        }
        advance(message.connection);
    }
}

void ConnectionFront::drain() {
    drain_begun_ = true;
    listener_.reset();
    std::vector<std::uint64_t> ids;
    for (auto& [id, c] : connections_) {
        const bool idle = c->state == Connection::State::Reading && !c->reader.begun(c->in);
        if (idle) c->state = Connection::State::Closed;
        resume(*c);
        ids.push_back(id);
    }
    for (const std::uint64_t id : ids) advance(id);
}

void ConnectionFront::keep_deadlines() {
    const auto now = Clock::now();
    std::vector<std::uint64_t> late;
    for (const auto& [id, c] : connections_) {
        if (c->state != Connection::State::Handling && now >= c->deadline) late.push_back(id);
    }
    for (const std::uint64_t id : late) {
        on_timeout(*connections_.at(id));
        advance(id);
    }
}

void ConnectionFront::on_timeout(Connection& c) {
    if (c.state == Connection::State::Waiting) {
        resume(c);
    } else if (c.state == Connection::State::Reading && c.reader.begun(c.in)) {
        refuse(c, kTooSlow);
    } else {
        c.state = Connection::State::Closed;
    }
}

void ConnectionFront::advance(std::uint64_t id) {
    const auto it = connections_.find(id);
    if (it == connections_.end()) return;
    Connection& c = *it->second;
    bool more = true;
    for (int steps = 0; more; ++steps) {
        if (steps == kStepsInARow) {
            unfinished_.push_back(id);
            return;
        }
        switch (c.state) {
            case Connection::State::Reading:
                more = read_some(c);
                break;
            case Connection::State::Writing:
                more = write_some(c);
                break;
            case Connection::State::Lingering:
                more = linger(c);
                break;
            case Connection::State::Handling:
            case Connection::State::Waiting:
                return;
            case Connection::State::Closed:
                reserve(c, 0);
                connections_.erase(it);
                return;
        }
    }
}

bool ConnectionFront::read_some(Connection& c) {
    if (!c.in.empty()) {
        const bool had_head = c.reader.state() != RequestReader::State::Head;
        const auto state = c.reader.feed(c.in);
        if (state == RequestReader::State::Refused) {
            refuse(c, c.reader.refusal());
        } else if (state != RequestReader::State::Head) {
            if (!had_head) on_head(c);
            if (c.state == Connection::State::Reading && state == RequestReader::State::Complete) {
                on_request(c);
            }
        }
        if (c.state != Connection::State::Reading) return true;
    }
    std::array<char, kReadBytes> bytes;
    const bool begun = c.reader.begun(c.in);
    const auto n = ::recv(c.fd.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (n < 0 && errno == EINTR) return true;
    if (n < 0 && would_block()) return false;
    if (n <= 0) {
        c.state = Connection::State::Closed;
        return true;
    }
    if (!begun) c.deadline = Clock::now() + options_.deadlines.head;
    c.in.append(bytes.data(), static_cast<std::size_t>(n));
    return true;
}

void ConnectionFront::on_head(Connection& c) {
    // before anything is done for it, and for every path: whoever is deceived gets no answer
    if (!hosts_.allows(c.reader.head())) return refuse(c, kMisdirected);
    const std::size_t size = c.reader.expected_body();
    // Uploads have a budget of their own, so that slow ones hold up nothing but each other.
    const bool is_upload = c.reader.head().is_upload();
    const bool has_room = is_upload ? uploading_ + size <= options_.limits.upload_bytes
                                    : reserved_ + size <= options_.limits.buffered_bytes;
    if (!has_room) return refuse(c, kOverloaded);
    is_upload ? reserve_upload(c, size) : reserve(c, size);
    c.deadline = Clock::now() + transfer_time(size, options_.deadlines);
    if (c.reader.state() == RequestReader::State::Body && c.reader.head().expects_continue) {
        // the socket's buffer is empty between requests: these few bytes fit
        ::send(c.fd.get(), kContinue.data(), kContinue.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    }
}

bool ConnectionFront::write_some(Connection& c) {
    while (c.sent < c.out.size()) {
        const auto n = ::send(c.fd.get(), c.out.data() + c.sent, c.out.size() - c.sent,
                              MSG_DONTWAIT | MSG_NOSIGNAL);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && would_block()) return false;
        if (n < 0) {
            c.state = Connection::State::Closed;
            return true;
        }
        c.sent += static_cast<std::size_t>(n);
    }
    if (!c.close_after) {
        start_reading(c);
        return true;
    }
    c.out = {};
    reserve(c, 0);
    ::shutdown(c.fd.get(), SHUT_WR);
    c.state = Connection::State::Lingering;
    c.deadline = Clock::now() + options_.deadlines.linger;
    return true;
}

bool ConnectionFront::linger(Connection& c) {
    std::array<char, kReadBytes> ignored;
    const auto n = ::recv(c.fd.get(), ignored.data(), ignored.size(), MSG_DONTWAIT);
    if (n < 0 && would_block()) return false;
    if (n == 0 || (n < 0 && errno != EINTR)) c.state = Connection::State::Closed;
    return true;
}

void ConnectionFront::start_reading(Connection& c) {
    c.out = {};
    reserve(c, 0);
    c.reader = RequestReader(options_.limits);
    c.state = Connection::State::Reading;
    c.deadline = Clock::now() + (c.in.empty() ? options_.deadlines.idle : options_.deadlines.head);
    if (draining_ && c.in.empty()) c.state = Connection::State::Closed;
}

void ConnectionFront::start_writing(Connection& c, std::string bytes) {
    c.out = std::move(bytes);
    c.sent = 0;
    reserve(c, c.out.size());
    c.state = Connection::State::Writing;
    c.deadline = Clock::now() + transfer_time(c.out.size(), options_.deadlines);
}

void ConnectionFront::refuse(Connection& c, const Refusal& refusal) {
    const auto exchange = new_exchange(c);
    exchange->status = refusal.status;
    exchange->answer = refusal_bytes(refusal, exchange->request_id);
    log(*exchange);
    c.close_after = true;
    c.in = {};
    start_writing(c, std::move(exchange->answer));
}

void ConnectionFront::on_request(Connection& c) {
    ++c.requests;
    auto exchange = new_exchange(c);
    exchange->body = std::move(c.reader.body());
    exchange->close = !exchange->head.keep_alive || draining_ ||
                      c.requests >= options_.limits.requests_per_connection;
    if (parts_.answer_health(*exchange)) {
        log(*exchange);
        c.close_after = exchange->close;
        start_writing(c, std::move(exchange->answer));
    } else {
        dispatch(c, std::move(exchange));
    }
}

void ConnectionFront::dispatch(Connection& c, std::unique_ptr<Exchange> exchange) {
    c.state = Connection::State::Handling;
    if (reserved_ <= options_.limits.buffered_bytes && pool_.try_submit(exchange)) return;
    c.reader.head() = std::move(exchange->head);  // for the log
    refuse(c, kOverloaded);
}

void ConnectionFront::finish(Connection& c, std::unique_ptr<Exchange> exchange) {
    if (exchange->waiting) return park(c, std::move(exchange));
    if (exchange->stream) {
        ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, c.fd.get(), nullptr);
        parts_.hub->adopt(std::move(c.fd), std::move(c.slot), std::move(exchange));
        c.state = Connection::State::Closed;
        return;
    }
    c.close_after = exchange->close;
    start_writing(c, std::move(exchange->answer));
}

void ConnectionFront::park(Connection& c, std::unique_ptr<Exchange> exchange) {
    c.deadline = Clock::now() + exchange->waiting->at_most;
    c.state = Connection::State::Waiting;
    // the job may have ended before its wait reached us
    const bool over = exchange->waiting->ended->load() || draining_;
    c.parked = std::move(exchange);
    if (over) resume(c);
}

void ConnectionFront::resume(Connection& c) {
    if (c.state != Connection::State::Waiting) return;
    c.parked->waited = true;
    dispatch(c, std::move(c.parked));
}

void ConnectionFront::reserve(Connection& c, std::size_t bytes) {
    (c.is_upload ? uploading_ : reserved_) -= c.reserved;
    reserved_ += bytes;
    c.reserved = bytes;
    c.is_upload = false;
}

void ConnectionFront::reserve_upload(Connection& c, std::size_t bytes) {
    reserve(c, 0);
    uploading_ += bytes;
    c.reserved = bytes;
    c.is_upload = true;
}

std::string ConnectionFront::new_request_id() {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::uint64_t word = renderer::mix(request_salt_ + ++request_count_);
    std::string id;
    for (unsigned shift = 0; shift < 64; shift += 4) id += kDigits[(word >> shift) & 15U];
    return id;
}

std::unique_ptr<Exchange> ConnectionFront::new_exchange(Connection& c) {
    auto exchange = std::make_unique<Exchange>();
    exchange->connection = c.id;
    exchange->head = std::move(c.reader.head());
    exchange->client = c.client;
    exchange->arrived = Clock::now();
    exchange->wake = [mail = mail_, id = c.id] { mail->post({id, nullptr}); };
    const std::string* own = exchange->head.find("X-Request-Id");
    exchange->request_id = own != nullptr && is_good_request_id(*own) ? *own : new_request_id();
    return exchange;
}

}  // namespace bouguer::server
