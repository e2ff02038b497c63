// SPDX-License-Identifier: Apache-2.0
// A file that is looked into before it is read whole.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "renderer/core/result.h"

namespace bouguer::renderer {

/// Bytes in a row, of which any can be read. Immutable as far as its reader can tell.
class ByteSource {
  public:
    virtual ~ByteSource() = default;
    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// `count` bytes from `offset`; fewer only where the source ends. Errors are those of the
    /// source.
    [[nodiscard]] virtual Result<std::string> read(std::uint64_t offset,
                                                   std::size_t count) const = 0;
};

/// Bytes in memory.
class MemorySource final : public ByteSource {
  public:
    explicit MemorySource(std::string bytes) : bytes_(std::move(bytes)) {}
    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    [[nodiscard]] Result<std::string> read(std::uint64_t offset, std::size_t count) const override {
        return bytes_.substr(std::min<std::uint64_t>(offset, bytes_.size()), count);
    }

  private:
    std::string bytes_;
};

}  // namespace bouguer::renderer
