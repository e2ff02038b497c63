// SPDX-License-Identifier: Apache-2.0
#include "server/http/connection_front.h"

#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <exception>

#include "server/http/refusals.h"

namespace bouguer::server {
namespace {

constexpr std::uint64_t kDoorId = 0, kHealthDoorId = 1, kMailId = 2, kFirstConnectionId = 3;
constexpr int kAcceptsInARow = 64;                      // then the others have their turn
constexpr std::chrono::milliseconds kLookInterval{50};  // how exact deadlines are

void watch(int epoll, int fd, std::uint64_t id, std::uint32_t events) {
    epoll_event event{};
    event.events = events;
    event.data.u64 = id;
    ::epoll_ctl(epoll, EPOLL_CTL_ADD, fd, &event);
}

/// Reads the beginning of an answer's file here, where waiting for the disk holds up nobody: most
/// files are sent without coming back to it.
void read_first_window(Exchange& exchange) {
    if (exchange.content.is_in_memory()) return;
    const std::size_t size = exchange.content.size();
    if (auto got = exchange.content.read(0, Outgoing::kWindowBytes, exchange.answer); !got) {
        answer_unreadable(exchange, got.error());
        return;
    }
    exchange.content = exchange.content.part(Outgoing::kWindowBytes, size);
}

}  // namespace

ConnectionFront::ConnectionFront(FrontListeners listeners, const HttpOptions& options,
                                 const ConnectionPlan& plan, FrontParts parts)
    : options_(options),
      parts_(std::move(parts)),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)),
      admission_(plan.connections, plan.share),
      reserved_(plan.health_places, std::max<std::size_t>(plan.health_places / 4, 1)),
      at_health_door_(plan.health_places, plan.health_places),
      buffered_(options.limits.buffered_bytes, plan.share_of(options.limits.buffered_bytes)),
      uploading_(options.limits.upload_bytes, plan.share_of(options.limits.upload_bytes)),
      next_id_(kFirstConnectionId),
      port_(listeners.all.port()),
      health_port_(listeners.health ? listeners.health->port() : 0),
      hosts_(options.host, port_, options.allowed_hosts),
      reader_([mail = mail_](std::uint64_t connection, Result<std::string> window) {
          mail->post_surely({connection, nullptr, std::move(window)});
      }),
      pool_({.threads = options.handler_threads,
             .waiting = options.limits.waiting_requests,
             .share = plan.share_of(options.limits.waiting_requests)},
            [this](std::unique_ptr<Exchange> exchange) { work(std::move(exchange)); }) {
    door_.emplace(std::move(listeners.all), epoll_.get(), kDoorId);
    if (listeners.health) {
        health_door_.emplace(std::move(*listeners.health), epoll_.get(), kHealthDoorId);
    }
    watch(epoll_.get(), mail_->fd(), kMailId, EPOLLIN);
    thread_ = std::thread([this] { run(); });
}

ConnectionFront::~ConnectionFront() {
    stopping_ = true;
    mail_->signal();
    thread_.join();
    pool_.stop();
    reader_.stop();
    // what was answered too late: an exchange holds the mailbox, which must not hold the exchange
    (void)mail_->take();
}

void ConnectionFront::begin_drain() {
    draining_ = true;
    mail_->signal();
}

int ConnectionFront::patience_ms() const {
    if (!unfinished_.empty()) return 0;
    const bool resting =
        (door_ && door_->is_resting()) || (health_door_ && health_door_->is_resting());
    if (connections_.empty() && !resting) return -1;
    return static_cast<int>(kLookInterval.count());
}

void ConnectionFront::run() {
    auto last_look = Clock::now();
    while (!stopping_) {
        std::array<epoll_event, 256> events{};
        const int n = ::epoll_wait(epoll_.get(), events.data(), events.size(), patience_ms());
        for (const std::uint64_t id : std::exchange(unfinished_, {})) on_event(id);
        for (int i = 0; i < n; ++i) on_event(events[i].data.u64);
        if (Clock::now() - last_look >= kLookInterval || draining_ != drain_begun_) {
            look_around();
            last_look = Clock::now();
        }
    }
    connections_.clear();
}

void ConnectionFront::look_around() {
    try {
        if (draining_ && !drain_begun_) drain();
        keep_deadlines();
    } catch (const std::exception&) {
        // no memory for a list: the next look will do
    }
    const auto now = Clock::now();
    if (door_) door_->look(now);
    if (health_door_) health_door_->look(now);
}

template <class Step>
void ConnectionFront::guarded(std::uint64_t id, Step step) {
    try {
        step();
    } catch (const std::exception&) {
        forget(id);
    }
}

