// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/exif.h"

#include <algorithm>
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

    /// Where the value of a tag in a directory stands; 0 where there is none. Short values stand in
    /// the entry, of tag, type, count and value.
    [[nodiscard]] std::uint64_t value_of(std::uint32_t tag, std::uint64_t directory) const {
        constexpr std::uint64_t kEntryBytes = 12;
        if (directory == 0) return 0;
        const std::uint32_t entries = number(directory, 2);
        for (std::uint32_t i = 0; i < entries; ++i) {
            const std::uint64_t entry = directory + 2 + i * kEntryBytes;
            if (number(entry, 2) == tag) return entry + 8;
        }
        return 0;
    }
    [[nodiscard]] std::uint64_t first_directory() const { return number(4, 4); }
    /// The directory that an entry points at.
    [[nodiscard]] std::uint64_t directory_of(std::uint32_t tag, std::uint64_t directory) const {
        const std::uint64_t value = value_of(tag, directory);
        return value != 0 ? number(value, 4) : 0;
    }
    /// A number of 16 bits, or of 32 where its entry says so; 0 where there is none.
    [[nodiscard]] std::uint32_t integer_of(std::uint32_t tag, std::uint64_t directory) const {
        constexpr std::uint32_t kShort = 3;
        const std::uint64_t value = value_of(tag, directory);
        return value == 0 ? 0 : number(value, number(value - 6, 2) == kShort ? 2 : 4);
    }
    [[nodiscard]] std::string_view bytes(std::uint64_t at, std::size_t count) const {
        return data_.substr(std::min<std::uint64_t>(at, data_.size()), count);
    }

  private:
    std::string_view data_;
    bool is_little_endian_;
};

std::string_view without_prefix(std::string_view data) {
    return data.starts_with(kExifPrefix) ? data.substr(kExifPrefix.size()) : data;
}

}  // namespace

int exif_orientation(std::string_view data) {
    constexpr std::uint32_t kOrientation = 0x0112;
    const Tiff tiff(without_prefix(data));
    if (!tiff.is_tiff()) return 1;
    const std::uint32_t value = tiff.integer_of(kOrientation, tiff.first_directory());
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
}

bool is_adobe_rgb(std::string_view data) {
    constexpr std::uint32_t kExif = 0x8769, kColourSpace = 0xa001, kInteroperability = 0xa005;
    const Tiff tiff(without_prefix(data));
    if (!tiff.is_tiff()) return false;
    const std::uint64_t exif = tiff.directory_of(kExif, tiff.first_directory());
    if (tiff.integer_of(kColourSpace, exif) == 2) return true;
    const std::uint64_t index = tiff.value_of(1, tiff.directory_of(kInteroperability, exif));
    return index != 0 && tiff.bytes(index, 3) == "R03";
}

}  // namespace bouguer::renderer
