// SPDX-License-Identifier: Apache-2.0
// Many tiny jobs on many threads while clients ask, cancel and delete: what goes wrong only when a
// job ends at the same time. The long form is
//     server_tests --gtest_filter='JobStress.*' --gtest_repeat=10
// and ThreadSanitizer runs it too (tests/tsan.sh).
#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "server/jobs/job_manager.h"
#include "server/log.h"
#include "server/storage/memory_job_store.h"
#include "server/storage/memory_result_store.h"
#include "tests/server/jobs/fake_render.h"
#include "tests/server/jobs/small_job.h"
#include "tests/support/named_bytes.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

constexpr int kWorkers = 16;
constexpr int kClients = 6;
constexpr int kJobsPerClient = 500;   // 3,000 in all
constexpr int kTasksPerClient = 200;  // 1,200 in all: they meet more often

/// Runs `body(client)` on so many threads and waits for them.
void on_clients(const std::function<void(int)>& body) {
    std::vector<std::thread> clients;
    for (int client = 0; client < kClients; ++client) clients.emplace_back(body, client);
    for (std::thread& client : clients) client.join();
}

std::string tiny_job() { return small_job(1, "", "[2,2]"); }

/// What a client does with its job once it is submitted: every combination comes up often.
class Client {
  public:
    explicit Client(JobManager& manager) : manager_(manager) {}

    void submit(int number) {
        const auto submitted = manager_.submit(tiny_job(), "");
        ASSERT_TRUE(submitted) << submitted.error().message;
        const JobId id = submitted->view.job.id;
        auto subscription = manager_.subscribe(id, [](const JobEvent&) {});
        ASSERT_TRUE(subscription);
        look_at(id, number);
        if (number % 5 == 1) {
            EXPECT_TRUE(manager_.cancel(id));
            cancelled_.push_back(id);
        } else if (number % 5 == 3) {
            EXPECT_TRUE(manager_.remove(id));
            removed_.push_back(id);
        } else {
            kept_.push_back(id);
        }
        if (number % 2 == 0) subscriptions_.push_back(std::move(*subscription));
    }

    /// Every job has come to the end that was asked for, and every kept picture has the bits of
    /// `exr`.
    void check(const std::string& exr) {
        for (const JobId& id : kept_) {
            wait_for_end(id);
            EXPECT_EQ(manager_.find(id)->job.state, JobState::Done);
            const auto file = manager_.file(id, "image.exr");
            ASSERT_TRUE(file) << file.error().message;
            EXPECT_EQ(file->content.all().value(), exr);
        }
        for (const JobId& id : cancelled_) {
            EXPECT_TRUE(is_final(manager_.find(id)->job.state));
        }
        for (const JobId& id : removed_) {
            EXPECT_EQ(manager_.find(id).error().kind, ErrorKind::NotFound);
        }
    }

    void wait_for_end(const JobId& id) {
        std::promise<void> ended;
        const auto subscription = manager_.subscribe(id, [&](const JobEvent& event) {
            if (event.type == "done") ended.set_value();
        });
        ASSERT_TRUE(subscription);
        ASSERT_EQ(ended.get_future().wait_for(120s), std::future_status::ready) << id;
    }

  private:
    void look_at(const JobId& id, int number) {
        for (int i = 0; i < number % 7; ++i) {
            EXPECT_TRUE(manager_.find(id));
            (void)manager_.file(id, "image.exr");
            (void)manager_.file(id, "report.json");
            std::this_thread::yield();
        }
        if (number % 16 == 0) {
            EXPECT_TRUE(manager_.list(20, "", std::nullopt));
        }
    }

    JobManager& manager_;
    std::vector<JobId> kept_, cancelled_, removed_;
    std::vector<std::unique_ptr<Subscription>> subscriptions_;
};

TEST(JobStress, ThousandsOfTinyJobsEndAsTheyShould) {
    set_log_level(LogLevel::Error);
    MemoryJobStore jobs;
    MemoryResultStore results;
    const tests::NoAssets assets;
    JobManager manager(jobs, results, assets,
                       {.threads = kWorkers, .scheduler = {.tasks = kClients * kJobsPerClient}});
    ASSERT_TRUE(manager.start());
    Client first(manager);
    const JobId reference = manager.submit(tiny_job(), "")->view.job.id;
    first.wait_for_end(reference);
    const std::string exr = manager.file(reference, "image.exr")->content.all().value();
    on_clients([&](int) {
        Client client(manager);
        for (int number = 0; number < kJobsPerClient; ++number) client.submit(number);
        client.check(exr);
    });
    EXPECT_EQ(manager.queue_length(), 0U);
}

/// Counts the ends of its tasks.
class Counter final : public RenderListener {
  public:
    bool begin(const JobId&) noexcept override {
        ++begun_;
        return true;
    }
    void progress(const JobId&, const JobProgress&) noexcept override {}
    void preview(const JobId&, const JobProgress&) noexcept override {}
    void end(const JobId&, RenderOutcome) noexcept override {
        {
            const std::lock_guard lock(mutex_);
            ++ended_;
        }
        news_.notify_all();
    }
    /// Waits until whatever began has ended.
    void wait() {
        std::unique_lock lock(mutex_);
        EXPECT_TRUE(news_.wait_for(lock, 120s, [&] { return ended_ == begun_; }));
    }

  private:
    std::atomic<int> begun_ = 0;
    std::mutex mutex_;
    std::condition_variable news_;
    int ended_ = 0;  // guarded by mutex_
};

// Without stores and documents the tasks' ends come closer together.
TEST(JobStress, TasksAreAskedAndCancelledWhileTheyEnd) {
    Counter counter;
    Scheduler scheduler({.tasks = kClients * kTasksPerClient});
    WorkerPool pool(scheduler, kWorkers);
    on_clients([&](int) {
        std::vector<std::shared_ptr<RenderTask>> tasks;
        for (int number = 0; number < kTasksPerClient; ++number) {
            auto prepare = [number]() -> Result<PreparedRender> {
                if (number % 11 == 5) throw std::bad_alloc();
                if (number % 11 == 7) return fail(ErrorKind::InvalidInput, "no scene");
                return PreparedRender{std::make_unique<FakeRender>(2, 2), {}, {}, 0, {}};
            };
            tasks.push_back(
                std::make_shared<RenderTask>("job", number % 3, 1, std::move(prepare), counter));
            ASSERT_TRUE(scheduler.add(tasks.back()));
            pool.wake();
            for (const auto& task : {tasks.back(), tasks[tasks.size() / 2]}) {
                (void)task->progress();
                (void)task->images();
                (void)task->file("image.exr");
                (void)task->file("report.json");
                (void)task->urgency();
            }
            const auto& other = tasks[tasks.size() * 2 / 3];
            if (number % 4 == 0 && other->cancel()) scheduler.drop(*other);
        }
        pool.wake();
        for (const auto& task : tasks) {
            while (!task->ended()) std::this_thread::sleep_for(1ms);
            EXPECT_EQ(task->urgency(), Urgency::Finish);
            EXPECT_FALSE(task->next_step());
        }
    });
    counter.wait();
}

}  // namespace
}  // namespace bouguer::server
