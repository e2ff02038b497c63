// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_manager.h"

#include "api/digest.h"
#include "api/json_builder.h"
#include "api/writers.h"
#include "server/jobs/job_json.h"
#include "server/jobs/memory_estimate.h"
#include "server/jobs/prepare_render.h"
#include "server/jobs/turn.h"
#include "server/log.h"
#include "server/utc_time.h"

namespace bouguer::server {
namespace {

/// Scenes that clients may have built at the same time only to look at their plan.
constexpr int kValidationsAtOnce = 2;

/// A job as it is first stored.
Job new_job(JobId id, const api::JobRequest& request, std::int64_t now_ms) {
    Job job;
    job.id = std::move(id);
    job.priority = request.priority;
    job.created_ms = now_ms;
    job.memory_bytes = job_memory_bytes(request);
    job.name = request.scene.name;
    job.labels = request.labels;
    job.scene_digest = request.scene_digest;
    job.digest = request.digest;
    job.request = request.canonical;
    return job;
}

Result<void> check_memory(std::uint64_t needed, std::uint64_t limit) {
    if (needed <= limit) return {};
    Error error{ErrorKind::InvalidInput,
                "the job needs more memory than this server gives to one",
                {},
                "over-limit"};
    error.problems.push_back({"", "over-limit", "film and geometry are estimated to be too large",
                              std::to_string(needed) + " bytes",
                              "at most " + std::to_string(limit) + " bytes"});
    return tl::unexpected(std::move(error));
}

/// Whether the same call may go well later: the storage is at fault and not what was asked.
bool is_storage_fault(const Error& error) { return error.kind == ErrorKind::Internal; }

/// Whether a job failed by that and not by its own fault.
bool is_storage_code(const std::string& code) {
    return code == "storage-full" || code == "storage-failed";
}

/// The end of a job whose begins ended with the process.
Transition gave_up(JobState from) {
    return {from,
            JobState::Failed,
            unix_ms(),
            "the server ended unexpectedly " + std::to_string(kMaxBegins) +
                " times while it rendered this job, which is not begun again",
            {},
            "crashed-the-server"};
}

/// A file that is made of a stored one.
Result<ResultFile> made_of(const ResultFile& source, const std::string& media_type) {
    const auto text = source.content.all();
    if (!text) return tl::unexpected(text.error());
    auto bytes = made_from_source(*text);
    if (!bytes) return tl::unexpected(bytes.error());
    std::string digest = api::sha256_hex(*bytes);
    return ResultFile{std::move(*bytes), media_type, std::move(digest), source.final};
}

/// An error as one sentence for the record of a job: the message and the first problem.
std::string sentence(const Error& error) {
    if (error.problems.empty()) return error.message;
    const Problem& first = error.problems.front();
    return error.message + " (" + first.pointer + ": " + first.detail + ")";
}

/// Reads the request of a job again; refuses one that is not what was accepted.
Result<api::JobRequest> stored_request(const JobStore& jobs, const JobId& id,
                                       const api::Limits& limits, const api::AssetSource& assets) {
    const auto job = jobs.find(id);
    if (!job) return tl::unexpected(job.error());
    const auto text = jobs.request(id);
    if (!text) return tl::unexpected(text.error());
    auto request = api::parse_job(*text, limits, assets);
    if (!request)
        return fail(request.error().kind, sentence(request.error()), api::code_of(request.error()));
    if (request->digest != job->digest || request->scene_digest != job->scene_digest ||
        request->canonical != *text) {
        return fail(ErrorKind::Internal,
                    "the request of this job was changed or damaged in the store: it is not the "
                    "one that was accepted",
                    "store-damaged");
    }
    if (auto fits = check_memory(job_memory_bytes(*request), limits.memory_bytes); !fits) {
        return fail(ErrorKind::InvalidInput, sentence(fits.error()), fits.error().code);
    }
    return request;
}

}  // namespace

JobManager::JobManager(JobStore& jobs, ResultStore& results, const api::AssetSource& assets,
                       const JobManagerOptions& options)
    : jobs_(jobs),
      results_(results),
      assets_(assets),
      options_(options),
      accepted_(options.accepted_bytes),
      scenes_(options.scene_cache_bytes),
      scheduler_(options.scheduler),
      watch_([this] { return probe(); }, [this] { return catch_up(); }, options.storage_times) {}

JobManager::~JobManager() { stop(); }

Result<void> JobManager::start() {
    auto unfinished = jobs_.unfinished();
    if (!unfinished) return tl::unexpected(unfinished.error());
    for (const Job& job : *unfinished) {
        if (auto resumed = resume(job.id); !resumed) {
            report_fault(resumed.error());
            remember(job.id, nullptr);
        }
    }
    workers_ = std::make_unique<WorkerPool>(scheduler_, options_.threads);
    watch_.start();
    is_accepting_ = true;
    return {};
}

Result<void> JobManager::resume(const JobId& id) {
    auto job = jobs_.find(id);
    if (job && job->state == JobState::Running) {
        job = change(id, job->attempts >= kMaxBegins
                             ? gave_up(JobState::Running)
                             : Transition{JobState::Running, JobState::Queued, unix_ms()});
    }
    if (!job && is_storage_fault(job.error())) return tl::unexpected(job.error());
    if (job && job->state == JobState::Queued) {
        take_up(*job);
    } else {
        forget(id);  // it has ended or is gone
    }
    return {};
}

void JobManager::take_up(const Job& job) {
    auto task = make_task(job);
    remember(job.id, task);
    scheduler_.add_again(std::move(task));
}

void JobManager::remember(const JobId& id, std::shared_ptr<RenderTask> task) {
    const std::lock_guard lock(live_mutex_);
    const auto [entry, is_new] = live_.insert_or_assign(id, std::move(task));
    if (is_new) drain_rate_.begin(DrainRate::Clock::now());
}

void JobManager::refuse_new() { is_accepting_ = false; }

void JobManager::stop() {
    refuse_new();
    if (workers_ == nullptr) return;
    workers_->refuse_new();  // first: what has not begun by now will not
    {
        const std::lock_guard lock(live_mutex_);
        for (const auto& [id, task] : live_) {
            if (task != nullptr) task->interrupt();
        }
    }
    workers_->stop();
    watch_.stop();
    for (const JobId& id : unstored_.ids()) {
        (void)try_to_store(id, *unstored_.find(id));
        unstored_.erase(id);
    }
    const std::lock_guard lock(live_mutex_);
    // Conflict: it had not begun. A fault of the storage: the next process finds it running.
    for (const auto& [id, task] : live_) (void)hand_back(id);
    live_.clear();
}

Result<Job> JobManager::hand_back(const JobId& id) {
    Transition back{JobState::Running, JobState::Queued, unix_ms()};
    back.takes_begin_back = true;
    return change(id, back);
}

std::shared_ptr<RenderTask> JobManager::make_task(const Job& job) {
    auto prepare = [this, id = job.id]() -> Result<PreparedRender> {
        auto accepted = accepted_.take(id);
        auto request = accepted ? Result<api::JobRequest>(*std::move(accepted))
                                : stored_request(jobs_, id, options_.documents, assets_);
        if (!request) return tl::unexpected(request.error());
        request->stop.limit_s = options_.max_seconds;
        return prepare_render(*request, scenes_);
    };
    RenderListener& listener = *this;
    const bool runs_alone = job.attempts + 1 >= kMaxBegins;
    return std::make_shared<RenderTask>(job.id, job.priority, job.memory_bytes, std::move(prepare),
                                        listener, runs_alone);
}

Result<SubmitResult> JobManager::submit(const std::string& body,
                                        const std::string& idempotency_key) {
    if (!is_accepting_) {
        return fail(ErrorKind::Busy, "the server is stopping", "draining");
    }
    const IdempotencyKey key{idempotency_key, api::sha256_hex(body)};
    auto before = jobs_.find_key(key);
    if (!before) return tl::unexpected(before.error());
    if (*before) return SubmitResult{view_of(std::move((*before)->job)), true};
    if (auto fault = watch_.error()) return tl::unexpected(std::move(*fault));

    auto request = api::parse_job(body, options_.documents, assets_);
    if (!request) return tl::unexpected(request.error());
    const std::int64_t now = unix_ms();
    const Job job = new_job(ids_.make(now), *request, now);
    if (auto fits = check_memory(job.memory_bytes, options_.documents.memory_bytes); !fits) {
        return tl::unexpected(fits.error());
    }
    const std::uint64_t scene_bytes = scene_memory_bytes(request->scene);
    Warnings warnings = request->warnings;
    accepted_.keep(job.id, *std::move(request), scene_bytes);  // before a worker can ask for it
    bool replayed = false;
    auto stored = admit(job, key, replayed);
    if (!stored || replayed) accepted_.drop(job.id);
    if (!stored) return tl::unexpected(stored.error());
    return SubmitResult{view_of(std::move(*stored)), replayed, std::move(warnings)};
}

Result<Job> JobManager::admit(const Job& job, const IdempotencyKey& key, bool& replayed) {
    const std::lock_guard lock(admission_);
    if (scheduler_.full()) {
        return fail(ErrorKind::Busy, "the queue is full; try again later", "queue-full");
    }
    auto stored = jobs_.insert(job, key);
    if (!stored && is_storage_fault(stored.error())) report_fault(stored.error());
    if (!stored) return tl::unexpected(stored.error());
    replayed = stored->replayed;
    if (replayed) return std::move(stored->job);
    log_event(LogLevel::Info, "job-state",
              {{"job_id", job.id}, {"state", "queued"}, {"name", job.name}});
    take_up(job);
    workers_->wake();
    return std::move(stored->job);
}

Result<Job> JobManager::change(const JobId& id, const Transition& transition) {
    auto job = jobs_.transition(id, transition);
    if (!job) return job;
    log_event(job->state == JobState::Failed ? LogLevel::Warning : LogLevel::Info, "job-state",
              {{"job_id", id},
               {"state", std::string(to_string(job->state))},
               {"seconds", api::json_number(job->progress.seconds)},
               {"failure", job->failure}});
    return job;
}

bool JobManager::begin(const JobId& id) noexcept {
    try {
        auto job = change(id, {JobState::Queued, JobState::Running, unix_ms()});
        if (job) {
            events_.publish(id, "snapshot", job_json(view_of(std::move(*job))));
            return true;
        }
        if (is_storage_fault(job.error())) {
            remember(id, nullptr);
            report_fault(job.error());
            return false;
        }
    } catch (const std::exception& e) {
        log_event(LogLevel::Error, "job-begin", {{"job_id", id}, {"error", e.what()}});
        begin_again(id);
        return false;
    }
    forget(id);
    return false;
}

void JobManager::progress(const JobId& id, const JobProgress& progress) noexcept {
    try {
        events_.publish(id, "progress", progress_event_json(id, progress));
    } catch (const std::exception& e) {
        log_event(LogLevel::Error, "job-progress", {{"job_id", id}, {"error", e.what()}});
    }
}

void JobManager::preview(const JobId& id, const JobProgress& progress) noexcept {
    try {
        events_.publish(id, "preview", progress_event_json(id, progress));
    } catch (const std::exception& e) {
        log_event(LogLevel::Error, "job-preview", {{"job_id", id}, {"error", e.what()}});
    }
}

void JobManager::end(const JobId& id, RenderOutcome outcome) noexcept {
    try {
        // What could not be read from the storage can be read later: it is no fault of the job.
        if (outcome.state == JobState::Failed && is_storage_code(outcome.failure_code)) {
            outcome.state = JobState::Queued;
        }
        const auto kept = std::make_shared<const RenderOutcome>(std::move(outcome));
        if (auto stored = try_to_store(id, *kept); !stored) {
            unstored_.add(id, kept);
            report_fault(stored.error());
        }
    } catch (const std::exception& e) {
        log_event(LogLevel::Error, "job-end", {{"job_id", id}, {"error", e.what()}});
        begin_again(id);
    }
}

/// After a lack of memory in between: what the store has of the job is looked at later.
void JobManager::begin_again(const JobId& id) {
    remember(id, nullptr);  // allocates nothing: it is there
    report_fault({ErrorKind::Internal, "out of memory", {}, "storage-failed"});
}

Result<void> JobManager::try_to_store(const JobId& id, const RenderOutcome& outcome) {
    try {
        return outcome.state == JobState::Queued ? put_back(id) : store_end(id, outcome);
    } catch (const std::exception& e) {  // memory: there may be more later
        return fail(ErrorKind::Internal, e.what(), "storage-failed");
    }
}

Result<void> JobManager::put_back(const JobId& id) {
    const auto queued = hand_back(id);
    if (!queued && is_storage_fault(queued.error())) return tl::unexpected(queued.error());
    remember(id, nullptr);  // catch_up() looks for it
    return {};
}

Result<void> JobManager::store_end(const JobId& id, const RenderOutcome& outcome) {
    if (!outcome.files.empty()) {
        if (auto stored = results_.put(id, outcome.files); !stored) return stored;
    }
    // A cancelled job was marked when the wish came; that it is cancelled or removed by now is no
    // error.
    if (outcome.state != JobState::Cancelled) {
        auto job = change(id, {JobState::Running, outcome.state, unix_ms(), outcome.failure,
                               outcome.progress, outcome.failure_code});
        if (job) {
            events_.publish(id, "done", job_json(view_of(std::move(*job))));
        } else if (is_storage_fault(job.error())) {
            return tl::unexpected(job.error());
        }
    }
    const auto kept = jobs_.find(id);
    if (!kept && kept.error().kind == ErrorKind::NotFound) (void)results_.remove(id);
    forget(id);
    return {};
}

void JobManager::report_fault(const Error& error) {
    scheduler_.hold(true);
    watch_.report(error);
}

Result<void> JobManager::probe() {
    if (options_.check_storage) {
        if (auto checked = options_.check_storage(); !checked) return checked;
    }
    return jobs_.probe();
}

Result<void> JobManager::catch_up() {
    for (const JobId& id : unstored_.ids()) {
        if (auto stored = try_to_store(id, *unstored_.find(id)); !stored) return stored;
        unstored_.erase(id);
    }
    for (const JobId& id : without_task()) {
        if (auto resumed = resume(id); !resumed) return resumed;
    }
    scheduler_.hold(false);
    workers_->wake();
    return {};
}

std::vector<JobId> JobManager::without_task() const {
    const std::lock_guard lock(live_mutex_);
    std::vector<JobId> ids;
    for (const auto& [id, task] : live_) {
        if (task == nullptr) ids.push_back(id);
    }
    return ids;
}

std::shared_ptr<RenderTask> JobManager::live(const JobId& id) const {
    const std::lock_guard lock(live_mutex_);
    const auto it = live_.find(id);
    return it == live_.end() ? nullptr : it->second;
}

void JobManager::forget(const JobId& id) {
    accepted_.drop(id);
    const std::lock_guard lock(live_mutex_);
    if (live_.erase(id) > 0) drain_rate_.end(DrainRate::Clock::now());
}

JobView JobManager::view_of(Job job) const {
    const auto task = live(job.id);
    if (task == nullptr && !is_final(job.state)) {
        // It may have ended since it was read.
        if (auto again = jobs_.find(job.id)) job = std::move(*again);
    }
    return view_of(std::move(job), task);
}

JobView JobManager::view_of(Job job, const std::shared_ptr<RenderTask>& task) const {
    JobView view{std::move(job), {}, {}};
    if (is_final(view.job.state)) {
        view.progress = view.job.progress;
        for (std::string& name : results_.names(view.job.id).value_or(std::vector<std::string>{})) {
            if (is_image(name)) view.images.push_back(std::move(name));
        }
    } else if (const auto ended = unstored_.find(view.job.id)) {
        view.progress = ended->progress;
        for (const auto& [name, bytes] : ended->files) {
            if (is_image(name)) view.images.push_back(name);
        }
    } else if (task != nullptr) {
        view.progress = task->progress();
        view.images = task->images();
    }
    return view;
}

Result<JobView> JobManager::find(const JobId& id) const {
    // In this order: a task is forgotten only after its end was stored.
    const auto task = live(id);
    auto job = jobs_.find(id);
    if (!job) return tl::unexpected(job.error());
    return view_of(std::move(*job), task);
}

Result<JobPage> JobManager::list(std::size_t limit, const std::string& cursor,
                                 std::optional<JobState> state) const {
    auto listing = jobs_.list(limit, cursor, state);
    if (!listing) return tl::unexpected(listing.error());
    JobPage page{{}, std::move(listing->next_cursor)};
    for (Job& job : listing->jobs) page.jobs.push_back(view_of(std::move(job)));
    return page;
}

Result<JobView> JobManager::cancel(const JobId& id) {
    while (true) {
        auto job = jobs_.find(id);
        if (!job) return tl::unexpected(job.error());
        if (is_final(job->state)) return view_of(std::move(*job));
        const auto task = live(id);
        JobProgress progress = task == nullptr ? JobProgress{} : task->progress();
        progress.seconds_left.reset();
        auto cancelled = change(id, {job->state, JobState::Cancelled, unix_ms(), {}, progress});
        if (!cancelled) {
            // Its state changed meanwhile: look again.
            if (cancelled.error().kind == ErrorKind::Conflict) continue;
            return tl::unexpected(cancelled.error());
        }
        if (task != nullptr && task->cancel()) {
            scheduler_.drop(*task);
            forget(id);
        }
        workers_->wake();
        JobView view = view_of(std::move(*cancelled));
        events_.publish(id, "done", job_json(view));
        return view;
    }
}

Result<void> JobManager::remove(const JobId& id) {
    if (auto cancelled = cancel(id); !cancelled) return tl::unexpected(cancelled.error());
    if (auto removed = jobs_.remove(id); !removed) return removed;
    log_event(LogLevel::Info, "job-removed", {{"job_id", id}});
    if (auto gone = results_.remove(id); !gone) {
        // The next start does it: the store remembers what was removed.
        log_event(LogLevel::Warning, "results-kept",
                  {{"job_id", id}, {"error", gone.error().message}});
    }
    return {};
}

Result<ResultFile> JobManager::file(const JobId& id, const std::string& name) const {
    const std::string media_type(media_type_of(name));
    const auto task = live(id);  // first, as in find()
    auto job = jobs_.find(id);
    if (!job) return tl::unexpected(job.error());
    if (media_type.empty()) return fail(ErrorKind::NotFound, "no such result");
    if (is_final(job->state)) {
        auto stored = stored_file(*job, name, media_type);
        // Cancelled a moment ago: the newest pass is on its way to the store.
        if (stored || task == nullptr || stored.error().code != "no-result") return stored;
    }
    if (const auto ended = unstored_.find(id); ended != nullptr && !ended->files.empty()) {
        return unstored_file(*ended, name, media_type);
    }
    if (task == nullptr) {
        return fail(ErrorKind::Conflict, "there is nothing of this job yet", "job-not-finished");
    }
    auto shown = task->file(name);
    if (shown || !task->ended()) return shown;
    return stored_file(*job, name, media_type);  // where all of an ended task is
}

Result<ResultFile> JobManager::unstored_file(const RenderOutcome& ended, const std::string& name,
                                             const std::string& media_type) {
    const std::string_view source = source_of(name);
    const auto file = ended.files.find(source.empty() ? name : std::string(source));
    if (file == ended.files.end()) {
        return fail(ErrorKind::NotFound, "the job ended without this result", "no-result");
    }
    ResultFile found{file->second, media_type, api::sha256_hex(file->second), false};
    return source.empty() ? found : made_of(found, media_type);
}

Result<ResultFile> JobManager::stored_file(const Job& job, const std::string& name,
                                           const std::string& media_type) const {
    auto stored = results_.get(job.id, name);
    if (stored) {
        return ResultFile{std::move(stored->content), media_type, std::move(stored->digest), true};
    }
    if (stored.error().kind != ErrorKind::NotFound) return tl::unexpected(stored.error());
    if (!source_of(name).empty()) {
        const auto source = stored_file(job, std::string(source_of(name)), media_type);
        if (!source) return tl::unexpected(source.error());
        return made_of(*source, media_type);
    }
    if (job.state == JobState::Done) {
        return fail(ErrorKind::Internal, "the stored " + name + " is gone", "result-damaged");
    }
    return fail(ErrorKind::NotFound, "the job ended without this result", "no-result");
}

Result<std::unique_ptr<Subscription>> JobManager::subscribe(const JobId& id,
                                                            EventListener listener) {
    return events_.subscribe(id, std::move(listener), [&]() -> Result<JobEvents::Greeting> {
        auto view = find(id);
        if (!view) return tl::unexpected(view.error());
        return JobEvents::Greeting{job_json(*view), is_final(view->job.state)};
    });
}

Result<std::string> JobManager::validate(const std::string& body) const {
    const Turn turn(validations_);
    if (!turn.is_within(kValidationsAtOnce)) {
        return fail(ErrorKind::Busy, "other scenes are being looked at; try again",
                    "validation-busy");
    }
    auto request = api::parse_job(body, options_.documents, assets_);
    if (!request) return tl::unexpected(request.error());
    const std::uint64_t memory = job_memory_bytes(*request);
    if (auto fits = check_memory(memory, options_.documents.memory_bytes); !fits) {
        return tl::unexpected(fits.error());
    }
    auto scene = renderer::build_scene(request->scene);
    if (!scene) return tl::unexpected(scene.error());
    return api::JsonObject()
        .set("valid", true)
        .set("scene_digest", request->scene_digest)
        .set("memory_bytes_estimate", memory)
        .set_json("notes", api::notes_json(request->notes))
        .set_json("warnings", api::warnings_json(request->warnings))
        .set_json("plan", api::plan_json(renderer::make_plan(**scene, request->settings)))
        .text();
}

Readiness JobManager::readiness() const {
    if (!is_accepting_) return {false, "draining"};
    if (const auto fault = watch_.error()) return {false, fault->code};
    return {};
}

std::size_t JobManager::queue_length() const { return scheduler_.num_waiting(); }

int JobManager::retry_after_s() const {
    return drain_rate_.seconds_to_drain(DrainRate::Clock::now());
}

}  // namespace bouguer::server
