// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "api/writers.h"
#include "renderer/film/picture_file.h"
#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/document.h"
#include "server/cli/output_file.h"
#include "server/storage/durable_file.h"

namespace bouguer::server {
namespace {

constexpr std::size_t kLargestFile = std::size_t{2} << 30U;

bool is_document(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{';
}

Result<renderer::LoadedPicture> load(const std::filesystem::path& file) {
    const auto bytes = read_file(file, kLargestFile);
    if (!bytes) return tl::unexpected(bytes.error());
    if (is_document(*bytes))
        return fail(ErrorKind::InvalidInput, file.string() +
                                                 " is a document; render it first: "
                                                 "bouguer render " +
                                                 file.string() + " -o PICTURE.exr");
    auto picture = renderer::load_picture(*bytes);
    if (!picture) picture.error().message = file.string() + ": " + picture.error().message;
    return picture;
}

void print_text(const CompareOptions& options, const renderer::PictureDifference& d,
                const renderer::OutputSettings& output) {
    std::cout << "CIEDE2000 of " << options.a.string() << " and " << options.b.string() << ", "
              << d.width << " x " << d.height << " pixels, as " << output.display
              << " shows them at exposure " << d.exposure << "\n"
              << "mean             " << d.mean << "\n"
              << "95th percentile  " << d.percentile_95 << "\n"
              << "maximum          " << d.maximum << " at (" << d.maximum_x << ", " << d.maximum_y
              << ")\n";
    if (d.unknown_pixels > 0)
        std::cout << "not comparable   " << d.unknown_pixels << " pixels without a finite colour\n";
}

Result<void> compare(const CompareOptions& options) {
    const auto output = read_output_options(options.output, api::OutputScope::Comparison, {});
    if (!output) return tl::unexpected(output.error());
    const auto a = load(options.a);
    if (!a) return tl::unexpected(a.error());
    const auto b = load(options.b);
    if (!b) return tl::unexpected(b.error());
    const auto difference = renderer::compare_pictures(*a, *b, *output);
    if (!difference) return tl::unexpected(difference.error());
    if (options.map) {
        const auto map = renderer::encode_difference_map(*difference);
        if (!map) return tl::unexpected(map.error());
        if (auto written = write_output(*options.map, *map); !written) return written;
    }
    if (options.json) {
        std::cout << api::comparison_json(*difference, *output, options.a.string(),
                                          options.b.string())
                  << "\n";
    } else {
        print_text(options, *difference, *output);
    }
    return {};
}

}  // namespace

int run_compare(const CompareOptions& options) {
    const auto done = compare(options);
    return done ? kExitOk : print_error(std::cerr, done.error());
}

}  // namespace bouguer::server
