// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_header.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bouguer::renderer {
namespace {

constexpr std::uint64_t kLargestSide = (1ULL << 31U) - 1;
/// Segments or attributes that are passed over at most: each is a read.
constexpr int kMostParts = 4096;
constexpr std::size_t kMostChannels = 1024;

/// Walks over a file. What is not there is read as zeros and remembered.
class Cursor {
  public:
    explicit Cursor(const ByteSource& file) : file_(file) {}

    [[nodiscard]] bool failed() const { return failed_ || error_; }
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }
    void skip(std::uint64_t count) { at_ += count; }
    /// Bytes up to the end of the file.
    [[nodiscard]] std::uint64_t left() const { return file_.size() - std::min(at_, file_.size()); }

    std::uint8_t byte() {
        if (at_ < begin_ || at_ - begin_ >= window_.size()) load();
        if (failed()) return 0;
        return static_cast<std::uint8_t>(window_[static_cast<std::size_t>(at_++ - begin_)]);
    }
    std::uint64_t big_endian(int bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) value = value << 8U | byte();
        return value;
    }
    std::uint32_t little_endian() {
        std::uint32_t value = 0;
        for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{byte()} << 8 * i;
        return value;
    }
    /// Up to a NUL; EXR's names have at most 255 bytes.
    std::string name() {
        std::string text;
        for (char c = 0; text.size() < 256 && (c = static_cast<char>(byte())) != 0;) text += c;
        failed_ = failed_ || text.size() > 255;
        return text;
    }

  private:
    void load() {
        constexpr std::size_t kWindow = 4096;
        auto read = file_.read(at_, kWindow);
        if (!read) {
            error_ = std::move(read).error();
            return;
        }
        begin_ = at_;
        window_ = *std::move(read);
        failed_ = failed_ || window_.empty();
    }

    const ByteSource& file_;
    std::uint64_t at_ = 0, begin_ = 0;
    std::string window_;
    bool failed_ = false;
    std::optional<Error> error_;
};

/// Why a picture is refused; empty when it is not.
using Refusal = std::string;
const Refusal kDamaged = kDamagedImageHeader;

/// IHDR is the first chunk: length, type, width, height, depth, colour type.
Refusal read_png(Cursor& file, ImageHeader& header) {
    file.skip(8 + 4);
    if (file.big_endian(4) != 0x49484452) return kDamaged;  // "IHDR"
    header.width = file.big_endian(4);
    header.height = file.big_endian(4);
    header.sample_bytes = file.byte() == 16 ? 2 : 1;
    // grey, -, RGB, palette, grey and alpha, -, RGBA; a palette may have alpha, of which we know
    // later
    constexpr std::array<std::uint8_t, 7> kChannels{1, 0, 3, 3, 2, 0, 4};
    const std::uint8_t colour = file.byte();
    header.channels = colour < kChannels.size() ? kChannels[colour] : 0;
    return header.channels > 0 ? Refusal() : kDamaged;
}

/// The next marker; bytes that belong to nothing are passed over, as the library does.
std::uint8_t next_marker(Cursor& file) {
    for (int i = 0; i < kMostParts && file.byte() != 0xff;) ++i;
    std::uint8_t marker = 0xff;
    while (marker == 0xff && !file.failed()) marker = file.byte();
    return marker;
}

/// Frames of 8 bits that are coded by the cosine transform, in one picture [ITU T.81 table B.1].
Refusal check_frame(std::uint8_t marker, std::uint8_t bits) {
    const int kind = marker & 0x0f;
    if (kind % 4 == 3) return "the image is a lossless JPEG, which is not read";
    if (kind % 8 > 4) return "the image is a hierarchical JPEG, which is not read";
    if (bits != 8)
        return "the image has JPEG samples of " + std::to_string(bits) +
               " bits; only those of 8 are read";
    return {};
}

/// The first frame header SOFn; segments before it are passed over.
Refusal read_jpeg(Cursor& file, ImageHeader& header) {
    file.skip(2);
    for (int i = 0; i < kMostParts && !file.failed(); ++i) {
        const std::uint8_t marker = next_marker(file);
        if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd7)) continue;    // TEM, RSTn: alone
        if (marker == 0xd9 || marker == 0xda || marker == 0) return kDamaged;  // EOI, SOS
        const std::uint64_t length = file.big_endian(2);
        const bool is_frame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (is_frame) {
            const std::uint8_t bits = file.byte();
            header.sample_bytes = 1;
            const bool is_progressive = marker == 0xc2 || marker == 0xca;
            header.working_bytes = is_progressive ? 2 : 0;  // all coefficients are kept
            header.height = file.big_endian(2);
            header.width = file.big_endian(2);
            header.channels = file.byte();
            return file.failed() ? kDamaged : check_frame(marker, bits);
        }
        if (length < 2) return kDamaged;
        file.skip(length - 2);
    }
    return kDamaged;
}

