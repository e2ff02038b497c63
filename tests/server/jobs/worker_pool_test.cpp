// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>

#include "tests/server/jobs/fake_task.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

/// Waits until the task has ended; false after ten seconds.
bool wait_for(const Task& task) {
    for (int i = 0; i < 10'000; ++i) {
        if (task.ended()) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

TEST(WorkerPool, RunsEveryStepOnce) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 3);
    std::atomic<int> steps = 0;
    const auto task = std::make_shared<FakeTask>("a", 0, 10, 90, 1, [&] { ++steps; });
    ASSERT_TRUE(scheduler.add(task));
    pool.wake();
    ASSERT_TRUE(wait_for(*task));
    EXPECT_EQ(steps, 100);
}

TEST(WorkerPool, RunsStepsAtTheSameTime) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 2);
    std::atomic<int> inside = 0;
    // Each step waits for the other; with one thread this would never end.
    const auto task = std::make_shared<FakeTask>("a", 0, 2, 0, 1, [&] {
        ++inside;
        for (int i = 0; i < 10'000 && inside < 2; ++i) std::this_thread::sleep_for(1ms);
    });
    ASSERT_TRUE(scheduler.add(task));
    pool.wake();
    ASSERT_TRUE(wait_for(*task));
    EXPECT_EQ(inside, 2);
}

TEST(WorkerPool, AStepThatThrowsFailsItsTaskAndTheWorkerLivesOn) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 1);
    const auto bad =
        std::make_shared<FakeTask>("bad", 5, 3, 0, 1, [] { throw std::runtime_error("no light"); });
    const auto odd = std::make_shared<FakeTask>("odd", 4, 3, 0, 1, [] { throw 7; });
    const auto huge =
        std::make_shared<FakeTask>("huge", 3, 3, 0, 1, [] { throw std::bad_alloc(); });
    const auto good = std::make_shared<FakeTask>("good", 0, 3, 0);
    for (const auto& task : {bad, odd, huge, good}) ASSERT_TRUE(scheduler.add(task));
    pool.wake();
    ASSERT_TRUE(wait_for(*good));
    EXPECT_EQ(bad->failure(), "internal error: no light");
    EXPECT_EQ(odd->failure(), "internal error");
    EXPECT_EQ(huge->failure(), "out of memory");
    EXPECT_EQ(good->failure(), "");
    EXPECT_EQ(good->steps_done(), 3);
}

// On one thread; the first step ends only when the other task's has run.
TEST(WorkerPool, WaitsForMemoryToChooseAStep) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 1);
    const auto task = std::make_shared<FakeTask>("a", 0, 3, 0);
    task->shortages = 2;
    ASSERT_TRUE(scheduler.add(task));
    pool.wake();
    ASSERT_TRUE(wait_for(*task));
    EXPECT_EQ(task->steps_done(), 3);
}

TEST(WorkerPool, ALongStepLosesItsPlace) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 1);
    std::promise<void> begun;
    std::promise<void> other_has_run;
    const auto step = [&] {
        begun.set_value();
        EXPECT_EQ(other_has_run.get_future().wait_for(20s), std::future_status::ready);
    };
    const auto slow = std::make_shared<FakeTask>("slow", 9, 1, 0, 1, step);
    ASSERT_TRUE(scheduler.add(slow));
    pool.wake();
    begun.get_future().wait();
    const auto other =
        std::make_shared<FakeTask>("other", 0, 1, 0, 1, [&] { other_has_run.set_value(); });
    ASSERT_TRUE(scheduler.add(other));
    pool.wake();
    EXPECT_TRUE(wait_for(*slow));
    EXPECT_TRUE(wait_for(*other));
}

// The spare workers are for others: of one task no more runs at a time, however long it takes.
TEST(WorkerPool, ATaskHasNeverMoreStepsUnderWayThanThereAreThreads) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 1);
    std::atomic<int> inside = 0;
    std::atomic<int> most = 0;
    std::promise<void> all_others_ran;
    const auto released = all_others_ran.get_future().share();
    const auto slow = std::make_shared<FakeTask>("slow", 9, 2, 0, 1, [&] {
        most = std::max<int>(most, ++inside);
        released.wait();
        --inside;
    });
    std::atomic<int> left = 50;
    const auto other = std::make_shared<FakeTask>("other", 0, 50, 0, 1, [&] {
        if (--left == 0) all_others_ran.set_value();
    });
    ASSERT_TRUE(scheduler.add(slow));
    ASSERT_TRUE(scheduler.add(other));
    pool.wake();
    EXPECT_TRUE(wait_for(*other));
    EXPECT_TRUE(wait_for(*slow));
    EXPECT_EQ(most, 1);
}

// Several tasks whose steps are long: each has its share of the spares, and all come back.
TEST(WorkerPool, WorkersOfLongStepsComeBack) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 2);
    for (int round = 0; round < 2; ++round) {
        std::promise<void> all_inside;
        std::atomic<int> inside = 0;
        const auto both = all_inside.get_future().share();
        std::vector<std::shared_ptr<FakeTask>> tasks;
        for (int i = 0; i < 3; ++i) {
            tasks.push_back(std::make_shared<FakeTask>("t", 0, 2, 0, 1, [&] {
                if (++inside == 6) all_inside.set_value();
                EXPECT_EQ(both.wait_for(20s), std::future_status::ready);
            }));
            ASSERT_TRUE(scheduler.add(tasks.back()));
        }
        pool.wake();
        for (const auto& task : tasks) EXPECT_TRUE(wait_for(*task)) << round;
    }
}

TEST(WorkerPool, StopLetsTheStepUnderWayEndAndBeginsNoOther) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 1);
    std::promise<void> begun;
    std::promise<void> go_on;
    std::atomic<int> steps = 0;
    const auto task = std::make_shared<FakeTask>("a", 0, 2, 0, 1, [&] {
        if (steps == 0) begun.set_value();
        go_on.get_future().wait();
        ++steps;
    });
    ASSERT_TRUE(scheduler.add(task));
    pool.wake();
    begun.get_future().wait();
    std::thread stopper([&] { pool.stop(); });
    std::this_thread::sleep_for(20ms);  // so that stop() is most likely waiting when the step ends
    EXPECT_EQ(steps, 0);
    go_on.set_value();
    stopper.join();
    EXPECT_EQ(steps, 1);
    EXPECT_FALSE(task->ended()) << "its second step was not begun";
}

TEST(WorkerPool, StopsWhenThereIsNothingToDoAndMayBeStoppedTwice) {
    Scheduler scheduler;
    WorkerPool pool(scheduler, 4);
    pool.stop();
    pool.stop();
    pool.wake();
}

}  // namespace
}  // namespace bouguer::server
