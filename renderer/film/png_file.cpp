// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/png_file.h"

#include <algorithm>
#include <array>

#include "renderer/film/image_decoder.h"
#include "renderer/film/inflate.h"

namespace bouguer::renderer {
namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kAround = 12;  ///< bytes of length, name and check sum around a chunk's data

/// Needed for the pixels.
constexpr std::array<std::string_view, 5> kPixelChunks{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
/// Say how the picture is to be taken. Those of colour stand before the pixels.
constexpr std::array<std::string_view, 6> kStatements{"cICP", "iCCP", "sRGB",
                                                      "gAMA", "cHRM", "eXIf"};

template <std::size_t N>
bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
    return value;
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
/// A reader that does not know such a chunk cannot read the picture [PNG 3rd ed. §5.4].
bool is_critical(std::string_view name) { return name[0] >= 'A' && name[0] <= 'Z'; }

tl::unexpected<Error> refuse(const std::string& reason) {
    return fail(ErrorKind::InvalidInput, reason, "bad-image");
}

struct Chunk {
    std::size_t at = 0;  ///< where it begins in the file
    std::string_view name, data;

    [[nodiscard]] std::string place() const {
        return "chunk " + std::string(name) + " at byte " + std::to_string(at);
    }
};

tl::unexpected<Error> damaged(const Chunk& chunk, const std::string& what) {
    return refuse("the image cannot be read: its " + chunk.place() + what);
}

/// Its bytes of pixels, packed out: a byte for the filter before every row, of every pass where
/// they are interlaced [PNG 3rd ed. §8]. IHDR has 13 bytes.
std::uint64_t unfolded_bytes(std::string_view ihdr) {
    struct Pass {
        unsigned column, row, columns, rows;  ///< the first and the steps
    };
    constexpr std::array<Pass, 7> kAdam7{{{0, 0, 8, 8},
                                          {4, 0, 8, 8},
                                          {0, 4, 4, 8},
                                          {2, 0, 4, 4},
                                          {0, 2, 2, 4},
                                          {1, 0, 2, 2},
                                          {0, 1, 1, 2}}};
    constexpr std::array<unsigned, 7> kNumbers{1, 0, 3, 1, 2, 0, 4};  // a pixel, by its colour type
    const std::uint64_t width = big_endian(ihdr), height = big_endian(ihdr.substr(4));
    const auto colour_type = static_cast<std::uint8_t>(ihdr[9]);
    const std::uint64_t bits = static_cast<std::uint64_t>(static_cast<std::uint8_t>(ihdr[8])) *
                               (colour_type < kNumbers.size() ? kNumbers[colour_type] : 0);
    const auto pass_bytes = [&](std::uint64_t columns, std::uint64_t rows) {
        return columns == 0 ? 0 : rows * (1 + (columns * bits + 7) / 8);
    };
    if (ihdr[12] == 0) return pass_bytes(width, height);
    std::uint64_t sum = 0;
    for (const Pass& p : kAdam7)
        sum += pass_bytes(
            (width - std::min<std::uint64_t>(p.column, width) + p.columns - 1) / p.columns,
            (height - std::min<std::uint64_t>(p.row, height) + p.rows - 1) / p.rows);
    return sum;
}

class Reader {
  public:
    explicit Reader(std::string_view bytes) : bytes_(bytes), pixels_(0, [](std::string_view) {}) {}

    Result<PngFile> run() {
        file_.pixels_only = bytes_.substr(0, kSignatureBytes);
        for (std::size_t at = kSignatureBytes;;) {
            const auto chunk = chunk_at(at);
            if (!chunk) return tl::unexpected(chunk.error());
            if (auto good = take(*chunk); !good) return tl::unexpected(std::move(good).error());
            if (chunk->name == "IEND") break;
            at += kAround + chunk->data.size();
        }
        return std::move(file_);
    }

  private:
    Result<Chunk> chunk_at(std::size_t at) const {
        const std::string_view rest = bytes_.substr(at);
        const auto cut = [&](const std::string& where) {
            return refuse("the image cannot be read: the file breaks off " + where +
                          ", before its end (the chunk IEND)");
        };
        if (rest.size() < kAround) return cut("at byte " + std::to_string(bytes_.size()));
        Chunk chunk{at, rest.substr(4, 4), {}};
        if (!std::all_of(chunk.name.begin(), chunk.name.end(), &is_letter))
            return refuse("the image cannot be read: no chunk begins at byte " +
                          std::to_string(at));
        const std::size_t size = big_endian(rest);
        if (size > rest.size() - kAround) return cut("in its " + chunk.place());
        chunk.data = rest.substr(8, size);
        if (crc32_of(rest.substr(4, 4 + size)) != big_endian(rest.substr(8 + size)))
            return damaged(chunk, " is damaged: its check sum is wrong");
        return chunk;
    }

    Result<void> take(const Chunk& chunk) {
        if ((chunk.name == "IHDR") != (chunk.at == kSignatureBytes))
            return damaged(chunk, " is at the wrong place");
        if (chunk.name == "IHDR") {
            if (auto good = take_header(chunk); !good) return good;
        } else if (chunk.name == "IDAT") {
            if (auto good = take_pixels(chunk); !good) return good;
        } else if (chunk.name == "IEND") {
            if (auto good = check_pixels_at(chunk); !good) return good;
        } else if (is_one_of(chunk.name, kStatements)) {
            if (auto good = take_statement(chunk); !good) return good;
        } else if (is_critical(chunk.name) && !is_one_of(chunk.name, kPixelChunks)) {
            return damaged(chunk, " is of no known kind, but the picture needs it");
        }
        is_in_pixels_ = chunk.name == "IDAT";
        if (is_one_of(chunk.name, kPixelChunks))
            file_.pixels_only += bytes_.substr(chunk.at, kAround + chunk.data.size());
        return {};
    }

    Result<void> take_header(const Chunk& chunk) {
        if (chunk.data.size() != 13) return refuse(kDamagedImageHeader);
        file_.bit_depth = static_cast<std::uint8_t>(chunk.data[8]);
        file_.colour_type = static_cast<std::uint8_t>(chunk.data[9]);
        expected_ = unfolded_bytes(chunk.data);
        pixels_.allow(expected_);
        return {};
    }

    Result<void> take_pixels(const Chunk& chunk) {
        if (has_pixels_ && !is_in_pixels_) return damaged(chunk, " is apart from those before it");
        has_pixels_ = true;
        if (!pixels_.add(chunk.data)) return damaged(chunk, " is damaged: its pixels are");
        return {};
    }

    Result<void> check_pixels_at(const Chunk& end) {
        if (!has_pixels_) return damaged(end, " comes before any pixels");
        if (pixels_.size() == expected_ && pixels_.is_complete()) return {};
        return refuse(std::string(kDamagedPixels) + ": the chunks IDAT hold " +
                      std::to_string(pixels_.size()) + " bytes of " + std::to_string(expected_) +
                      (pixels_.size() == expected_ ? " without the end" : ""));
    }

    Result<void> take_statement(const Chunk& chunk) {
        if (has_pixels_ && chunk.name != "eXIf") return damaged(chunk, " is behind the pixels");
        if (!file_.statements.emplace(chunk.name, chunk.data).second)
            return damaged(chunk, " is there twice");
        return {};
    }

    std::string_view bytes_;
    PngFile file_;
    Inflater pixels_;
    std::uint64_t expected_ = 0;
    bool has_pixels_ = false, is_in_pixels_ = false;
};

}  // namespace

Result<PngFile> read_png_file(std::string_view bytes) { return Reader(bytes).run(); }

}  // namespace bouguer::renderer
