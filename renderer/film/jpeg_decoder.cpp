// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/jpeg_decoder.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

// These need the names of <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include "renderer/film/exif.h"

namespace bouguer::renderer {
namespace {

constexpr int kExifMarker = JPEG_APP0 + 1;
constexpr int kProfileMarker = JPEG_APP0 + 2;
/// Every scan of a progressive file costs a pass over the whole picture, however few bytes it has;
/// writers make about ten.
constexpr int kMostScans = 100;

/// [Adobe RGB (1998) §4.3]
constexpr TransferCurve kAdobeRgbCurve{TransferCurve::Kind::Power, 563.0 / 256};
constexpr std::array<float, 8> kAdobeRgb{0.64F, 0.33F, 0.21F,   0.71F,
                                         0.15F, 0.06F, 0.3127F, 0.3290F};

/// libjpeg's reports: the first one ends the reading.
struct Reports {
    jpeg_error_mgr manager{};  ///< comes first: libjpeg knows the address of this alone
    std::jmp_buf back{};
    char text[JMSG_LENGTH_MAX] = "";
};

[[noreturn]] void give_up(j_common_ptr info) {
    auto* reports = reinterpret_cast<Reports*>(info->err);
    (*info->err->format_message)(info, reports->text);
    std::longjmp(reports->back, 1);
}

/// Warnings have level -1. A later JFIF of the same format is none.
void judge_message(j_common_ptr info, int level) {
    if (level < 0 && info->err->msg_code != JWRN_JFIF_MAJOR) give_up(info);
}

void count_scans(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= kMostScans) return;
    auto* reports = reinterpret_cast<Reports*>(info->err);
    std::snprintf(reports->text, sizeof reports->text, "it has more than %d scans", kMostScans);
    std::longjmp(reports->back, 1);
}

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

/// One file and the state of its reading.
class JpegFile {
  public:
    explicit JpegFile(std::string_view bytes) : size_(bytes.size()) {
        info_.err = jpeg_std_error(&reports_.manager);
        reports_.manager.error_exit = &give_up;
        reports_.manager.emit_message = &judge_message;
        reports_.manager.output_message = [](j_common_ptr) {};
        progress_.progress_monitor = &count_scans;
        // Without memory for its own state libjpeg reports too.
        is_begun_ = guarded([&] {
            jpeg_create_decompress(&info_);
            info_.progress = &progress_;
            jpeg_save_markers(&info_, kExifMarker, 0xffff);
            jpeg_save_markers(&info_, kProfileMarker, 0xffff);
            jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(bytes.data()),
                         static_cast<unsigned long>(bytes.size()));
        });
    }
    ~JpegFile() { jpeg_destroy_decompress(&info_); }
    JpegFile(const JpegFile&) = delete;
    JpegFile& operator=(const JpegFile&) = delete;

    [[nodiscard]] jpeg_decompress_struct& info() { return info_; }

    [[nodiscard]] bool read_header() {
        return is_begun_ && guarded([&] { jpeg_read_header(&info_, TRUE); });
    }

    /// Rows of `row_bytes` into `rows`, which has room for all of them.
    [[nodiscard]] bool read_pixels(std::uint8_t* rows, std::size_t row_bytes) {
        return guarded([&] {
            info_.do_block_smoothing = FALSE;  // which makes up what is missing
            jpeg_start_decompress(&info_);
            while (info_.output_scanline < info_.output_height) {
                JSAMPROW row = rows + row_bytes * info_.output_scanline;
                jpeg_read_scanlines(&info_, &row, 1);
            }
        });
    }

    /// What the file said of itself is gone afterwards.
    [[nodiscard]] bool finish() {
        return guarded([&] { jpeg_finish_decompress(&info_); });
    }

