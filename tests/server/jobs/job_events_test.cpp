// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_events.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>

namespace bouguer::server {
namespace {

using Greeting = JobEvents::Greeting;

/// A listener that writes types and data into a string.
struct Diary {
    std::mutex mutex;
    std::string text;
    std::uint64_t last_id = 0;
    bool ids_grow = true;

    EventListener listener() {
        return [this](const JobEvent& event) {
            const std::lock_guard lock(mutex);
            text += event.type + ":" + event.data + " ";
            ids_grow = ids_grow && event.id > last_id;
            last_id = event.id;
        };
    }
};

auto running(const std::string& data) {
    return [data]() -> Result<Greeting> { return Greeting{data, false}; };
}

TEST(JobEvents, BeginsWithTheSnapshotAndEndsWithDone) {
    JobEvents events;
    Diary diary;
    const auto subscription = events.subscribe("a", diary.listener(), running("0"));
    ASSERT_TRUE(subscription);
    EXPECT_EQ(diary.text, "snapshot:0 ");
    events.publish("a", "progress", "1");
    events.publish("b", "progress", "of another job");
    events.publish("a", "done", "2");
    events.publish("a", "progress", "of a straggler");
    EXPECT_EQ(diary.text, "snapshot:0 progress:1 done:2 ");
    EXPECT_TRUE(diary.ids_grow);
}

TEST(JobEvents, WhatHappensDuringTheGreetingComesAfterTheSnapshot) {
    JobEvents events;
    Diary diary;
    const auto subscription = events.subscribe("a", diary.listener(), [&]() -> Result<Greeting> {
        events.publish("a", "progress", "early");
        return Greeting{"0", false};
    });
    EXPECT_EQ(diary.text, "snapshot:0 progress:early ");
    EXPECT_TRUE(diary.ids_grow);
}

TEST(JobEvents, AnEndedJobIsDoneAtOnce) {
    JobEvents events;
    Diary diary;
    const auto subscription = events.subscribe("a", diary.listener(), [&]() -> Result<Greeting> {
        events.publish("a", "done", "the same end, seen twice");
        return Greeting{"0", true};
    });
    EXPECT_EQ(diary.text, "snapshot:0 done:0 ");
}

TEST(JobEvents, WithoutAGreetingThereIsNoSubscription) {
    JobEvents events;
    Diary diary;
    const auto subscription = events.subscribe(
        "a", diary.listener(), []() -> Result<Greeting> { return fail(ErrorKind::NotFound, ""); });
    EXPECT_FALSE(subscription);
    events.publish("a", "progress", "1");
    EXPECT_EQ(diary.text, "");
    EXPECT_EQ(events.num_listeners(), 0U);
}

TEST(JobEvents, NothingComesAfterTheEndOfTheSubscription) {
    JobEvents events;
    Diary diary;
    auto subscription = events.subscribe("a", diary.listener(), running("0"));
    ASSERT_TRUE(subscription);
    subscription->reset();
    events.publish("a", "progress", "1");
    EXPECT_EQ(diary.text, "snapshot:0 ");
    EXPECT_EQ(events.num_listeners(), 0U);
}

TEST(JobEvents, EndingASubscriptionWaitsForTheCallUnderWay) {
    JobEvents events;
    std::promise<void> inside;
    std::promise<void> go_on;
    std::atomic<bool> left = false;
    auto subscription = events.subscribe(
        "a",
        [&](const JobEvent& event) {
            if (event.type != "progress") return;
            inside.set_value();
            go_on.get_future().wait();
            left = true;
        },
        running("0"));
    ASSERT_TRUE(subscription);
    std::thread publisher([&] { events.publish("a", "progress", "1"); });
    inside.get_future().wait();
    std::thread helper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        go_on.set_value();
    });
    subscription->reset();
    EXPECT_TRUE(left);
    publisher.join();
    helper.join();
}

TEST(JobEvents, AListenerMayEndItsOwnSubscription) {
    JobEvents events;
    std::unique_ptr<Subscription> subscription;
    int calls = 0;
    auto made = events.subscribe(
        "a",
        [&](const JobEvent&) {
            ++calls;
            subscription.reset();
        },
        running("0"));
    ASSERT_TRUE(made);
    subscription = std::move(*made);
    events.publish("a", "progress", "1");
    events.publish("a", "progress", "2");
    EXPECT_EQ(calls, 2);  // the snapshot and the first
}

TEST(JobEvents, KeepsTheOrderWhenManyThreadsPublish) {
    JobEvents events;
    Diary diary;
    const auto subscription = events.subscribe("a", diary.listener(), running("0"));
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&] {
                for (int i = 0; i < 200; ++i) events.publish("a", "progress", "");
            });
        }
    }
    const std::lock_guard lock(diary.mutex);
    EXPECT_TRUE(diary.ids_grow);
    EXPECT_EQ(diary.text.size(), 11 + 800 * std::string("progress: ").size());
}

}  // namespace
}  // namespace bouguer::server