void ConnectionFront::forget(std::uint64_t id) noexcept { connections_.erase(id); }

void ConnectionFront::on_event(std::uint64_t id) {
    if (id == kDoorId && door_) return accept_some(*door_, false);
    if (id == kHealthDoorId && health_door_) return accept_some(*health_door_, true);
    if (id == kMailId) return read_mail();
    guarded(id, [&] { advance(id); });
}

void ConnectionFront::accept_some(Door& door, bool for_health) {
    for (int i = 0; i < kAcceptsInARow; ++i) {
        bool is_over = false;
        guarded(next_id_, [&] {
            auto accepted = door.accept(Clock::now());
            is_over = !accepted;
            if (accepted) add(std::move(*accepted), for_health);
        });
        if (is_over) return;
    }
}

void ConnectionFront::add(Accepted accepted, bool for_health) {
    const std::uint64_t id = next_id_++;
    auto connection = std::make_unique<Connection>(id, std::move(accepted.fd),
                                                   std::move(accepted.client), options_.limits);
    Connection& c = *connections_.emplace(id, std::move(connection)).first->second;
    // edge-triggered and never changed again: the state says whether an edge matters
    watch(epoll_.get(), c.fd.get(), id, EPOLLIN | EPOLLOUT | EPOLLRDHUP | EPOLLET);
    if (for_health) c.access = Connection::Access::HealthDoor;
    seat(c);
    start_reading(c);
    advance(id);
}

void ConnectionFront::seat(Connection& c) {
    if (c.access == Connection::Access::All) c.place = admission_.admit(c.client_key);
    if (c.place) return;
    HealthPlaces* places = &at_health_door_;
    if (c.access == Connection::Access::All) {
        c.access = Connection::Access::Reserved;
        places = &reserved_;
    }
    auto taken = places->take(c.id, c.client_key);
    c.seat = std::move(taken.seat);
    if (!taken.gives_way) return;
    const std::uint64_t other = *taken.gives_way;
    guarded(other, [&] {
        on_timeout(*connections_.at(other));
        advance(other);
        forget(other);  // without waiting for it to read the answer
    });
}

void ConnectionFront::read_mail() {
    for (Message& message : mail_->take()) {
        const std::uint64_t id = message.connection;
        const auto it = connections_.find(id);
        if (it == connections_.end()) continue;
        guarded(id, [&] {
            on_mail(*it->second, std::move(message));
            advance(id);
        });
    }
}

void ConnectionFront::on_mail(Connection& c, Message message) {
    if (message.exchange) {
        finish(c, std::move(message.exchange));
    } else if (message.window) {
        on_window(c, std::move(*message.window));
    } else {
        resume(c);
    }
}

void ConnectionFront::drain() {
    door_.reset();
    std::vector<std::uint64_t> ids;
    for (auto& [id, c] : connections_) {
        if (c->access != Connection::Access::HealthDoor) ids.push_back(id);
    }
    drain_begun_ = true;
    for (const std::uint64_t id : ids) {
        guarded(id, [&] {
            Connection& c = *connections_.at(id);
            const bool idle = c.state == Connection::State::Reading && !c.reader.begun(c.in);
            if (idle) c.state = Connection::State::Closed;
            resume(c);
            advance(id);
        });
    }
}

void ConnectionFront::keep_deadlines() {
    const auto now = Clock::now();
    std::vector<std::uint64_t> late;
    for (const auto& [id, c] : connections_) {
        const bool is_ours =
            c->state == Connection::State::Handling || c->state == Connection::State::Fetching;
        // a wake that was lost is found here
        const bool waited = c->parked && c->parked->waiting->ended->load();
        if (!is_ours && (now >= c->deadline || waited)) late.push_back(id);
    }
    for (const std::uint64_t id : late) {
        guarded(id, [&] {
            on_timeout(*connections_.at(id));
            advance(id);
        });
    }
}

void ConnectionFront::work(std::unique_ptr<Exchange> exchange) noexcept {
    const std::uint64_t connection = exchange->connection;
    try {
        exchange->waiting.reset();
        parts_.handle(*exchange);
        if (!exchange->stream && !exchange->waiting) read_first_window(*exchange);
    } catch (const std::exception&) {
        // no memory to say so: the front closes what has no answer
        exchange->stream.reset();
        exchange->waiting.reset();
        exchange->answer.clear();
        exchange->content = {};
    }
    mail_->post_surely({connection, std::move(exchange), std::nullopt});
}

}  // namespace bouguer::server
