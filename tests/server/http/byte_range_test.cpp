// SPDX-License-Identifier: Apache-2.0
#include "server/http/byte_range.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

constexpr std::size_t kSize = 100;

ByteRange part(std::string_view field) {
    const RangeRequest request = parse_range_field(field, kSize);
    EXPECT_EQ(request.kind, RangeRequest::Kind::Part) << field;
    return request.range;
}

TEST(ByteRange, IsInclusiveAndClampedToTheEnd) {
    EXPECT_EQ(part("bytes=0-0"), (ByteRange{0, 1}));
    EXPECT_EQ(part("bytes=10-19"), (ByteRange{10, 10}));
    EXPECT_EQ(part("bytes=90-"), (ByteRange{90, 10}));
    EXPECT_EQ(part("bytes=90-1000"), (ByteRange{90, 10}));
    EXPECT_EQ(part("bytes=99-99999999999999999999999"), (ByteRange{99, 1}));
    EXPECT_EQ(part("bytes=-7"), (ByteRange{93, 7}));
    EXPECT_EQ(part("bytes=-1000"), (ByteRange{0, 100}));
}

TEST(ByteRange, BehindTheEndCannotBeSatisfied) {
    for (const char* field :
         {"bytes=100-", "bytes=100-200", "bytes=-0", "bytes=99999999999999999999-"}) {
        EXPECT_EQ(parse_range_field(field, kSize).kind, RangeRequest::Kind::NotSatisfiable)
            << field;
    }
    EXPECT_EQ(parse_range_field("bytes=0-", 0).kind, RangeRequest::Kind::NotSatisfiable);
}

TEST(ByteRange, WhatIsNotUnderstoodIsIgnored) {
    for (const char* field : {"", "bytes=", "bytes=-", "bytes=5-4", "bytes=a-b", "bytes=1-2,5-6",
                              "lines=1-2", "bytes=+1-2", "bytes=1 -2", "bytes=--1"}) {
        EXPECT_EQ(parse_range_field(field, kSize).kind, RangeRequest::Kind::Whole) << field;
    }
}

}  // namespace
}  // namespace bouguer::server
