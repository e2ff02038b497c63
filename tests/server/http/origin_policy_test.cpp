// SPDX-License-Identifier: Apache-2.0
#include "server/http/origin_policy.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

bool is_same(std::string_view origin, std::string_view host) {
    return is_same_origin(origin, authority_from(host));
}

TEST(OriginPolicy, TheSameHostAndPortIsTheSameOrigin) {
    EXPECT_TRUE(is_same("http://localhost:8080", "localhost:8080"));
    EXPECT_TRUE(is_same("http://LOCALHOST:8080", "localhost:8080"));
    EXPECT_TRUE(is_same("http://[::1]:8080", "[0:0::1]:8080"));
    EXPECT_TRUE(is_same("http://a.example", "a.example:80"));
    EXPECT_TRUE(is_same("https://a.example:443", "a.example")) << "behind a proxy that ends TLS";
    EXPECT_TRUE(is_same("HTTPS://a.example", "a.example"));
}

TEST(OriginPolicy, EverythingElseIsAnother) {
    EXPECT_FALSE(is_same("http://localhost:8081", "localhost:8080"));
    EXPECT_FALSE(is_same("http://localhost", "localhost:8080"));
    EXPECT_FALSE(is_same("https://a.example", "a.example:80"));
    EXPECT_FALSE(is_same("http://127.0.0.1:8080", "localhost:8080"));
    EXPECT_FALSE(is_same("null", "localhost:8080"));
    EXPECT_FALSE(is_same("ftp://localhost", "localhost"));
    EXPECT_FALSE(is_same("http://localhost/", "localhost"));
    EXPECT_FALSE(is_same("http://user@localhost", "localhost"));
    EXPECT_FALSE(is_same_origin("http://localhost", std::nullopt));
}

TEST(OriginPolicy, AStarIsForReadingOnly) {
    const std::vector<std::string> all{"*"};
    EXPECT_TRUE(may_read(all, "https://a.example"));
    EXPECT_FALSE(may_change(all, "https://a.example"));
    EXPECT_FALSE(may_change(all, "*"));
    const std::vector<std::string> one{"*", "https://a.example"};
    EXPECT_TRUE(may_change(one, "https://a.example"));
    EXPECT_FALSE(may_change(one, "https://b.example"));
    EXPECT_FALSE(may_read({"https://a.example"}, "https://b.example"));
}

}  // namespace
}  // namespace bouguer::server
