// SPDX-License-Identifier: Apache-2.0
// The files of one document, each read once however often it is named.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "api/job_document.h"
#include "renderer/textures/texture_image.h"

namespace bouguer::api {

/// Reads files for as long as one document is read: ten thousand objects that name one file share
/// one mesh. Checks what is named by its digest against it. Not thread-safe.
class DocumentAssets {
  public:
    DocumentAssets(const AssetSource& source, const Limits& limits)
        : source_(source), limits_(limits) {}

    using MeshPtr = std::shared_ptr<const renderer::TriangleMesh>;

    /// The mesh in a PLY or OBJ file. Errors of AssetSource::read() and renderer::read_mesh();
    /// InvalidInput "digest-mismatch" when the content is not that of the name.
    [[nodiscard]] Result<MeshPtr> mesh(const std::string& name);

    /// The picture in a PNG, JPEG or EXR file. Errors of AssetSource::read() and
    /// renderer::read_texture_image(); "digest-mismatch". `max_pixels` counts when it is first
    /// read.
    [[nodiscard]] Result<renderer::TextureImagePtr> image(const std::string& name,
                                                          std::size_t max_pixels);

    /// Of the contents of all files that were read so far by a path: they may change while the
    /// document stays. Empty when there are none.
    [[nodiscard]] std::string digest() const;

  private:
    Result<std::string> read(const std::string& name);

    const AssetSource& source_;
    const Limits& limits_;
    std::map<std::string, Result<MeshPtr>> meshes_;
    std::map<std::string, Result<renderer::TextureImagePtr>> images_;
    std::map<std::string, std::string> digests_;  ///< of files read by a path
};

}  // namespace bouguer::api
