// SPDX-License-Identifier: Apache-2.0
// A job being rendered: a Render with its lock, its clock and its end.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "renderer/render.h"
#include "server/jobs/job_service.h"
#include "server/jobs/result_files.h"
#include "server/jobs/task.h"

namespace bouguer::server {

/// A render that is ready to begin.
struct PreparedRender {
    std::unique_ptr<renderer::Render> render;
    renderer::OutputSettings output;
    JobDigests digests;
    double scene_seconds = 0;  ///< that it took to build the scene
    renderer::SpectrumNotes notes{};
};

/// What became of a job.
struct RenderOutcome {
    JobState state = JobState::Failed;  ///< Done, Failed or Cancelled
    std::string failure;                ///< of a failed one: why, fit for a client
    JobProgress progress;
    ResultFiles files;  ///< of a cancelled one: of its newest pass, or none
};

/// Is told what happens to a task: by a worker, without a lock held, one call at a time for `begin`
/// and `end`, the others at any time between them.
class RenderListener {
  public:
    virtual ~RenderListener() = default;
    /// Before anything is done. False: the task ends here and nothing else is told.
    [[nodiscard]] virtual bool begin(const JobId& id) noexcept = 0;
    virtual void progress(const JobId& id, const JobProgress& progress) noexcept = 0;
    /// A better picture can be had from RenderTask::file.
    virtual void preview(const JobId& id, const JobProgress& progress) noexcept = 0;
    virtual void end(const JobId& id, RenderOutcome outcome) noexcept = 0;
};

/// Thread-safe. Its steps are: prepare (build the scene), one for each unit, finish (make the
/// files). What the scheduler asks (urgency, next_step, ended) does not wait while a pass is being
/// ended, which takes long for a large picture: other jobs go on meanwhile.
class RenderTask final : public Task {
  public:
    using Prepare = std::function<Result<PreparedRender>()>;  ///< called by a worker; may throw

    /// `listener` outlives the task.
    RenderTask(JobId id, int priority, std::uint64_t memory_bytes, Prepare prepare,
               RenderListener& listener);

    [[nodiscard]] const JobId& id() const override { return id_; }
    [[nodiscard]] int priority() const override { return priority_; }
    [[nodiscard]] std::uint64_t memory_bytes() const override { return memory_bytes_; }
    [[nodiscard]] Urgency urgency() const override;
    [[nodiscard]] std::optional<Step> next_step() override;
    [[nodiscard]] bool ended() const override { return is_ended_; }
    void fail(const std::string& reason) noexcept override;

    /// Begins no other unit. A task that has not begun ends at once and tells nobody; any other
    /// ends, as cancelled, once the units under way have given up. Returns whether it ended at
    /// once.
    bool cancel();

    /// The process stops: units under way are given up and handed back.
    void interrupt() { give_up_ = true; }

    [[nodiscard]] JobProgress progress() const;
    /// Names of the images that file() has now.
    [[nodiscard]] std::vector<std::string> images() const;
    /// A file of the newest complete pass, as JobService::file. Conflict, code "job-not-finished",
    /// before there is one.
    [[nodiscard]] Result<ResultFile> file(const std::string& name) const;

  private:
    enum class Phase { Waiting, Preparing, Rendering, Finishing, Ended };
    using Clock = std::chrono::steady_clock;
    class StepGuard;

    void prepare();
    void end_locked();
    [[nodiscard]] bool merge_locked(std::unique_ptr<renderer::UnitResult> result);
    void trace(const renderer::Unit& unit);
    void make_preview(const renderer::Picture& picture);
    void finish();
    [[nodiscard]] RenderOutcome outcome();

    [[nodiscard]] double seconds_locked() const;
    [[nodiscard]] JobProgress progress_locked() const;
    [[nodiscard]] renderer::Report report_locked() const;
    [[nodiscard]] bool is_over_locked() const;
    [[nodiscard]] bool is_preview_due_locked(Clock::time_point now) const;
    void note_error_locked();

    const JobId id_;
    const int priority_;
    const std::uint64_t memory_bytes_;
    const Prepare prepare_;
    RenderListener& listener_;

    std::atomic<bool> give_up_ = false;  ///< units under way end without a result
    std::atomic<bool> is_ended_ = false;
    std::atomic<bool> is_ending_pass_ =
        false;  ///< a worker holds mutex_ for long; no units are left
    mutable std::mutex mutex_;
    Phase phase_ = Phase::Waiting;  // guarded by mutex_, as all below
    int steps_under_way_ = 0;
    int units_under_way_ = 0;  ///< handed out and not merged
    bool is_cancelled_ = false;
    std::string failure_;
    PreparedRender prepared_;
    Clock::time_point render_began_;
    JobProgress last_progress_;  ///< the error of the newest pass; all of it once ended
    std::string png_;            ///< the newest preview
    renderer::ImageInfo shown_;  ///< what it shows
    bool is_making_preview_ = false;
    Clock::time_point last_preview_, last_progress_event_;
    Clock::duration preview_cost_{};
};

}  // namespace bouguer::server
