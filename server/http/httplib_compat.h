// SPDX-License-Identifier: Apache-2.0
// The one difference between the HTTP library's versions that concerns us: 0.11 (Debian 12) asks
// the stream for the peers' addresses, 0.18 (Debian 13) takes them as four parameters.
#pragma once

#include <httplib.h>

#include <concepts>
#include <functional>

namespace bouguer::server {

/// Opens the library's protected door: one request from `stream`, its answer to `stream`.
class HttplibEngine : public httplib::Server {
  public:
    /// `setup` sees the parsed request before it is routed.
    bool process(httplib::Stream& stream, bool close,
                 const std::function<void(httplib::Request&)>& setup) {
        bool closed = false;
        return process_as(*this, stream, close, closed, setup);
    }

  private:
    // A template, so that only the branch that fits the installed version is compiled.
    template <std::derived_from<HttplibEngine> Engine>
    static bool process_as(Engine& engine, httplib::Stream& stream, bool close, bool& closed,
                           const std::function<void(httplib::Request&)>& setup) {
        if constexpr (requires { engine.process_request(stream, close, closed, setup); }) {
            return engine.process_request(stream, close, closed, setup);
        } else {
            return engine.process_request(stream, {}, 0, {}, 0, close, closed, setup);
        }
    }
};

}  // namespace bouguer::server
