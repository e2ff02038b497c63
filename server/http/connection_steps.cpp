// SPDX-License-Identifier: Apache-2.0
// What becomes of one connection: from the first byte of a request to the last of its answer.
#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

#include "server/http/connection_front.h"
#include "server/http/refusals.h"

namespace bouguer::server {
namespace {

constexpr std::size_t kReadBytes = 16U << 10U, kSendBytes = 64U << 10U;
constexpr int kStepsInARow = 32;  // then the others have their turn
// An answer of this size is sent whatever the budgets say: what was done is told. A head is no
// larger either.
constexpr std::size_t kSmallAnswer = 16U << 10U;
constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";

constexpr Refusal kOverloaded{503, "busy", "The server is busy; try again shortly."};
constexpr Refusal kMisdirected{421, "misdirected-request",
                               "This server does not go by the host that the request names; its "
                               "operator can allow it with --allowed-host."};
constexpr Refusal kTooSlow{408, "request-timeout", "The request did not arrive in time."};
constexpr Refusal kHealthOnly{404, "not-found", "Here are /livez and /readyz and nothing else."};

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK; }

Pace body_pace(const HttpDeadlines& deadlines) {
    return {{deadlines.body, deadlines.body_pause, deadlines.bytes_per_second}, Clock::now()};
}

Pace answer_pace(const HttpDeadlines& deadlines) {
    return {{deadlines.answer_pause, deadlines.answer_pause, deadlines.bytes_per_second},
            Clock::now()};
}

}  // namespace

void ConnectionFront::log(const Exchange& exchange) const {
    if (parts_.log) parts_.log(access_record(exchange));
}

void ConnectionFront::advance(std::uint64_t id) {
    const auto it = connections_.find(id);
    if (it == connections_.end()) return;
    Connection& c = *it->second;
    for (int steps = 0; step(c); ++steps) {
        if (steps == kStepsInARow) {
            unfinished_.push_back(id);
            return;
        }
    }
    if (c.state == Connection::State::Closed) forget(id);
}

bool ConnectionFront::step(Connection& c) {
    switch (c.state) {
        case Connection::State::Reading:
            return read_some(c);
        case Connection::State::Writing:
            return write_some(c);
        case Connection::State::Lingering:
            return linger(c);
        case Connection::State::Handling:
        case Connection::State::Waiting:
        case Connection::State::Fetching:
        case Connection::State::Closed:
            break;
    }
    return false;
}

void ConnectionFront::on_timeout(Connection& c) {
    if (c.state == Connection::State::Waiting) {
        resume(c);
    } else if (c.state != Connection::State::Reading) {
        c.state = Connection::State::Closed;
    } else if (c.access == Connection::Access::Reserved) {
        refuse(c, kOverloaded);
    } else if (c.reader.begun(c.in)) {
        refuse(c, kTooSlow);
    } else {
        c.state = Connection::State::Closed;
    }
}

