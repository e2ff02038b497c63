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
/// A pass may end so much later than the time that is allowed.
constexpr double kGrace_s = 0.5;
/// A pass is planned to take this share of the time that is left.
constexpr double kShareOfTimeLeft = 0.9;
/// Dimension of the place in the pixel; the integrators' numbers start above.
constexpr std::uint64_t kDimensionFilm = 0;

Crop area_of(const RenderSettings& settings) {
    return settings.crop.value_or(
        Crop{0, 0, settings.resolution.width, settings.resolution.height});
}

/// Goes through the samples of a unit from its cursor on: all of a pixel, then the next pixel of
/// the row, then the next row.
struct NextSample {
    explicit NextSample(const UnitResult& result) : unit(result.unit()) {
        const std::size_t pixel = result.cursor / unit.num_samples;
        const auto width = static_cast<std::size_t>(unit.width);
        x = unit.x + static_cast<int>(pixel % width);
        y = unit.y + static_cast<int>(pixel / width);
        sample = unit.first_sample + static_cast<std::uint32_t>(result.cursor % unit.num_samples);
    }

    void advance() {
        if (++sample < unit.first_sample + unit.num_samples) return;
        sample = unit.first_sample;
        if (++x < unit.x + unit.width) return;
        x = unit.x;
        ++y;
    }

    const Unit unit;
    int x = 0, y = 0;
    std::uint32_t sample = 0;
};

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

    std::shared_ptr<UnitResult> next_unit() override {
        std::shared_ptr<UnitResult> unit;
        if (!paused_.empty()) {
            unit = std::move(paused_.front());
            paused_.pop_front();
        } else if (!waiting_.empty()) {
            unit = std::make_shared<UnitResult>(waiting_.front(), film_.replicates());
            waiting_.pop_front();
        }
        return unit;
    }

    void trace(UnitResult& unit, const TraceLimits& limits) const override {
        const auto scratch = integrator_->make_scratch();
        scratch->limits = limits;
        for (NextSample next(unit); !unit.is_complete(); next.advance()) {
            if (!trace_sample(unit, next, *scratch)) return;
            if (scratch->is_to_pause()) return;
        }
    }

    bool merge(const UnitResult& unit, double seconds) override {
        film_.merge(unit);
        book(unit);
        if (--unmerged_ > 0) return false;
        end_pass(seconds);
        return true;
    }

    void give_back(std::shared_ptr<UnitResult> unit) override {
        rays_ += unit->counters.rays - unit->rays_told;
        unit->rays_told = unit->counters.rays;
        paused_.push_back(std::move(unit));
    }

    std::optional<double> deadline_s() const override {
        if (!time_allowed()) return std::nullopt;
        return *time_allowed() + kGrace_s;
    }

    void end_late() override {
        report_.stopped_by = is_limited_by_owner() ? "server-limit" : "seconds";
        if (samples_done_ > 0) return;
        for (const auto& unit : paused_) {
            film_.merge(*unit);
            book(*unit);
        }
        show_film();
        report_.health.unfinished_pass =
            UnfinishedPass{film_.num_pixels(), film_.num_pixels() - report_.health.samples};
        paused_.clear();
        waiting_.clear();
    }

    bool finished() const override { return !report_.stopped_by.empty(); }
    std::uint32_t current_pass() const override { return pass_; }
    bool has_units() const override { return !waiting_.empty() || !paused_.empty(); }
    std::uint32_t samples_done() const override { return samples_done_; }
    std::uint64_t rays() const override { return rays_; }

    double progress(double seconds) const override {
        if (finished()) return 1;
        const double in_pass =
            1 - static_cast<double>(unmerged_) / static_cast<double>(units_in_pass_);
        double share = (samples_done_ + in_pass * samples_in_pass_) / sample_limit();
        if (const auto allowed = time_allowed())
            share = std::max(share, *allowed > 0 ? seconds / *allowed : 1);
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
        if (counters_.light > 0) {
            report.bias.depth_limit_share = counters_.depth_light / counters_.light;
            report.bias.threshold_share = counters_.threshold_light / counters_.light;
        }
        report.health.blackened_samples = counters_.blackened_samples;
        for (const auto& [object, count] : counters_.lost_bodies) {
            report.health.unmatched_exits += count;
            report.health.unmatched_objects.push_back({scene_->object_names()[object], count});
        }
        report.health.medium_stack_overflows = counters_.medium_stack_overflows;
        report.health.shadow_rays_cut = counters_.shadow_rays_cut;
        report.health.total_reflections = counters_.total_reflections;
        return report;
    }

    std::shared_ptr<const Picture> picture() const override { return newest_; }

  private:
    [[nodiscard]] std::uint32_t sample_limit() const { return stop_.samples.value_or(kMaxSamples); }

    /// Seconds, the lesser of what the job asks for and what the owner allows.
    [[nodiscard]] std::optional<double> time_allowed() const {
        return is_limited_by_owner() ? stop_.limit_s : stop_.seconds;
    }
    [[nodiscard]] bool is_limited_by_owner() const {
        return stop_.limit_s && !(stop_.seconds && *stop_.seconds <= *stop_.limit_s);
    }

    /// False when it was given up; then it counts for nothing and will be traced again.
    [[nodiscard]] bool trace_sample(UnitResult& unit, const NextSample& next,
                                    TraceScratch& scratch) const {
        const PixelSampler sampler(settings_.seed, next.x, next.y, next.sample, film_.replicates());
        const Vec2 offset = sample_filter(settings_.filter, sampler.get_2d(kDimensionFilm));
        const Ray ray = camera_.generate({next.x + 0.5 + offset.x, next.y + 0.5 + offset.y});
        TraceCounters counters;
        const Xyz value = integrator_->trace(ray, sampler, scratch, counters);
        if (scratch.has_given_up()) return false;
        unit.counters += counters;
        unit.add_sample(next.x, next.y, next.sample, value);
        ++unit.cursor;
        return true;
    }

    void begin_pass(double seconds) {
        samples_in_pass_ = std::min(pass_samples(samples_done_), sample_limit() - samples_done_);
        if (const auto allowed = time_allowed(); allowed && samples_done_ > 0) {
            // Not more than fits into the time that is left, at the speed so far: a pass that is
            // late is lost.
            const double fitting =
                kShareOfTimeLeft * (*allowed - seconds) * samples_done_ / std::max(seconds, 1e-9);
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
        show_film();
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

    void show_film() {
        newest_ = std::make_shared<const Picture>(
            Picture{film_.area().width, film_.area().height, film_.mean_xyz()});
    }

    [[nodiscard]] std::string stop_reason(const ErrorPoint& point) const {
        if (samples_done_ >= sample_limit()) return "samples";
        if (stop_.error && point.relative_rmse && !point.few_events &&
            point.relative_rmse->high <= *stop_.error) {
            return "error";
        }
        const auto allowed = time_allowed();
        if (!allowed || point.seconds < *allowed) return {};
        return is_limited_by_owner() ? "server-limit" : "seconds";
    }

    void book(const UnitResult& result) {
        counters_ += result.counters;
        rays_ += result.counters.rays - result.rays_told;
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
    std::shared_ptr<const Picture> newest_;  ///< null before there is one
    Report report_;                          ///< all but what counters_ holds
    TraceCounters counters_;
    std::uint64_t rays_ = 0;  ///< with those of units given back
    std::deque<Unit> waiting_;
    std::deque<std::shared_ptr<UnitResult>> paused_;
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
