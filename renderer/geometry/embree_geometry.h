// SPDX-License-Identifier: Apache-2.0
// Geometry on Embree: the queries. How it is put together is in geometry_builder.cpp.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/geometry/analytic_set.h"
#include "renderer/geometry/embree_api.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/mesh_part.h"

namespace bouguer::renderer {

/// An infinite plane: dot(n, p) = offset.
struct PlanePart {
    Vec3 n;
    Real offset = 0;
    PartOwner owner;
};

/// What Embree has allocated, and how much it may.
struct EmbreeMemory {
    std::atomic<std::int64_t> bytes{0};
    std::uint64_t max_bytes = 0;
    std::atomic<bool> exceeded{false};
};

/// Everything that queries read. Immutable once built.
struct GeometryData {
    std::unique_ptr<EmbreeMemory> memory =
        std::make_unique<EmbreeMemory>();  ///< outlives the device, which reports to it
    DeviceHandle device;
    std::vector<SceneHandle> instanced;  ///< scenes of one mesh each
    SceneHandle scene;                   ///< null when it would be empty
    /// Embree's geometry i (or instance i) is mesh i; the one after the last is all analytic
    /// shapes.
    std::vector<MeshPart> meshes;
    std::vector<PartOwner> mesh_owners;
    std::unique_ptr<AnalyticSet> analytic = std::make_unique<AnalyticSet>();
    std::vector<PlanePart> planes;
    Vec3 origin;
    Real radius = 0;
    Real scale = 1;    ///< from scene units to Embree's: a power of two
    Real unscale = 1;  ///< its inverse
    std::uint32_t num_meshes = 0;
    std::uint64_t num_triangles = 0;
    std::uint64_t own_bytes = 0;
};

class EmbreeGeometry final : public Geometry {
  public:
    explicit EmbreeGeometry(GeometryData data) : data_(std::move(data)) {}

    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const override;
    [[nodiscard]] std::optional<Hit> intersect_within(const Ray& ray, Real t_max) const override;
    [[nodiscard]] bool occluded(const Ray& ray, Real t_max) const override;
    [[nodiscard]] Vec2 surface_uv(const Hit& hit) const override;
    [[nodiscard]] Vec3 origin() const override { return data_.origin; }
    [[nodiscard]] Real radius() const override { return data_.radius; }
    [[nodiscard]] std::uint64_t num_triangles() const override { return data_.num_triangles; }
    [[nodiscard]] std::uint64_t memory_bytes() const override;

    /// What queries read; for benchmarks that ask Embree without us.
    [[nodiscard]] const GeometryData& data() const { return data_; }

  private:
    GeometryData data_;
};

}  // namespace bouguer::renderer
