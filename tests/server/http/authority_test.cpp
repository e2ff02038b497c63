// SPDX-License-Identifier: Apache-2.0
#include "server/http/authority.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(Authority, ReadsHostAndPort) {
    EXPECT_EQ(authority_from("localhost"), (Authority{"localhost", std::nullopt}));
    EXPECT_EQ(authority_from("Render.Example:8080"), (Authority{"render.example", 8080}));
    EXPECT_EQ(authority_from("127.0.0.1:80"), (Authority{"127.0.0.1", 80}));
    EXPECT_EQ(authority_from("[::1]:8080"), (Authority{"::1", 8080}));
    EXPECT_EQ(authority_from("[0:0::0:1]"), (Authority{"::1", std::nullopt})) << "the same address";
    EXPECT_EQ(authority_from("localhost:"), (Authority{"localhost", std::nullopt}));
    EXPECT_EQ(authority_from("localhost.:1"), (Authority{"localhost", 1})) << "the root's dot";
}

TEST(Authority, RefusesTheRest) {
    for (const char* text : {"", ":80", "user@localhost", "a b", "a:b", "a:-1", "a:+1", "a:65536",
                             "a:80:80", "::1", "[::1", "[::1]80", "[localhost]", "[]",
                             "local%68ost", "a/b", "a,b", "\xc3\xa4.example"}) {
        EXPECT_FALSE(authority_from(text)) << text;
    }
}

TEST(Authority, KnowsAddresses) {
    for (const char* host : {"127.0.0.1", "10.0.0.1", "::1", "fe80::1"}) {
        EXPECT_TRUE(is_address(host)) << host;
    }
    for (const char* host : {"localhost", "127.0.0.1.example", "127.1", "1", "0x7f000001", ""}) {
        EXPECT_FALSE(is_address(host)) << host;
    }
}

TEST(Authority, KnowsLoopback) {
    for (const char* host : {"127.0.0.1", "127.255.255.254", "::1", "localhost"}) {
        EXPECT_TRUE(is_loopback(host)) << host;
    }
    for (const char* host : {"0.0.0.0", "::", "128.0.0.1", "10.0.0.1", "::ffff:10.0.0.1",
                             "127.0.0.1.example", "localhost.example", ""}) {
        EXPECT_FALSE(is_loopback(host)) << host;
    }
}

}  // namespace
}  // namespace bouguer::server
