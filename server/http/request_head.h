// SPDX-License-Identifier: Apache-2.0
// The head of a request, read strictly [RFC 9112]: what is ambiguous is refused, never repaired, so
// that no proxy before us can disagree on where a request ends.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "server/http/authority.h"
#include "server/http/field_syntax.h"
#include "server/http/http_options.h"

namespace bouguer::server {

/// Why a request is answered before any route sees it. The connection is closed after it.
struct Refusal {
    int status = 400;
    std::string_view code;    ///< as in /docs/problems
    std::string_view detail;  ///< one sentence
};

struct HeaderField {
    std::string name, value;  ///< as sent, surrounding white space removed
};

struct RequestHead {
    std::string method;
    std::string target;  ///< origin form: path and query, percent-encoded
    /// Whom the request is for: of an absolute target or else of Host [RFC 9112 §3.2.2, §3.3]. The
    /// host is empty when Host is; nothing is there in HTTP/1.0 without one.
    std::optional<Authority> authority;
    int minor_version = 1;  ///< HTTP/1.x
    std::vector<HeaderField> fields;
    std::uint64_t content_length = 0;  ///< 0 as well when there is no such field
    bool chunked = false;
    bool expects_continue = false;
    bool keep_alive = true;

    /// The value of the first field of that name (any case); null when there is none.
    [[nodiscard]] const std::string* find(std::string_view name) const;
    /// The target up to the query.
    [[nodiscard]] std::string_view path() const;
    /// Whether the body is a file that is put among the assets: these may be larger than documents.
    [[nodiscard]] bool is_upload() const;
    /// The most bytes that the body may have.
    [[nodiscard]] std::size_t body_limit(const HttpLimits& limits) const {
        return is_upload() ? limits.asset_bytes : limits.body_bytes;
    }
};

/// `text`: the request line and the fields, each with its CRLF, without the empty line.
[[nodiscard]] tl::expected<RequestHead, Refusal> parse_head(std::string_view text,
                                                            const HttpLimits& limits);

}  // namespace bouguer::server
