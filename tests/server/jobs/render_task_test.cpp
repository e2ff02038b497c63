// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/render_task.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

#include "server/jobs/worker_pool.h"
#include "tests/server/jobs/fake_render.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

/// Remembers what it was told; the end can be waited for.
class Recorder final : public RenderListener {
  public:
    bool begin(const JobId&) noexcept override {
        ++begun;
        return lets_begin;
    }
    void progress(const JobId&, const JobProgress&) noexcept override { ++progresses; }
    void preview(const JobId&, const JobProgress&) noexcept override { ++previews; }
    void end(const JobId&, RenderOutcome outcome) noexcept override {
        end_.set_value(std::move(outcome));
    }
    RenderOutcome wait() {
        auto future = end_.get_future();
        if (future.wait_for(20s) != std::future_status::ready) {
            ADD_FAILURE() << "the task did not end";
            return {};
        }
        return future.get();
    }

    std::atomic<int> begun = 0, progresses = 0, previews = 0;
    bool lets_begin = true;

  private:
    std::promise<RenderOutcome> end_;
};

class RenderTaskTest : public testing::Test {
  protected:
    std::shared_ptr<RenderTask> make(RenderTask::Prepare prepare) {
        return std::make_shared<RenderTask>("job", 0, 1, std::move(prepare), recorder_);
    }
    std::shared_ptr<RenderTask> make(std::uint32_t passes, int units,
                                     FakeRender::OnTrace on_trace = {}) {
        return make([=]() -> Result<PreparedRender> {
            return PreparedRender{
                std::make_unique<FakeRender>(passes, units, on_trace), {}, {"d", "s"}, 0.25, {}};
        });
    }
    RenderOutcome run(const std::shared_ptr<RenderTask>& task, int threads = 2) {
        EXPECT_TRUE(scheduler_.add(task));
        WorkerPool pool(scheduler_, threads);
        return recorder_.wait();
    }

    Recorder recorder_;
    Scheduler scheduler_;
};

TEST_F(RenderTaskTest, MakesEveryFileWhenItIsDone) {
    const RenderOutcome outcome = run(make(3, 5));
    EXPECT_EQ(outcome.state, JobState::Done);
    EXPECT_EQ(outcome.failure, "");
    for (const char* name : {"image.png", "image.exr", "report.json", "error.json", "error.csv",
                             "plan.json", "health.json"}) {
        EXPECT_TRUE(outcome.files.contains(name)) << name;
    }
    EXPECT_EQ(outcome.files.size(), 7U) << "the plot is made when it is asked for";
    EXPECT_EQ(outcome.progress.samples, 3U);
    EXPECT_EQ(outcome.progress.fraction, 1.0);
    EXPECT_DOUBLE_EQ(outcome.progress.relative_rmse.value().value, 1.0 / 3);
    EXPECT_EQ(recorder_.begun, 1);
}

// The scheduler asks between a task's last step and the moment it lets go of it.
TEST_F(RenderTaskTest, CanBeAskedOnceItHasEnded) {
    const auto task = make(2, 3);
    run(task);
    EXPECT_TRUE(task->ended());
    EXPECT_EQ(task->urgency(), Urgency::Finish);
    EXPECT_FALSE(task->next_step());
    EXPECT_EQ(task->progress().samples, 2U);
    EXPECT_EQ(task->progress().fraction, 1.0);
    EXPECT_EQ(task->file("report.json").error().code, "job-not-finished");
    EXPECT_FALSE(task->cancel());
}

TEST_F(RenderTaskTest, CanBeAskedBetweenAllItsSteps) {
    const auto task = make(2, 2);
    int steps = 0;
    while (auto step = task->next_step()) {
        EXPECT_FALSE(task->ended());
        (void)task->urgency();
        (void)task->progress();
        (void)task->file("report.json");
        (*step)();
        ++steps;
    }
    EXPECT_EQ(steps, 6) << "prepare, two passes of two units, finish";
    EXPECT_TRUE(task->ended());
}

