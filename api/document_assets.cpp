// SPDX-License-Identifier: Apache-2.0
#include "api/document_assets.h"

#include "api/digest.h"
#include "renderer/geometry/mesh_file.h"

namespace bouguer::api {

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

Result<DocumentAssets::MeshPtr> DocumentAssets::mesh(const std::string& name) {
    if (const auto known = meshes_.find(name); known != meshes_.end()) return known->second;
    const renderer::MeshLimits limits{limits_.mesh_vertices, limits_.mesh_triangles};
    auto mesh = read(name).and_then(
        [&](const std::string& bytes) { return renderer::read_mesh(bytes, limits); });
    return meshes_.emplace(name, std::move(mesh)).first->second;
}

Result<renderer::TextureImagePtr> DocumentAssets::image(const std::string& name,
                                                        std::size_t max_pixels) {
    if (const auto known = images_.find(name); known != images_.end()) return known->second;
    auto image = read(name).and_then(
        [&](const std::string& bytes) { return renderer::read_texture_image(bytes, max_pixels); });
    return images_.emplace(name, std::move(image)).first->second;
}

std::string DocumentAssets::digest() const {
    std::string all;
    for (const auto& [name, digest] : digests_) all += name + '\0' + digest + '\0';
    return all.empty() ? all : digest_of(all);
}

}  // namespace bouguer::api