/// What a channel of an EXR file is.
struct ExrChannel {
    std::string name;
    bool is_integer = false, is_sampled = false;  ///< of whole numbers; not one number a pixel
};

/// Names of channels up to an empty one, each with 16 bytes of its own: type, linearity, sampling.
std::vector<ExrChannel> read_channels(Cursor& file) {
    std::vector<ExrChannel> channels;
    for (std::string name; channels.size() < kMostChannels && !(name = file.name()).empty();) {
        const bool is_integer = file.little_endian() == 0;
        file.skip(4);
        const std::uint32_t across = file.little_endian(), down = file.little_endian();
        channels.push_back({std::move(name), is_integer, across != 1 || down != 1});
    }
    return channels;
}

/// Grey or RGB, alone or with alpha, of floats. In the file they stand in the order of their names.
Refusal check_channels(const std::vector<ExrChannel>& channels) {
    std::string names, bare;
    for (const ExrChannel& channel : channels) {
        names += (names.empty() ? "" : ", ") + channel.name;
        bare += channel.name + ' ';
        if (names.size() > 200) break;
    }
    if (bare.find("RY ") != std::string::npos || bare.find("BY ") != std::string::npos)
        return "the image's channels are luminance and chroma (" + names +
               "), which are not read: store R, G, B";
    for (const ExrChannel& c : channels) {
        if (c.is_integer)
            return "the image's channel " + c.name +
                   " is of whole numbers, which name things and are no light";
        if (c.is_sampled) return "the image's channel " + c.name + " has not one number a pixel";
    }
    constexpr std::array<std::string_view, 4> kRead{"Y ", "A Y ", "B G R ", "A B G R "};
    if (std::find(kRead.begin(), kRead.end(), bare) != kRead.end()) return {};
    return "the image's channels are " + names + "; they must be Y or R, G, B, with or without A";
}

Refusal take_channels(Cursor value, std::uint64_t size, ImageHeader& header) {
    const std::uint64_t left = value.left();
    const auto channels = read_channels(value);
    if (value.failed() || header.channels > 0 || left - value.left() != size) return kDamaged;
    header.channels = static_cast<int>(channels.size());
    return check_channels(channels);
}

/// x and y of the first and of the last pixel.
Refusal take_window(Cursor value, std::uint64_t /*size*/, ImageHeader& header) {
    std::array<std::int64_t, 4> box{};
    for (std::int64_t& side : box) side = static_cast<std::int32_t>(value.little_endian());
    if (value.failed() || box[2] < box[0] || box[3] < box[1] || header.width > 0) return kDamaged;
    header.width = static_cast<std::uint64_t>(box[2] - box[0]) + 1;
    header.height = static_cast<std::uint64_t>(box[3] - box[1]) + 1;
    return {};
}

/// The library takes memory for a whole tile, however small the picture is.
Refusal take_tiles(Cursor value, std::uint64_t /*size*/, ImageHeader& /*header*/) {
    constexpr std::uint64_t kMostPixels = 1U << 22U;
    const std::uint64_t across = value.little_endian(), down = value.little_endian();
    if (value.failed() || across * down > kMostPixels) return "the image's tiles are too large";
    return {};
}

struct ExrAttribute {
    std::string_view name, type;
    Refusal (*take)(Cursor value, std::uint64_t size, ImageHeader& header);
};
constexpr std::array kExrAttributes{ExrAttribute{"channels", "chlist", &take_channels},
                                    ExrAttribute{"dataWindow", "box2i", &take_window},
                                    ExrAttribute{"tiles", "tiledesc", &take_tiles}};

