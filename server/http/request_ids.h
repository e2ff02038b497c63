// SPDX-License-Identifier: Apache-2.0
// Names of requests: in answers and in the log.
#pragma once

#include <cstdint>
#include <string>

#include "server/http/request_head.h"

namespace bouguer::server {

/// One thread only.
class RequestIds {
  public:
    RequestIds();
    /// The client's own X-Request-Id if it is a short token, or a new one that no other has.
    [[nodiscard]] std::string id_of(const RequestHead& head);

  private:
    std::uint64_t salt_, count_ = 0;
};

}  // namespace bouguer::server
