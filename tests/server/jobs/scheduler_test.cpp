// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/scheduler.h"

#include <gtest/gtest.h>

#include "tests/server/jobs/fake_task.h"

namespace bouguer::server {
namespace {

/// So that many of them fit into a turn.
constexpr double kShort = 0.01;

/// The ids of the next `n` steps, each run and charged `seconds` before the next is asked for.
std::string run_steps(Scheduler& scheduler, int n, double seconds = 1) {
    std::string ids;
    for (int i = 0; i < n; ++i) {
        auto work = scheduler.next();
        if (!work) break;
        work->run();
        scheduler.charge(*work->task, seconds);
        ids += work->task->id();
    }
    return ids;
}

std::shared_ptr<FakeTask> task(const char* id, int priority, int first, int later,
                               std::uint64_t memory = 1) {
    return std::make_shared<FakeTask>(id, priority, first, later, memory);
}

TEST(Scheduler, HasNothingToDoWhenEmpty) {
    Scheduler scheduler;
    EXPECT_FALSE(scheduler.next());
}

TEST(Scheduler, GivesEveryStepOnceAndForgetsTheTask) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 2, 3)));
    EXPECT_EQ(run_steps(scheduler, 100), "aaaaa");
    EXPECT_EQ(scheduler.num_active(), 0U);
    EXPECT_EQ(scheduler.num_waiting(), 0U);
}

TEST(Scheduler, RefusesMoreThanItsBound) {
    Scheduler scheduler({.tasks = 2});
    ASSERT_TRUE(scheduler.add(task("a", 0, 1, 0)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 1, 0)));
    EXPECT_TRUE(scheduler.full());
    const auto refused = scheduler.add(task("c", 9, 1, 0));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::Busy);
    run_steps(scheduler, 1);
    EXPECT_TRUE(scheduler.add(task("d", 0, 1, 0))) << "an ended task makes room";
}

// A restart has to take up what was accepted, however much it is.
TEST(Scheduler, TakesAcceptedTasksAgainBeyondItsBound) {
    Scheduler scheduler({.tasks = 1});
    ASSERT_TRUE(scheduler.add(task("a", 0, 1, 0)));
    scheduler.add_again(task("b", 0, 1, 0));
    EXPECT_EQ(run_steps(scheduler, 10), "ab");
}

TEST(Scheduler, AFirstPassGoesBeforeLaterPasses) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 2, 4)));
    EXPECT_EQ(run_steps(scheduler, 3, kShort), "aaa");
    ASSERT_TRUE(scheduler.add(task("b", 0, 2, 0)));
    EXPECT_EQ(run_steps(scheduler, 10, kShort), "bbaaa");
}

// Urgency comes before priority: a low job's first pass before a high job's later ones.
TEST(Scheduler, AFirstPassGoesEvenBeforeLaterPassesOfHigherPriority) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("h", 5, 1, 2)));
    EXPECT_EQ(run_steps(scheduler, 2), "hh");
    ASSERT_TRUE(scheduler.add(task("l", -5, 1, 1)));
    EXPECT_EQ(run_steps(scheduler, 10), "lhl");
}

TEST(Scheduler, HigherPriorityGoesFirstAmongFirstPasses) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("l", -1, 1, 0)));
    ASSERT_TRUE(scheduler.add(task("m", 0, 1, 0)));
    ASSERT_TRUE(scheduler.add(task("h", 7, 1, 0)));
    EXPECT_EQ(run_steps(scheduler, 10), "hml");
}

TEST(Scheduler, OlderGoesFirstAmongEqualFirstPasses) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 2, 0)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 2, 0)));
    EXPECT_EQ(run_steps(scheduler, 10, kShort), "aabb");
}

// A turn is 0.25 s of a thread; steps of 0.125 s: two of them.
TEST(Scheduler, FirstPassesTakeTurns) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 6, 0)));
    EXPECT_EQ(run_steps(scheduler, 2, 0.125), "aa");
    ASSERT_TRUE(scheduler.add(task("b", 0, 4, 0)));
    ASSERT_TRUE(scheduler.add(task("c", 0, 1, 0)));
    EXPECT_EQ(run_steps(scheduler, 20, 0.125), "bbcaabbaa");
}

