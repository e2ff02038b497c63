// SPDX-License-Identifier: Apache-2.0
// Unfolding of what zlib has packed, with a bound.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

struct z_stream_s;

namespace bouguer::renderer {

/// The check sum of PNG's chunks [PNG 3rd ed. annex D].
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes);

/// Unfolds one zlib stream that may come in pieces [RFC 1950]. Not thread-safe.
class Inflater {
  public:
    /// Gives up after `most_bytes`. What comes out goes to `take`, a piece at a time.
    Inflater(std::uint64_t most_bytes, std::function<void(std::string_view)> take);
    ~Inflater();
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    /// Another bound, before anything was added.
    void allow(std::uint64_t most_bytes) { most_bytes_ = most_bytes; }
    /// False when the stream is damaged or unfolds to more than it may; then it is over.
    [[nodiscard]] bool add(std::string_view packed);
    /// Whether the stream has come to its end and its check sum was right.
    [[nodiscard]] bool is_complete() const { return is_complete_; }
    /// Bytes that have come out.
    [[nodiscard]] std::uint64_t size() const { return size_; }

  private:
    std::unique_ptr<z_stream_s> stream_;
    std::uint64_t most_bytes_, size_ = 0;
    std::function<void(std::string_view)> take_;
    bool is_begun_ = false, is_complete_ = false;
};

}  // namespace bouguer::renderer
