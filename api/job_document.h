// SPDX-License-Identifier: Apache-2.0
// The documents bouguer-job/1 and bouguer-scene/1: text -> typed values, every problem with its
// JSON pointer.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "api/limits.h"
#include "renderer/core/byte_source.h"
#include "renderer/core/result.h"
#include "renderer/core/warning.h"
#include "renderer/render.h"
#include "renderer/settings.h"
#include "renderer/spectrum/spectrum_notes.h"

namespace bouguer::api {

/// Where documents find the files they name. Implementations are thread-safe and never leave their
/// root folder.
class AssetSource {
  public:
    virtual ~AssetSource() = default;
    /// The file `name`, of which nothing is read yet: a path (relative, no "..") or a digest
    /// ("sha256-<hex>"). NotFound; TooLarge.
    [[nodiscard]] virtual Result<std::unique_ptr<const renderer::ByteSource>> open(
        std::string_view name) const = 0;
    /// All its bytes.
    [[nodiscard]] Result<std::string> read(std::string_view name) const;
};

/// A job, read and checked.
struct JobRequest {
    renderer::SceneDescription scene;
    renderer::RenderSettings settings;
    renderer::StopRule stop;
    renderer::OutputSettings output;
    renderer::SpectrumNotes notes;  ///< `where` is a JSON pointer
    Warnings warnings;              ///< what is valid and probably not meant
    int priority = 0;               ///< -100 .. 100; higher goes first
    std::map<std::string, std::string> labels;
    std::string scene_digest;  ///< "sha256-<hex>" of the scene's canonical form
    std::string digest;        ///< likewise of the whole job without priority and labels
    /// Of the contents of the files that the scene names by a path; empty when there are none.
    std::string files_digest;
    std::string canonical;  ///< the whole document, keys sorted, no white space
};

/// Reads a job (`bouguer-job/1`), or a bare scene (`bouguer-scene/1`) as a job with every default.
/// Error{Malformed}: not JSON, too deep, duplicate key, invalid UTF-8. Error{InvalidInput}: values,
/// all problems at once. Error{TooLarge}: over `limits.body_bytes`. Error{Busy}, code
/// "out-of-memory": memory ran out on the way. Thread-safe.
[[nodiscard]] Result<JobRequest> parse_job(std::string_view text, const Limits& limits,
                                           const AssetSource& assets);

/// Reads a scene alone, for validation. Problems as parse_job.
[[nodiscard]] Result<JobRequest> parse_scene(std::string_view text, const Limits& limits,
                                             const AssetSource& assets);

}  // namespace bouguer::api