// Cancelled between the scene and the first unit, or while the scene is built.
TEST_F(RenderTaskTest, CancelledWhilePreparingItEndsAsCancelled) {
    std::shared_ptr<RenderTask> task;
    task = make([&]() -> Result<PreparedRender> {
        EXPECT_FALSE(task->cancel());
        EXPECT_EQ(task->urgency(), Urgency::FirstPass);
        EXPECT_FALSE(task->next_step()) << "not before the scene is there";
        EXPECT_EQ(task->file("report.json").error().code, "job-not-finished");
        return PreparedRender{std::make_unique<FakeRender>(2, 2), {}, {}, 0, {}};
    });
    const RenderOutcome outcome = run(task);
    EXPECT_EQ(outcome.state, JobState::Cancelled);
    EXPECT_TRUE(outcome.files.empty());
    EXPECT_EQ(outcome.progress.samples, 0U);
}

TEST_F(RenderTaskTest, CancelledWhilePreparingFailsItEnds) {
    std::shared_ptr<RenderTask> task;
    task = make([&]() -> Result<PreparedRender> {
        EXPECT_FALSE(task->cancel());
        throw std::runtime_error("no scene");
    });
    const RenderOutcome outcome = run(task);
    EXPECT_NE(outcome.state, JobState::Done);
    EXPECT_TRUE(outcome.files.empty());
}

TEST_F(RenderTaskTest, FailsWhenTheSceneCannotBeBuilt) {
    const RenderOutcome outcome = run(make([]() -> Result<PreparedRender> {
        return fail(ErrorKind::InvalidInput, "the mesh is gone");
    }));
    EXPECT_EQ(outcome.state, JobState::Failed);
    EXPECT_EQ(outcome.failure, "the mesh is gone");
    EXPECT_TRUE(outcome.files.empty());
}

TEST_F(RenderTaskTest, FailsWhenPreparingThrows) {
    const RenderOutcome outcome =
        run(make([]() -> Result<PreparedRender> { throw std::bad_alloc(); }));
    EXPECT_EQ(outcome.state, JobState::Failed);
    EXPECT_EQ(outcome.failure, "out of memory");
}

TEST_F(RenderTaskTest, FailsOnceWhenUnitsThrow) {
    const RenderOutcome outcome = run(make(2, 8,
                                           [](const renderer::Unit& unit) {
                                               if (unit.pass == 1)
                                                   throw std::runtime_error("no light");
                                           }),
                                      4);
    EXPECT_EQ(outcome.state, JobState::Failed);
    EXPECT_EQ(outcome.failure, "internal error: no light");
}

TEST_F(RenderTaskTest, CancelledWhileWaitingItEndsAtOnceAndTellsNobody) {
    const auto task = make(1, 1);
    EXPECT_TRUE(task->cancel());
    EXPECT_TRUE(task->ended());
    EXPECT_FALSE(task->next_step());
    EXPECT_EQ(recorder_.begun, 0);
}

TEST_F(RenderTaskTest, EndsWithoutATellWhenItMayNotBegin) {
    recorder_.lets_begin = false;
    const auto task = make(1, 1);
    auto step = task->next_step();
    ASSERT_TRUE(step);
    (*step)();
    EXPECT_TRUE(task->ended());
}

// Units take 1 ms and there would be a million of them.
TEST_F(RenderTaskTest, CancelledWhileRunningItKeepsTheNewestPass) {
    std::promise<void> in_second_pass;
    std::atomic<bool> told = false;
    const auto task = make(1'000'000, 2, [&](const renderer::Unit& unit) {
        std::this_thread::sleep_for(1ms);
        if (unit.pass == 1 && !told.exchange(true)) in_second_pass.set_value();
    });
    ASSERT_TRUE(scheduler_.add(task));
    WorkerPool pool(scheduler_, 2);
    in_second_pass.get_future().wait();
    EXPECT_FALSE(task->cancel());
    pool.wake();
    const RenderOutcome outcome = recorder_.wait();
    EXPECT_EQ(outcome.state, JobState::Cancelled);
    EXPECT_TRUE(outcome.files.contains("image.exr"));
    EXPECT_NE(outcome.files.at("report.json").find("\"cancel\""), std::string::npos);
}

