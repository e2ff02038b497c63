// SPDX-License-Identifier: Apache-2.0
// Rays a second: Embree alone against Geometry, on the same triangles and the same rays, by turns
// within one run because machines drift. One thread. A ratio of 1.3 is 1.3 times Embree's time.
//
//     embree_bench [rounds]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "renderer/core/hash.h"
#include "renderer/geometry/embree_api.h"
#include "renderer/geometry/geometry.h"
#include "tests/support/meshes.h"

namespace {

using namespace bouguer::renderer;

constexpr int kRays = 1 << 17;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The scene's triangles once more, with nothing around them.
class BareEmbree {
  public:
    BareEmbree(const std::vector<PlacedShape>& shapes, Vec3 origin)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
        for (const PlacedShape& placed : shapes) {
            const auto& mesh = *std::get<std::shared_ptr<const TriangleMesh>>(placed.shape);
            for (const Transform& m : placed.instances) add(mesh, m, origin);
        }
        rtcCommitScene(scene_.get());
    }

    [[nodiscard]] RTCRayHit intersect(RTCRayHit ray) const {
        EmbreeContext context;
        init_context(context);
        embree_intersect(scene_.get(), ray, context);
        return ray;
    }
    [[nodiscard]] bool occluded(RTCRay ray) const {
        EmbreeContext context;
        init_context(context);
        embree_occluded(scene_.get(), ray, context);
        return ray.tfar < 0;
    }

  private:
    void add(const TriangleMesh& mesh, const Transform& m, Vec3 origin) {
        const GeometryHandle geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        auto* xyz = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.positions.size()));
        for (const Vec3& position : mesh.positions) {
            const Vec3 p = m.point(position) - origin;
            for (int i = 0; i < 3; ++i) *xyz++ = static_cast<float>(p[i]);
        }
        auto* corners = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), mesh.triangles.size()));
        for (const auto& triangle : mesh.triangles)
            corners = std::copy(triangle.begin(), triangle.end(), corners);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene_.get(), geometry.get());
    }

    DeviceHandle device_;
    SceneHandle scene_;
};

RTCRayHit bare_ray(const Ray& ray) {
    RTCRayHit r{};
    r.ray.org_x = static_cast<float>(ray.o.x);
    r.ray.org_y = static_cast<float>(ray.o.y);
    r.ray.org_z = static_cast<float>(ray.o.z);
    r.ray.dir_x = static_cast<float>(ray.d.x);
    r.ray.dir_y = static_cast<float>(ray.d.y);
    r.ray.dir_z = static_cast<float>(ray.d.z);
    r.ray.tfar = kInfinity;
    r.ray.mask = ~0U;
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return r;
}

double uniform(std::uint64_t& state) { return static_cast<double>(hash(++state) >> 11U) * 0x1p-53; }

