// SPDX-License-Identifier: Apache-2.0
#include "server/http/outgoing.h"

#include <gtest/gtest.h>

#include "tests/server/unnamed_file.h"

namespace bouguer::server {
namespace {

using testing::numbered_bytes;
using testing::unnamed_file;

/// All of it in steps of `step`, windows read when they are asked for; how many were.
std::string sent_in_steps(Outgoing out, std::size_t step, int& windows) {
    std::string sent;
    for (;;) {
        if (out.needs_window()) {
            ++windows;
            const Content next = out.next_window();
            EXPECT_LE(next.size(), Outgoing::kWindowBytes);
            std::string window = out.take_room();
            EXPECT_TRUE(window.empty());
            EXPECT_TRUE(next.read(0, next.size(), window));
            out.supply(std::move(window));
        }
        const std::string_view ready = out.ready().substr(0, step);
        if (ready.empty()) return sent;
        sent += ready;
        out.sent(ready.size());
    }
}

TEST(Outgoing, SendsTheBytesAndThenTheContent) {
    const std::string body = numbered_bytes(3 * Outgoing::kWindowBytes / 2);
    for (const Content& content : {Content(body), Content(unnamed_file(body), 0, body.size())}) {
        SCOPED_TRACE(content.is_in_memory() ? "memory" : "file");
        int windows = 0;
        EXPECT_EQ(sent_in_steps(Outgoing("head", content), 1000, windows), "head" + body);
        EXPECT_EQ(windows, content.is_in_memory() ? 0 : 2);
    }
    int windows = 0;
    EXPECT_EQ(sent_in_steps(Outgoing("head"), 3, windows), "head");
    EXPECT_EQ(sent_in_steps(Outgoing(), 3, windows), "");
    EXPECT_EQ(windows, 0);
}

TEST(Outgoing, HoldsAFileByAWindowAndMemoryAsAWhole) {
    constexpr std::size_t kLarge = 3 * Outgoing::kWindowBytes;
    EXPECT_GE(Outgoing::held_bytes("head", Content(std::string(kLarge, 'x'))), kLarge);
    const Content file(unnamed_file(std::string(kLarge, 'x')), 0, kLarge);
    EXPECT_EQ(Outgoing::held_bytes("head", file), Outgoing::kWindowBytes);
    EXPECT_LE(Outgoing::held_bytes("head", file.part(0, 100)), 100U);
}

}  // namespace
}  // namespace bouguer::server
