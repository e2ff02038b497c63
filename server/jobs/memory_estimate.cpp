// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/memory_estimate.h"

#include "renderer/film/film.h"
#include "renderer/geometry/mesh_size.h"
#include "renderer/materials/material_textures.h"

namespace bouguer::server {
namespace {

constexpr std::uint64_t kInstanceBytes = 1024;
constexpr std::uint64_t kFixedBytes = 1U << 20U;
/// The newest picture and the one before it, what the encoders of PNG and EXR make of it, and the
/// files: measured, 1000 x 760 pixels took 254 MiB and 2000 x 1520 1008, of which the film is 209
/// and 835.
constexpr std::uint64_t kPictureBytes = 6 * 3 * sizeof(float);

/// Of every texture once, however many surfaces have it.
std::uint64_t texture_memory_bytes(const renderer::SceneDescription& scene) {
    renderer::TextureSet textures;
    for (const renderer::MaterialDescription& material : scene.materials)
        textures.merge(renderer::textures_of(material));
    return renderer::memory_bytes_of(textures);
}

}  // namespace

std::uint64_t scene_memory_bytes(const renderer::SceneDescription& scene) {
    std::uint64_t bytes = kFixedBytes + texture_memory_bytes(scene);
    for (const renderer::ObjectDescription& object : scene.objects) {
        bytes += object.placed.instances.size() * kInstanceBytes;
        const auto* mesh =
            std::get_if<std::shared_ptr<const renderer::TriangleMesh>>(&object.placed.shape);
        if (mesh == nullptr || *mesh == nullptr) continue;
        bytes +=
            renderer::MeshSize{(*mesh)->positions.size(), (*mesh)->triangles.size()}.memory_bytes();
    }
    return bytes;
}

std::uint64_t job_memory_bytes(const api::JobRequest& job) {
    const renderer::Resolution whole = job.settings.resolution;
    const renderer::Crop area =
        job.settings.crop.value_or(renderer::Crop{0, 0, whole.width, whole.height});
    const auto pixels =
        static_cast<std::uint64_t>(area.width) * static_cast<std::uint64_t>(area.height);
    const auto replicates = static_cast<std::uint32_t>(job.settings.replicates);
    return scene_memory_bytes(job.scene) + pixels * kPictureBytes +
           renderer::Film::memory_bytes(pixels, replicates);
}

}  // namespace bouguer::server
