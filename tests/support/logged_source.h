// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "renderer/core/byte_source.h"

namespace bouguer::tests {

/// A file that begins with `first_bytes` and goes on with zeros up to `size`; says how much of it
/// was read.
class LoggedSource final : public renderer::ByteSource {
  public:
    LoggedSource(std::string first_bytes, std::uint64_t size, std::uint64_t& bytes_read)
        : first_bytes_(std::move(first_bytes)), size_(size), bytes_read_(bytes_read) {}

    [[nodiscard]] std::uint64_t size() const override { return size_; }
    [[nodiscard]] Result<std::string> read(std::uint64_t offset, std::size_t count) const override {
        const std::uint64_t left = size_ - std::min(offset, size_);
        std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(left, count)), '\0');
        for (std::size_t i = 0; i < bytes.size() && offset + i < first_bytes_.size(); ++i) {
            bytes[i] = first_bytes_[static_cast<std::size_t>(offset) + i];
        }
        bytes_read_ += bytes.size();
        return bytes;
    }

  private:
    std::string first_bytes_;
    std::uint64_t size_;
    std::uint64_t& bytes_read_;
};

}  // namespace bouguer::tests
