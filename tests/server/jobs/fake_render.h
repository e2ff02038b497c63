// SPDX-License-Identifier: Apache-2.0
// A render of counted units, without rays: what a task does is seen without waiting for pictures.
#pragma once

#include <deque>
#include <functional>

#include "renderer/film/unit_result.h"
#include "renderer/render.h"

namespace bouguer::server {

/// `passes` of `units` one-pixel units each. `on_trace` runs inside trace(), `on_pass` inside the
/// merge() that ends a pass; both may block or throw.
class FakeRender final : public renderer::Render {
  public:
    using OnTrace = std::function<void(const renderer::Unit&)>;

    FakeRender(std::uint32_t passes, int units, OnTrace on_trace = {},
               std::function<void()> on_pass = {})
        : passes_(passes),
          units_(units),
          on_trace_(std::move(on_trace)),
          on_pass_(std::move(on_pass)) {
        begin_pass();
    }

    std::shared_ptr<renderer::UnitResult> next_unit() override {
        if (waiting_.empty()) return nullptr;
        auto unit = std::move(waiting_.front());
        waiting_.pop_front();
        return unit;
    }
    void trace(renderer::UnitResult& unit, const renderer::TraceLimits& limits) const override {
        if (on_trace_) on_trace_(unit.unit());
        if (limits.give_up != nullptr && *limits.give_up) return;
        if (renderer::TraceLimits::Clock::now() >= limits.give_up_at) return;
        unit.cursor = unit.num_samples();
    }
    bool merge(const renderer::UnitResult&, double seconds) override {
        if (--unmerged_ > 0) return false;
        if (on_pass_) on_pass_();
        ++pass_;
        renderer::ErrorPoint point;
        point.seconds = seconds;
        point.samples = pass_;
        point.relative_rmse = renderer::Estimate{1.0 / pass_, 0.5 / pass_, 2.0 / pass_};
        curve_.push_back(point);
        if (!finished()) begin_pass();
        return true;
    }
    void give_back(std::shared_ptr<renderer::UnitResult> unit) override {
        waiting_.push_front(std::move(unit));
    }
    std::optional<double> deadline_s() const override { return deadline; }
    void end_late() override { is_late_ = true; }
    bool finished() const override { return is_late_ || pass_ == passes_; }
    std::uint32_t current_pass() const override { return pass_; }
    bool has_units() const override { return !waiting_.empty(); }
    double progress(double) const override { return static_cast<double>(pass_) / passes_; }
    std::uint32_t samples_done() const override { return pass_; }
    std::uint64_t rays() const override { return 10UL * pass_; }
    renderer::Report report() const override {
        renderer::Report report;
        report.error = curve_;
        if (finished()) report.stopped_by = is_late_ ? "seconds" : "samples";
        if (is_late_ && pass_ == 0) report.health.unfinished_pass = renderer::UnfinishedPass{1, 1};
        return report;
    }
    std::shared_ptr<const renderer::Picture> picture() const override {
        if (pass_ == 0 && !is_late_) return nullptr;
        return std::make_shared<renderer::Picture>(
            renderer::Picture{1, 1, {0.1F * static_cast<float>(pass_), 0.1F, 0.1F}});
    }

    std::optional<double> deadline;  ///< set before it is used

  private:
    void begin_pass() {
        for (int i = 0; i < units_; ++i) {
            waiting_.push_back(std::make_shared<renderer::UnitResult>(
                renderer::Unit{pass_, i, 0, 1, 1, pass_, 1}, 2));
        }
        unmerged_ = units_;
    }

    const std::uint32_t passes_;
    const int units_;
    const OnTrace on_trace_;
    const std::function<void()> on_pass_;
    std::deque<std::shared_ptr<renderer::UnitResult>> waiting_;
    bool is_late_ = false;
    int unmerged_ = 0;
    std::uint32_t pass_ = 0;
    std::vector<renderer::ErrorPoint> curve_;
};

}  // namespace bouguer::server
