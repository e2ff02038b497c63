// SPDX-License-Identifier: Apache-2.0
#include "server/http/query.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

httplib::Request request_for(std::string_view target) {
    httplib::Request request;
    request.params = params_of(target);
    return request;
}

TEST(Query, HasEveryParameterAsOftenAsItIsThere) {
    EXPECT_EQ(params_of("/a"), httplib::Params());
    EXPECT_EQ(params_of("/a?"), httplib::Params());
    EXPECT_EQ(params_of("/a?b=c&&b=c&d=e=f?&g&=h"),
              (httplib::Params{{"", "h"}, {"b", "c"}, {"b", "c"}, {"d", "e=f?"}, {"g", ""}}));
    EXPECT_EQ(params_of("/%3f?%62=%2B+%26%00"), (httplib::Params{{"b", std::string("+ &\0", 4)}}));
}

TEST(Query, WhatIsThereTwiceIsRefused) {
    EXPECT_TRUE(query_of(request_for("/x?b=1&a=&v=1&v=1")));
    EXPECT_FALSE(query_of(request_for("/x?a=1&a=2")));
    EXPECT_FALSE(query_of(request_for("/x?a=1&a=1"))) << "alike, too";
}

TEST(Query, WhatNobodyHasTakenIsRefused) {
    auto query = query_of(request_for("/x?a=1&b=2&c=3"));
    ASSERT_TRUE(query);
    EXPECT_EQ(take_optional(*query, "a"), "1");
    EXPECT_EQ(take_optional(*query, "a"), std::nullopt);
    const auto refused = expect_empty(*query);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "invalid-query");
    EXPECT_EQ(refused.error().problems.size(), 2U) << "all at once";
    EXPECT_TRUE(expect_empty({}));
}

}  // namespace
}  // namespace bouguer::server
