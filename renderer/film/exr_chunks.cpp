// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/exr_chunks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "renderer/film/image_decoder.h"
#include "renderer/film/inflate.h"

namespace bouguer::renderer {
namespace {

/// Little-endian numbers of a file; 0 beyond its end.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
    [[nodiscard]] std::uint64_t at(std::uint64_t place, unsigned count) const {
        if (place > bytes_.size() || bytes_.size() - place < count) return 0;
        std::uint64_t value = 0;
        for (unsigned i = count; i-- > 0;)
            value = value << 8U | static_cast<std::uint8_t>(bytes_[place + i]);
        return value;
    }
    [[nodiscard]] std::int64_t signed_at(std::uint64_t place) const {
        return static_cast<std::int32_t>(at(place, 4));
    }
    /// Up to a NUL.
    [[nodiscard]] std::string_view name(std::uint64_t place) const {
        const std::string_view rest = bytes_.substr(std::min<std::uint64_t>(place, bytes_.size()));
        return rest.substr(0, rest.find('\0'));
    }

  private:
    std::string_view bytes_;
};

/// In the order of the attribute's values.
enum class Compression : std::uint8_t { None, Rle, Zips, Zip, Piz, Pxr24, B44, B44a, Dwaa, Dwab };
constexpr std::array<std::uint64_t, 10> kRowsOfAChunk{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

struct Layout {
    std::uint64_t table = 0;  ///< where the places of the chunks stand
    std::uint64_t width = 0, height = 0;
    std::int64_t left = 0, top = 0;
    std::uint64_t pixel_bytes = 0;
    std::uint64_t pxr24_bytes = 0;  ///< of a pixel: floats have 24 bits there
    std::uint64_t compression = 0;
    std::uint64_t chunk_width = 0, chunk_rows = 0;
    bool is_tiled = false;
};

void add_channels(const Numbers& file, std::uint64_t at, Layout& layout) {
    for (std::string_view name; !(name = file.name(at)).empty(); at += name.size() + 1 + 16) {
        const bool is_half = file.at(at + name.size() + 1, 4) == 1;
        layout.pixel_bytes += is_half ? 2 : 4;
        layout.pxr24_bytes += is_half ? 2 : 3;
    }
}

Layout layout_of(const Numbers& file) {
    constexpr std::uint64_t kTiled = 0x200;
    Layout layout;
    layout.is_tiled = (file.at(4, 4) & kTiled) != 0;
    std::uint64_t at = 8;
    for (std::string_view name; !(name = file.name(at)).empty();) {
        const std::uint64_t size_at =
            at + name.size() + 1 + file.name(at + name.size() + 1).size() + 1;
        const std::uint64_t value = size_at + 4;
        if (name == "channels") add_channels(file, value, layout);
        if (name == "compression") layout.compression = file.at(value, 1);
        if (name == "dataWindow") {
            layout.left = file.signed_at(value);
            layout.top = file.signed_at(value + 4);
            layout.width = static_cast<std::uint64_t>(file.signed_at(value + 8) - layout.left + 1);
            layout.height = static_cast<std::uint64_t>(file.signed_at(value + 12) - layout.top + 1);
        }
        if (name == "tiles") {
            layout.chunk_width = file.at(value, 4);
            layout.chunk_rows = file.at(value + 4, 4);
        }
        at = value + file.at(size_at, 4);
    }
    layout.table = at + 1;
    if (!layout.is_tiled && layout.compression < kRowsOfAChunk.size()) {
        layout.chunk_width = layout.width;
        layout.chunk_rows = kRowsOfAChunk[layout.compression];
    }
    return layout;
}

/// Bytes that run lengths stand for: a count below 0 of bytes as they are, or one more than the
/// count of the same byte.
std::uint64_t run_bytes(std::string_view packed) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < packed.size();) {
        const int count = static_cast<signed char>(packed[i]);
        const auto plain = static_cast<std::size_t>(count < 0 ? -count : 1);
        if (packed.size() - i - 1 < plain) return 0;
        sum += static_cast<std::uint64_t>(count < 0 ? -count : count + 1);
        i += 1 + plain;
    }
    return sum;
}

