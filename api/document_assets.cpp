// SPDX-License-Identifier: Apache-2.0
#include "api/document_assets.h"

#include <algorithm>

#include "api/digest.h"
#include "renderer/film/image_header.h"
#include "renderer/geometry/mesh_file.h"
#include "renderer/geometry/mesh_size.h"
#include "renderer/textures/file_colours.h"

namespace bouguer::api {
namespace {

/// A sum that is over its limit; `allowed` is the limit, for people.
tl::unexpected<Error> over_limit(const std::string& message, std::string allowed) {
    Error error{ErrorKind::InvalidInput, message, {}, "over-limit"};
    error.problems.push_back({"", "over-limit", message, {}, std::move(allowed)});
    return tl::unexpected(std::move(error));
}

}  // namespace

Result<void> DocumentAssets::add_bytes(std::uint64_t bytes) {
    const std::uint64_t taken = std::min(bytes_ + largest_file_, limits_.memory_bytes);
    if (bytes > limits_.memory_bytes - taken) {
        return over_limit(
            "the scene's files need more memory than this server gives to one job",
            "at most " + std::to_string(limits_.memory_bytes) + " bytes for a whole job");
    }
    bytes_ += bytes;
    return {};
}

Result<std::uint64_t> DocumentAssets::mesh_bytes(const std::string& name) {
    const auto file = source_.open(name);
    if (!file) return tl::unexpected(file.error());
    const auto size =
        renderer::read_mesh_size(**file, {limits_.mesh_vertices, limits_.mesh_triangles});
    if (!size) return tl::unexpected(size.error());
    largest_file_ = std::max(largest_file_, (*file)->size());
    return size->memory_bytes();
}

Result<std::uint64_t> DocumentAssets::image_bytes(const std::string& name) {
    const auto file = source_.open(name);
    if (!file) return tl::unexpected(file.error());
    const auto header = renderer::read_image_header(**file);
    if (!header) return tl::unexpected(header.error());
    auto fits = renderer::check_pixels(header->width, header->height, limits_.texture_pixels);
    if (!fits) return tl::unexpected(std::move(fits).error());
    if (header->pixels() > limits_.scene_texture_pixels - pixels_) {
        return over_limit("the scene's textures have too many pixels",
                          "at most " + std::to_string(limits_.scene_texture_pixels) +
                              " pixels in all image textures");
    }
    pixels_ += header->pixels();
    // The chunks of a PNG that hold its pixels are put together once more, the profile of a JPEG
    // too.
    const std::uint64_t copies = header->format == renderer::ImageFormat::Exr ? 1 : 2;
    largest_file_ = std::max(largest_file_, copies * (*file)->size());
    return header->decoded_bytes();
}

template <class Content>
void DocumentAssets::expect(std::map<std::string, File<Content>>& files, const std::string& name,
                            Result<std::uint64_t> (DocumentAssets::*needed)(const std::string&)) {
    const auto [entry, is_new] = files.try_emplace(name);
    if (!is_new) return;
    auto bytes = (this->*needed)(name);
    if (bytes) entry->second.bytes = *bytes;
    auto fits = bytes ? add_bytes(*bytes) : Result<void>();
    if (!bytes) refuse(entry->second.refusal, cause(name, std::move(bytes).error()));
    if (!fits) refuse(entry->second.refusal, std::move(fits).error());
}

/// Of a header that makes no sense it is the cause that the file is not the one of its digest.
Error DocumentAssets::cause(const std::string& name, Error refusal) {
    if (!is_digest(name) || refusal.kind != ErrorKind::InvalidInput) return refusal;
    if (refusal.code == "over-limit") return refusal;
    const auto whole = read(name);
    return whole ? refusal : whole.error();
}

void DocumentAssets::refuse(std::optional<Error>& refusal, Error error) {
    is_over_limit_ = is_over_limit_ || error.code == "over-limit";
    refusal = std::move(error);
}

void DocumentAssets::expect_mesh(const std::string& name) {
    expect(meshes_, name, &DocumentAssets::mesh_bytes);
}

void DocumentAssets::expect_image(const std::string& name) {
    expect(images_, name, &DocumentAssets::image_bytes);
}

Result<std::string> DocumentAssets::read(const std::string& name) {
    auto bytes = source_.read(name);
    if (!bytes) return bytes;
    const std::string digest = digest_of(*bytes);
    if (!is_digest(name)) {
        digests_[name] = digest;
    } else if (digest != name) {
        return fail(ErrorKind::InvalidInput, "the content of this file has the digest " + digest,
                    "digest-mismatch");
    }
    return bytes;
}

/// A mesh may have more triangles than its file had faces: those beyond are added.
Result<DocumentAssets::MeshPtr> DocumentAssets::read_mesh(const std::string& name,
                                                          std::uint64_t expected_bytes) {
    const renderer::MeshLimits limits{limits_.mesh_vertices, limits_.mesh_triangles};
    auto mesh = read(name).and_then(
        [&](const std::string& bytes) { return renderer::read_mesh(bytes, limits); });
    if (!mesh) return mesh;
    const renderer::MeshSize size{(*mesh)->positions.size(), (*mesh)->triangles.size()};
    const std::uint64_t more = size.memory_bytes() - std::min(size.memory_bytes(), expected_bytes);
    if (auto fits = add_bytes(more); !fits) return tl::unexpected(std::move(fits).error());
    return mesh;
}

template <class Content, class Read>
Result<Content> DocumentAssets::content(File<Content>& file, const Read& read) {
    if (file.refusal) return tl::unexpected(*file.refusal);
    if (file.content != nullptr) return file.content;
    if (is_over_limit_) return fail(ErrorKind::InvalidInput, "not read", kNotRead);
    auto content = read();
    if (content) return file.content = *std::move(content);
    refuse(file.refusal, std::move(content).error());
    return tl::unexpected(*file.refusal);
}

Result<DocumentAssets::MeshPtr> DocumentAssets::mesh(const std::string& name) {
    expect_mesh(name);
    File<MeshPtr>& file = meshes_.at(name);
    return content(file, [&] { return read_mesh(name, file.bytes); });
}

/// Colours that are neither sRGB nor linear are kept once more, as floats.
Result<renderer::TextureImagePtr> DocumentAssets::read_image(const std::string& name) {
    auto image = read(name).and_then([&](const std::string& bytes) {
        return renderer::read_texture_image(bytes, limits_.texture_pixels);
    });
    if (!image) return image;
    if (auto fits = add_bytes(renderer::conversion_bytes(**image)); !fits)
        return tl::unexpected(std::move(fits).error());
    return image;
}

Result<renderer::TextureImagePtr> DocumentAssets::image(const std::string& name) {
    expect_image(name);
    return content(images_.at(name), [&] { return read_image(name); });
}

std::string DocumentAssets::digest() const {
    std::string all;
    for (const auto& [name, digest] : digests_) all += name + '\0' + digest + '\0';
    return all.empty() ? all : digest_of(all);
}

}  // namespace bouguer::api
