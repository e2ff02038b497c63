// SPDX-License-Identifier: Apache-2.0
#include "server/http/content_reader.h"

#include <gtest/gtest.h>

#include <future>

#include "tests/server/unnamed_file.h"

namespace bouguer::server {
namespace {

using testing::unnamed_file;
using Delivered = std::pair<std::uint64_t, Result<std::string>>;

TEST(ContentReader, ReadsOnItsOwnThread) {
    std::promise<Delivered> delivered;
    std::thread::id where;
    ContentReader reader([&](std::uint64_t connection, Result<std::string> bytes) {
        where = std::this_thread::get_id();
        delivered.set_value({connection, std::move(bytes)});
    });
    reader.ask({7, Content(unnamed_file("0123456789"), 2, 5), {}});
    const Delivered got = delivered.get_future().get();
    EXPECT_EQ(got.first, 7U);
    EXPECT_EQ(got.second.value(), "23456");
    EXPECT_NE(where, std::this_thread::get_id());
}

TEST(ContentReader, TellsWhatCannotBeRead) {
    std::promise<Delivered> delivered;
    ContentReader reader([&](std::uint64_t connection, Result<std::string> bytes) {
        delivered.set_value({connection, std::move(bytes)});
    });
    reader.ask({1, Content(unnamed_file("short"), 0, 100), {}});
    EXPECT_FALSE(delivered.get_future().get().second);
}

TEST(ContentReader, StopsWithWorkLeft) {
    std::atomic<int> read{0};
    const Content content(unnamed_file("abc"), 0, 3);
    ContentReader reader([&](std::uint64_t, const Result<std::string>&) { ++read; });
    for (std::uint64_t i = 0; i < 1000; ++i) reader.ask({i, content, {}});
    reader.stop();
    const int before = read;
    reader.stop();
    EXPECT_EQ(read, before);
}

}  // namespace
}  // namespace bouguer::server
