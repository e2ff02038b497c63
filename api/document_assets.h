// SPDX-License-Identifier: Apache-2.0
// The files of one document: each judged by its header, and read once however often it is named.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "api/job_document.h"
#include "renderer/textures/texture_image.h"

namespace bouguer::api {

/// Reads files for as long as one document is read: ten thousand objects that name one file share
/// one mesh. Checks what is named by its digest against it. Not thread-safe.
///
/// What all files need together is known from their headers, and limited: name every file with
/// expect_...() before the first is read. After one that goes beyond a limit nothing more is read.
class DocumentAssets {
  public:
    DocumentAssets(const AssetSource& source, const Limits& limits)
        : source_(source), limits_(limits) {}

    using MeshPtr = std::shared_ptr<const renderer::TriangleMesh>;

    /// Looks at the first bytes of a file (of an OBJ at all of them, in pieces) and adds what it
    /// needs. What is wrong with it is kept for mesh() or image().
    void expect_mesh(const std::string& name);
    void expect_image(const std::string& name);

    /// The mesh in a PLY or OBJ file. Errors of AssetSource and renderer::read_mesh();
    /// InvalidInput: "digest-mismatch" when the content is not that of the name, "over-limit" with
    /// the sums of this document, kNotRead.
    [[nodiscard]] Result<MeshPtr> mesh(const std::string& name);

    /// The picture in a PNG, JPEG or EXR file. Errors of AssetSource and
    /// renderer::read_texture_image(); else as mesh().
    [[nodiscard]] Result<renderer::TextureImagePtr> image(const std::string& name);

    /// Code of the error of a file that nothing is wrong with, but others are over a limit, which
    /// is reported in their place.
    static constexpr const char* kNotRead = "not-read";
    /// Whether a file is over a limit.
    [[nodiscard]] bool is_over_limit() const { return is_over_limit_; }

    /// Of the contents of all files that were read so far by a path: they may change while the
    /// document stays. Empty when there are none.
    [[nodiscard]] std::string digest() const;

  private:
    template <class Content>
    struct File {
        std::optional<Error> refusal;
        std::uint64_t bytes = 0;  ///< of memory, as expected
        Content content;          ///< null: not read yet
    };

    Result<std::uint64_t> mesh_bytes(const std::string& name);
    Result<std::uint64_t> image_bytes(const std::string& name);
    [[nodiscard]] Result<void> add_bytes(std::uint64_t bytes);
    template <class Content>
    void expect(std::map<std::string, File<Content>>& files, const std::string& name,
                Result<std::uint64_t> (DocumentAssets::*needed)(const std::string&));
    Result<std::string> read(const std::string& name);
    Result<MeshPtr> read_mesh(const std::string& name, std::uint64_t expected_bytes);
    Result<renderer::TextureImagePtr> read_image(const std::string& name);
    template <class Content, class Read>
    Result<Content> content(File<Content>& file, const Read& read);
    [[nodiscard]] Error cause(const std::string& name, Error refusal);
    void refuse(std::optional<Error>& refusal, Error error);

    const AssetSource& source_;
    const Limits& limits_;
    std::map<std::string, File<MeshPtr>> meshes_;
    std::map<std::string, File<renderer::TextureImagePtr>> images_;
    std::uint64_t bytes_ = 0;         ///< of memory, for all files
    std::uint64_t largest_file_ = 0;  ///< bytes: one at a time is in memory as it lies
    std::uint64_t pixels_ = 0;
    bool is_over_limit_ = false;
    std::map<std::string, std::string> digests_;  ///< of files read by a path
};

}  // namespace bouguer::api