// Whoever has had a second of a thread without coming to the end of its first pass is no longer
// urgent: a newcomer goes first, and later passes have their share.
TEST(Scheduler, ALongFirstPassSharesWithLaterPasses) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 100, 0)));
    EXPECT_EQ(run_steps(scheduler, 4, 0.5), "aaaa");
    ASSERT_TRUE(scheduler.add(task("b", 0, 1, 3)));
    // b begins with the 2 s that a has had and takes its first pass; then whoever has had less time
    // goes, and of two that have had the same the older: half and half.
    EXPECT_EQ(run_steps(scheduler, 8, 0.5), "baababab");
}

TEST(Scheduler, GivesOneTaskOnlySoManyStepsAtATime) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 5, 0)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 5, 0)));
    std::vector<Scheduler::Work> under_way;
    std::string ids;
    while (auto work = scheduler.next(2)) {
        ids += work->task->id();
        under_way.push_back(std::move(*work));
    }
    EXPECT_EQ(ids, "aabb");
    under_way.front().run();
    scheduler.charge(*under_way.front().task, kShort);
    EXPECT_EQ(scheduler.next(2)->task->id(), "a");
}

TEST(Scheduler, EqualsShareTheirLaterPasses) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 1, 3)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 1, 3)));
    EXPECT_EQ(run_steps(scheduler, 10), "abababab");
}

// Steps of a cost three times as much: b gets three steps for each of a.
TEST(Scheduler, SharesTimeAndNotSteps) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 0, 100)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 0, 100)));
    int a = 0;
    int b = 0;
    for (int i = 0; i < 80; ++i) {
        auto work = scheduler.next();
        ASSERT_TRUE(work);
        const bool is_a = work->task->id() == "a";
        ++(is_a ? a : b);
        work->run();
        scheduler.charge(*work->task, is_a ? 3.0 : 1.0);
    }
    EXPECT_EQ(a, 20);
    EXPECT_EQ(b, 60);
}

// Otherwise a long job would starve while newcomers make up for time before they came.
TEST(Scheduler, ANewcomerDoesNotMakeUpForThePast) {
    Scheduler scheduler;
    ASSERT_TRUE(scheduler.add(task("a", 0, 0, 100)));
    run_steps(scheduler, 50);
    ASSERT_TRUE(scheduler.add(task("b", 0, 0, 100)));
    EXPECT_EQ(run_steps(scheduler, 6), "ababab");
}

TEST(Scheduler, ActivatesOnlyWhatFitsIntoMemory) {
    Scheduler scheduler({.memory_bytes = 10});
    ASSERT_TRUE(scheduler.add(task("a", 0, 1, 2, 6)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 1, 1, 5)));
    ASSERT_TRUE(scheduler.add(task("c", 0, 1, 1, 1)));
    EXPECT_EQ(run_steps(scheduler, 1), "a");
    EXPECT_EQ(scheduler.num_active(), 1U) << "b does not fit, and c does not overtake it";
    EXPECT_EQ(run_steps(scheduler, 10), "aabcbc");
}

TEST(Scheduler, ATaskLargerThanMemoryRunsAlone) {
    Scheduler scheduler({.memory_bytes = 10});
    ASSERT_TRUE(scheduler.add(task("a", 0, 1, 1, 100)));
    ASSERT_TRUE(scheduler.add(task("b", 0, 1, 0, 1)));
    EXPECT_EQ(run_steps(scheduler, 10), "aab");
}

TEST(Scheduler, DropsOnlyWhatWaits) {
    Scheduler scheduler({.active_tasks = 1});
    const auto a = task("a", 0, 1, 1);
    const auto b = task("b", 0, 1, 1);
    ASSERT_TRUE(scheduler.add(a));
    ASSERT_TRUE(scheduler.add(b));
    run_steps(scheduler, 1);
    scheduler.drop(*a);
    scheduler.drop(*b);
    EXPECT_EQ(scheduler.num_waiting(), 0U);
    EXPECT_EQ(run_steps(scheduler, 10), "a");
}

}  // namespace
}  // namespace bouguer::server
