// SPDX-License-Identifier: Apache-2.0
#include "server/http/authority.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace bouguer::server {
namespace {

std::string lower(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return out;
}

bool is_name(std::string_view host) {
    return !host.empty() && std::all_of(host.begin(), host.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    });
}

/// The address as it is usually written; empty when it is none.
std::string usual_v6(const std::string& host) {
    in6_addr address{};
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (inet_pton(AF_INET6, host.c_str(), &address) != 1) return {};
    return inet_ntop(AF_INET6, &address, text.data(), text.size()) == nullptr ? "" : text.data();
}

/// An empty text is the port of the scheme, as "host:" is "host" [RFC 3986 §3.2.3].
bool read_port(std::string_view text, std::optional<int>& port) {
    if (text.empty()) return true;
    unsigned value = 0;  // unsigned: no sign is read
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || stop != text.data() + text.size() || value > 65535) return false;
    port = static_cast<int>(value);
    return true;
}

}  // namespace

std::optional<Authority> authority_from(std::string_view text) {
    Authority authority;
    std::string_view rest;
    if (text.substr(0, 1) == "[") {
        const auto end = text.find(']');
        if (end == std::string_view::npos) return std::nullopt;
        authority.host = usual_v6(std::string(text.substr(1, end - 1)));
        rest = text.substr(end + 1);
        if (authority.host.empty()) return std::nullopt;
    } else {
        const auto colon = std::min(text.find(':'), text.size());
        authority.host = lower(text.substr(0, colon));
        rest = text.substr(colon);
        if (!is_name(authority.host)) return std::nullopt;
        if (authority.host.size() > 1 && authority.host.back() == '.') authority.host.pop_back();
    }
    if (!rest.empty() && (rest.front() != ':' || !read_port(rest.substr(1), authority.port))) {
        return std::nullopt;
    }
    return authority;
}

bool is_address(const std::string& host) {
    in_addr v4{};
    return inet_pton(AF_INET, host.c_str(), &v4) == 1 || !usual_v6(host).empty();
}

bool is_loopback(std::string_view host) {
    const std::string text(host);
    in_addr v4{};
    if (inet_pton(AF_INET, text.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24U) == 127;
    in6_addr v6{};
    if (inet_pton(AF_INET6, text.c_str(), &v6) == 1) return IN6_IS_ADDR_LOOPBACK(&v6) != 0;
    return text == "localhost";
}

}  // namespace bouguer::server
