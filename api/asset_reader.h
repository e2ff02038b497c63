// SPDX-License-Identifier: Apache-2.0
// Files that objects of a document name, by a path in the job's folder or by their digest:
//
//     "path": "teapot.ply" | "asset": "sha256-<64 hexadecimal digits>"
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "api/json_reader.h"
#include "api/limits.h"

namespace bouguer::api {

struct NamedAsset {
    JsonValue at;      ///< where it is named
    std::string name;  ///< for DocumentAssets
};

/// What `reader`'s object names by `path` or `asset`. Empty after a report: neither or both, a path
/// that leads out of the folder, no digest.
[[nodiscard]] std::optional<NamedAsset> require_asset(JsonReader& reader, const Limits& limits);

/// Reports that the text at `value` is no digest.
void report_no_digest(const JsonValue& value);

/// Reports at the name why the file cannot be used. Problems without a code of their own get
/// `code`; `allowed` is what would be accepted. Errors that are not the document's end the reading.
void report_asset(const NamedAsset& asset, const Error& error, std::string_view code,
                  std::string_view allowed);

}  // namespace bouguer::api
