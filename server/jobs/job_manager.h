// SPDX-License-Identifier: Apache-2.0
// The jobs of this process: accepts, stores, renders and shows them.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "api/job_document.h"
#include "server/jobs/accepted_requests.h"
#include "server/jobs/drain_rate.h"
#include "server/jobs/job_events.h"
#include "server/jobs/job_id.h"
#include "server/jobs/job_service.h"
#include "server/jobs/render_task.h"
#include "server/jobs/scene_cache.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/storage_watch.h"
#include "server/jobs/unstored_ends.h"
#include "server/jobs/worker_pool.h"
#include "server/storage/job_store.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

struct JobManagerOptions {
    int threads = 1;
    double max_seconds = 86'400;  ///< of rendering one job; what is there by then is its result
    SchedulerLimits scheduler{};
    api::Limits documents{};
    std::uint64_t scene_cache_bytes = 512U << 20U;
    std::uint64_t accepted_bytes = 256U << 20U;  ///< of requests that wait, as they were read
    /// Of the place where the stores keep things: "storage-full", "storage-failed". May be empty.
    std::function<Result<void>()> check_storage{};
    StorageWatchTimes storage_times{};
};

/// Begins of one job that may end with the process, but for orderly stops, before it is given up.
inline constexpr std::uint32_t kMaxBegins = 3;

/// Thread-safe. A job is stored before it is accepted, and its results before it is done, so that a
/// crash at any moment loses nothing: the next process begins again what had not ended, and since
/// units are pure functions it gets the same picture. A job whose begins ended with the process
/// kMaxBegins times fails instead, and the last of those begins was alone with nothing beside it,
/// so that no other is blamed for it.
///
/// When the storage fails, nothing is lost and nobody waits: what could not be stored is kept and
/// tried again, nothing new is begun or taken meanwhile, and readiness() says why.
class JobManager final : public JobService, private RenderListener {
  public:
    /// Everything outlives the manager. Nothing runs before start().
    JobManager(JobStore& jobs, ResultStore& results, const api::AssetSource& assets,
               const JobManagerOptions& options);
    /// As stop().
    ~JobManager() override;

    /// Takes up the jobs that an earlier process left unfinished and begins to render.
    [[nodiscard]] Result<void> start();
    /// Accepts nothing more: it is not ready and submit() answers Busy.
    void refuse_new();
    /// As refuse_new(); gives up the units under way, puts running jobs back into the stored queue
    /// and joins the threads. What the storage does not take even now is rendered again by the next
    /// process. Idempotent.
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
    [[nodiscard]] Readiness readiness() const override;
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
    /// A job of the store that nobody renders: into the queue, or to its end if it has begun too
    /// often. Error: the storage failed.
    [[nodiscard]] Result<void> resume(const JobId& id);
    /// What came of a job; of state Queued: nothing, it is to be rendered again. An error: the
    /// storage failed, and the same is to be tried again.
    [[nodiscard]] Result<void> try_to_store(const JobId& id, const RenderOutcome& outcome);
    [[nodiscard]] Result<void> store_end(const JobId& id, const RenderOutcome& outcome);
    [[nodiscard]] Result<void> put_back(const JobId& id);
    [[nodiscard]] Result<Job> hand_back(const JobId& id);
    void begin_again(const JobId& id);
    /// Begins nothing more until everything is stored.
    void report_fault(const Error& error);
    [[nodiscard]] Result<void> probe();
    [[nodiscard]] Result<void> catch_up();
    /// Stores a change of state, logs it and tells the listeners.
    [[nodiscard]] Result<Job> change(const JobId& id, const Transition& transition);
    [[nodiscard]] std::shared_ptr<RenderTask> live(const JobId& id) const;
    void remember(const JobId& id, std::shared_ptr<RenderTask> task);
    void forget(const JobId& id);
    [[nodiscard]] std::vector<JobId> without_task() const;
    [[nodiscard]] JobView view_of(Job job) const;
    /// `task` is what live() gave before the job was read.
    [[nodiscard]] JobView view_of(Job job, const std::shared_ptr<RenderTask>& task) const;
    [[nodiscard]] static Result<ResultFile> unstored_file(const RenderOutcome& ended,
                                                          const std::string& name,
                                                          const std::string& media_type);
    [[nodiscard]] Result<ResultFile> stored_file(const Job& job, const std::string& name,
                                                 const std::string& media_type) const;

    JobStore& jobs_;
    ResultStore& results_;
    const api::AssetSource& assets_;
    const JobManagerOptions options_;
    JobIdMaker ids_;
    JobEvents events_;
    AcceptedRequests accepted_;
    SceneCache scenes_;
    Scheduler scheduler_;
    std::atomic<bool> is_accepting_ = false;
    mutable std::atomic<int> validations_ = 0;  ///< under way
    std::mutex admission_;  ///< between looking for room in the queue and taking it
    mutable std::mutex live_mutex_;
    /// Jobs that have not ended; null: to be resumed when the storage works again. Guarded by
    /// live_mutex_.
    std::map<JobId, std::shared_ptr<RenderTask>> live_;
    DrainRate drain_rate_;  // of live_
    UnstoredEnds unstored_;
    StorageWatch watch_;
    std::unique_ptr<WorkerPool> workers_;  // set by start(); last: it uses the others
};

}  // namespace bouguer::server
