// SPDX-License-Identifier: Apache-2.0
#include "tests/server/http/fake_job_service.h"

#include <array>
#include <cstdio>

namespace bouguer::server::testing {

/// One lock a listener is held during its call, so that ending a subscription waits for it.
struct FakeJobService::Listeners {
    struct One {
        JobId job;
        std::mutex calling;
        EventListener listener;  ///< guarded by calling; empty once unsubscribed
    };
    std::mutex mutex;
    std::set<std::shared_ptr<One>> all;  ///< guarded by mutex
    std::uint64_t next_event = 1;        ///< guarded by mutex
};

class FakeJobService::FakeSubscription : public Subscription {
  public:
    FakeSubscription(std::shared_ptr<Listeners> listeners, std::shared_ptr<Listeners::One> one)
        : listeners_(std::move(listeners)), one_(std::move(one)) {}
    ~FakeSubscription() override {
        {
            const std::lock_guard lock(listeners_->mutex);
            listeners_->all.erase(one_);
        }
        const std::lock_guard lock(one_->calling);
        one_->listener = nullptr;
    }

  private:
    std::shared_ptr<Listeners> listeners_;
    std::shared_ptr<Listeners::One> one_;
};

std::shared_ptr<FakeJobService::Listeners> FakeJobService::make_listeners() {
    return std::make_shared<Listeners>();
}

JobId FakeJobService::add_locked() {
    std::array<char, 40> id{};
    std::snprintf(id.data(), id.size(), "01890000-0000-7000-8000-%012x", ++count_);
    JobView view;
    view.job.id = id.data();
    view.job.state = JobState::Running;
    jobs_[view.job.id] = view;
    return view.job.id;
}

JobId FakeJobService::add() {
    const std::lock_guard lock(mutex_);
    return add_locked();
}

void FakeJobService::emit(const JobId& id, const std::string& type, const std::string& data) {
    std::vector<std::shared_ptr<Listeners::One>> called;
    JobEvent event{.id = 0, .type = type, .data = data};
    {
        const std::lock_guard lock(listeners_->mutex);
        event.id = ++listeners_->next_event;
        for (const auto& one : listeners_->all) {
            if (one->job == id) called.push_back(one);
        }
    }
    for (const auto& one : called) {
        const std::lock_guard lock(one->calling);
        if (one->listener) one->listener(event);
    }
}

void FakeJobService::finish(const JobId& id) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.at(id).job.state = JobState::Done;
    }
    emit(id, "done", R"({"state":"done"})");
}

void FakeJobService::set_file(const JobId& id, const std::string& name, ResultFile file) {
    const std::lock_guard lock(mutex_);
    files_[id][name] = std::move(file);
}

void FakeJobService::on_find(std::function<void()> action) {
    const std::lock_guard lock(mutex_);
    on_find_ = std::move(action);
}

std::size_t FakeJobService::listeners() const {
    const std::lock_guard lock(listeners_->mutex);
    return listeners_->all.size();
}

Result<SubmitResult> FakeJobService::submit(const std::string& body, const std::string& key) {
    const std::lock_guard lock(mutex_);
    last_body = body;
    last_key = key;
    if (is_full) return fail(ErrorKind::Busy, "the queue is full", "queue-full");
    if (body.front() != '{') {
        Error error{
            .kind = ErrorKind::InvalidInput, .message = "not a job", .problems = {}, .code = {}};
        error.problems.push_back({"/scene", "missing", "there is no scene", "", "an object"});
        return tl::unexpected(error);
    }
    const bool replayed = !key.empty() && keys_.contains(key);
    const JobId id = replayed ? keys_.at(key) : add_locked();
    if (!key.empty()) keys_[key] = id;
    return SubmitResult{jobs_.at(id), replayed};
}

Result<JobView> FakeJobService::find(const JobId& id) const {
    std::function<void()> action;
    {
        const std::lock_guard lock(mutex_);
        action = on_find_;
    }
    if (action) action();
    const std::lock_guard lock(mutex_);
    const auto it = jobs_.find(id);
    if (it == jobs_.end()) return fail(ErrorKind::NotFound, "no such job");
    return it->second;
}

Result<JobPage> FakeJobService::list(std::size_t limit, const std::string& cursor,
                                     std::optional<JobState> state) const {
    const std::lock_guard lock(mutex_);
    JobPage page;
    for (const auto& [id, view] : jobs_) {
        if (id <= cursor || (state && view.job.state != *state)) continue;
        if (page.jobs.size() == limit) {
            page.next_cursor = page.jobs.back().job.id;
            break;
        }
        page.jobs.push_back(view);
    }
    return page;
}

Result<JobView> FakeJobService::cancel(const JobId& id) {
    const std::lock_guard lock(mutex_);
    const auto it = jobs_.find(id);
    if (it == jobs_.end()) return fail(ErrorKind::NotFound, "no such job");
    if (!is_final(it->second.job.state)) it->second.job.state = JobState::Cancelled;
    return it->second;
}

Result<void> FakeJobService::remove(const JobId& id) {
    const std::lock_guard lock(mutex_);
    if (jobs_.erase(id) == 0) return fail(ErrorKind::NotFound, "no such job");
    return {};
}

Result<ResultFile> FakeJobService::file(const JobId& id, const std::string& name) const {
    const std::lock_guard lock(mutex_);
    if (!jobs_.contains(id)) return fail(ErrorKind::NotFound, "no such job");
    const auto of_job = files_.find(id);
    if (of_job == files_.end() || !of_job->second.contains(name)) {
        return fail(ErrorKind::Conflict, "nothing yet", "job-not-finished");
    }
    return of_job->second.at(name);
}

Result<std::unique_ptr<Subscription>> FakeJobService::subscribe(const JobId& id,
                                                                EventListener listener) {
    bool ended = false;
    {
        const std::lock_guard lock(mutex_);
        const auto it = jobs_.find(id);
        if (it == jobs_.end()) return fail(ErrorKind::NotFound, "no such job");
        ended = is_final(it->second.job.state);
    }
    listener({.id = 1, .type = "snapshot", .data = R"({"id":")" + id + "\"}"});
    if (ended) listener({.id = 2, .type = "done", .data = R"({"state":"done"})"});
    auto one = std::make_shared<Listeners::One>();
    one->job = id;
    one->listener = std::move(listener);
    const std::lock_guard lock(listeners_->mutex);
    listeners_->all.insert(one);
    return std::make_unique<FakeSubscription>(listeners_, std::move(one));
}

Result<std::string> FakeJobService::validate(const std::string& body) const {
    if (body.empty()) return fail(ErrorKind::Malformed, "not JSON");
    return std::string(R"({"problems":[]})");
}

}  // namespace bouguer::server::testing
