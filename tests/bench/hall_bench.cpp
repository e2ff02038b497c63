// SPDX-License-Identifier: Apache-2.0
// How much of Embree's own speed a render reaches: renders a scene, then traces the very same rays
// with nothing but Embree, in turns within one run, and prints the share.
//
//     hall_bench SCENE.json [SAMPLES] [THREADS] [OUT.png]

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <thread>
#include <vector>

#include "renderer/geometry/embree_geometry.h"
#include "renderer/integrators/integrator_registry.h"
#include "renderer/scene/scene.h"
#include "tests/support/parallel_render.h"
#include "tests/support/scene_files.h"

namespace {

using namespace bouguer;
using namespace bouguer::renderer;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

struct RecordedRay {
    Ray ray;
    Real t_max;
    bool is_shadow;
};

/// Passes rays on and writes down those of the thread that asked for it.
class RecordingGeometry final : public Geometry {
  public:
    explicit RecordingGeometry(std::unique_ptr<const Geometry> inner) : inner_(std::move(inner)) {}
    bool nearest(const Ray& ray, Real t_max, Hit& hit) const override {
        if (record != nullptr) record->push_back({ray, t_max, false});
        return inner_->nearest(ray, t_max, hit);
    }
    bool occluded(const Ray& ray, Real t_max) const override {
        if (record != nullptr) record->push_back({ray, t_max, true});
        return inner_->occluded(ray, t_max);
    }
    void crossings(const Ray& ray, Real from, Real to, std::vector<Hit>& hits) const override {
        inner_->crossings(ray, from, to, hits);
    }
    Real reach(const Hit& hit) const override { return inner_->reach(hit); }
    bool contains(std::uint32_t object, std::uint32_t instance, Vec3 p) const override {
        return inner_->contains(object, instance, p);
    }
    bool touches(std::uint32_t object, std::uint32_t instance, Vec3 p, Real reach) const override {
        return inner_->touches(object, instance, p, reach);
    }
    bool is_thin(std::uint32_t object, std::uint32_t instance) const override {
        return inner_->is_thin(object, instance);
    }
    Bounds bounds(std::uint32_t object, std::uint32_t instance) const override {
        return inner_->bounds(object, instance);
    }
    Vec2 surface_uv(const Hit& hit) const override { return inner_->surface_uv(hit); }
    Vec3 smooth_point(const Hit& hit) const override { return inner_->smooth_point(hit); }
    Vec3 origin() const override { return inner_->origin(); }
    Real radius() const override { return inner_->radius(); }
    std::uint64_t num_triangles() const override { return inner_->num_triangles(); }
    std::uint64_t memory_bytes() const override { return inner_->memory_bytes(); }
    const Geometry& inner() const { return *inner_; }

    static thread_local std::vector<RecordedRay>* record;

  private:
    std::unique_ptr<const Geometry> inner_;
};
thread_local std::vector<RecordedRay>* RecordingGeometry::record = nullptr;

/// One pass over all units of a render; returns the time and adds to `rays`.
template <class Work>
double on_threads(int threads, Work work) {
    const auto start = Clock::now();
    std::vector<std::thread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back([&work, i] { work(i); });
    for (std::thread& t : pool) t.join();
    return seconds_since(start);
}

/// What Embree does with a ray when nobody refines, shades or books: the bare query.
void bare(const GeometryData& data, const RecordedRay& r) {
    GeometryQuery query(data, r.ray);
    RTCRayHit record{};
    record.ray.org_x = static_cast<float>(r.ray.o.x * data.scale);
    record.ray.org_y = static_cast<float>(r.ray.o.y * data.scale);
    record.ray.org_z = static_cast<float>(r.ray.o.z * data.scale);
    record.ray.dir_x = static_cast<float>(r.ray.d.x);
    record.ray.dir_y = static_cast<float>(r.ray.d.y);
    record.ray.dir_z = static_cast<float>(r.ray.d.z);
    record.ray.mask = ~0U;
    record.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    record.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    record.ray.tfar = static_cast<float>(r.t_max * data.scale);
    if (r.is_shadow) {
        query.t_max = r.t_max;
        query.scale = data.scale;
        embree_occluded(data.scene.get(), record.ray, query);
    } else {
        embree_intersect(data.scene.get(), record, query);
    }
}

void ours(const Geometry& geometry, const RecordedRay& r) {
    if (r.is_shadow) {
        static_cast<void>(geometry.occluded(r.ray, r.t_max));
    } else {
        Hit hit;
        static_cast<void>(geometry.nearest(r.ray, r.t_max, hit));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: hall_bench SCENE.json [SAMPLES] [THREADS] [OUT.png]\n");
        return 2;
    }
    auto job = bouguer::test::load_job(argv[1]);
    const auto samples = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 16);
    const int threads = argc > 3 ? std::atoi(argv[3]) : 2;
    const auto scene =
        Scene::build(job.scene,
                     [](std::unique_ptr<const Geometry> inner) -> std::unique_ptr<const Geometry> {
                         return std::make_unique<RecordingGeometry>(std::move(inner));
                     })
            .value();
    StopRule stop;
    stop.samples = samples;

    // The rays of every seventh unit of the first pass.
    std::vector<RecordedRay> rays;
    {
        auto render = Render::create(scene, job.settings, stop).value();
        RecordingGeometry::record = &rays;
        int i = 0;
        while (auto unit = render->next_unit()) {
            if (i++ % 7 == 0) render->trace(*unit);
            if (render->current_pass() > 0) break;
        }
        RecordingGeometry::record = nullptr;
    }
    const auto& geometry = dynamic_cast<const EmbreeGeometry&>(
        dynamic_cast<const RecordingGeometry&>(scene->geometry()).inner());

    double best_share = 0;
    for (int round = 0; round < 3; ++round) {
        auto render = Render::create(scene, job.settings, stop).value();
        const double render_s = bouguer::test::run_to_end(*render, threads);
        const double render_rate = static_cast<double>(render->rays()) / render_s;
        const auto replay = [&](auto trace) {
            const double s = on_threads(threads, [&](int t) {
                for (std::size_t i = static_cast<std::size_t>(t); i < rays.size();
                     i += static_cast<std::size_t>(threads))
                    trace(rays[i]);
            });
            return static_cast<double>(rays.size()) / s;
        };
        const double bare_rate = replay([&](const RecordedRay& r) { bare(geometry.data(), r); });
        const double ours_rate = replay([&](const RecordedRay& r) { ours(geometry, r); });
        best_share = std::max(best_share, render_rate / bare_rate);
        std::printf(
            "render %.2f s, %.2f million rays, %.2f million rays/s; Embree alone %.2f; Geometry "
            "%.2f; share of Embree %.1f %%\n",
            render_s, static_cast<double>(render->rays()) * 1e-6, render_rate * 1e-6,
            bare_rate * 1e-6, ours_rate * 1e-6, 100 * render_rate / bare_rate);
        if (argc > 4 && round == 0) {
            const std::string png = encode_png(*render->picture(), job.output).value();
            std::ofstream(argv[4], std::ios::binary) << png;
            const Report report = render->report();
            std::printf(
                "kernel %s, %zu values a path, %zu recorded rays, depth cut %.2g, threshold cut "
                "%.2g, relative rmse %.3g\n",
                report.plan.kernel.c_str(), report.plan.values_per_path, rays.size(),
                report.bias.depth_limit_throughput, report.bias.threshold_throughput,
                report.error.back().relative_rmse ? report.error.back().relative_rmse->value : -1);
        }
    }
    return 0;
}
