// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_reader.h"

#include <algorithm>

namespace bouguer::server {

RequestReader::State RequestReader::refuse(const Refusal& refusal) {
    refusal_ = refusal;
    return state_ = State::Refused;
}

std::size_t RequestReader::expected_body() const {
    return head_.chunked ? head_.body_limit(*limits_)
                         : static_cast<std::size_t>(head_.content_length);
}

RequestReader::State RequestReader::feed(std::string& in) {
    if (state_ == State::Head) read_head(in);
    if (state_ == State::Body) read_body(in);
    return state_;
}

RequestReader::State RequestReader::read_head(std::string& in) {
    // an empty line before a request is allowed [RFC 9112 §2.2]
    if (searched_ == 0 && in.compare(0, 2, "\r\n") == 0) in.erase(0, 2);
    const std::size_t end = in.find("\r\n\r\n", searched_);
    if (std::min(end, in.size()) > limits_->head_bytes) {
        if (in.find("\r\n") > limits_->head_bytes) {
            return refuse({414, "target-too-long", "The path and query are longer than allowed."});
        }
        return refuse({431, "head-too-large", "The header fields are larger than allowed."});
    }
    if (end == std::string::npos) {
        searched_ = in.size() - std::min<std::size_t>(in.size(), 3);
        return state_;
    }
    auto head = parse_head(std::string_view(in).substr(0, end + 2), *limits_);
    if (!head) return refuse(head.error());
    in.erase(0, end + 4);
    head_ = std::move(*head);
    chunks_ = ChunkedDecoder(head_.body_limit(*limits_));
    return state_ = State::Body;
}

RequestReader::State RequestReader::read_body(std::string& in) {
    if (!head_.chunked) {
        const std::size_t n = std::min(expected_body() - body_.size(), in.size());
        body_.append(in, 0, n);
        in.erase(0, n);
        if (body_.size() == expected_body()) state_ = State::Complete;
        return state_;
    }
    switch (chunks_.feed(in, body_)) {
        case ChunkedDecoder::Result::NeedMore:
            return state_;
        case ChunkedDecoder::Result::Done:
            return state_ = State::Complete;
        case ChunkedDecoder::Result::TooLarge:
            return refuse({413, "content-too-large", "The body is larger than allowed."});
        case ChunkedDecoder::Result::Malformed:
            break;
    }
    return refuse({400, "malformed-request", "The chunked coding of the body is broken."});
}

}  // namespace bouguer::server
