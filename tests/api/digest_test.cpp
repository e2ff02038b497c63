// SPDX-License-Identifier: Apache-2.0
#include "api/digest.h"

#include <gtest/gtest.h>

namespace bouguer::api {
namespace {

// FIPS 180-4, example of one block: SHA-256("abc").
TEST(Digest, IsSha256InLowerCaseHex) {
    EXPECT_EQ(sha256_hex("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Digest, IsToldByItsForm) {
    const std::string digest = digest_of("abc");
    EXPECT_EQ(digest, "sha256-" + sha256_hex("abc"));
    EXPECT_TRUE(is_digest(digest));
    EXPECT_FALSE(is_digest(digest.substr(0, 70)));
    EXPECT_FALSE(is_digest(digest + "0"));
    EXPECT_FALSE(is_digest("sha256-" + std::string(64, 'A')));
    EXPECT_FALSE(is_digest("sha512-" + std::string(64, 'a')));
}

}  // namespace
}  // namespace bouguer::api
