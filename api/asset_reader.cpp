// SPDX-License-Identifier: Apache-2.0
#include "api/asset_reader.h"

#include <algorithm>

#include "api/digest.h"
#include "api/document_assets.h"

namespace bouguer::api {
namespace {

/// Relative, and nothing in it that leads out of a folder.
bool is_safe_path(std::string_view path) {
    if (path.empty() || path.front() == '/') return false;
    for (const char c : path) {
        if (static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == 0x7f) return false;
    }
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        if (path.substr(begin, end - begin) == "..") return false;
        begin = end + 1;
    }
    return true;
}

std::optional<NamedAsset> named_by_path(const JsonValue& at, const Limits& limits) {
    auto path = at.text(limits.name_bytes);
    if (!path) return std::nullopt;
    if (is_safe_path(*path)) return NamedAsset{at, *std::move(path)};
    at.report("out-of-range", "the path leaves the folder of the assets",
              "a relative path without \"..\", \"\\\" and control characters");
    return std::nullopt;
}

std::optional<NamedAsset> named_by_digest(const JsonValue& at, const Limits& limits) {
    auto digest = at.text(limits.name_bytes);
    if (!digest) return std::nullopt;
    if (is_digest(*digest)) return NamedAsset{at, *std::move(digest)};
    report_no_digest(at);
    return std::nullopt;
}

}  // namespace

void report_no_digest(const JsonValue& value) {
    value.report("bad-format", "this is no digest", "\"sha256-\" and 64 digits of 0-9 and a-f");
}

std::optional<NamedAsset> require_asset(JsonReader& reader, const Limits& limits) {
    const auto asset = reader.find("asset");
    if (!asset) {
        const auto path = reader.require("path");
        return path ? named_by_path(*path, limits) : std::nullopt;
    }
    if (const auto path = reader.find("path")) {
        path->report("duplicate", "the file is named twice", "\"path\" or \"asset\"");
        return std::nullopt;
    }
    return named_by_digest(*asset, limits);
}

void report_asset(const NamedAsset& asset, const Error& error, std::string_view code,
                  std::string_view allowed) {
    const JsonValue& at = asset.at;
    if (error.code == DocumentAssets::kNotRead) return;
    if (error.kind == ErrorKind::NotFound && is_digest(asset.name)) {
        at.report("missing-asset", "no asset of this digest has been uploaded",
                  "the digest of a file that was put at /v1/assets/" + asset.name);
    } else if (error.kind == ErrorKind::NotFound) {
        at.report("unknown-name", "there is no such file", "the name of an asset");
    } else if (error.kind == ErrorKind::TooLarge) {
        at.report("over-limit", error.message);
    } else if (error.kind != ErrorKind::InvalidInput) {
        at.problems().fail_with(error);
    } else if (error.problems.empty()) {
        at.report(error.code.empty() ? code : error.code, error.message, std::string(allowed));
    }
    // The file's own pointers lead nowhere in this document, so all point to its name.
    for (const Problem& problem : error.problems) {
        at.report(problem.code.empty() ? code : problem.code, problem.detail, problem.allowed);
    }
}

}  // namespace bouguer::api
