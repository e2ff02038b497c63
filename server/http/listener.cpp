// SPDX-License-Identifier: Apache-2.0
#include "server/http/listener.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

namespace bouguer::server {
namespace {

constexpr int kBacklog = 1024;
// Of an answer no more than this waits in the kernel to be sent: what is said to be held in windows
// would else be held once more there.
constexpr int kUnsentBytes = 128 << 10;
constexpr unsigned kPeerSilence_ms = 30'000;  // unacknowledged data for that long: the peer is gone

using AddressList = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

void set_option(int fd, int level, int name, int value) {
    ::setsockopt(fd, level, name, &value, sizeof value);
}

FileDescriptor bound_socket(const addrinfo& address) {
    FileDescriptor fd(::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!fd) return fd;
    // REUSEADDR, never REUSEPORT: two daemons must not share a port unnoticed
    set_option(fd.get(), SOL_SOCKET, SO_REUSEADDR, 1);
    if (::bind(fd.get(), address.ai_addr, address.ai_addrlen) != 0 ||
        ::listen(fd.get(), kBacklog) != 0) {
        const int reason = errno;
        fd.reset();
        errno = reason;
    }
    return fd;
}

std::string numeric_address(const sockaddr_storage& address, socklen_t size) {
    std::array<char, NI_MAXHOST> text{};
    const int failed = ::getnameinfo(reinterpret_cast<const sockaddr*>(&address), size, text.data(),
                                     text.size(), nullptr, 0, NI_NUMERICHOST);
    return failed == 0 ? text.data() : "unknown";
}

int bound_port(int fd) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    std::array<char, NI_MAXSERV> text{};
    ::getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size);
    ::getnameinfo(reinterpret_cast<sockaddr*>(&address), size, nullptr, 0, text.data(), text.size(),
                  NI_NUMERICSERV);
    return std::atoi(text.data());
}

}  // namespace

Result<Listener> Listener::open(const std::string& host, int port) {
    addrinfo hints{};
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const int unresolved =
        ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
    const std::string where = host + ":" + std::to_string(port);
    if (unresolved != 0) {
        return fail(ErrorKind::Internal,
                    "cannot listen on " + where + ": " + ::gai_strerror(unresolved));
    }
    const AddressList addresses(found, &::freeaddrinfo);
    Listener listener;
    for (const addrinfo* a = found; a != nullptr && !listener.socket_; a = a->ai_next) {
        listener.socket_ = bound_socket(*a);
    }
    if (!listener.socket_) {
        return fail(ErrorKind::Internal, "cannot listen on " + where + ": " + std::strerror(errno));
    }
    listener.port_ = bound_port(listener.socket_.get());
    return listener;
}

tl::expected<Accepted, NoClient> Listener::accept() {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    FileDescriptor fd(::accept4(socket_.get(), reinterpret_cast<sockaddr*>(&address), &size,
                                SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!fd) {
        const bool is_ours =
            errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
        // whatever else went wrong belongs to that one client and is no reason to stop
        return tl::unexpected(is_ours ? NoClient::OutOfResources : NoClient::NoneWaits);
    }
    set_option(fd.get(), IPPROTO_TCP, TCP_NODELAY, 1);
    set_option(fd.get(), IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(kPeerSilence_ms));
    set_option(fd.get(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, kUnsentBytes);
    return Accepted{std::move(fd), numeric_address(address, size)};
}

}  // namespace bouguer::server
