// SPDX-License-Identifier: Apache-2.0
// An answer on its way out: the bytes that may be sent now, and what is still to be read of a file.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "server/content.h"

namespace bouguer::server {

/// Of a content in a file no more than a window is ever in memory. Plain data; one thread at a
/// time.
class Outgoing {
  public:
    static constexpr std::size_t kWindowBytes = 256U << 10U;

    Outgoing() = default;
    /// `bytes` first, then `content`.
    explicit Outgoing(std::string bytes, Content content = {})
        : bytes_(std::move(bytes)), content_(std::move(content)) {}

    /// What may be sent now; empty when a window is missing or all is sent.
    [[nodiscard]] std::string_view ready() const {
        if (sent_ < bytes_.size()) return std::string_view(bytes_).substr(sent_);
        return content_.view().substr(std::min(at_, content_.view().size()));
    }
    /// The first `n` bytes of ready() are on their way.
    void sent(std::size_t n) { (sent_ < bytes_.size() ? sent_ : at_) += n; }

    /// Whether the next window has to be read before anything can be sent.
    [[nodiscard]] bool needs_window() const { return ready().empty() && at_ < content_.size(); }
    /// What has to be read then: at most kWindowBytes.
    [[nodiscard]] Content next_window() const { return content_.part(at_, kWindowBytes); }
    /// The room of the last window, for the next.
    [[nodiscard]] std::string take_room();
    /// The bytes of next_window().
    void supply(std::string window);

    /// Memory that such an answer may occupy until it is sent.
    [[nodiscard]] static std::size_t held_bytes(const std::string& bytes, const Content& content);

  private:
    std::string bytes_;     ///< before the content, or a window of it
    std::size_t sent_ = 0;  ///< of bytes_
    Content content_;
    std::size_t at_ = 0;  ///< of content_: before it everything was sent or is in bytes_
};

}  // namespace bouguer::server
