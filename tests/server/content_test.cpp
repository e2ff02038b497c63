// SPDX-License-Identifier: Apache-2.0
#include "server/content.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include "tests/server/unnamed_file.h"

namespace bouguer::server {
namespace {

using testing::unnamed_file;

TEST(Content, HasNothingAtFirst) {
    const Content nothing;
    EXPECT_EQ(nothing.size(), 0U);
    EXPECT_TRUE(nothing.empty());
    EXPECT_EQ(nothing.memory_bytes(), 0U);
    EXPECT_EQ(nothing.all().value(), "");
    EXPECT_EQ(nothing.part(3, 4).all().value(), "");
}

TEST(Content, ReadsTheSameFromMemoryAndFromAFile) {
    const std::string bytes = "0123456789";
    for (const Content& content :
         {Content(bytes), Content(unnamed_file("xx" + bytes + "yy"), 2, 10)}) {
        SCOPED_TRACE(content.is_in_memory() ? "memory" : "file");
        EXPECT_EQ(content.size(), 10U);
        EXPECT_EQ(content.all().value(), bytes);
        std::string text = "> ";
        ASSERT_TRUE(content.read(3, 4, text));
        EXPECT_EQ(text, "> 3456") << "what was there stays";
        ASSERT_TRUE(content.read(8, 100, text));
        EXPECT_EQ(text, "> 345689") << "no more than there is";
        ASSERT_TRUE(content.read(11, 1, text));
        EXPECT_EQ(text, "> 345689");
    }
}

TEST(Content, PartsOfPartsAreWhereTheyShouldBe) {
    for (const Content& content :
         {Content("0123456789"), Content(unnamed_file("0123456789"), 0, 10)}) {
        const Content part = content.part(2, 6);
        EXPECT_EQ(part.size(), 6U);
        EXPECT_EQ(part.all().value(), "234567");
        EXPECT_EQ(part.part(4, 100).all().value(), "67") << "never more than the part";
        EXPECT_EQ(content.part(20, 1).size(), 0U);
    }
}

TEST(Content, TellsTheMemoryThatItHolds) {
    const Content content(std::string(1000, 'x'));
    EXPECT_EQ(content.memory_bytes(), 1000U);
    EXPECT_EQ(content.part(1, 2).memory_bytes(), 1000U) << "a part keeps all of it";
    EXPECT_EQ(Content(unnamed_file("abc"), 0, 3).memory_bytes(), 0U);
}

TEST(Content, KeepsItsFileOpen) {
    Content part;
    {
        const Content whole(unnamed_file("0123456789"), 0, 10);
        part = whole.part(5, 5);
    }
    EXPECT_EQ(part.all().value(), "56789");
}

TEST(Content, AFileThatBecameShorterIsAnError) {
    const auto file = unnamed_file("0123456789");
    const Content content(file, 0, 10);
    ASSERT_EQ(::ftruncate(file->get(), 4), 0);
    std::string text = "kept";
    const auto got = content.read(2, 8, text);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().kind, ErrorKind::Internal);
    EXPECT_EQ(text, "kept");
    EXPECT_FALSE(content.all());
}

}  // namespace
}  // namespace bouguer::server
