// SPDX-License-Identifier: Apache-2.0
#include "server/http/plain_answer.h"

#include <array>
#include <ctime>

#include "api/writers.h"

namespace bouguer::server {
namespace {

struct Reason {
    int status;
    std::string_view phrase;
};
constexpr std::array kReasons{
    Reason{200, "OK"},
    Reason{201, "Created"},
    Reason{202, "Accepted"},
    Reason{204, "No Content"},
    Reason{206, "Partial Content"},
    Reason{304, "Not Modified"},
    Reason{400, "Bad Request"},
    Reason{403, "Forbidden"},
    Reason{404, "Not Found"},
    Reason{405, "Method Not Allowed"},
    Reason{406, "Not Acceptable"},
    Reason{408, "Request Timeout"},
    Reason{409, "Conflict"},
    Reason{412, "Precondition Failed"},
    Reason{413, "Content Too Large"},
    Reason{414, "URI Too Long"},
    Reason{415, "Unsupported Media Type"},
    Reason{416, "Range Not Satisfiable"},
    Reason{417, "Expectation Failed"},
    Reason{421, "Misdirected Request"},
    Reason{422, "Unprocessable Content"},
    Reason{431, "Request Header Fields Too Large"},
    Reason{500, "Internal Server Error"},
    Reason{501, "Not Implemented"},
    Reason{503, "Service Unavailable"},
    Reason{505, "HTTP Version Not Supported"},
};

}  // namespace

std::string_view reason_phrase(int status) {
    for (const Reason& reason : kReasons) {
        if (reason.status == status) return reason.phrase;
    }
    return {};
}

std::string http_date() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 40> text{};
    const std::size_t n =
        std::strftime(text.data(), text.size(), "%a, %d %b %Y %H:%M:%S GMT", &utc);
    return {text.data(), n};
}

std::string problem_text(const Refusal& refusal, std::string_view request_id) {
    return api::problem_json(refusal.status, refusal.code, reason_phrase(refusal.status),
                             refusal.detail, request_id);
}

std::string to_bytes(const PlainAnswer& answer) {
    std::string out = "HTTP/1.1 " + std::to_string(answer.status) + ' ';
    out += reason_phrase(answer.status);
    out += "\r\nDate: " + http_date() + "\r\nContent-Type: ";
    out += answer.content_type;
    out += "\r\nContent-Length: " + std::to_string(answer.body.size()) +
           "\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Request-Id: ";
    out += answer.request_id;
    if (answer.retry_after_s > 0) out += "\r\nRetry-After: " + std::to_string(answer.retry_after_s);
    if (answer.close) out += "\r\nConnection: close";
    out += "\r\n\r\n";
    if (!answer.head_only) out += answer.body;
    return out;
}

std::string refusal_bytes(const Refusal& refusal, std::string_view request_id) {
    return to_bytes({.status = refusal.status,
                     .content_type = "application/problem+json",
                     .body = problem_text(refusal, request_id),
                     .request_id = request_id,
                     // the front's bounds are of what is under way now: over in a moment
                     .retry_after_s = refusal.status == 503 ? 1 : 0,
                     .close = true});
}

}  // namespace bouguer::server
