// SPDX-License-Identifier: Apache-2.0
#include "server/http/chunked_decoder.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "server/http/field_syntax.h"

namespace bouguer::server {
namespace {

constexpr std::size_t kLongestLine = 1024;  // a size with its extensions, or a trailer
// Size lines and trailers together may not outweigh the data by more than this and a factor.
constexpr std::size_t kFreeOverhead = 16 * 1024;
constexpr std::size_t kOverheadPerByte = 4;

/// The end of the quoted string that `text` begins with; npos: it has none.
std::size_t end_of_quoted(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"') return i + 1;
        if (text[i] == '\\') ++i;
    }
    return std::string_view::npos;
}

/// ";name", ";name=value" or ";name="a value"", any number of them [RFC 9112 §7.1.1]. White space
/// around the parts, which senders must not make, is refused: others read it in more ways than one.
bool are_extensions(std::string_view text) {
    while (!text.empty()) {
        if (text.front() != ';') return false;
        text.remove_prefix(1);
        const auto name_end = std::min(text.find_first_of(";="), text.size());
        if (!is_token(text.substr(0, name_end))) return false;
        text.remove_prefix(name_end);
        if (text.substr(0, 1) != "=") continue;
        text.remove_prefix(1);
        const bool is_quoted = text.substr(0, 1) == "\"";
        const auto end = std::min(is_quoted ? end_of_quoted(text) : text.find(';'), text.size());
        const std::string_view value = text.substr(0, end);
        if (is_quoted ? !is_quoted_string(value) : !is_token(value)) return false;
        text.remove_prefix(end);
    }
    return true;
}

}  // namespace

ChunkedDecoder::Result ChunkedDecoder::begin_chunk(const std::string& line) {
    const std::size_t digits = std::min(line.find(';'), line.size());
    const char* end = line.data() + digits;
    const auto [stop, error] = std::from_chars(line.data(), end, left_, 16);
    if (error == std::errc::result_out_of_range) return Result::TooLarge;
    if (digits == 0 || stop != end || error != std::errc{}) return Result::Malformed;
    if (!are_extensions(std::string_view(line).substr(digits))) return Result::Malformed;
    if (left_ > limit_ - decoded_) return Result::TooLarge;
    decoded_ += left_;
    state_ = left_ == 0 ? State::Trailer : State::Data;
    return Result::NeedMore;
}

ChunkedDecoder::Result ChunkedDecoder::feed(std::string& in, std::string& out) {
    std::size_t at = 0;
    Result result = Result::NeedMore;
    while (result == Result::NeedMore) {
        if (state_ == State::Data) {
            const std::size_t n = std::min(left_, in.size() - at);
            out.append(in, at, n);
            at += n;
            left_ -= n;
            if (left_ > 0) break;
            state_ = State::DataEnd;
        }
        const std::size_t end = in.find('\n', at);
        if (end == std::string::npos) {
            if (in.size() - at > kLongestLine) result = Result::Malformed;
            break;
        }
        if (end == at || in[end - 1] != '\r' || end - at > kLongestLine) {
            result = Result::Malformed;
            break;
        }
        const std::string line = in.substr(at, end - 1 - at);
        at = end + 1;
        overhead_ += line.size();
        if (state_ == State::DataEnd) {
            state_ = State::Size;
            if (!line.empty()) result = Result::Malformed;
        } else if (state_ == State::Size) {
            result = begin_chunk(line);
        } else {
            if (line.empty()) {
                result = Result::Done;
            } else if (!is_field_line(line)) {
                result = Result::Malformed;
            }
        }
        if (overhead_ > kFreeOverhead + kOverheadPerByte * decoded_) result = Result::Malformed;
    }
    in.erase(0, at);
    return result;
}

}  // namespace bouguer::server
