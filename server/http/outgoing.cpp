// SPDX-License-Identifier: Apache-2.0
#include "server/http/outgoing.h"

#include <algorithm>

namespace bouguer::server {

std::string Outgoing::take_room() {
    std::string room = std::exchange(bytes_, {});
    room.clear();
    sent_ = 0;
    return room;
}

void Outgoing::supply(std::string window) {
    at_ += window.size();
    bytes_ = std::move(window);
    sent_ = 0;
}

std::size_t Outgoing::held_bytes(const std::string& bytes, const Content& content) {
    if (content.is_in_memory()) return bytes.capacity() + content.memory_bytes();
    return std::max(bytes.capacity(), std::min(content.size(), kWindowBytes));
}

}  // namespace bouguer::server
