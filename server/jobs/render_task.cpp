// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/render_task.h"

#include <algorithm>

#include "api/digest.h"
#include "renderer/film/unit_result.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

/// Least time between two progress events and between two previews of a job.
constexpr auto kEventInterval = 250ms;
/// A unit is left after so long, so that a worker gives way to other jobs.
constexpr auto kTurn = 100ms;
/// A preview may take this share of one thread's time.
constexpr int kPreviewShare = 4;

tl::unexpected<Error> not_finished() {
    return bouguer::fail(ErrorKind::Conflict, "there is nothing of this job yet",
                         "job-not-finished");
}

/// Does not throw, not even when there is no memory for the text.
std::string no_results_because(const char* what) noexcept {
    try {
        return std::string("the results could not be made: ") + what;
    } catch (...) {
        return "out of memory";  // short enough to need none
    }
}

}  // namespace

/// Counts a step as under way until it ends, however it ends.
class RenderTask::StepGuard {
  public:
    explicit StepGuard(RenderTask& task) : task_(task) {}
    ~StepGuard() {
        const std::lock_guard lock(task_.mutex_);
        --task_.steps_under_way_;
    }
    StepGuard(const StepGuard&) = delete;
    StepGuard& operator=(const StepGuard&) = delete;

  private:
    RenderTask& task_;
};

RenderTask::RenderTask(JobId id, int priority, std::uint64_t memory_bytes, Prepare prepare,
                       RenderListener& listener, bool runs_alone)
    : id_(std::move(id)),
      priority_(priority),
      memory_bytes_(memory_bytes),
      prepare_(std::move(prepare)),
      listener_(listener),
      runs_alone_(runs_alone) {}

bool RenderTask::is_over_locked() const {
    return is_given_up_locked() || is_complete_ ||
           (phase_ == Phase::Rendering && Clock::now() >= deadline_);
}

Urgency RenderTask::urgency() const {
    const std::lock_guard lock(mutex_);
    switch (phase_) {
        case Phase::Waiting:
        case Phase::Preparing:
            return Urgency::FirstPass;
        case Phase::Rendering:
        case Phase::EndingPass:
            if (is_over_locked()) return Urgency::Finish;
            return shown_->picture ? Urgency::LaterPass : Urgency::FirstPass;
        case Phase::Finishing:
        case Phase::Ended:
            break;
    }
    return Urgency::Finish;
}

std::optional<Task::Step> RenderTask::next_step() {
    const std::lock_guard lock(mutex_);
    std::optional<Step> step;
    if (phase_ == Phase::Waiting) {
        phase_ = Phase::Preparing;
        step = [this] { prepare(); };
    } else if (phase_ == Phase::Rendering && !is_over_locked()) {
        try {
            step = take_unit_locked();
        } catch (const std::bad_alloc&) {
            failure_ = "out of memory";  // short enough to need none
        }
    }
    if (!step && phase_ < Phase::Finishing && is_over_locked() && steps_under_way_ == 0) {
        leave_rendering_locked(Phase::Finishing);
        step = [this] { finish(); };
    }
    if (step) ++steps_under_way_;
    return step;
}

std::optional<Task::Step> RenderTask::take_unit_locked() {
    std::shared_ptr<renderer::UnitResult> unit = prepared_.render->next_unit();
    if (unit == nullptr) return std::nullopt;
    Step step = [this, unit = std::move(unit)] { trace(unit); };
    ++units_under_way_;
    return step;
}

bool RenderTask::ended() const {
    const std::lock_guard lock(mutex_);
    return phase_ == Phase::Ended && steps_under_way_ == 0;
}

void RenderTask::fail(std::string reason) noexcept {
    const std::lock_guard lock(mutex_);
    // The next step that is asked for is the one that finishes.
    if (failure_.empty()) failure_ = std::move(reason);
}

bool RenderTask::cancel() {
    const std::lock_guard lock(mutex_);
    is_cancelled_ = true;
    give_up_ = true;
    if (phase_ != Phase::Waiting) return false;
    phase_ = Phase::Ended;
    return true;
}

void RenderTask::leave_rendering_locked(Phase next) {
    if (phase_ == Phase::Rendering) progress_ = progress_locked();
    phase_ = next;
}

