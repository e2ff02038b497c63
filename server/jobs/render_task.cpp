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
/// A preview may take this share of one thread's time.
constexpr int kPreviewShare = 4;

tl::unexpected<Error> not_finished() {
    return bouguer::fail(ErrorKind::Conflict, "there is nothing of this job yet",
                         "job-not-finished");
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
                       RenderListener& listener)
    : id_(std::move(id)),
      priority_(priority),
      memory_bytes_(memory_bytes),
      prepare_(std::move(prepare)),
      listener_(listener) {}

bool RenderTask::is_over_locked() const {
    return is_cancelled_ || !failure_.empty() ||
           (prepared_.render != nullptr && prepared_.render->finished());
}

Urgency RenderTask::urgency() const {
    if (is_ending_pass_) return Urgency::LaterPass;  // it has nothing to hand out anyway
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::Waiting || phase_ == Phase::Preparing) return Urgency::FirstPass;
    if (is_over_locked()) return Urgency::Finish;
    return prepared_.render->samples_done() == 0 ? Urgency::FirstPass : Urgency::LaterPass;
}

std::optional<Task::Step> RenderTask::next_step() {
    if (is_ending_pass_) return std::nullopt;
    const std::lock_guard lock(mutex_);
    std::optional<Step> step;
    if (phase_ == Phase::Waiting) {
        phase_ = Phase::Preparing;
        step = [this] { prepare(); };
    } else if (phase_ == Phase::Rendering && is_over_locked()) {
        if (steps_under_way_ == 0) {
            phase_ = Phase::Finishing;
            step = [this] { finish(); };
        }
    } else if (phase_ == Phase::Rendering) {
        if (const auto unit = prepared_.render->next_unit()) {
            ++units_under_way_;
            step = [this, unit = *unit] { trace(unit); };
        }
    }
    if (step) ++steps_under_way_;
    return step;
}

void RenderTask::fail(const std::string& reason) noexcept {
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = reason;
    // The next step that is asked for is the one that finishes.
    if (phase_ == Phase::Preparing) phase_ = Phase::Rendering;
}

bool RenderTask::cancel() {
    const std::lock_guard lock(mutex_);
    is_cancelled_ = true;
    give_up_ = true;
    if (phase_ != Phase::Waiting) return false;
    end_locked();
    return true;
}

void RenderTask::end_locked() {
    phase_ = Phase::Ended;
    is_ended_ = true;
}

void RenderTask::prepare() {
    const StepGuard guard(*this);
    if (!listener_.begin(id_)) {
        const std::lock_guard lock(mutex_);
        end_locked();
        return;
    }
    Result<PreparedRender> prepared = prepare_();
    const std::lock_guard lock(mutex_);
    if (prepared) {
        prepared_ = std::move(*prepared);
    } else {
        failure_ = prepared.error().message;
    }
    render_began_ = Clock::now();
    phase_ = Phase::Rendering;
}

void RenderTask::trace(const renderer::Unit& unit) {
    const StepGuard guard(*this);
    // The render is not let go of while a step is under way.
    std::unique_ptr<renderer::UnitResult> result = prepared_.render->trace(unit, &give_up_);
    std::optional<JobProgress> progress;
    std::optional<renderer::Picture> picture;
    {
        const std::lock_guard lock(mutex_);
        if (is_cancelled_ || !failure_.empty()) return;
        if (result == nullptr) {
            --units_under_way_;
            return prepared_.render->give_back(unit);
        }
        const bool pass_ended = merge_locked(std::move(result));
        const auto now = Clock::now();
        // The last pass needs no preview: the finished picture follows at once.
        if (pass_ended && !prepared_.render->finished() && is_preview_due_locked(now)) {
            last_preview_ = now;
            is_making_preview_ = true;
            picture = prepared_.render->picture();
        }
        if (now - last_progress_event_ >= kEventInterval) {
            last_progress_event_ = now;
            progress = progress_locked();
        }
    }
    if (progress) listener_.progress(id_, *progress);
    if (picture) make_preview(*picture);
}

bool RenderTask::merge_locked(std::unique_ptr<renderer::UnitResult> result) {
    struct Reset {
        std::atomic<bool>& flag;
        ~Reset() { flag = false; }
    } const reset{is_ending_pass_};
    is_ending_pass_ = --units_under_way_ == 0 && !prepared_.render->has_units();
    const bool pass_ended = prepared_.render->merge(std::move(result), seconds_locked());
    if (pass_ended) note_error_locked();
    return pass_ended;
}

