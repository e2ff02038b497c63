// SPDX-License-Identifier: Apache-2.0
#include "server/http/door.h"

#include <sys/epoll.h>

namespace bouguer::server {

Door::Door(Listener listener, int epoll, std::uint64_t id)
    : listener_(std::move(listener)), epoll_(epoll), id_(id) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = id_;
    ::epoll_ctl(epoll_, EPOLL_CTL_ADD, listener_.fd(), &event);
}

void Door::listen_for(std::uint32_t events) const {
    epoll_event event{};
    event.events = events;
    event.data.u64 = id_;
    ::epoll_ctl(epoll_, EPOLL_CTL_MOD, listener_.fd(), &event);
}

std::optional<Accepted> Door::accept(Clock::time_point now) {
    if (is_resting()) return std::nullopt;
    auto accepted = listener_.accept();
    if (accepted) return std::move(*accepted);
    if (accepted.error() == NoClient::OutOfResources) {
        resting_until_ = now + kRest;
        listen_for(0);
    }
    return std::nullopt;
}

void Door::look(Clock::time_point now) {
    if (!is_resting() || now < *resting_until_) return;
    resting_until_.reset();
    listen_for(EPOLLIN);
}

}  // namespace bouguer::server
