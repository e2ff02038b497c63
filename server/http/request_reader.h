// SPDX-License-Identifier: Apache-2.0
// Collects one request from a connection's bytes: the head, then the body, never more than the
// limits allow. A request is handed on only when it is complete, so no thread ever waits for a
// client.
#pragma once

#include <optional>
#include <string>

#include "server/http/chunked_decoder.h"
#include "server/http/request_head.h"

namespace bouguer::server {

class RequestReader {
  public:
    enum class State { Head, Body, Complete, Refused };

    explicit RequestReader(const HttpLimits& limits)
        : limits_(&limits), chunks_(limits.body_bytes) {}

    /// Takes this request's bytes from the front of `in`; what follows them stays there.
    State feed(std::string& in);

    [[nodiscard]] State state() const { return state_; }
    /// Whether any byte of a request has come.
    [[nodiscard]] bool begun(const std::string& in) const {
        return state_ != State::Head || !in.empty();
    }
    [[nodiscard]] const Refusal& refusal() const { return refusal_; }  ///< when Refused
    [[nodiscard]] RequestHead& head() { return head_; }                ///< from Body on
    [[nodiscard]] std::string& body() { return body_; }
    /// The body's bytes that may still come, for deadlines and budgets; an upper bound if chunked.
    [[nodiscard]] std::size_t expected_body() const;

  private:
    State read_head(std::string& in);
    State read_body(std::string& in);
    State refuse(const Refusal& refusal);

    const HttpLimits* limits_;
    State state_ = State::Head;
    std::size_t searched_ = 0;  ///< bytes of the head in which its end was looked for
    RequestHead head_;
    ChunkedDecoder chunks_;
    std::string body_;
    Refusal refusal_;
};

}  // namespace bouguer::server
