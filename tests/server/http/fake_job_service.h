// SPDX-License-Identifier: Apache-2.0
// A JobService without a renderer: jobs are what a test says they are.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include "server/jobs/job_service.h"

namespace bouguer::server::testing {

/// Thread-safe.
class FakeJobService : public JobService {
  public:
    /// Adds a running job and returns its id.
    JobId add();
    /// Brings an event to all who listen to the job.
    void emit(const JobId& id, const std::string& type, const std::string& data = "{}");
    /// Ends the job and tells it.
    void finish(const JobId& id);
    void set_file(const JobId& id, const std::string& name, ResultFile file);
    /// Called at the start of find(), without a lock: may wait or throw.
    void on_find(std::function<void()> action);
    [[nodiscard]] std::size_t listeners() const;

    std::atomic<bool> is_ready{true};
    std::atomic<bool> is_full{false};
    std::string last_body, last_key;  ///< of submit() and validate(); read them after the answer

    Result<SubmitResult> submit(const std::string& body, const std::string& key) override;
    Result<JobView> find(const JobId& id) const override;
    Result<JobPage> list(std::size_t limit, const std::string& cursor,
                         std::optional<JobState> state) const override;
    Result<JobView> cancel(const JobId& id) override;
    Result<void> remove(const JobId& id) override;
    Result<ResultFile> file(const JobId& id, const std::string& name) const override;
    Result<std::unique_ptr<Subscription>> subscribe(const JobId& id,
                                                    EventListener listener) override;
    Result<std::string> validate(const std::string& body) const override;
    Readiness readiness() const override {
        return is_ready ? Readiness{} : Readiness{false, "storage-full"};
    }
    std::size_t queue_length() const override { return 3; }
    int retry_after_s() const override { return 37; }

  private:
    struct Listeners;
    class FakeSubscription;

    JobId add_locked();

    mutable std::mutex mutex_;
    std::map<JobId, JobView> jobs_;
    std::map<std::string, JobId> keys_;
    std::map<JobId, std::map<std::string, ResultFile>> files_;
    std::function<void()> on_find_;
    std::shared_ptr<Listeners> listeners_ = make_listeners();
    int count_ = 0;

    static std::shared_ptr<Listeners> make_listeners();
};

}  // namespace bouguer::server::testing
