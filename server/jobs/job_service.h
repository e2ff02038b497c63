// SPDX-License-Identifier: Apache-2.0
// What the HTTP routes ask of the jobs: the seam between who speaks and who decides. Routes are
// tested with a fake of it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/core/warning.h"
#include "server/content.h"
#include "server/jobs/job.h"

namespace bouguer::server {

struct JobView {
    Job job;  ///< without the request document
    JobProgress progress;
    std::vector<std::string> images;  ///< "image.png", "image.exr"; empty before the first pass
};

struct JobPage {
    std::vector<JobView> jobs;  ///< newest first
    std::string next_cursor;    ///< opaque; empty on the last page
};

/// A result with what conditional and range requests need.
struct ResultFile {
    Content content;
    std::string media_type;  ///< "image/png", "image/x-exr", "application/json", "text/csv"
    std::string digest;      ///< sha256 hex of the content: the strong ETag
    bool final = false;      ///< the job has ended: it never changes
};

/// One thing that happened to a job.
struct JobEvent {
    std::uint64_t id = 0;  ///< grows within a job and process; begins anew in the next process
    std::string type;  ///< "snapshot", "progress", "preview", "done" (done: any final state, the
                       ///< last event)
    std::string data;  ///< JSON text, one line
};

/// Gets a job's events, from any thread, never under a lock of the service; must return quickly and
/// not throw.
using EventListener = std::function<void(const JobEvent&)>;

/// Keeps a listener registered as long as it lives. Destroying it waits for a call under way.
class Subscription {
  public:
    virtual ~Subscription() = default;
};

/// Whether jobs are taken.
struct Readiness {
    bool ready = true;
    std::string reason{};  ///< why not: "draining", "storage-full", "storage-failed" ...
};

struct SubmitResult {
    JobView view;
    bool replayed = false;  ///< the Idempotency-Key was seen before: nothing new was made
    Warnings warnings{};    ///< of the document; none are told of a replay
};

/// Thread-safe. Errors: NotFound (no such job), Conflict, Busy (queue full), InvalidInput ...
class JobService {
  public:
    virtual ~JobService() = default;

    /// Reads, admits and stores a job; when this returns the job survives a crash.
    /// `idempotency_key` may be empty; seen with another body: InvalidInput, code
    /// "idempotency-key-reused".
    [[nodiscard]] virtual Result<SubmitResult> submit(const std::string& body,
                                                      const std::string& idempotency_key) = 0;
    [[nodiscard]] virtual Result<JobView> find(const JobId& id) const = 0;
    /// `limit` in [1, 100]; `cursor` from a former page or empty; `state` filters.
    [[nodiscard]] virtual Result<JobPage> list(std::size_t limit, const std::string& cursor,
                                               std::optional<JobState> state) const = 0;
    /// Idempotent; a job that has ended stays as it is.
    [[nodiscard]] virtual Result<JobView> cancel(const JobId& id) = 0;
    /// Cancels if need be and deletes the job and its files. Unknown ids are NotFound.
    [[nodiscard]] virtual Result<void> remove(const JobId& id) = 0;

    /// `name`: "image.png", "image.exr" (newest complete pass while it runs), "report.json",
    /// "error.json", "error.csv", "error.png", "plan.json", "health.json". Conflict, code
    /// "job-not-finished", before there is anything.
    [[nodiscard]] virtual Result<ResultFile> file(const JobId& id,
                                                  const std::string& name) const = 0;

    /// A "snapshot" event is delivered before this returns, then everything that happens. If the
    /// job has ended: the snapshot, then "done".
    [[nodiscard]] virtual Result<std::unique_ptr<Subscription>> subscribe(
        const JobId& id, EventListener listener) = 0;

    /// Problems and plan of a scene or job document; nothing is rendered. JSON text.
    [[nodiscard]] virtual Result<std::string> validate(const std::string& body) const = 0;

    /// Does not wait for a disk.
    [[nodiscard]] virtual Readiness readiness() const = 0;
    [[nodiscard]] virtual std::size_t queue_length() const = 0;
    /// When it is worth asking again for a place in the queue, or for a job that was just accepted:
    /// until then what waits and runs now should have ended. Seconds, in [1, 600]; measured.
    [[nodiscard]] virtual int retry_after_s() const = 0;
};

/// The JSON of a view, as in GET /v1/jobs/{id}. Progress events carry its "progress" member.
[[nodiscard]] std::string job_json(const JobView& view);
/// The same with "warnings": the answer to a submission.
[[nodiscard]] std::string submitted_job_json(const SubmitResult& result);
[[nodiscard]] std::string job_page_json(const JobPage& page);

}  // namespace bouguer::server