    /// Whether every component came, and in a progressive file every bit of it.
    [[nodiscard]] bool is_complete() const {
        for (int c = 0; c < info_.num_components; ++c) {
            if (info_.comp_info[c].quant_table == nullptr) return false;
            if (info_.coef_bits == nullptr) continue;
            const int(&bits)[DCTSIZE2] = info_.coef_bits[c];  // -1: never came, else bits left out
            if (std::any_of(std::begin(bits), std::end(bits), [](int b) { return b != 0; }))
                return false;
        }
        return true;
    }

    /// False where the segments of the profile do not fit together.
    [[nodiscard]] bool read_profile(std::vector<std::uint8_t>& profile) {
        JOCTET* data = nullptr;
        unsigned size = 0;
        const bool is_good =
            guarded([&] { static_cast<void>(jpeg_read_icc_profile(&info_, &data, &size)); });
        const std::unique_ptr<JOCTET, Free> owner(data);
        if (is_good && data != nullptr) profile.assign(data, data + size);
        return is_good;
    }

    [[nodiscard]] std::string_view exif() const {
        for (auto* m = info_.marker_list; m != nullptr; m = m->next) {
            const std::string_view data(reinterpret_cast<const char*>(m->data), m->data_length);
            if (m->marker == kExifMarker && data.starts_with(kExifPrefix)) return data;
        }
        return {};
    }

    /// What libjpeg last had to say, and where.
    [[nodiscard]] std::string report() const {
        const std::size_t left = info_.src != nullptr ? info_.src->bytes_in_buffer : 0;
        return std::string(": ") + reports_.text + ", at byte " +
               std::to_string(size_ - std::min(left, size_)) + " of " + std::to_string(size_);
    }

  private:
    /// Whether `step` came to its end. It may hold nothing that has a destructor: it is left by a
    /// jump.
    template <class Step>
    [[nodiscard]] bool guarded(const Step& step) {
        if (setjmp(reports_.back) != 0) return false;
        step();
        return true;
    }

    jpeg_decompress_struct info_{};
    Reports reports_;
    jpeg_progress_mgr progress_{};
    std::size_t size_;
    bool is_begun_ = false;
};

tl::unexpected<Error> refuse(const std::string& reason) {
    return fail(ErrorKind::InvalidInput, reason, "bad-image");
}

}  // namespace

Result<DecodedImage> decode_jpeg(std::string_view bytes, const ImageHeader& header) {
    JpegFile file(bytes);
    jpeg_decompress_struct& info = file.info();
    if (!file.read_header()) return refuse(kDamagedImageHeader + file.report());
    if (info.image_width != header.width || info.image_height != header.height)
        return refuse(kDamagedImageHeader);
    if (info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK)
        return refuse("the image is CMYK, amounts of ink: convert it to sRGB");
    if (info.out_color_space != JCS_GRAYSCALE && info.out_color_space != JCS_RGB)
        return refuse("the image's " + std::to_string(info.num_components) +
                      " channels are neither grey nor R, G, B");
    DecodedImage image;
    image.format = ImageFormat::Jpeg;
    image.width = static_cast<int>(info.image_width);
    image.height = static_cast<int>(info.image_height);
    image.channels = info.out_color_space == JCS_RGB ? 3 : 1;
    const auto row_bytes =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> rows(row_bytes * info.image_height);
    if (!file.read_pixels(rows.data(), row_bytes)) return refuse(kDamagedPixels + file.report());
    if (!file.is_complete())
        return refuse(std::string(kDamagedPixels) + ": some of its scans are missing");
    const std::string_view exif = file.exif();
    image.orientation = exif_orientation(exif);
    if (is_adobe_rgb(exif)) image.colour = {kAdobeRgbCurve, kAdobeRgb, {}};
    std::vector<std::uint8_t> profile;
    if (!file.read_profile(profile) || !file.finish())
        return refuse(kDamagedPixels + file.report());
    if (!profile.empty()) image.colour = {{}, {}, std::move(profile)};
    image.samples = std::move(rows);
    return image;
}

}  // namespace bouguer::renderer