void RenderTask::make_preview(const renderer::Picture& picture) {
    const auto begin = Clock::now();
    renderer::ImageInfo shown;
    auto png = renderer::encode_png(picture, prepared_.output, &shown);
    JobProgress progress;
    {
        const std::lock_guard lock(mutex_);
        is_making_preview_ = false;
        preview_cost_ = Clock::now() - begin;
        if (!png) return;  // the finished picture will fail too, and say why
        png_ = std::move(*png);
        shown_ = shown;
        progress = progress_locked();
    }
    listener_.preview(id_, progress);
}

void RenderTask::finish() {
    const StepGuard guard(*this);
    RenderOutcome result;
    try {
        result = outcome();
    } catch (const std::exception& e) {
        result.state = JobState::Failed;
        result.failure = std::string("the results could not be made: ") + e.what();
        result.files.clear();
    }
    listener_.end(id_, std::move(result));
    const std::lock_guard lock(mutex_);
    last_progress_ = progress_locked();
    prepared_ = {};
    png_.clear();
    end_locked();
}

RenderOutcome RenderTask::outcome() {
    RenderOutcome result;
    renderer::Report report;
    std::optional<renderer::Picture> picture;
    {
        const std::lock_guard lock(mutex_);
        result.progress = progress_locked();
        result.progress.seconds_left.reset();
        result.failure = failure_;
        if (!failure_.empty()) return result;
        // Cancelled, but all that was asked for had been done by then: done.
        const bool is_done = prepared_.render != nullptr && prepared_.render->finished();
        result.state = is_done ? JobState::Done : JobState::Cancelled;
        if (prepared_.render == nullptr) return result;
        report = report_locked();
        picture = prepared_.render->picture();
    }
    if (!picture) return result;
    auto files = result_files(picture, report, prepared_.output, prepared_.digests);
    if (files) {
        result.files = std::move(*files);
    } else {
        result.state = JobState::Failed;
        result.failure = files.error().message;
    }
    return result;
}

double RenderTask::seconds_locked() const {
    return std::chrono::duration<double>(Clock::now() - render_began_).count();
}

void RenderTask::note_error_locked() {
    const auto curve = prepared_.render->report().error;
    if (curve.empty()) return;
    last_progress_.rmse = curve.back().rmse;
    last_progress_.relative_rmse = curve.back().relative_rmse;
}

JobProgress RenderTask::progress_locked() const {
    JobProgress progress = last_progress_;
    if (prepared_.render == nullptr) return progress;
    const renderer::Render& render = *prepared_.render;
    progress.seconds = seconds_locked();
    progress.fraction = std::clamp(render.progress(progress.seconds), 0.0, 1.0);
    progress.samples = render.samples_done();
    progress.pass = render.current_pass();
    progress.rays = render.rays();
    if (progress.fraction > 0) {
        progress.seconds_left = progress.seconds * (1 - progress.fraction) / progress.fraction;
    }
    return progress;
}

renderer::Report RenderTask::report_locked() const {
    renderer::Report report = prepared_.render->report();
    report.timings.scene_s = prepared_.scene_seconds;
    report.bias.spectra = prepared_.notes;
    report.timings.render_s = seconds_locked();
    report.image = shown_;
    if (is_cancelled_ && report.stopped_by.empty()) report.stopped_by = "cancel";
    return report;
}

bool RenderTask::is_preview_due_locked(Clock::time_point now) const {
    if (is_making_preview_) return false;
    if (png_.empty()) return true;
    return now - last_preview_ >=
           std::max<Clock::duration>(kEventInterval, preview_cost_ * kPreviewShare);
}

JobProgress RenderTask::progress() const {
    const std::lock_guard lock(mutex_);
    return progress_locked();
}

std::vector<std::string> RenderTask::images() const {
    const std::lock_guard lock(mutex_);
    if (png_.empty()) return {};
    return {"image.png", "image.exr"};
}

Result<ResultFile> RenderTask::file(const std::string& name) const {
    const std::string media_type(media_type_of(name));
    if (media_type.empty()) return bouguer::fail(ErrorKind::NotFound, "no such result");
    std::string bytes;
    std::optional<renderer::Picture> picture;
    std::optional<renderer::Report> report;
    renderer::OutputSettings output;
    JobDigests digests;
    {
        const std::lock_guard lock(mutex_);
        if (prepared_.render == nullptr || (is_image(name) && png_.empty())) return not_finished();
        output = prepared_.output;
        digests = prepared_.digests;
        if (name == "image.png") {
            bytes = png_;
        } else if (name == "image.exr") {
            picture = prepared_.render->picture();
        } else {
            report = report_locked();
        }
    }
    if (report) bytes = report_file(name, *report, output, digests).value_or("");
    if (picture) {
        auto exr = renderer::encode_exr(*picture, output);
        if (!exr) return tl::unexpected(exr.error());
        bytes = std::move(*exr);
    }
    std::string digest = api::sha256_hex(bytes);
    return ResultFile{std::move(bytes), media_type, std::move(digest), false};
}

}  // namespace bouguer::server
