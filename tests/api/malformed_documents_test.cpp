// SPDX-License-Identifier: Apache-2.0
#include "tests/api/malformed_documents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "api/job_document.h"
#include "api/writers.h"
#include "tests/api/fake_assets.h"

namespace bouguer::api {
namespace {

using Places = std::vector<std::pair<std::string, std::string>>;

Places places_of(const Error& error) {
    Places places;
    for (const Problem& problem : error.problems) {
        places.emplace_back(problem.pointer, problem.code);
    }
    std::sort(places.begin(), places.end());
    return places;
}

std::string lines_of(const Places& places) {
    std::string lines;
    for (const auto& [pointer, code] : places) lines += "  " + pointer + "  " + code + "\n";
    return lines;
}

TEST(MalformedDocuments, AreRefusedWithEveryPointerAndCode) {
    const auto documents = tests::malformed_documents();
    EXPECT_GE(documents.size(), 200U);
    for (const tests::MalformedDocument& document : documents) {
        const auto job = parse_job(document.body, Limits{}, tests::FakeAssets{});
        if (job) {
            ADD_FAILURE() << document.name << ": was accepted";
            continue;
        }
        EXPECT_EQ(status_of(job.error()), document.status) << document.name;
        EXPECT_EQ(lines_of(places_of(job.error())), lines_of(document.problems)) << document.name;
    }
}

// Everything a client is told is short text, whatever stood in the document.
TEST(MalformedDocuments, AreReportedInShort) {
    for (const tests::MalformedDocument& document : tests::malformed_documents()) {
        const auto job = parse_job(document.body, Limits{}, tests::FakeAssets{});
        ASSERT_FALSE(job) << document.name;
        for (const Problem& problem : job.error().problems) {
            EXPECT_FALSE(problem.detail.empty()) << document.name;
            EXPECT_LT(problem.found.size(), 400U) << document.name;
            EXPECT_LT(problem.detail.size() + problem.allowed.size(), 800U) << document.name;
        }
        EXPECT_LT(problem_json(job.error()).size(), 20'000U) << document.name;
    }
}

}  // namespace
}  // namespace bouguer::api