TEST_F(RenderTaskTest, CancelledBeforeThereIsAPictureItHasNoFiles) {
    std::promise<void> begun;
    std::promise<void> go_on;
    const auto task = make(5, 1, [&](const renderer::Unit&) {
        begun.set_value();
        go_on.get_future().wait();
    });
    ASSERT_TRUE(scheduler_.add(task));
    WorkerPool pool(scheduler_, 1);
    begun.get_future().wait();
    task->cancel();
    go_on.set_value();
    const RenderOutcome outcome = recorder_.wait();
    EXPECT_EQ(outcome.state, JobState::Cancelled);
    EXPECT_TRUE(outcome.files.empty());
}

// Units end only when they are given up.
TEST_F(RenderTaskTest, EndsAsDoneWhenItsTimeIsOverInTheFirstPass) {
    const auto task = make([&]() -> Result<PreparedRender> {
        auto render = std::make_unique<FakeRender>(
            5, 2, [](const renderer::Unit&) { std::this_thread::sleep_for(1ms); });
        render->deadline = 0;
        return PreparedRender{std::move(render), {}, {}, 0, {}};
    });
    const RenderOutcome outcome = run(task);
    EXPECT_EQ(outcome.state, JobState::Done);
    EXPECT_EQ(outcome.progress.samples, 0U);
    ASSERT_TRUE(outcome.unfinished_pass);
    EXPECT_EQ(outcome.unfinished_pass->without_sample, 1U);
    EXPECT_TRUE(outcome.files.contains("image.png"));
    EXPECT_NE(outcome.files.at("report.json").find(R"("stopped_by":"seconds")"), std::string::npos);
    EXPECT_NE(outcome.files.at("health.json").find(R"("without_sample":1)"), std::string::npos);
}

TEST_F(RenderTaskTest, KeepsTheNewestPassWhenItsTimeIsOverLater) {
    const auto task = make([&]() -> Result<PreparedRender> {
        auto render = std::make_unique<FakeRender>(
            1'000'000, 2, [](const renderer::Unit&) { std::this_thread::sleep_for(1ms); });
        render->deadline = 0.2;
        return PreparedRender{std::move(render), {}, {}, 0, {}};
    });
    const RenderOutcome outcome = run(task);
    EXPECT_EQ(outcome.state, JobState::Done);
    EXPECT_GT(outcome.progress.samples, 0U);
    EXPECT_FALSE(outcome.unfinished_pass);
    EXPECT_TRUE(outcome.files.contains("image.exr"));
}

// The wish to cancel came first: what there is of the first pass is not asked for.
TEST_F(RenderTaskTest, CancelledInTheFirstPassItHasNoPictureThoughItsTimeIsOver) {
    const auto task = make([&]() -> Result<PreparedRender> {
        auto render = std::make_unique<FakeRender>(5, 2);
        render->deadline = 0;
        return PreparedRender{std::move(render), {}, {}, 0, {}};
    });
    auto prepare = task->next_step();
    (*prepare)();
    EXPECT_FALSE(task->cancel());
    EXPECT_EQ(task->urgency(), Urgency::Finish);
    (*task->next_step())();
    const RenderOutcome outcome = recorder_.wait();
    EXPECT_EQ(outcome.state, JobState::Cancelled);
    EXPECT_TRUE(outcome.files.empty());
}

