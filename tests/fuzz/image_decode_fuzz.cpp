// SPDX-License-Identifier: Apache-2.0
// libFuzzer entry for the reading of pictures down to the light of a texture: whatever the bytes, a
// picture that keeps its promises or an error, in memory and time that are bounded. The check sums
// of a PNG's chunks are put right first, or nothing behind them would be tried; what is no picture
// is tried as an ICC profile. Build as job_document_fuzz.cpp says, target image_decode_fuzz, then
//
//     tests/fuzz/make_picture_corpus.py build/fuzz/pictures
//     build/fuzz/tests/fuzz/image_decode_fuzz -max_total_time=1200 -timeout=10
//         -malloc_limit_mb=256 build/fuzz/pictures
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/film/image_decoder.h"
#include "renderer/film/inflate.h"
#include "renderer/textures/file_colours.h"

namespace {

using namespace bouguer::renderer;

void require(bool promise) {
    if (!promise) std::abort();
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
    return value;
}

/// Gives every chunk that fits the check sum of its bytes.
std::string with_check_sums(std::string png) {
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t size = big_endian(std::string_view(png).substr(at));
        if (size > png.size() - at - 12) break;
        const std::uint32_t sum = crc32_of(std::string_view(png).substr(at + 4, 4 + size));
        for (std::size_t i = 0; i < 4; ++i)
            png[at + 8 + size + i] = static_cast<char>(sum >> (24 - 8 * i));
        at += 12 + size;
    }
    return png;
}

void check_samples(const ImageSamples& samples, int width, int height, int channels) {
    require(width > 0 && height > 0 && channels >= 1 && channels <= 4);
    const auto expected = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                          static_cast<std::size_t>(channels);
    require(expected == std::visit([](const auto& s) { return s.size(); }, samples));
}

void try_picture(std::string_view bytes) {
    constexpr std::size_t kMostPixels = 1U << 16U;
    const auto decoded = decode_image(bytes, kMostPixels);
    if (decoded) {
        require(decoded->orientation == 1);
        check_samples(decoded->samples, decoded->width, decoded->height, decoded->channels);
    }
    const auto image = read_texture_image(bytes, kMostPixels);
    if (!image) return;
    require(decoded.has_value());
    const auto light = in_file_colours(*image);
    if (!light) return;
    check_samples((*light)->samples, (*light)->width, (*light)->height, (*light)->channels);
    require((*light)->encoding.has_value());
    if (const auto* floats = std::get_if<std::vector<float>>(&(*light)->samples))
        for (const float v : *floats) require(std::isfinite(v) && v >= 0);
}

void try_profile(std::string_view bytes) {
    PictureColour colour;
    colour.icc_profile.assign(bytes.begin(), bytes.end());
    if (bytes.empty()) return;
    for (const bool is_grey : {false, true}) {
        const auto known = known_encoding(colour, ColourEncoding::Srgb, is_grey);
        const auto to_light = linear_rec709(colour, ColourEncoding::Srgb, is_grey);
        require(known.has_value() == to_light.has_value());
        std::vector<float> pixels{0, 0, 0, 0.25F, 0.25F, 0.25F, 1, 1, 1, 0.1F, 0.2F, 0.9F};
        if (to_light) (*to_light)(pixels);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto format = image_format_of(bytes);
    if (!format) {
        try_profile(bytes);
    } else {
        try_picture(format == ImageFormat::Png ? with_check_sums(std::string(bytes))
                                               : std::string(bytes));
    }
    return 0;
}