void RenderTask::prepare() {
    const StepGuard guard(*this);
    if (!listener_.begin(id_)) {
        const std::lock_guard lock(mutex_);
        phase_ = Phase::Ended;
        return;
    }
    Result<PreparedRender> prepared = prepare_();
    if (prepared) return begin_rendering(std::move(*prepared));
    const std::lock_guard lock(mutex_);
    failure_ = prepared.error().message;
    failure_code_ = prepared.error().code;
}

void RenderTask::begin_rendering(PreparedRender prepared) {
    prepared_ = std::move(prepared);
    render_began_ = Clock::now();
    if (const auto seconds = prepared_.render->deadline_s()) {
        deadline_ = render_began_ + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(*seconds));
    }
    auto shown = look();
    const std::lock_guard lock(mutex_);
    shown_ = std::move(shown);
    phase_ = Phase::Rendering;
}

/// By whoever has the render to itself.
std::shared_ptr<const RenderTask::Shown> RenderTask::look() const {
    auto shown =
        std::make_shared<Shown>(Shown{prepared_.render->picture(), prepared_.render->report(),
                                      prepared_.output, prepared_.digests});
    shown->report.timings.scene_s = prepared_.scene_seconds;
    shown->report.timings.render_s = seconds();
    shown->report.bias.spectra = prepared_.notes;
    shown->report.warnings = prepared_.warnings;
    shown->report.warnings.add(renderer::warnings_of(shown->report));
    return shown;
}

void RenderTask::trace(const std::shared_ptr<renderer::UnitResult>& unit) {
    const StepGuard guard(*this);
    // The render stays as long as a step is under way.
    prepared_.render->trace(*unit, {Clock::now() + kTurn, deadline_, &give_up_});
    std::optional<JobProgress> progress;
    bool is_last = false;
    {
        const std::lock_guard lock(mutex_);
        --units_under_way_;
        if (is_given_up_locked()) return;
        if (!unit->is_complete()) {
            prepared_.render->give_back(unit);
        } else if (units_under_way_ == 0 && !prepared_.render->has_units()) {
            is_last = true;
            leave_rendering_locked(Phase::EndingPass);
        } else {
            (void)prepared_.render->merge(*unit, seconds());
        }
        if (!is_last) progress = progress_event_locked(Clock::now());
    }
    if (is_last) return end_pass(*unit);
    if (progress) listener_.progress(id_, *progress);
}

void RenderTask::end_pass(const renderer::UnitResult& last) {
    (void)prepared_.render->merge(last, seconds());
    std::shared_ptr<const Shown> shown = look();
    std::optional<JobProgress> progress;
    bool makes_preview = false;
    {
        const std::lock_guard lock(mutex_);
        shown_ = shown;
        if (const auto& curve = shown->report.error; !curve.empty()) {
            progress_.rmse = curve.back().rmse;
            progress_.relative_rmse = curve.back().relative_rmse;
        }
        is_complete_ = prepared_.render->finished();
        phase_ = Phase::Rendering;
        const auto now = Clock::now();
        progress = progress_event_locked(now);
        // The last pass needs no preview: the finished picture follows at once.
        if (!is_complete_ && is_preview_due_locked(now)) {
            last_preview_ = now;
            makes_preview = is_making_preview_ = true;
        }
    }
    if (progress) listener_.progress(id_, *progress);
    if (makes_preview) make_preview(*shown);
}

void RenderTask::make_preview(const Shown& shown) {
    const auto begin = Clock::now();
    renderer::ImageInfo info;
    auto png = renderer::encode_png(*shown.picture, shown.output, &info);
    JobProgress progress;
    {
        const std::lock_guard lock(mutex_);
        is_making_preview_ = false;
        preview_cost_ = Clock::now() - begin;
        if (!png) return;  // the finished picture will fail too, and say why
        has_preview_ = true;
        png_ = Content(std::move(*png));
        png_info_ = info;
        progress = progress_locked();
    }
    listener_.preview(id_, progress);
}

void RenderTask::finish() {
    const StepGuard guard(*this);
    listener_.end(id_, outcome());
    {
        const std::lock_guard lock(mutex_);
        shown_.reset();
        png_ = {};
    }
    prepared_ = {};  // a large film takes its time: nobody waits for it
    const std::lock_guard lock(mutex_);
    phase_ = Phase::Ended;
}

RenderOutcome RenderTask::outcome() noexcept {
    RenderOutcome result;
    {
        const std::lock_guard lock(mutex_);
        result.progress = progress_;
        result.progress.seconds_left.reset();
    }
    try {
        return outcome_of_render();
    } catch (const std::exception& e) {
        result.failure = no_results_because(e.what());
    } catch (...) {
        result.failure = no_results_because("internal error");
    }
    return result;
}

