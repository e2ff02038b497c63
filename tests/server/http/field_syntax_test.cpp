// SPDX-License-Identifier: Apache-2.0
#include "server/http/field_syntax.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(FieldSyntax, KnowsTokensAndValues) {
    EXPECT_TRUE(is_token("X-a.b_1~"));
    for (const char* text : {"", "a b", "a:", "\"a\"", "\xc3\xa4"}) EXPECT_FALSE(is_token(text));
    EXPECT_TRUE(is_field_value("a b\t\xc3\xa4"));
    for (const char* text : {"\r", "\n", "\x01", "\x7f"}) EXPECT_FALSE(is_field_value(text));
}

TEST(FieldSyntax, KnowsQuotedStrings) {
    for (const char* text : {R"("")", R"("a b;c")", R"("\"")", R"("a\\")"}) {
        EXPECT_TRUE(is_quoted_string(text)) << text;
    }
    for (const char* text : {"", R"(")", "a", R"("a)", R"(a")", R"("a"b")", R"("\")", "\"\r\""}) {
        EXPECT_FALSE(is_quoted_string(text)) << text;
    }
}

TEST(FieldSyntax, KnowsFieldLines) {
    EXPECT_TRUE(is_field_line("A: b"));
    EXPECT_TRUE(is_field_line("A:"));
    for (const char* line : {"", "A", ": b", "A : b", " A: b", "A: \r"}) {
        EXPECT_FALSE(is_field_line(line)) << line;
    }
}

TEST(FieldSyntax, TrimsAndComparesWithoutCase) {
    EXPECT_EQ(trimmed(" \ta b\t "), "a b");
    EXPECT_EQ(trimmed("  "), "");
    EXPECT_TRUE(equal_ignoring_case("ETag", "etAG"));
    EXPECT_FALSE(equal_ignoring_case("a", "ab"));
}

}  // namespace
}  // namespace bouguer::server
