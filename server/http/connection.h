// SPDX-License-Identifier: Apache-2.0
// One client's connection as the front keeps it. Plain data; only the front's thread touches it.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "server/file_descriptor.h"
#include "server/http/exchange.h"
#include "server/http/request_reader.h"

namespace bouguer::server {

/// Counts a connection as long as it lives, whichever thread owns it.
class ConnectionSlot {
  public:
    using Counter = std::shared_ptr<std::atomic<std::size_t>>;
    explicit ConnectionSlot(Counter counter) : counter_(std::move(counter)) { ++*counter_; }
    ConnectionSlot(ConnectionSlot&& other) noexcept = default;
    ConnectionSlot& operator=(ConnectionSlot&& other) noexcept {
        std::swap(counter_, other.counter_);
        return *this;
    }
    ConnectionSlot(const ConnectionSlot&) = delete;
    ConnectionSlot& operator=(const ConnectionSlot&) = delete;
    ~ConnectionSlot() {
        if (counter_) --*counter_;
    }

  private:
    Counter counter_;
};

struct Connection {
    enum class State {
        Reading,    ///< a request comes in
        Handling,   ///< it is with the handler threads; nothing is read
        Waiting,    ///< it waits for a job (`parked`)
        Writing,    ///< the answer goes out
        Lingering,  ///< all is said; what still comes in is thrown away so that the answer arrives
        Closed      ///< to be forgotten
    };

    Connection(std::uint64_t name, FileDescriptor socket, ConnectionSlot counted,
               std::string address, const HttpLimits& limits)
        : id(name),
          fd(std::move(socket)),
          slot(std::move(counted)),
          client(std::move(address)),
          reader(limits) {}

    std::uint64_t id;
    FileDescriptor fd;
    ConnectionSlot slot;
    std::string client;  ///< numeric address
    RequestReader reader;

    State state = State::Reading;
    Clock::time_point deadline;  ///< of the present state; Handling has none
    std::string in;              ///< bytes received and not yet taken
    std::string out;             ///< bytes to be sent, from `sent` on
    std::size_t sent = 0;
    std::size_t reserved = 0;  ///< of a budget for bodies and answers
    bool is_upload = false;    ///< whether that is the budget of uploads
    bool close_after = false;  ///< the connection ends when `out` is sent
    int requests = 0;
    std::unique_ptr<Exchange> parked;
};

}  // namespace bouguer::server