RenderOutcome RenderTask::outcome_of_render() {
    RenderOutcome result;
    {
        const std::lock_guard lock(mutex_);
        result.progress = progress_;
        result.progress.seconds_left.reset();
        result.failure = failure_;
        result.failure_code = failure_code_;
    }
    if (!result.failure.empty()) return result;
    const bool is_complete = complete_render();
    // Cancelled, but all that was asked for had been done by then: done.
    result.state = is_complete ? JobState::Done : JobState::Cancelled;
    if (prepared_.render == nullptr) return result;
    const std::shared_ptr<const Shown> shown = look();
    if (!shown->picture) return result;
    renderer::Report report = shown->report;
    if (!is_complete) report.stopped_by = "cancel";
    result.unfinished_pass = report.health.unfinished_pass;
    result.warnings = report.warnings;
    auto files = result_files(shown->picture.get(), report, shown->output, shown->digests);
    if (files) {
        result.files = std::move(*files);
    } else {
        result.state = JobState::Failed;
        result.failure = files.error().message;
    }
    return result;
}

/// Whether all that was asked for is done, or as much as the time allowed.
bool RenderTask::complete_render() {
    if (prepared_.render == nullptr) return false;
    {
        const std::lock_guard lock(mutex_);
        if (is_complete_) return true;
        if (is_cancelled_) return false;
    }
    prepared_.render->end_late();
    return true;
}

double RenderTask::seconds() const {
    return std::chrono::duration<double>(Clock::now() - render_began_).count();
}

JobProgress RenderTask::progress_locked() const {
    JobProgress progress = progress_;
    if (phase_ != Phase::Rendering) return progress;
    const renderer::Render& render = *prepared_.render;
    progress.seconds = seconds();
    progress.fraction = std::clamp(render.progress(progress.seconds), 0.0, 1.0);
    progress.samples = render.samples_done();
    progress.pass = render.current_pass();
    progress.rays = render.rays();
    progress.seconds_left.reset();
    if (progress.fraction > 0) {
        progress.seconds_left = progress.seconds * (1 - progress.fraction) / progress.fraction;
    }
    return progress;
}

/// What is to be told now, if something is.
std::optional<JobProgress> RenderTask::progress_event_locked(Clock::time_point now) {
    if (now - last_progress_event_ < kEventInterval) return std::nullopt;
    last_progress_event_ = now;
    return progress_locked();
}

bool RenderTask::is_preview_due_locked(Clock::time_point now) const {
    if (is_making_preview_) return false;
    if (!has_preview_) return true;
    return now - last_preview_ >=
           std::max<Clock::duration>(kEventInterval, preview_cost_ * kPreviewShare);
}

JobProgress RenderTask::progress() const {
    const std::lock_guard lock(mutex_);
    return progress_locked();
}

std::vector<std::string> RenderTask::images() const {
    const std::lock_guard lock(mutex_);
    if (!has_preview_) return {};
    return {"image.png", "image.exr"};
}

Result<std::string> RenderTask::made_anew(const std::string& name, const Shown& shown,
                                          const renderer::ImageInfo& png_info) {
    if (is_image(name)) return renderer::encode_exr(*shown.picture, shown.output);
    renderer::Report report = shown.report;
    report.image = png_info;
    return report_file(name, report, shown.output, shown.digests).value_or("");
}

Result<ResultFile> RenderTask::file(const std::string& name) const {
    const std::string media_type(media_type_of(name));
    if (media_type.empty()) return bouguer::fail(ErrorKind::NotFound, "no such result");
    std::shared_ptr<const Shown> shown;
    renderer::ImageInfo png_info;
    Content content;
    {
        const std::lock_guard lock(mutex_);
        if (shown_ == nullptr || (is_image(name) && !has_preview_)) return not_finished();
        shown = shown_;
        png_info = png_info_;
        content = png_;
    }
    std::string digest;
    if (name == "image.png") {
        digest = api::sha256_hex(content.all().value());  // it is in memory
    } else {
        auto bytes = made_anew(name, *shown, png_info);
        if (!bytes) return tl::unexpected(bytes.error());
        digest = api::sha256_hex(*bytes);
        content = std::move(*bytes);
    }
    return ResultFile{std::move(content), media_type, std::move(digest), false};
}

}  // namespace bouguer::server