/// Types of which the library reads so many bytes, whatever the file says of their size: what
/// follows would then be another header than the one that is judged here.
struct ExrType {
    std::string_view name;
    std::uint32_t size;
};
constexpr std::array kExrTypes{
    ExrType{"box2f", 16},   ExrType{"box2i", 16},      ExrType{"chromaticities", 32},
    ExrType{"double", 8},   ExrType{"compression", 1}, ExrType{"deepImageState", 1},
    ExrType{"envmap", 1},   ExrType{"float", 4},       ExrType{"int", 4},
    ExrType{"keycode", 28}, ExrType{"lineOrder", 1},   ExrType{"m33d", 72},
    ExrType{"m33f", 36},    ExrType{"m44d", 128},      ExrType{"m44f", 64},
    ExrType{"rational", 8}, ExrType{"tiledesc", 9},    ExrType{"timecode", 8},
    ExrType{"v2d", 16},     ExrType{"v2f", 8},         ExrType{"v2i", 8},
    ExrType{"v3d", 24},     ExrType{"v3f", 12},        ExrType{"v3i", 12},
};
/// Types that have counts inside, by which the library takes memory.
constexpr std::array<std::string_view, 2> kCountedTypes{"preview", "stringvector"};

/// A picture of `across` by `down` pixels of four bytes, or texts behind their sizes.
bool is_counted_right(std::string_view type, Cursor value, std::uint64_t size) {
    if (type == "preview") {
        const std::uint64_t across = value.little_endian(), down = value.little_endian();
        return across < kLargestSide && down < kLargestSide && size == 8 + 4 * across * down;
    }
    for (int i = 0; size > 0; ++i) {
        const std::uint64_t text = value.little_endian();
        if (value.failed() || i == kMostParts || size < 4 || text > size - 4) return false;
        size -= 4 + text;
        value.skip(text);
    }
    return true;
}

bool is_type_right(std::string_view type, const Cursor& value, std::uint64_t size) {
    const auto fixed = std::find_if(kExrTypes.begin(), kExrTypes.end(),
                                    [&](const ExrType& t) { return t.name == type; });
    if (fixed != kExrTypes.end()) return fixed->size == size;
    if (type == "idmanifest") return false;  // names of ids, packed: what it unfolds to is claimed
    const bool is_counted =
        std::find(kCountedTypes.begin(), kCountedTypes.end(), type) != kCountedTypes.end();
    return !is_counted || is_counted_right(type, value, size);
}

/// All attributes: name, type, size, value. The library takes memory for sizes that are in none of
/// its types, before it looks whether the file has so many bytes.
Refusal read_exr(Cursor& file, ImageHeader& header) {
    file.skip(4);
    const std::uint32_t version = file.little_endian();
    if ((version & 0x1000U) != 0)
        return "the image has several parts, of which none is known to be meant: store one alone";
    if ((version & 0x800U) != 0) return "the image has samples in depth, which are not read";
    header.sample_bytes = 4;  // numbers of 16 bits too are read as floats
    for (int i = 0; i < kMostParts && !file.failed(); ++i) {
        const std::string name = file.name();
        if (name.empty()) return header.width > 0 && header.channels > 0 ? Refusal() : kDamaged;
        const std::string type = file.name();
        const std::uint32_t size = file.little_endian();
        if (size > file.left() || !is_type_right(type, file, size)) return kDamaged;
        const auto known = std::find_if(kExrAttributes.begin(), kExrAttributes.end(),
                                        [&](const ExrAttribute& a) { return a.name == name; });
        if (known != kExrAttributes.end()) {
            if (type != known->type) return kDamaged;
            if (Refusal refusal = known->take(file, size, header); !refusal.empty()) return refusal;
        }
        file.skip(size);
    }
    return kDamaged;
}

tl::unexpected<Error> refuse(std::string reason) {
    return fail(ErrorKind::InvalidInput, std::move(reason), "bad-image");
}

}  // namespace

Result<ImageHeader> read_image_header(const ByteSource& file) {
    const auto first = file.read(0, 16);
    if (!first) return tl::unexpected(first.error());
    const auto format = image_format_of(*first);
    if (!format) return refuse(kUnknownImageFormat);
    ImageHeader header;
    header.format = *format;
    Cursor cursor(file);
    const auto read = *format == ImageFormat::Png    ? &read_png
                      : *format == ImageFormat::Jpeg ? &read_jpeg
                                                     : &read_exr;
    Refusal refusal = read(cursor, header);
    if (cursor.error()) return tl::unexpected(*cursor.error());
    if (cursor.failed() || header.width > kLargestSide || header.height > kLargestSide)
        return refuse(kDamagedImageHeader);
    if (!refusal.empty()) return refuse(std::move(refusal));
    return header;
}

Result<void> check_pixels(std::uint64_t width, std::uint64_t height, std::uint64_t max_pixels) {
    if (width * height <= max_pixels) return {};
    return fail(ErrorKind::InvalidInput,
                "the image has " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels, more than " + std::to_string(max_pixels),
                "over-limit");
}

}  // namespace bouguer::renderer
