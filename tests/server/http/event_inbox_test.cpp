// SPDX-License-Identifier: Apache-2.0
#include "server/http/event_inbox.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

using std::chrono::milliseconds;
const EventInbox::Clock::time_point kStart{std::chrono::hours(1)};

JobEvent event(std::uint64_t id, const std::string& type) {
    return {.id = id, .type = type, .data = "{}"};
}
std::string text(std::uint64_t id, const std::string& type) {
    return to_event_text(event(id, type));
}

TEST(EventInbox, WritesTheEventStreamFormat) {
    EXPECT_EQ(text(7, "preview"), "id: 7\nevent: preview\ndata: {}\n\n");
}

TEST(EventInbox, KeepsTheNewestProgressAndItsInterval) {
    EventInbox inbox(milliseconds(250), 1000);
    inbox.push(event(1, "progress"));
    EXPECT_EQ(inbox.take(kStart).text, text(1, "progress"));
    inbox.push(event(2, "progress"));
    inbox.push(event(3, "progress"));
    const auto early = inbox.take(kStart + milliseconds(249));
    EXPECT_EQ(early.text, "");
    EXPECT_TRUE(early.pending);
    const auto later = inbox.take(kStart + milliseconds(250));
    EXPECT_EQ(later.text, text(3, "progress"));
    EXPECT_FALSE(later.pending);
}

TEST(EventInbox, OtherEventsAreNotHeldBackAndKeepTheOrder) {
    EventInbox inbox(milliseconds(250), 1000);
    inbox.push(event(1, "progress"));
    inbox.push(event(2, "preview"));
    inbox.push(event(3, "done"));
    inbox.push(event(4, "progress"));  // nothing follows the end
    const auto taken = inbox.take(kStart);
    EXPECT_EQ(taken.text, text(1, "progress") + text(2, "preview") + text(3, "done"));
    EXPECT_TRUE(taken.ended);
}

TEST(EventInbox, WakesOnceUntilTaken) {
    EventInbox inbox(milliseconds(250), 1000);
    int woken = 0;
    inbox.push(event(1, "snapshot"));
    inbox.on_push([&] { ++woken; });
    EXPECT_EQ(woken, 1) << "what came before is told at once";
    inbox.push(event(2, "preview"));
    EXPECT_EQ(woken, 1);
    (void)inbox.take(kStart).text;
    inbox.push(event(3, "preview"));
    EXPECT_EQ(woken, 2);
}

TEST(EventInbox, GivesUpWhoDoesNotTake) {
    EventInbox inbox(milliseconds(250), 100);
    for (int i = 0; i < 10; ++i) inbox.push(event(1, "preview"));
    EXPECT_TRUE(inbox.take(kStart).overflow);
}

}  // namespace
}  // namespace bouguer::server
