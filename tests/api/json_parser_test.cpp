// SPDX-License-Identifier: Apache-2.0
#include "api/json_parser.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "api/json_text.h"
#include "tests/api/json_testing.h"
#include "tests/support/source_folder.h"

namespace bouguer::api {
namespace {

namespace fs = std::filesystem;

std::string canonical(std::string_view text) { return canonical_text(tests::tree_of(text).root()); }

/// What the library itself makes of the text: what all digests were made of so far.
std::string by_library(std::string_view text) { return nlohmann::json::parse(text).dump(); }

/// Pointer and code of the only problem of a text.
std::string problem_of(std::string_view text) {
    const auto tree = read_json_tree(text, Limits{});
    if (tree || tree.error().problems.size() != 1) return "none or several";
    return tree.error().problems[0].pointer + " " + tree.error().problems[0].code;
}

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// The digests of documents are those of their canonical text: none may ever change.
TEST(JsonParser, WritesWhatTheLibraryWrites) {
    constexpr std::array kTexts{
        "[]",
        "{}",
        "\"\"",
        "null",
        "[true, false, null]",
        "[1, 1.0, -1, -0, -0.0, 0, 0.0, 1e2, 100]",
        "[9007199254740992, 9007199254740993, -9007199254740993, 9223372036854775807]",
        "[9223372036854775808, 18446744073709551615, 18446744073709551616, -9223372036854775808]",
        "[0.1, 1e-300, 5e-324, 1.7976931348623157e308, 123456789012345680000, 1e21, 1e-7]",
        "[[1, 2, 3], [4, 5, 6]]",
        "[[1, 2, 3], [4, 5]]",
        "[[1, 2], [3, 4], \"end\"]",
        "[[1, 2], [3, 4], 5]",
        "[1, 2, [3]]",
        "[[], [1], []]",
        "[[1], []]",
        "[[[1, 2], [3, 4]], [[5, 6], [7, 8]]]",
        "[[1, 2], [3, 18446744073709551615]]",
        "[1, {\"b\": [1, 2], \"a\": [[1], [2]]}, 2]",
        "{\"b\": 1, \"a\": {\"d\": [1, 2], \"c\": \"x\"}, \"\": 0, \"\\u00e4\": 1, \"z\": 2}",
        "[\"a\\\"b\\\\c\\/\\b\\f\\n\\r\\t\\u0000\\u001f\\u007f\\u2028 \\ud834\\udd1e\"]",
    };
    for (const std::string_view text : kTexts) EXPECT_EQ(canonical(text), by_library(text));
}

TEST(JsonParser, WritesScenesAsTheLibraryDoes) {
    const fs::path root = tests::source_folder() / "client-examples/scenes";
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".json") continue;
        const std::string text = text_of(entry.path());
        EXPECT_TRUE(canonical(text) == by_library(text)) << entry.path();
    }
}

/// A random document, small and deep enough for every way of packing.
nlohmann::json random_json(std::mt19937& random, int depth) {
    const auto below = [&](int n) { return std::uniform_int_distribution(0, n - 1)(random); };
    const auto number = [&]() -> nlohmann::json {
        if (below(2) == 0) return below(7) - 3;
        return std::ldexp(below(1 << 20) - (1 << 19), below(80) - 50);
    };
    const auto many = [&](const auto& one) {
        auto array = nlohmann::json::array();
        for (int i = below(5); i > 0; --i) array.push_back(one());
        return array;
    };
    switch (below(depth > 0 ? 8 : 4)) {
        case 0:
            return number();
        case 1:
            return std::string(static_cast<std::size_t>(below(4)), 'x');
        case 2:
            return below(2) == 0;
        case 3:
            return many(number);
        case 4: {
            const int width = 1 + below(3);
            return many([&] {
                auto row = nlohmann::json::array();
                for (int i = 0; i < width; ++i) row.push_back(number());
                return row;
            });
        }
        case 5: {
            auto object = nlohmann::json::object();
            for (int i = below(30); i > 0; --i)
                object[std::to_string(below(1000))] = random_json(random, depth - 1);
            return object;
        }
        default:
            return many([&] { return random_json(random, depth - 1); });
    }
}