bool inflates_to(std::string_view packed, std::uint64_t bytes) {
    Inflater inflater(bytes, [](std::string_view) {});
    return inflater.add(packed) && inflater.is_complete() && inflater.size() == bytes;
}

/// Whether a chunk of so many pixels is whole. One that would not get smaller is not packed.
bool is_whole(const Layout& layout, std::string_view packed, std::uint64_t pixels) {
    const std::uint64_t bytes = pixels * layout.pixel_bytes;
    if (packed.size() >= bytes) return packed.size() == bytes;
    switch (static_cast<Compression>(layout.compression)) {
        case Compression::None:
            return false;
        case Compression::Rle:
            return run_bytes(packed) == bytes;
        case Compression::Zips:
        case Compression::Zip:
            return inflates_to(packed, bytes);
        case Compression::Pxr24:
            return inflates_to(packed, pixels * layout.pxr24_bytes);
        default:
            return true;
    }
}

tl::unexpected<Error> refuse(const std::string& reason) {
    return fail(ErrorKind::InvalidInput, reason, "bad-image");
}

/// Those of the largest picture where there are smaller ones beside it: they come first.
class Chunks {
  public:
    Chunks(std::string_view bytes, const Layout& layout)
        : bytes_(bytes), file_(bytes), layout_(layout) {}

    Result<void> check() const {
        const std::uint64_t across =
            (layout_.width + layout_.chunk_width - 1) / layout_.chunk_width;
        const std::uint64_t down = (layout_.height + layout_.chunk_rows - 1) / layout_.chunk_rows;
        for (std::uint64_t row = 0; row < down; ++row)
            for (std::uint64_t column = 0; column < across; ++column)
                if (auto good = check_one(row * across + column, column, row); !good) return good;
        return {};
    }

  private:
    Result<void> check_one(std::uint64_t index, std::uint64_t column, std::uint64_t row) const {
        const std::uint64_t at = file_.at(layout_.table + 8 * index, 8);
        const std::uint64_t begin = at + (layout_.is_tiled ? 20 : 8);
        const auto damaged = [&](const char* what) {
            return refuse(kDamagedPixels + (": chunk " + std::to_string(index)) + what +
                          std::to_string(at));
        };
        if (at == 0 || at > bytes_.size() || begin > bytes_.size())
            return damaged(" is missing: the file breaks off before byte ");
        const std::uint64_t size = file_.at(begin - 4, 4);
        if (size > bytes_.size() - begin) return damaged(" breaks off; it begins at byte ");
        const bool is_in_place =
            layout_.is_tiled
                ? file_.at(at, 4) == column && file_.at(at + 4, 4) == row &&
                      file_.at(at + 8, 8) == 0
                : file_.signed_at(at) ==
                      layout_.top + static_cast<std::int64_t>(row * layout_.chunk_rows);
        const std::uint64_t width =
            std::min(layout_.chunk_width, layout_.width - column * layout_.chunk_width);
        const std::uint64_t rows =
            std::min(layout_.chunk_rows, layout_.height - row * layout_.chunk_rows);
        if (!is_in_place || !is_whole(layout_, bytes_.substr(begin, size), width * rows))
            return damaged(" is damaged; it begins at byte ");
        return {};
    }

    std::string_view bytes_;
    Numbers file_;
    const Layout& layout_;
};

}  // namespace

Result<void> check_exr_chunks(std::string_view bytes) {
    const Layout layout = layout_of(Numbers(bytes));
    if (layout.chunk_width == 0 || layout.chunk_rows == 0 || layout.pixel_bytes == 0)
        return refuse(kDamagedImageHeader);
    return Chunks(bytes, layout).check();
}

}  // namespace bouguer::renderer
