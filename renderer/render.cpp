// SPDX-License-Identifier: Apache-2.0
#include "renderer/render.h"

#include <algorithm>
#include <deque>
#include <new>

#include "renderer/cameras/camera.h"
#include "renderer/core/out_of_memory.h"
#include "renderer/film/error_estimate.h"
#include "renderer/film/film.h"
#include "renderer/film/image_library.h"
#include "renderer/geometry/embree_version.h"
#include "renderer/integrators/integrator_registry.h"
#include "renderer/pass_plan.h"
#include "renderer/plan/plan.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

/// When nothing else ends a render, this number of samples a pixel does.
constexpr std::uint32_t kMaxSamples = 1U << 20U;
/// Dimension of the place in the pixel; the integrators' numbers start above.
constexpr std::uint64_t kDimensionFilm = 0;

Crop area_of(const RenderSettings& settings) {
    return settings.crop.value_or(
        Crop{0, 0, settings.resolution.width, settings.resolution.height});
}

class ProgressiveRender final : public Render {
  public:
    ProgressiveRender(std::shared_ptr<const Scene> scene, Camera camera,
                      const RenderSettings& settings, const StopRule& stop)
        : scene_(std::move(scene)),
          camera_(camera),
          settings_(settings),
          stop_(stop),
          integrator_(
              integrator_entry(settings.integrator).make(*scene_, analyse(*scene_), settings)),
          film_(area_of(settings), static_cast<std::uint32_t>(settings.replicates)) {
        report_.plan = make_plan(*scene_, settings);
        report_.health.dropped_triangles = scene_->dropped_triangles();
        if (settings.integrator == IntegratorType::Hall) {
            report_.bias.wavelength_relative =
                quadrature_error(*scene_, settings.wavelength_step_nm, observer_of(settings));
        }
        begin_pass(0);
    }

    std::optional<Unit> next_unit() override {
        if (waiting_.empty()) return std::nullopt;
        const Unit unit = waiting_.front();
        waiting_.pop_front();
        return unit;
    }

    std::unique_ptr<UnitResult> trace(const Unit& unit,
                                      const std::atomic<bool>* give_up) const override {
        auto result = std::make_unique<UnitResult>(unit, film_.replicates());
        const auto scratch = integrator_->make_scratch();
        scratch->give_up = give_up;
        for (int y = unit.y; y < unit.y + unit.height; ++y) {
            for (int x = unit.x; x < unit.x + unit.width; ++x) {
                for (std::uint32_t s = 0; s < unit.num_samples; ++s) {
                    const std::uint32_t sample = unit.first_sample + s;
                    const PixelSampler sampler(settings_.seed, x, y, sample, film_.replicates());
                    const Vec2 offset =
                        sample_filter(settings_.filter, sampler.get_2d(kDimensionFilm));
                    const Ray ray = camera_.generate({x + 0.5 + offset.x, y + 0.5 + offset.y});
                    const Xyz value = integrator_->trace(ray, sampler, *scratch, result->counters);
                    if (scratch->has_given_up()) return nullptr;
                    result->add_sample(x, y, sample, value);
                }
            }
        }
        return result;
    }

    bool merge(std::unique_ptr<UnitResult> result, double seconds) override {
        film_.merge(*result);
        book(*result);
        if (--unmerged_ > 0) return false;
        end_pass(seconds);
        return true;
    }

    void give_back(const Unit& unit) override { waiting_.push_front(unit); }

    bool finished() const override { return !report_.stopped_by.empty(); }
    std::uint32_t current_pass() const override { return pass_; }
    bool has_units() const override { return !waiting_.empty(); }
    std::uint32_t samples_done() const override { return samples_done_; }
    std::uint64_t rays() const override { return counters_.rays; }

    double progress(double seconds) const override {
        if (finished()) return 1;
        const double in_pass =
            1 - static_cast<double>(unmerged_) / static_cast<double>(units_in_pass_);
        double share = (samples_done_ + in_pass * samples_in_pass_) / sample_limit();
        if (stop_.seconds)
            share = std::max(share, *stop_.seconds > 0 ? seconds / *stop_.seconds : 1);
        if (stop_.error && !report_.error.empty() && report_.error.back().relative_rmse) {
            // Noise falls with the root of the samples.
            const double ratio = *stop_.error / report_.error.back().relative_rmse->high;
            share = std::max(share, ratio * ratio);
        }
        return std::min(share, 1.0);
    }