TEST_F(RenderTaskTest, ShowsTheNewestPassWhileItRuns) {
    std::promise<void> in_second_pass;
    std::promise<void> go_on;
    const auto task = make(2, 1, [&](const renderer::Unit& unit) {
        if (unit.pass == 0) return;
        in_second_pass.set_value();
        go_on.get_future().wait();
    });
    EXPECT_EQ(task->file("image.png").error().code, "job-not-finished");
    EXPECT_EQ(task->file("plan.json").error().code, "job-not-finished");
    EXPECT_EQ(task->file("passwd").error().kind, ErrorKind::NotFound);
    EXPECT_TRUE(task->images().empty());
    ASSERT_TRUE(scheduler_.add(task));
    WorkerPool pool(scheduler_, 1);
    in_second_pass.get_future().wait();
    EXPECT_EQ(recorder_.previews, 1);
    EXPECT_EQ(task->images().size(), 2U);
    const auto png = task->file("image.png");
    ASSERT_TRUE(png);
    EXPECT_EQ(png->content.all()->substr(1, 3), "PNG");
    EXPECT_EQ(png->media_type, "image/png");
    EXPECT_FALSE(png->final);
    EXPECT_TRUE(task->file("image.exr"));
    EXPECT_TRUE(task->file("health.json"));
    EXPECT_EQ(task->progress().samples, 1U);
    EXPECT_DOUBLE_EQ(task->progress().fraction, 0.5);
    go_on.set_value();
    const RenderOutcome outcome = recorder_.wait();
    EXPECT_NE(outcome.files.at("image.png"), png->content.all().value())
        << "the second pass differs";
}

TEST_F(RenderTaskTest, TellsProgressAtMostFourTimesASecond) {
    const auto begin = std::chrono::steady_clock::now();
    run(make(100, 10, [](const renderer::Unit&) { std::this_thread::sleep_for(300us); }));
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    EXPECT_LE(recorder_.progresses, 2 + 4 * spent.count());
    EXPECT_LE(recorder_.previews, 2 + 4 * spent.count());
    EXPECT_GE(recorder_.previews, 1);
}

// The end of a pass takes long for a large picture; the second thread must not wait for it.
TEST_F(RenderTaskTest, AnotherJobGoesOnWhileAPassIsEnded) {
    std::promise<void> inside;
    std::promise<void> go_on;
    const auto large = make([&]() -> Result<PreparedRender> {
        auto render = std::make_unique<FakeRender>(1, 3, FakeRender::OnTrace{}, [&] {
            inside.set_value();
            go_on.get_future().wait();
        });
        return PreparedRender{std::move(render), {}, {}, 0};
    });
    ASSERT_TRUE(scheduler_.add(large));
    WorkerPool pool(scheduler_, 2);
    inside.get_future().wait();
    Recorder other;
    const auto small = std::make_shared<RenderTask>(
        "other", 0, 1,
        []() -> Result<PreparedRender> {
            return PreparedRender{std::make_unique<FakeRender>(2, 3), {}, {}, 0};
        },
        other);
    ASSERT_TRUE(scheduler_.add(small));
    pool.wake();
    EXPECT_EQ(other.wait().state, JobState::Done);
    EXPECT_FALSE(large->ended());
    // Nor does whoever asks: a client gets what was there before the pass.
    EXPECT_EQ(large->urgency(), Urgency::FirstPass);
    EXPECT_FALSE(large->next_step());
    EXPECT_EQ(large->progress().samples, 0U);
    EXPECT_TRUE(large->file("plan.json"));
    EXPECT_EQ(large->file("image.exr").error().code, "job-not-finished");
    EXPECT_FALSE(large->cancel()) << "it ends later";
    go_on.set_value();
    EXPECT_EQ(recorder_.wait().state, JobState::Done);
}

TEST_F(RenderTaskTest, FailsWhenTheEndOfAPassThrows) {
    const RenderOutcome outcome = run(make([]() -> Result<PreparedRender> {
        auto render = std::make_unique<FakeRender>(2, 3, FakeRender::OnTrace{},
                                                   [] { throw std::bad_alloc(); });
        return PreparedRender{std::move(render), {}, {}, 0};
    }));
    EXPECT_EQ(outcome.state, JobState::Failed);
    EXPECT_EQ(outcome.failure, "out of memory");
}

}  // namespace
}  // namespace bouguer::server
