// SPDX-License-Identifier: Apache-2.0
// The files that come of a render: their names, media types and bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "renderer/render.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

/// "image/png" for "image.png" and so on; empty when no result has that name.
[[nodiscard]] std::string_view media_type_of(std::string_view name);

/// Whether the file of that name shows the picture, so that there is none before the first pass.
[[nodiscard]] bool is_image(std::string_view name);

/// Of a file that is not stored but made of a stored one when it is asked for: the name of that
/// one. Empty for all others.
[[nodiscard]] std::string_view source_of(std::string_view name);

/// Makes such a file ("error.png") of the bytes of its source. Error{Internal}, code
/// "result-damaged".
[[nodiscard]] Result<std::string> made_from_source(std::string_view source);

/// What a report names as its origin.
struct JobDigests {
    std::string job, scene;  ///< "sha256-<hex>"; may be empty
};

/// One of the files without a picture of the scene: "report.json", "error.json", "error.csv",
/// "error.png", "plan.json", "health.json". Empty for other names.
[[nodiscard]] std::optional<std::string> report_file(std::string_view name,
                                                     const renderer::Report& report,
                                                     const renderer::OutputSettings& output,
                                                     const JobDigests& digests);

/// Every file that is kept of a render that has ended; without images when `picture` is null.
/// Completes the report: timings.output_s, image.
[[nodiscard]] Result<ResultFiles> result_files(const renderer::Picture* picture,
                                               renderer::Report& report,
                                               const renderer::OutputSettings& output,
                                               const JobDigests& digests);

}  // namespace bouguer::server
