// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_head.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace bouguer::server {
namespace {

using Refused = tl::unexpected<Refusal>;

Refused refuse(int status, std::string_view code, std::string_view detail) {
    return Refused(Refusal{status, code, detail});
}
Refused malformed(std::string_view detail) { return refuse(400, "malformed-request", detail); }

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

/// RFC 9110 §5.6.2
constexpr bool is_token_char(char c) {
    const bool alnum = (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z');
    return alnum || std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}
bool is_token(std::string_view s) {
    return !s.empty() && std::all_of(s.begin(), s.end(), is_token_char);
}
/// Field values: visible ASCII, space, tab and bytes over 127.
constexpr bool is_value_char(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return c == '\t' || (byte >= 0x20 && byte != 0x7f);
}
constexpr bool is_target_char(char c) { return c > 0x20 && c < 0x7f; }

std::string_view trimmed(std::string_view s) {
    const auto first = s.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return s.substr(first, s.find_last_not_of(" \t") - first + 1);
}

/// Whether a comma-separated field value holds `token`.
bool lists(std::string_view value, std::string_view token) {
    while (!value.empty()) {
        const auto comma = std::min(value.find(','), value.size());
        if (equal_ignoring_case(trimmed(value.substr(0, comma)), token)) return true;
        value.remove_prefix(std::min(comma + 1, value.size()));
    }
    return false;
}

constexpr std::array<std::string_view, 9> kMethods{"GET",     "HEAD",  "POST",  "PUT",    "DELETE",
                                                   "OPTIONS", "PATCH", "TRACE", "CONNECT"};

/// http://host/path -> /path [RFC 9112 §3.2.2]
std::string_view origin_form(std::string_view target) {
    for (const std::string_view scheme : {"http://", "https://"}) {
        if (target.substr(0, scheme.size()) != scheme) continue;
        const auto slash = target.find('/', scheme.size());
        return slash == std::string_view::npos ? std::string_view("/") : target.substr(slash);
    }
    return target;
}

std::optional<Refusal> parse_request_line(std::string_view line, const HttpLimits& limits,
                                          RequestHead& head) {
    const auto first = line.find(' ');
    const auto last = line.rfind(' ');
    if (first == std::string_view::npos || first == last) {
        return Refusal{400, "malformed-request", "The request line has not three parts."};
    }
    const std::string_view method = line.substr(0, first);
    const std::string_view target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    if (!is_token(method)) return Refusal{400, "malformed-request", "The method is no token."};
    if (version.substr(0, 5) != "HTTP/" || version.size() != 8) {
        return Refusal{400, "malformed-request", "The request line ends with no HTTP version."};
    }
    if (version != "HTTP/1.1" && version != "HTTP/1.0") {
        return Refusal{505, "version-not-supported", "This server speaks HTTP/1.1 and HTTP/1.0."};
    }
    if (target.size() > limits.target_bytes) {
        return Refusal{414, "target-too-long", "The path and query are longer than allowed."};
    }
    if (!std::all_of(target.begin(), target.end(), is_target_char)) {
        return Refusal{400, "malformed-request", "The target holds a character that it may not."};
    }
    if (std::find(kMethods.begin(), kMethods.end(), method) == kMethods.end() ||
        method == "TRACE" || method == "CONNECT") {
        return Refusal{501, "method-not-implemented", "This method is not implemented."};
    }
    head.method = method;
    head.target = origin_form(target);
    head.minor_version = version.back() - '0';
    if (head.target.front() != '/' && !(head.target == "*" && head.method == "OPTIONS")) {
        return Refusal{400, "malformed-request", "The target does not begin with a slash."};
    }
    return std::nullopt;
}

std::optional<Refusal> parse_field(std::string_view line, RequestHead& head) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) {
        return Refusal{400, "malformed-request", "A header field has no proper name."};
    }
    const std::string_view value = line.substr(colon + 1);
    if (!std::all_of(value.begin(), value.end(), is_value_char)) {
        return Refusal{400, "malformed-request", "A header field holds a control character."};
    }
    head.fields.push_back({std::string(line.substr(0, colon)), std::string(trimmed(value))});
    return std::nullopt;
}

