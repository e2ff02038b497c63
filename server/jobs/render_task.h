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
#include "server/content.h"
#include "server/jobs/job_service.h"
#include "server/jobs/result_files.h"
#include "server/jobs/task.h"

namespace bouguer::server {

/// A render that is ready to begin.
struct PreparedRender {
    std::shared_ptr<renderer::Render> render;
    renderer::OutputSettings output;
    JobDigests digests;
    double scene_seconds = 0;  ///< that it took to build the scene
    renderer::SpectrumNotes notes{};
    Warnings warnings{};  ///< of the document
};

/// What became of a job.
struct RenderOutcome {
    JobState state = JobState::Failed;  ///< Done, Failed or Cancelled
    std::string failure;                ///< of a failed one: why, fit for a client
    JobProgress progress;
    ResultFiles files;           ///< of a cancelled one: of its newest pass, or none
    Warnings warnings{};         ///< of document and picture
    std::string failure_code{};  ///< `failure` as a stable name; may be empty
    std::optional<renderer::UnfinishedPass> unfinished_pass{};  ///< that the picture is of
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
/// files). A unit that takes longer than a moment is left, and goes on in a later step, perhaps of
/// another worker: others get their turn meanwhile. Its phase is the one truth about it: whatever
/// is asked is answered from the phase and from what was published when the phase began, never from
/// a render that another thread may be ending or letting go of. Its lock is held for moments only,
/// so that what the scheduler asks (urgency, next_step, ended) never waits for a picture.
class RenderTask final : public Task {
  public:
    using Prepare = std::function<Result<PreparedRender>()>;  ///< called by a worker; may throw

    /// `listener` outlives the task.
    RenderTask(JobId id, int priority, std::uint64_t memory_bytes, Prepare prepare,
               RenderListener& listener, bool runs_alone = false);

    [[nodiscard]] const JobId& id() const override { return id_; }
    [[nodiscard]] int priority() const override { return priority_; }
    [[nodiscard]] std::uint64_t memory_bytes() const override { return memory_bytes_; }
    [[nodiscard]] bool runs_alone() const override { return runs_alone_; }
    [[nodiscard]] Urgency urgency() const override;
    [[nodiscard]] std::optional<Step> next_step() override;
    [[nodiscard]] bool ended() const override;
    void fail(std::string reason) noexcept override;

    /// Begins no other unit. A task that has not begun ends at once and tells nobody; any other
    /// ends, as cancelled, once the units under way have given up. Returns whether it ended at
    /// once.
    bool cancel();

    /// The process stops: units under way are left and handed back.
    void interrupt() { give_up_ = true; }

    [[nodiscard]] JobProgress progress() const;
    /// Names of the images that can be had now, from file() or, of an ended task, from the store.
    [[nodiscard]] std::vector<std::string> images() const;
    /// A file of the newest complete pass, as JobService::file. Conflict, code "job-not-finished",
    /// before there is one and once the task has ended.
    [[nodiscard]] Result<ResultFile> file(const std::string& name) const;

  private:
    enum class Phase {
        Waiting,     ///< nothing was done
        Preparing,   ///< a worker builds the scene; there is no render yet
        Rendering,   ///< units are handed out and merged, under the lock
        EndingPass,  ///< one worker has the render to itself, without the lock; no units are left
        Finishing,   ///< likewise: the files are made
        Ended        ///< there is no render any more
    };
    using Clock = std::chrono::steady_clock;
    class StepGuard;

    /// What can be shown of a running job. Never changes, so that it is read without the lock.
    struct Shown {
        std::shared_ptr<const renderer::Picture> picture;  ///< null before the first complete pass
        renderer::Report report;
        renderer::OutputSettings output;
        JobDigests digests;
    };

    void prepare();
    void trace(const std::shared_ptr<renderer::UnitResult>& unit);
    void end_pass(const renderer::UnitResult& last);
    void make_preview(const Shown& shown);
    void finish();

    /// A file that is made when it is asked for: all but the PNG.
    [[nodiscard]] static Result<std::string> made_anew(const std::string& name, const Shown& shown,
                                                       const renderer::ImageInfo& png_info);
    void begin_rendering(PreparedRender prepared);
    [[nodiscard]] std::shared_ptr<const Shown> look() const;
    [[nodiscard]] RenderOutcome outcome() noexcept;
    [[nodiscard]] RenderOutcome outcome_of_render();
    [[nodiscard]] bool complete_render();

    [[nodiscard]] bool is_given_up_locked() const { return is_cancelled_ || !failure_.empty(); }
    [[nodiscard]] bool is_over_locked() const;
    [[nodiscard]] std::optional<Step> take_unit_locked();
    void leave_rendering_locked(Phase next);
    [[nodiscard]] double seconds() const;
    [[nodiscard]] JobProgress progress_locked() const;
    [[nodiscard]] std::optional<JobProgress> progress_event_locked(Clock::time_point now);
    [[nodiscard]] bool is_preview_due_locked(Clock::time_point now) const;

    const JobId id_;
    const int priority_;
    const std::uint64_t memory_bytes_;
    const Prepare prepare_;
    RenderListener& listener_;
    const bool runs_alone_;

    std::atomic<bool> give_up_ = false;  ///< units under way are left at once

    mutable std::mutex mutex_;
    Phase phase_ = Phase::Waiting;  // guarded by mutex_, as all below but prepared_
    int steps_under_way_ = 0;
    int units_under_way_ = 0;  ///< handed out and not come back
    bool is_cancelled_ = false;
    bool is_complete_ = false;  ///< the render has done all that was asked for
    std::string failure_, failure_code_;
    JobProgress progress_;  ///< as it was when the phase Rendering was left; the error always
    std::shared_ptr<const Shown> shown_;  ///< null before Rendering and once ended
    bool has_preview_ = false;
    Content png_;                   ///< the newest preview; empty once ended
    renderer::ImageInfo png_info_;  ///< what it shows
    bool is_making_preview_ = false;
    Clock::time_point last_preview_, last_progress_event_;
    Clock::duration preview_cost_{};

    // Set by prepare(), let go of by finish(). In the phase Rendering it is used under mutex_ (but
    // for Render::trace), in EndingPass and Finishing by the one worker whose step that is.
    PreparedRender prepared_;
    Clock::time_point render_began_;  ///< set before the phase Rendering; does not change
    Clock::time_point deadline_ = Clock::time_point::max();  ///< likewise: of Render::deadline_s()
};

}  // namespace bouguer::server
