// SPDX-License-Identifier: Apache-2.0
// The jobs of this process: accepts, stores, renders and shows them.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "api/job_document.h"
#include "server/jobs/drain_rate.h"
#include "server/jobs/job_events.h"
#include "server/jobs/job_id.h"
#include "server/jobs/job_service.h"
#include "server/jobs/render_task.h"
#include "server/jobs/scene_cache.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/worker_pool.h"
#include "server/storage/job_store.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

struct JobManagerOptions {
    int threads = 1;
    SchedulerLimits scheduler{};
    api::Limits documents{};
    std::uint64_t scene_cache_bytes = 512U << 20U;
};

/// Thread-safe. A job is stored before it is accepted, and its results before it is done, so that a
/// crash at any moment loses nothing: the next process begins again what had not ended, and since
/// units are pure functions it gets the same picture.
class JobManager final : public JobService, private RenderListener {
  public:
    /// Everything outlives the manager. Nothing runs before start().
    JobManager(JobStore& jobs, ResultStore& results, const api::AssetSource& assets,
               const JobManagerOptions& options);
    /// As stop().
    ~JobManager() override;

    /// Takes up the jobs that an earlier process left unfinished and begins to render.
    [[nodiscard]] Result<void> start();
    /// Accepts nothing more: ready() is false and submit() answers Busy.
    void refuse_new();
    /// As refuse_new(); gives up the units under way, puts running jobs back into the stored queue
    /// and joins the threads. Idempotent.
    void stop();

    [[nodiscard]] Result<SubmitResult> submit(const std::string& body,
                                              const std::string& idempotency_key) override;
    [[nodiscard]] Result<JobView> find(const JobId& id) const override;
    [[nodiscard]] Result<JobPage> list(std::size_t limit, const std::string& cursor,
                                       std::optional<JobState> state) const override;
    [[nodiscard]] Result<JobView> cancel(const JobId& id) override;
    [[nodiscard]] Result<void> remove(const JobId& id) override;
    [[nodiscard]] Result<ResultFile> file(const JobId& id, const std::string& name) const override;
    [[nodiscard]] Result<std::unique_ptr<Subscription>> subscribe(const JobId& id,
                                                                  EventListener listener) override;
    [[nodiscard]] Result<std::string> validate(const std::string& body) const override;
    [[nodiscard]] bool ready() const override;
    [[nodiscard]] std::size_t queue_length() const override;
    [[nodiscard]] int retry_after_s() const override;

  private:
    [[nodiscard]] bool begin(const JobId& id) noexcept override;
    void progress(const JobId& id, const JobProgress& progress) noexcept override;
    void preview(const JobId& id, const JobProgress& progress) noexcept override;
    void end(const JobId& id, RenderOutcome outcome) noexcept override;

    [[nodiscard]] Result<Job> admit(const Job& job, const IdempotencyKey& key, bool& replayed);
    [[nodiscard]] std::shared_ptr<RenderTask> make_task(const Job& job);
    void take_up(const Job& job);
    void store_end(const JobId& id, RenderOutcome& outcome);
    /// Stores a change of state, logs it and tells the listeners.
    [[nodiscard]] Result<Job> change(const JobId& id, const Transition& transition);
    [[nodiscard]] std::shared_ptr<RenderTask> live(const JobId& id) const;
    void forget(const JobId& id);
    [[nodiscard]] JobView view_of(Job job) const;
    /// `task` is what live() gave before the job was read.
    [[nodiscard]] JobView view_of(Job job, const std::shared_ptr<RenderTask>& task) const;
    [[nodiscard]] Result<ResultFile> stored_file(const JobId& id, const std::string& name,
                                                 const std::string& media_type) const;

    JobStore& jobs_;
    ResultStore& results_;
    const api::AssetSource& assets_;
    const JobManagerOptions options_;
    JobIdMaker ids_;
    JobEvents events_;
    SceneCache scenes_;
    Scheduler scheduler_;
    std::atomic<bool> is_accepting_ = false;
    mutable std::atomic<int> validations_ = 0;  ///< under way
    std::mutex admission_;  ///< between looking for room in the queue and taking it
    mutable std::mutex live_mutex_;
    std::map<JobId, std::shared_ptr<RenderTask>> live_;  // guarded by live_mutex_
    DrainRate drain_rate_;                               // of live_
    std::unique_ptr<WorkerPool> workers_;                // set by start(); last: it uses the others
};

}  // namespace bouguer::server
