// SPDX-License-Identifier: Apache-2.0
// A client that sends whatever it is told, well-formed or not, over a loopback socket.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/file_descriptor.h"

namespace bouguer::server::testing {

struct RawResponse {
    int status = 0;                              ///< 0: none came
    std::map<std::string, std::string> headers;  ///< names in lower case; the last of equals
    std::string body;
    [[nodiscard]] std::string header(const std::string& name) const {
        const auto it = headers.find(name);
        return it == headers.end() ? std::string{} : it->second;
    }
};

class RawClient {
  public:
    /// `source`: the loopback address to come from, e.g. "127.0.0.2", as another client.
    explicit RawClient(int port, const char* source = "127.0.0.1");

    void send(std::string_view bytes) const;
    /// The next response; `head_only` for HEAD. Waits two seconds at most.
    [[nodiscard]] RawResponse receive(bool head_only = false);
    /// Bytes until `text` has come, the peer closed, or two seconds have passed.
    [[nodiscard]] std::string receive_until(std::string_view text);
    /// Whether the peer closes within two seconds; bytes before that are lost.
    [[nodiscard]] bool is_closed();
    /// Whether something can be read within two seconds.
    [[nodiscard]] bool has_answer() const;
    /// Half-closes: nothing more is sent.
    void finish_sending() const;
    [[nodiscard]] int fd() const { return fd_.get(); }

  private:
    /// False at the end or after two seconds.
    bool more();

    FileDescriptor fd_;
    std::string buffer_;
};

/// A request with Host and, if there is a body, its length and JSON's type.
[[nodiscard]] std::string request_text(std::string_view method, std::string_view target,
                                       const std::vector<std::string>& fields = {},
                                       std::string_view body = {});

}  // namespace bouguer::server::testing