std::size_t count(const RequestHead& head, std::string_view name) {
    return static_cast<std::size_t>(
        std::count_if(head.fields.begin(), head.fields.end(),
                      [&](const HeaderField& f) { return equal_ignoring_case(f.name, name); }));
}

std::optional<Refusal> parse_content_length(const std::string& text, const HttpLimits& limits,
                                            RequestHead& head) {
    const char* end = text.data() + text.size();
    // from_chars on an unsigned type takes digits only: no sign, no white space, no list
    const auto [stop, error] = std::from_chars(text.data(), end, head.content_length);
    if (text.empty() || stop != end || error == std::errc::invalid_argument) {
        return Refusal{400, "malformed-request", "Content-Length is no number."};
    }
    if (error == std::errc::result_out_of_range || head.content_length > head.body_limit(limits)) {
        return Refusal{413, "content-too-large", "The body is larger than allowed."};
    }
    return std::nullopt;
}

/// Where the body ends [RFC 9112 §6]. Two answers to that are an attack or a fault: refused.
std::optional<Refusal> decide_framing(const HttpLimits& limits, RequestHead& head) {
    const std::size_t lengths = count(head, "Content-Length");
    const std::size_t codings = count(head, "Transfer-Encoding");
    if (lengths > 1 || codings > 1 || (lengths != 0 && codings != 0)) {
        return Refusal{400, "ambiguous-length", "The length of the body is given more than once."};
    }
    if (codings == 1) {
        if (!equal_ignoring_case(*head.find("Transfer-Encoding"), "chunked")) {
            return Refusal{501, "coding-not-implemented",
                           "The only transfer coding here is chunked."};
        }
        if (head.minor_version == 0) {
            return Refusal{400, "ambiguous-length", "HTTP/1.0 has no transfer codings."};
        }
        head.chunked = true;
    }
    if (lengths == 1) return parse_content_length(*head.find("Content-Length"), limits, head);
    return std::nullopt;
}

std::optional<Refusal> check_fields(const HttpLimits& limits, RequestHead& head) {
    const std::size_t hosts = count(head, "Host");
    if (hosts > 1 || (hosts == 0 && head.minor_version == 1)) {
        return Refusal{400, "malformed-request", "There must be one Host field."};
    }
    const std::string* connection = head.find("Connection");
    head.keep_alive =
        head.minor_version == 1 && !(connection != nullptr && lists(*connection, "close"));
    const std::string* expect = head.find("Expect");
    if (expect != nullptr && !equal_ignoring_case(*expect, "100-continue")) {
        return Refusal{417, "expectation-failed", "The only expectation here is 100-continue."};
    }
    head.expects_continue = expect != nullptr && head.minor_version == 1;
    const std::string* coding = head.find("Content-Encoding");
    if (coding != nullptr && !equal_ignoring_case(*coding, "identity")) {
        return Refusal{415, "encoding-not-supported", "Bodies are read as they are: no encoding."};
    }
    return decide_framing(limits, head);
}

}  // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

const std::string* RequestHead::find(std::string_view name) const {
    for (const HeaderField& field : fields) {
        if (equal_ignoring_case(field.name, name)) return &field.value;
    }
    return nullptr;
}

std::string_view RequestHead::path() const {
    return std::string_view(target).substr(0, target.find('?'));
}

bool RequestHead::is_upload() const { return method == "PUT" && path().starts_with("/v1/assets/"); }

tl::expected<RequestHead, Refusal> parse_head(std::string_view text, const HttpLimits& limits) {
    RequestHead head;
    for (bool first = true; !text.empty(); first = false) {
        const auto end = text.find("\r\n");
        if (end == std::string_view::npos) return malformed("A line does not end with CR LF.");
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end + 2);
        if (!first && head.fields.size() == limits.header_fields) {
            return refuse(431, "head-too-large", "There are more header fields than allowed.");
        }
        const auto refusal =
            first ? parse_request_line(line, limits, head) : parse_field(line, head);
        if (refusal) return Refused(*refusal);
    }
    if (const auto refusal = check_fields(limits, head)) return Refused(*refusal);
    return head;
}

}  // namespace bouguer::server
