// SPDX-License-Identifier: Apache-2.0
#include "server/log_text.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(LogText, LeavesWhatCanBeSeen) {
    for (const char* text : {R"({"name":"Kugel \"grün\" 球 🎨","n":1})", "", "\xc2\xa0"}) {
        EXPECT_EQ(escape_invisible(text), text);
    }
}

// The override of direction shows "gpj.exe" as "exe.jpg".
TEST(LogText, EscapesMarksOfDirection) {
    EXPECT_EQ(escape_invisible("\"\u202egpj.exe\""), R"("\u202egpj.exe")");
    EXPECT_EQ(escape_invisible("\u200e\u200f\u061c\u2066\u2067\u2068\u2069"),
              R"(\u200e\u200f\u061c\u2066\u2067\u2068\u2069)");
    EXPECT_EQ(escape_invisible("\u202a\u202b\u202c\u202d"), R"(\u202a\u202b\u202c\u202d)");
}

TEST(LogText, EscapesControlsSeparatorsAndWhatHasNoWidth) {
    EXPECT_EQ(escape_invisible("\x7f\xc2\x80\xc2\x9b\xc2\x9f"), R"(\u007f\u0080\u009b\u009f)");
    EXPECT_EQ(escape_invisible("\u2028\u2029\u200b\ufeff"), R"(\u2028\u2029\u200b\ufeff)");
    EXPECT_EQ(escape_invisible("\U000e0041"), R"(\udb40\udc41)") << "a pair of UTF-16";
}

TEST(LogText, DoesNotReadBeyondTheEnd) { EXPECT_EQ(escape_invisible("\xe2\x80").size(), 2U); }

}  // namespace
}  // namespace bouguer::server