Vec3 direction(std::uint64_t& state) {
    const double z = 2 * uniform(state) - 1;
    const double phi = 2 * kPi * uniform(state);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Rays of a camera, row by row.
std::vector<Ray> primary_rays(Vec3 eye, Vec3 corner, Vec3 across, Vec3 down) {
    std::vector<Ray> rays;
    for (int i = 0; i < kRays; ++i) {
        const double x = (i % 512) / 512.0;
        const double y = i / 512 / (kRays / 512.0);
        rays.push_back({eye, normalize(corner + x * across + y * down)});
    }
    return rays;
}

/// Rays that leave where `rays` arrive, spread by the cosine law.
std::vector<Ray> bounced(const Geometry& geometry, const std::vector<Ray>& rays) {
    std::vector<Ray> result;
    std::uint64_t state = 0;
    for (const Ray& ray : rays) {
        const auto hit = geometry.intersect(ray);
        if (!hit) continue;
        const Vec3 n = dot(hit->ng, ray.d) < 0 ? hit->ng : -hit->ng;
        const Vec3 d = normalize(n + 0.999 * direction(state));
        result.push_back({leave_surface(*hit, d), d});
    }
    return result;
}

double seconds(const std::function<double(std::size_t, std::size_t)>& work, std::size_t first,
               std::size_t last) {
    static volatile double sink = 0;  // keeps the work from being left out
    const auto start = std::chrono::steady_clock::now();
    sink = sink + work(first, last);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// By turns over short stretches of the rays, of which the best time counts each: what else runs
/// on the machine disturbs few of them.
void report(const std::string& name, std::size_t rays, int rounds,
            const std::function<double(std::size_t, std::size_t)>& bare,
            const std::function<double(std::size_t, std::size_t)>& ours) {
    constexpr std::size_t kStretch = 4096;
    double sum_bare = 0;
    double sum_ours = 0;
    for (std::size_t first = 0; first < rays; first += kStretch) {
        const std::size_t last = std::min(rays, first + kStretch);
        double best_bare = 1e9;
        double best_ours = 1e9;
        for (int i = 0; i < rounds; ++i) {
            best_bare = std::min(best_bare, seconds(bare, first, last));
            best_ours = std::min(best_ours, seconds(ours, first, last));
        }
        sum_bare += best_bare;
        sum_ours += best_ours;
    }
    const auto n = static_cast<double>(rays) / 1e6;
    std::printf("%-28s %9.2f %9.2f %8.2f %8.1f\n", name.c_str(), n / sum_bare, n / sum_ours,
                sum_ours / sum_bare, (sum_ours - sum_bare) / n * 1e3);
}

void measure(const std::string& name, const std::vector<PlacedShape>& shapes, Vec3 eye,
             int rounds) {
    const auto geometry = Geometry::build(shapes);
    if (!geometry) std::exit(1);
    const Geometry& g = **geometry;
    const BareEmbree bare(shapes, g.origin());
    const auto seen = primary_rays(eye - g.origin(), {-0.5, 0.5, -1}, {1, 0, 0}, {0, -1, 0});
    for (const bool is_primary : {true, false}) {
        const std::vector<Ray> rays = is_primary ? seen : bounced(g, seen);
        std::vector<RTCRayHit> bare_rays;
        for (const Ray& ray : rays) bare_rays.push_back(bare_ray(ray));
        report(
            name + (is_primary ? ", primary" : ", bounced"), rays.size(), rounds,
            [&](std::size_t first, std::size_t last) {
                double sum = 0;
                for (std::size_t i = first; i < last; ++i)
                    sum += bare.intersect(bare_rays[i]).hit.Ng_x;
                return sum;
            },
            [&](std::size_t first, std::size_t last) {
                double sum = 0;
                for (std::size_t i = first; i < last; ++i) {
                    if (const auto hit = g.intersect(rays[i])) sum += hit->t + hit->ng.x;
                }
                return sum;
            });
        if (is_primary) continue;
        report(
            name + ", shadow", rays.size(), rounds,
            [&](std::size_t first, std::size_t last) {
                double sum = 0;
                for (std::size_t i = first; i < last; ++i)
                    sum += bare.occluded(bare_rays[i].ray) ? 1 : 0;
                return sum;
            },
            [&](std::size_t first, std::size_t last) {
                double sum = 0;
                for (std::size_t i = first; i < last; ++i)
                    sum += g.occluded(rays[i], kInfinity) ? 1 : 0;
                return sum;
            });
    }
}

Transform box(Vec3 middle, Vec3 half) {
    return Transform::translate(middle) * Transform::scale(half);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 10;
    std::printf("%-28s %9s %9s %8s %8s\n", "million rays/s", "Embree", "Geometry", "ratio",
                "ns more");
    const auto cube = test::cube();
    const std::vector<PlacedShape> room{
        {cube,
         {box({0, 1, 0}, {2, 1, 2}), box({-1, 0.4, -1}, {0.3, 0.4, 0.3}),
          box({0.7, 0.6, -0.5}, {0.3, 0.6, 0.3})}}};
    measure("room, 36 triangles", room, {0, 1, 1.8}, rounds);
    measure("torus, 70 thousand",
            {{test::torus(1, 0.4, 350, 100)}, {cube, {box({0, -2, 0}, {9, 1, 9})}}}, {0, 0.5, 3},
            rounds);
    measure("torus, 1 million",
            {{test::torus(1, 0.4, 1000, 500)}, {cube, {box({0, -2, 0}, {9, 1, 9})}}}, {0, 0.5, 3},
            rounds);
}
