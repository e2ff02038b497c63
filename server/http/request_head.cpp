// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_head.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace bouguer::server {
namespace {

using Refused = tl::unexpected<Refusal>;

Refused refuse(int status, std::string_view code, std::string_view detail) {
    return Refused(Refusal{status, code, detail});
}
Refused malformed(std::string_view detail) { return refuse(400, "malformed-request", detail); }

/// Visible ASCII; a fragment is never sent [RFC 9112 §3.2].
constexpr bool is_target_char(char c) { return c > 0x20 && c < 0x7f && c != '#'; }

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

/// A '%' is followed by two digits [RFC 3986 §2.1]: the library would also read "%u002f".
bool is_percent_encoded(std::string_view text) {
    const auto is_hex = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t i = text.find('%'); i < text.size(); i = text.find('%', i + 1)) {
        if (i + 2 >= text.size() || !is_hex(text[i + 1]) || !is_hex(text[i + 2])) return false;
    }
    return true;
}

/// Whether decoding the path would make a delimiter or a control character of data: an encoded
/// slash or backslash would name a resource that a path rule of a proxy before us has not seen.
bool hides_something(std::string_view path) {
    for (std::size_t i = path.find('%'); i < path.size(); i = path.find('%', i + 1)) {
        unsigned byte = 0;
        std::from_chars(path.data() + i + 1, path.data() + i + 3, byte, 16);
        if (byte < 0x20 || byte == 0x7f || byte == '/' || byte == '\\') return true;
    }
    return false;
}

/// http://host/path -> host and /path [RFC 9112 §3.2.2]. False: it has no proper host.
bool read_absolute_form(std::string_view target, RequestHead& head) {
    const auto scheme_end = target.find("://");
    if (scheme_end == std::string_view::npos) return true;
    const std::string_view scheme = target.substr(0, scheme_end);
    if (!equal_ignoring_case(scheme, "http") && !equal_ignoring_case(scheme, "https")) return true;
    const std::string_view rest = target.substr(scheme_end + 3);
    const auto path = std::min(rest.find_first_of("/?"), rest.size());
    head.authority = authority_from(rest.substr(0, path));
    head.target = '/';
    head.target += rest.substr(rest.substr(path, 1) == "/" ? path + 1 : path);
    return head.authority.has_value();
}

std::optional<Refusal> check_target(RequestHead& head) {
    if (head.target.front() != '/' && !(head.target == "*" && head.method == "OPTIONS")) {
        return Refusal{400, "malformed-request", "The target does not begin with a slash."};
    }
    if (!is_percent_encoded(head.target)) {
        return Refusal{400, "malformed-request", "A percent sign is not followed by two digits."};
    }
    if (hides_something(head.path())) {
        return Refusal{404, "not-found",
                       "No address here has an encoded slash, backslash or control character."};
    }
    return std::nullopt;
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
    head.target = target;
    head.minor_version = version.back() - '0';
    if (!read_absolute_form(target, head)) {
        return Refusal{400, "malformed-request", "The target names no proper host."};
    }
    return check_target(head);
}

std::optional<Refusal> parse_field(std::string_view line, RequestHead& head) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) {
        return Refusal{400, "malformed-request", "A header field has no proper name."};
    }
    const std::string_view value = line.substr(colon + 1);
    if (!is_field_value(value)) {
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

/// The host of an absolute target counts and not the field, which must be there and good all the
/// same.
std::optional<Refusal> check_host(RequestHead& head) {
    const std::size_t hosts = count(head, "Host");
    if (hosts > 1 || (hosts == 0 && head.minor_version == 1)) {
        return Refusal{400, "malformed-request", "There must be one Host field."};
    }
    const std::string* host = head.find("Host");
    if (host == nullptr) return std::nullopt;
    const auto authority = host->empty() ? Authority() : authority_from(*host);
    if (!authority) return Refusal{400, "malformed-request", "Host is no host with a port."};
    if (!head.authority) head.authority = authority;
    return std::nullopt;
}

std::optional<Refusal> check_fields(const HttpLimits& limits, RequestHead& head) {
    if (const auto refusal = check_host(head)) return refusal;
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
