// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_ids.h"

#include <algorithm>
#include <random>

#include "renderer/core/hash.h"

namespace bouguer::server {
namespace {

/// Ids of clients are repeated in answers and logs: short, and harmless in both.
bool is_good(const std::string& id) {
    return !id.empty() && id.size() <= 64 && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               c == '-' || c == '_' || c == '.';
    });
}

}  // namespace

RequestIds::RequestIds()
    : salt_((std::uint64_t{std::random_device{}()} << 32U) | std::random_device{}()) {}

std::string RequestIds::id_of(const RequestHead& head) {
    const std::string* own = head.find("X-Request-Id");
    if (own != nullptr && is_good(*own)) return *own;
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::uint64_t word = renderer::mix(salt_ + ++count_);
    std::string id;
    for (unsigned shift = 0; shift < 64; shift += 4) id += kDigits[(word >> shift) & 15U];
    return id;
}

}  // namespace bouguer::server
