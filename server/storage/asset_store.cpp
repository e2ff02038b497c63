// SPDX-License-Identifier: Apache-2.0
#include "server/storage/asset_store.h"

#include <algorithm>
#include <array>

#include "api/digest.h"
#include "renderer/film/image_decoder.h"

namespace bouguer::server {
namespace {

/// OBJ has no magic number: its first line that is neither empty nor a comment begins with one of
/// the format's words.
bool is_obj(std::string_view bytes) {
    constexpr std::array<std::string_view, 11> kWords{"v", "vt", "vn", "vp",     "f",     "l",
                                                      "o", "g",  "s",  "mtllib", "usemtl"};
    while (!bytes.empty()) {
        std::string_view line = bytes.substr(0, bytes.find('\n'));
        bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
        const auto begin = line.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos || line[begin] == '#') continue;
        line.remove_prefix(begin);
        const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
        return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
    }
    return false;
}

std::string in_mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

}  // namespace

std::string_view asset_media_type(std::string_view bytes) {
    if (const auto format = renderer::image_format_of(bytes)) {
        constexpr std::array<std::string_view, 3> kImages{"image/png", "image/jpeg", "image/x-exr"};
        return kImages[static_cast<std::size_t>(*format)];
    }
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return "application/x-ply";
    return is_obj(bytes) ? "model/obj" : "";
}

Result<void> check_asset(const std::string& digest, std::string_view bytes,
                         const AssetStoreLimits& limits) {
    if (bytes.size() > limits.file_bytes) {
        return fail(ErrorKind::TooLarge,
                    "the file is larger than " + in_mebibytes(limits.file_bytes));
    }
    if (const std::string found = api::digest_of(bytes); found != digest) {
        return fail(ErrorKind::InvalidInput,
                    "the body has the digest " + found + " and not " + digest, "digest-mismatch");
    }
    if (asset_media_type(bytes).empty()) {
        return fail(ErrorKind::InvalidInput,
                    "the body is none of PNG, JPEG, EXR, PLY and OBJ, judged by its content",
                    "unknown-type");
    }
    return {};
}

tl::unexpected<Error> asset_store_is_full(const AssetStoreLimits& limits) {
    return fail(ErrorKind::TooLarge,
                "there is no room left for this file: all together may have " +
                    in_mebibytes(limits.total_bytes),
                "asset-store-full");
}

}  // namespace bouguer::server