TEST(JsonParser, WritesRandomDocumentsAsTheLibraryDoes) {
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const std::string text = random_json(random, 4).dump();
        ASSERT_EQ(canonical(text), text);
    }
}

TEST(JsonParser, KeepsRowsOfNumbersPacked) {
    const JsonTree tree = tests::tree_of("[[0, 0.5, 1], [2, 3, 4], [5, 6, 7e0]]");
    const Json rows = tree.root();
    ASSERT_EQ(rows.size(), 3U);
    const auto last = rows[2].packed_numbers();
    ASSERT_EQ(last.size(), 3U);
    EXPECT_EQ(last.data(), rows[0].packed_numbers().data() + 6);
    EXPECT_EQ(last[2], 7);
    EXPECT_TRUE(rows[2][1].is_whole());
    EXPECT_FALSE(rows[2][2].is_whole());
}

std::string numbered_key(int i) {
    std::ostringstream key;
    key << 'k' << i;
    return key.str();
}

TEST(JsonParser, FindsTheMembersOfObjectsOfAnySize) {
    for (const int size : {0, 1, 16, 17, 18, 100}) {
        std::ostringstream members;
        for (int i = 0; i < size; ++i) members << (i > 0 ? "," : "") << "\"k" << i << "\":" << i;
        std::string text("{");
        text += members.str();
        const JsonTree tree = tests::tree_of(text + "}");
        for (int i = 0; i < size; ++i) {
            const auto member = tree.root().find(numbered_key(i));
            ASSERT_TRUE(member);
            EXPECT_EQ(member->integer(), i);
        }
        EXPECT_FALSE(tree.root().contains("k"));
        if (size == 0) continue;
        for (const int again : {0, size - 1}) {
            const std::string key = numbered_key(again);
            EXPECT_EQ(problem_of(text + ",\"" + key + "\":0}"), "/" + key + " duplicate-key");
        }
    }
}

TEST(JsonParser, PointsIntoArraysAndObjects) {
    EXPECT_EQ(problem_of("[[1, 2], [3, 4], [5, 1e999]]"), "/2/1 not-finite");
    EXPECT_EQ(problem_of("[[1, 2], [3], [1e999]]"), "/2/0 not-finite");
    EXPECT_EQ(problem_of(R"({"a": [1, {"b/c": [0, "x", 1e999]}]})"), "/a/1/b~1c/2 not-finite");
    EXPECT_EQ(problem_of(R"([0, {"a": 1, "b": {}, "a": 2}])"), "/1/a duplicate-key");
}

// RFC 8259, 2: white space alone may follow the value. The library ends at a NUL and says well.
TEST(JsonParser, RefusesWhatFollowsANul) {
    for (const std::string_view after : {"", " ", "junk", "\0", "{}"}) {
        std::string text("{\"a\": [1]}");
        text += '\0';
        text += after;
        EXPECT_EQ(problem_of(text), " not-json");
    }
    EXPECT_EQ(problem_of(std::string("{}\n\0", 4)), " not-json");
    EXPECT_EQ(problem_of(std::string("\0{}", 3)), " not-json");
    EXPECT_EQ(problem_of(std::string("{\"a\0\": 1}", 9)), " not-json");
    const auto tree = read_json_tree(std::string("{}\n  \0", 6), Limits{});
    ASSERT_FALSE(tree);
    EXPECT_EQ(tree.error().kind, ErrorKind::Malformed);
    EXPECT_NE(tree.error().problems[0].detail.find("line 2, column 3"), std::string::npos)
        << tree.error().problems[0].detail;
}

}  // namespace
}  // namespace bouguer::api
