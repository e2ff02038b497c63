// SPDX-License-Identifier: Apache-2.0
// One client's connection as the front keeps it. Plain data; only the front's thread touches it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "server/file_descriptor.h"
#include "server/http/admission.h"
#include "server/http/budget.h"
#include "server/http/client_key.h"
#include "server/http/exchange.h"
#include "server/http/health_places.h"
#include "server/http/outgoing.h"
#include "server/http/pace.h"
#include "server/http/request_reader.h"

namespace bouguer::server {

struct Connection {
    enum class State {
        Reading,    ///< a request comes in
        Handling,   ///< it is with the handler threads; nothing is read
        Waiting,    ///< it waits for a job (`parked`)
        Writing,    ///< the answer goes out
        Fetching,   ///< more of the answer is being read from its file
        Lingering,  ///< all is said; what still comes in is thrown away so that the answer arrives
        Closed      ///< to be forgotten
    };
    enum class Access {
        All,
        Reserved,   ///< one more than may be: health is answered, all else refused
        HealthDoor  ///< from the listener for health, where there is nothing else
    };

    Connection(std::uint64_t name, FileDescriptor socket, std::string address,
               const HttpLimits& limits)
        : id(name),
          fd(std::move(socket)),
          client(std::move(address)),
          client_key(server::client_key(client)),
          reader(limits) {}

    std::uint64_t id;
    FileDescriptor fd;
    std::string client;      ///< numeric address
    std::string client_key;  ///< whose share it counts to
    Access access = Access::All;
    std::optional<Place> place;  ///< with Access::All
    HealthPlaces::Seat seat;     ///< without
    RequestReader reader;

    State state = State::Reading;
    Clock::time_point deadline;  ///< of the present state; Handling and Fetching have none
    Pace pace;                   ///< of a body or an answer
    std::string in;              ///< bytes received and not yet taken
    Outgoing out;
    Clock::time_point fetch_begun;
    Reservation held;          ///< of the request while it comes, or of its answer
    bool close_after = false;  ///< the connection ends when `out` is sent
    int requests = 0;
    std::unique_ptr<Exchange> parked;
};

}  // namespace bouguer::server
