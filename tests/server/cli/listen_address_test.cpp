// SPDX-License-Identifier: Apache-2.0
#include "server/cli/listen_address.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(ListenAddress, ReadsHostAndPort) {
    EXPECT_EQ(listen_address_from("127.0.0.1:8080")->host, "127.0.0.1");
    EXPECT_EQ(listen_address_from("127.0.0.1:8080")->port, 8080);
    EXPECT_EQ(listen_address_from("localhost:0")->port, 0);
    EXPECT_EQ(listen_address_from("[::1]:65535")->host, "::1");
}

TEST(ListenAddress, RefusesTheRest) {
    for (const char* bad : {"", ":", "8080", "host", ":80", "host:", "host:65536", "host:-1",
                            "host:8o", "::1:80", "host: 80", "[]:80", "host:99999999999"}) {
        EXPECT_FALSE(listen_address_from(bad)) << bad;
    }
}

TEST(ListenAddress, HasAUrl) {
    EXPECT_EQ(url_of({"127.0.0.1", 80}), "http://127.0.0.1:80");
    EXPECT_EQ(url_of({"::1", 80}), "http://[::1]:80");
}

}  // namespace
}  // namespace bouguer::server