    Report report() const override {
        Report report = report_;
        const double samples = std::max<double>(1, static_cast<double>(report.health.samples));
        report.bias.depth_limit_throughput = counters_.depth_throughput / samples;
        report.bias.threshold_throughput = counters_.threshold_throughput / samples;
        report.health.rays_cut_by_depth = counters_.rays_cut_by_depth;
        report.health.rays_cut_by_threshold = counters_.rays_cut_by_threshold;
        report.health.unmatched_exits = counters_.unmatched_exits;
        report.health.medium_stack_overflows = counters_.medium_stack_overflows;
        report.health.shadow_rays_cut = counters_.shadow_rays_cut;
        report.health.total_reflections = counters_.total_reflections;
        return report;
    }

    std::optional<Picture> picture() const override {
        if (samples_done_ == 0) return std::nullopt;
        return newest_;
    }

  private:
    [[nodiscard]] std::uint32_t sample_limit() const { return stop_.samples.value_or(kMaxSamples); }

    void begin_pass(double seconds) {
        samples_in_pass_ = std::min(pass_samples(samples_done_), sample_limit() - samples_done_);
        if (stop_.seconds && samples_done_ > 0) {
            // Not more than fits into the time that is left, at the speed so far.
            const double fitting =
                (*stop_.seconds - seconds) * samples_done_ / std::max(seconds, 1e-9);
            samples_in_pass_ =
                static_cast<std::uint32_t>(std::clamp<double>(fitting, 1, samples_in_pass_));
        }
        const auto units = units_of_pass(film_.area(), pass_, samples_done_, samples_in_pass_);
        waiting_.assign(units.begin(), units.end());
        unmerged_ = units_in_pass_ = units.size();
    }

    void end_pass(double seconds) {
        samples_done_ += samples_in_pass_;
        samples_in_pass_ = 0;
        newest_ = {film_.area().width, film_.area().height, film_.mean_xyz()};
        ErrorPoint point{seconds, samples_done_, counters_.rays, {}, {}, false};
        if (const auto estimate = estimate_error(film_)) {
            point.rmse = estimate->rmse;
            point.relative_rmse = estimate->relative_rmse;
            point.few_events = estimate->few_events;
        }
        report_.error.push_back(point);
        report_.stopped_by = stop_reason(point);
        if (finished()) return;
        ++pass_;
        begin_pass(seconds);
    }

    [[nodiscard]] std::string stop_reason(const ErrorPoint& point) const {
        if (samples_done_ >= sample_limit()) return "samples";
        if (stop_.error && point.relative_rmse && !point.few_events &&
            point.relative_rmse->high <= *stop_.error) {
            return "error";
        }
        if (stop_.seconds && point.seconds >= *stop_.seconds) return "seconds";
        return {};
    }

    void book(const UnitResult& result) {
        counters_ += result.counters;
        Health& total = report_.health;
        const Health& more = result.health();
        total.samples += more.samples;
        total.rejected_nan += more.rejected_nan;
        total.rejected_infinite += more.rejected_infinite;
        total.rejected_negative += more.rejected_negative;
        for (const RejectedSample& r : more.rejected) {
            if (total.rejected.size() < UnitResult::kMaxRejectedKept) total.rejected.push_back(r);
        }
    }

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    RenderSettings settings_;
    StopRule stop_;
    std::unique_ptr<Integrator> integrator_;
    Film film_;
    Picture newest_;
    Report report_;  ///< all but what counters_ holds
    TraceCounters counters_;
    std::deque<Unit> waiting_;
    std::size_t units_in_pass_ = 0, unmerged_ = 0;
    std::uint32_t pass_ = 0, samples_done_ = 0, samples_in_pass_ = 0;
};

}  // namespace

Result<std::unique_ptr<Render>> Render::create(std::shared_ptr<const Scene> scene,
                                               const RenderSettings& settings,
                                               const StopRule& stop) {
    auto camera = Camera::create(scene->camera(), settings.resolution, scene->geometry().origin());
    if (!camera) return tl::unexpected(camera.error());
    try {
        return std::make_unique<ProgressiveRender>(std::move(scene), *camera, settings, stop);
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

std::vector<std::string> library_versions() { return {embree_version(), image_library_version()}; }

}  // namespace bouguer::renderer
