// SPDX-License-Identifier: Apache-2.0
#include "server/http/client_key.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(ClientKey, IsTheAddressOfIpv4) {
    EXPECT_EQ(client_key("192.0.2.1"), "192.0.2.1");
    EXPECT_EQ(client_key("::ffff:192.0.2.1"), "192.0.2.1") << "of a listener for both families";
}

TEST(ClientKey, IsTheNetworkOfIpv6) {
    EXPECT_EQ(client_key("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::/64");
    EXPECT_EQ(client_key("2001:db8:1:2::9"), "2001:db8:1:2::/64") << "has 2^64 others at hand";
    EXPECT_EQ(client_key("2001:db8:1:3::9"), "2001:db8:1:3::/64");
    EXPECT_EQ(client_key("fe80::1%eth0"), "fe80::/64");
    EXPECT_EQ(client_key("::1"), "::/64");
}

TEST(ClientKey, LeavesAloneWhatIsNoAddress) { EXPECT_EQ(client_key("unknown"), "unknown"); }

}  // namespace
}  // namespace bouguer::server
