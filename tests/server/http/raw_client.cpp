// SPDX-License-Identifier: Apache-2.0
#include "tests/server/http/raw_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>

namespace bouguer::server::testing {
namespace {

constexpr int kPatience_ms = 2000;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    });
    return text;
}

}  // namespace

RawClient::RawClient(int port, const char* source)
    : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    ::inet_pton(AF_INET, source, &own.sin_addr);
    ::bind(fd_.get(), reinterpret_cast<sockaddr*>(&own), sizeof own);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(fd_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
        fd_.reset();
    }
}

void RawClient::send(std::string_view bytes) const {
    while (!bytes.empty()) {
        const auto n = ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (n <= 0) return;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
}

bool RawClient::more() {
    pollfd ready{fd_.get(), POLLIN, 0};
    if (::poll(&ready, 1, kPatience_ms) <= 0) return false;
    std::array<char, 65536> bytes;
    const auto n = ::recv(fd_.get(), bytes.data(), bytes.size(), 0);
    if (n <= 0) return false;
    buffer_.append(bytes.data(), static_cast<std::size_t>(n));
    return true;
}

RawResponse RawClient::receive(bool head_only) {
    RawResponse response;
    std::size_t end = 0;
    while ((end = buffer_.find("\r\n\r\n")) == std::string::npos) {
        if (!more()) return response;
    }
    std::string head = buffer_.substr(0, end + 2);
    buffer_.erase(0, end + 4);
    response.status = std::atoi(head.c_str() + 9);
    for (std::size_t at = head.find("\r\n") + 2; at < head.size();) {
        const std::size_t line_end = head.find("\r\n", at);
        const std::size_t colon = head.find(':', at);
        response.headers[lower(head.substr(at, colon - at))] =
            head.substr(colon + 2, line_end - colon - 2);
        at = line_end + 2;
    }
    if (head_only) return response;
    const auto size =
        static_cast<std::size_t>(std::atoll(response.header("content-length").c_str()));
    while (buffer_.size() < size && more()) {
    }
    response.body = buffer_.substr(0, size);
    buffer_.erase(0, size);
    return response;
}

std::string RawClient::receive_until(std::string_view text) {
    while (buffer_.find(text) == std::string::npos && more()) {
    }
    return std::exchange(buffer_, {});
}

bool RawClient::is_closed() {
    for (;;) {
        pollfd ready{fd_.get(), POLLIN, 0};
        if (::poll(&ready, 1, kPatience_ms) <= 0) return false;
        std::array<char, 4096> bytes;
        if (::recv(fd_.get(), bytes.data(), bytes.size(), 0) <= 0) return true;
    }
}

bool RawClient::has_answer() const {
    pollfd ready{fd_.get(), POLLIN, 0};
    return ::poll(&ready, 1, kPatience_ms) > 0;
}

void RawClient::finish_sending() const { ::shutdown(fd_.get(), SHUT_WR); }

std::string request_text(std::string_view method, std::string_view target,
                         const std::vector<std::string>& fields, std::string_view body) {
    std::string text;
    text.append(method).append(" ").append(target).append(" HTTP/1.1\r\nHost: localhost\r\n");
    for (const std::string& field : fields) text += field + "\r\n";
    if (!body.empty()) {
        text += "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
                "\r\n";
    }
    return text.append("\r\n").append(body);
}

}  // namespace bouguer::server::testing
