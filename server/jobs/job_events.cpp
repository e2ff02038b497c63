// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_events.h"

#include <condition_variable>
#include <deque>
#include <thread>

namespace bouguer::server {

/// The events that one listener has still to get. Whoever wants to deliver while nobody does
/// becomes the deliverer until the box is empty.
class JobEvents::Outbox {
  public:
    explicit Outbox(EventListener listener) : listener_(std::move(listener)) {}

    void add(const JobEvent& event) {
        const std::lock_guard lock(mutex_);
        if (!is_closed_) events_.push_back(event);
    }

    /// Delivers what there is, unless another thread is about it.
    void deliver() {
        std::unique_lock lock(mutex_);
        if (is_open_) deliver(lock);
    }

    /// Delivers `first` and then what has come since the listener was registered.
    void open(std::deque<JobEvent> first) {
        std::unique_lock lock(mutex_);
        events_.insert(events_.begin(), std::make_move_iterator(first.begin()),
                       std::make_move_iterator(first.end()));
        is_open_ = true;
        deliver(lock);
    }

    /// Nothing is delivered after this returns. Waits for a call under way, unless it is the
    /// caller's own.
    void close() {
        std::unique_lock lock(mutex_);
        is_closed_ = true;
        idle_.wait(lock, [&] {
            return deliverer_ == std::thread::id{} || deliverer_ == std::this_thread::get_id();
        });
    }

  private:
    void deliver(std::unique_lock<std::mutex>& lock) {
        if (deliverer_ != std::thread::id{}) return;
        deliverer_ = std::this_thread::get_id();
        while (!events_.empty() && !is_closed_) {
            const JobEvent event = std::move(events_.front());
            events_.pop_front();
            if (event.type == "done") is_closed_ = true;
            lock.unlock();
            listener_(event);
            lock.lock();
        }
        deliverer_ = {};
        idle_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable idle_;
    std::deque<JobEvent> events_;  // guarded by mutex_, as all below
    bool is_open_ = false;
    bool is_closed_ = false;
    std::thread::id deliverer_;  ///< of the thread inside listener_, if any
    const EventListener listener_;
};

struct JobEvents::Registry {
    mutable std::mutex mutex;
    std::uint64_t last_id = 0;  // guarded by mutex, as all below
    std::multimap<JobId, std::shared_ptr<Outbox>> outboxes;
};

/// What the subscriber holds.
class JobEvents::Handle final : public Subscription {
  public:
    Handle(std::shared_ptr<Registry> registry, JobId id, std::shared_ptr<Outbox> outbox)
        : registry_(std::move(registry)), id_(std::move(id)), outbox_(std::move(outbox)) {}
    ~Handle() override {
        {
            const std::lock_guard lock(registry_->mutex);
            const auto [first, last] = registry_->outboxes.equal_range(id_);
            for (auto it = first; it != last; ++it) {
                if (it->second == outbox_) {
                    registry_->outboxes.erase(it);
                    break;
                }
            }
        }
        outbox_->close();
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

  private:
    const std::shared_ptr<Registry> registry_;
    const JobId id_;
    const std::shared_ptr<Outbox> outbox_;
};

JobEvents::JobEvents() : registry_(std::make_shared<Registry>()) {}
JobEvents::~JobEvents() = default;

Result<std::unique_ptr<Subscription>> JobEvents::subscribe(
    const JobId& id, EventListener listener, const std::function<Result<Greeting>()>& greet) {
    auto outbox = std::make_shared<Outbox>(std::move(listener));
    std::uint64_t event_id = 0;
    {
        const std::lock_guard lock(registry_->mutex);
        registry_->outboxes.emplace(id, outbox);
        registry_->last_id += 2;
        event_id = registry_->last_id - 1;
    }
    auto handle = std::make_unique<Handle>(registry_, id, outbox);
    auto greeting = greet();
    if (!greeting) return tl::unexpected(greeting.error());
    std::deque<JobEvent> first{{event_id, "snapshot", greeting->snapshot}};
    if (greeting->is_done) first.push_back({event_id + 1, "done", greeting->snapshot});
    outbox->open(std::move(first));
    return handle;
}

void JobEvents::publish(const JobId& id, const std::string& type, const std::string& data) {
    std::vector<std::shared_ptr<Outbox>> outboxes;
    JobEvent event{0, type, data};
    {
        const std::lock_guard lock(registry_->mutex);
        event.id = ++registry_->last_id;
        const auto [first, last] = registry_->outboxes.equal_range(id);
        for (auto it = first; it != last; ++it) {
            it->second->add(event);  // here, so that the order is that of the ids
            outboxes.push_back(it->second);
        }
    }
    for (const auto& outbox : outboxes) outbox->deliver();
}

std::size_t JobEvents::num_listeners() const {
    const std::lock_guard lock(registry_->mutex);
    return registry_->outboxes.size();
}

}  // namespace bouguer::server
