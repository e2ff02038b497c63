// SPDX-License-Identifier: Apache-2.0
#include "server/http/client_key.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>

namespace bouguer::server {
namespace {

std::string text_of(int family, const void* address) {
    std::array<char, INET6_ADDRSTRLEN> text{};
    const char* written = ::inet_ntop(family, address, text.data(), text.size());
    return written == nullptr ? std::string() : std::string(written);
}

}  // namespace

std::string client_key(const std::string& numeric_address) {
    // a link-local address names its link behind a "%"
    const std::string plain = numeric_address.substr(0, numeric_address.find('%'));
    in6_addr address{};
    if (::inet_pton(AF_INET6, plain.c_str(), &address) != 1) return numeric_address;
    if (IN6_IS_ADDR_V4MAPPED(&address)) return text_of(AF_INET, &address.s6_addr[12]);
    std::fill(std::begin(address.s6_addr) + 8, std::end(address.s6_addr), std::uint8_t{0});
    return text_of(AF_INET6, &address) + "/64";
}

}  // namespace bouguer::server
