// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/exif.h"

#include <cstdint>

namespace bouguer::renderer {
namespace {

/// Numbers in the byte order that a TIFF header names; 0 beyond the end.
class Tiff {
  public:
    explicit Tiff(std::string_view data) : data_(data), is_little_endian_(data.starts_with("II")) {}

    [[nodiscard]] bool is_tiff() const {
        return (is_little_endian_ || data_.starts_with("MM")) && number(2, 2) == 42;
    }
    [[nodiscard]] std::uint32_t number(std::uint64_t at, unsigned bytes) const {
        if (at + bytes > data_.size()) return 0;
        std::uint32_t value = 0;
        for (unsigned i = 0; i < bytes; ++i) {
            const unsigned k = is_little_endian_ ? bytes - 1 - i : i;
            value = value << 8U | static_cast<std::uint8_t>(data_[at + k]);
        }
        return value;
    }

  private:
    std::string_view data_;
    bool is_little_endian_;
};

}  // namespace

int exif_orientation(std::string_view data) {
    constexpr std::uint32_t kOrientation = 0x0112, kShort = 3;
    constexpr std::uint64_t kEntryBytes = 12;  // tag, type, count, value
    if (data.starts_with(kExifPrefix)) data.remove_prefix(kExifPrefix.size());
    const Tiff tiff(data);
    if (!tiff.is_tiff()) return 1;
    const std::uint64_t directory = tiff.number(4, 4);
    const std::uint32_t entries = tiff.number(directory, 2);
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::uint64_t entry = directory + 2 + i * kEntryBytes;
        if (tiff.number(entry, 2) != kOrientation) continue;
        const bool is_short = tiff.number(entry + 2, 2) == kShort;
        const std::uint32_t value = tiff.number(entry + 8, is_short ? 2 : 4);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

}  // namespace bouguer::renderer
