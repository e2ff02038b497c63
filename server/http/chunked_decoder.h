// SPDX-License-Identifier: Apache-2.0
// Removes the chunked transfer coding [RFC 9112 §7.1] as the bytes come in. Read strictly: what
// another reader might take for the end of a chunk or of the body is refused.
#pragma once

#include <cstddef>
#include <string>

namespace bouguer::server {

class ChunkedDecoder {
  public:
    enum class Result { NeedMore, Done, Malformed, TooLarge };

    explicit ChunkedDecoder(std::size_t limit) : limit_(limit) {}

    /// Takes what it can from the front of `in` and appends the decoded bytes to `out`. Bytes after
    /// the last chunk stay in `in`. Chunk extensions and trailers must be well-formed;
    /// they are skipped, and bounded.
    Result feed(std::string& in, std::string& out);

  private:
    enum class State { Size, Data, DataEnd, Trailer };

    Result begin_chunk(const std::string& line);

    std::size_t limit_;
    State state_ = State::Size;
    std::size_t left_ = 0;      ///< bytes of the present chunk still to come
    std::size_t overhead_ = 0;  ///< bytes of size lines and trailers so far
    std::size_t decoded_ = 0;
};

}  // namespace bouguer::server