bool ConnectionFront::read_some(Connection& c) {
    if (!c.in.empty()) {
        take_bytes(c);
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
    const auto now = Clock::now();
    if (!begun && c.access != Connection::Access::Reserved) {
        c.deadline = now + options_.deadlines.head;
    }
    if (c.reader.state() == RequestReader::State::Body) {
        c.pace.progress(static_cast<std::size_t>(n), now);
        c.deadline = c.pace.deadline();
    }
    c.in.append(bytes.data(), static_cast<std::size_t>(n));
    return true;
}

void ConnectionFront::take_bytes(Connection& c) {
    const bool had_head = c.reader.state() != RequestReader::State::Head;
    const auto state = c.reader.feed(c.in);
    if (state == RequestReader::State::Refused) return refuse(c, c.reader.refusal());
    if (!had_head && state != RequestReader::State::Head) on_head(c);
    if (c.state != Connection::State::Reading) return;
    if (!hold_request(c)) return refuse(c, kOverloaded);
    if (state == RequestReader::State::Complete) on_request(c);
}

bool ConnectionFront::hold_request(Connection& c) {
    const std::string& body = c.reader.body();
    const std::size_t bytes = c.in.capacity() + body.capacity();
    if (!body.empty()) return c.held.try_resize(bytes);
    c.held.resize(bytes);  // heads are small, and without them nobody could ask about health
    return true;
}

void ConnectionFront::on_head(Connection& c) {
    const RequestHead& head = c.reader.head();
    // before anything is done for it, and for every path: whoever is deceived gets no answer. At
    // the door for health there is nothing to be had, and probes come by any name.
    const bool is_judged = c.access != Connection::Access::HealthDoor;
    if (is_judged && !hosts_.allows(head)) return refuse(c, kMisdirected);
    const bool has_body = c.reader.state() == RequestReader::State::Body;
    if (has_body && c.access == Connection::Access::Reserved) return refuse(c, kOverloaded);
    if (has_body && c.access == Connection::Access::HealthDoor) return refuse(c, kHealthOnly);
    // Uploads have a budget of their own, so that slow ones hold up nothing but each other.
    c.held = Reservation(head.is_upload() ? uploading_ : buffered_, c.client_key);
    c.pace = body_pace(options_.deadlines);
    c.pace.progress(c.reader.body().size(), Clock::now());
    c.deadline = c.pace.deadline();
    if (has_body && head.expects_continue) {
        // the socket's buffer is empty between requests: these few bytes fit
        ::send(c.fd.get(), kContinue.data(), kContinue.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    }
}

bool ConnectionFront::write_some(Connection& c) {
    const std::string_view bytes = c.out.ready().substr(0, kSendBytes);
    if (bytes.empty()) {
        c.out.needs_window() ? fetch(c) : on_sent(c);
        return true;
    }
    const auto n = ::send(c.fd.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) return true;
    if (n < 0 && would_block()) return false;
    if (n < 0) {
        c.state = Connection::State::Closed;
        return true;
    }
    c.out.sent(static_cast<std::size_t>(n));
    c.pace.progress(static_cast<std::size_t>(n), Clock::now());
    c.deadline = c.pace.deadline();
    return true;
}

void ConnectionFront::fetch(Connection& c) {
    c.state = Connection::State::Fetching;
    c.fetch_begun = Clock::now();
    reader_.ask({c.id, c.out.next_window(), c.out.take_room()});
}

void ConnectionFront::on_window(Connection& c, Result<std::string> window) {
    if (!window) {
        // the length is announced already: to stop in the middle is all that can be said
        c.state = Connection::State::Closed;
        return;
    }
    c.out.supply(std::move(*window));
    c.pace.forgive(Clock::now() - c.fetch_begun);
    c.deadline = c.pace.deadline();
    c.state = Connection::State::Writing;
}

void ConnectionFront::on_sent(Connection& c) {
    if (!c.close_after) return start_reading(c);
    c.out = {};
    c.held.resize(0);
    ::shutdown(c.fd.get(), SHUT_WR);
    c.state = Connection::State::Lingering;
    c.deadline = Clock::now() + options_.deadlines.linger;
}

bool ConnectionFront::linger(Connection& c) {
    std::array<char, kReadBytes> ignored;
    const auto n = ::recv(c.fd.get(), ignored.data(), ignored.size(), MSG_DONTWAIT);
    if (n < 0 && would_block()) return false;
    if (n == 0 || (n < 0 && errno != EINTR)) c.state = Connection::State::Closed;
    return true;
}

void ConnectionFront::start_reading(Connection& c) {
    const HttpDeadlines& deadlines = options_.deadlines;
    c.out = {};
    if (c.in.empty()) c.in = {};  // an idle connection keeps no memory
    c.held = Reservation(buffered_, c.client_key);
    c.held.resize(c.in.capacity());
    c.reader = RequestReader(options_.limits);
    c.state = Connection::State::Reading;
    c.deadline = Clock::now() + (c.in.empty() ? deadlines.idle : deadlines.head);
    if (c.access == Connection::Access::Reserved) {
        c.deadline = Clock::now() + deadlines.reserved_place;
    }
    if (draining_ && c.in.empty() && c.access != Connection::Access::HealthDoor) {
        c.state = Connection::State::Closed;
    }
}

void ConnectionFront::start_writing(Connection& c, Outgoing out) {
    c.out = std::move(out);
    c.state = Connection::State::Writing;
    c.pace = answer_pace(options_.deadlines);
    c.deadline = c.pace.deadline();
}

void ConnectionFront::refuse(Connection& c, const Refusal& refusal) {
    const auto exchange = new_exchange(c);
    answer_refusal(*exchange, refusal);
    c.in = {};
    answer(c, *exchange);
}

void ConnectionFront::on_request(Connection& c) {
    ++c.requests;
    auto exchange = new_exchange(c);
    exchange->body = std::move(c.reader.body());
    const bool is_guest = c.access == Connection::Access::Reserved;
    exchange->close = !exchange->head.keep_alive || is_guest ||
                      c.requests >= options_.limits.requests_per_connection ||
                      (draining_ && c.access != Connection::Access::HealthDoor);
    if (!parts_.answer_health(*exchange)) {
        if (c.access == Connection::Access::All) return dispatch(c, std::move(exchange));
        answer_refusal(*exchange, is_guest ? kOverloaded : kHealthOnly);
    }
    answer(c, *exchange);
}

void ConnectionFront::dispatch(Connection& c, std::unique_ptr<Exchange> exchange) {
    c.state = Connection::State::Handling;
    if (pool_.try_submit(exchange)) return;
    answer_refusal(*exchange, kOverloaded);
    answer(c, *exchange);
}

void ConnectionFront::finish(Connection& c, std::unique_ptr<Exchange> exchange) {
    if (exchange->waiting) {
        park(c, std::move(exchange));
    } else if (exchange->stream) {
        ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, c.fd.get(), nullptr);
        parts_.hub->adopt(std::move(c.fd), std::move(*c.place), std::move(exchange));
        c.state = Connection::State::Closed;
    } else if (exchange->answer.empty()) {
        c.state = Connection::State::Closed;  // there was no memory for one
    } else {
        answer(c, *exchange);
    }
}

void ConnectionFront::answer(Connection& c, Exchange& exchange) {
    if (!hold_answer(c, exchange)) answer_refusal(exchange, kOverloaded);
    log(exchange);
    c.close_after = exchange.close;
    start_writing(c, Outgoing(std::move(exchange.answer), std::move(exchange.content)));
}

bool ConnectionFront::hold_answer(Connection& c, const Exchange& exchange) {
    const std::size_t bytes = Outgoing::held_bytes(exchange.answer, exchange.content);
    c.held = Reservation(buffered_, c.client_key);
    if (bytes > kSmallAnswer) return c.held.try_resize(bytes);
    c.held.resize(bytes);
    return true;
}

void ConnectionFront::park(Connection& c, std::unique_ptr<Exchange> exchange) {
    c.held.resize(0);
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

std::unique_ptr<Exchange> ConnectionFront::new_exchange(Connection& c) {
    auto exchange = std::make_unique<Exchange>();
    exchange->connection = c.id;
    exchange->head = std::move(c.reader.head());
    exchange->client = c.client;
    exchange->client_key = c.client_key;
    exchange->arrived = Clock::now();
    exchange->wake = [mail = mail_, id = c.id] { mail->try_post({id, nullptr, std::nullopt}); };
    exchange->request_id = request_ids_.id_of(exchange->head);
    return exchange;
}

}  // namespace bouguer::server
