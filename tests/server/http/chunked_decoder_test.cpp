// SPDX-License-Identifier: Apache-2.0
#include "server/http/chunked_decoder.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

using Result = ChunkedDecoder::Result;

struct Decoded {
    Result result;
    std::string out, rest;
};

Decoded decode(const std::string& text, std::size_t limit = 1000) {
    ChunkedDecoder decoder(limit);
    Decoded d{Result::NeedMore, "", text};
    d.result = decoder.feed(d.rest, d.out);
    return d;
}

TEST(ChunkedDecoder, JoinsChunksAndLeavesTheNextRequest) {
    const Decoded d = decode("3\r\nabc\r\nA;x=\"y\"\r\n0123456789\r\n0\r\nTrailer: t\r\n\r\nGET /");
    EXPECT_EQ(d.result, Result::Done);
    EXPECT_EQ(d.out, "abc0123456789");
    EXPECT_EQ(d.rest, "GET /");
}

TEST(ChunkedDecoder, DoesNotCareHowTheBytesCome) {
    const std::string text = "5\r\nhello\r\n6\r\n world\r\n0\r\n\r\n";
    ChunkedDecoder decoder(11);
    std::string in;
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        in += text[i];
        const Result expected = i + 1 == text.size() ? Result::Done : Result::NeedMore;
        ASSERT_EQ(decoder.feed(in, out), expected) << i;
    }
    EXPECT_EQ(out, "hello world");
}

TEST(ChunkedDecoder, RefusesBeforeItReadsTooMuch) {
    EXPECT_EQ(decode("B\r\n", 10).result, Result::TooLarge);
    EXPECT_EQ(decode("6\r\n123456\r\n5\r\n", 10).result, Result::TooLarge);
    EXPECT_EQ(decode("A\r\n0123456789\r\n0\r\n\r\n", 10).result, Result::Done);
    EXPECT_EQ(decode("FFFFFFFFFFFFFFFF\r\n").result, Result::TooLarge);
    EXPECT_EQ(decode("FFFFFFFFFFFFFFFFFF\r\n").result, Result::TooLarge);
}

TEST(ChunkedDecoder, RefusesWhatIsBroken) {
    for (const char* text : {"x\r\n", "\r\n", "-1\r\n", "+1\r\n", "0x1\r\n", "1\nab",
                             "3\r\nabcd\r\n", "3\r\nabc\n", " 3\r\n"}) {
        EXPECT_EQ(decode(text).result, Result::Malformed) << text;
    }
    EXPECT_EQ(decode(std::string(2000, '1')).result, Result::Malformed);
}

TEST(ChunkedDecoder, SkipsGoodExtensionsAndTrailers) {
    for (const char* text : {"1;a\r\nx\r\n0\r\n\r\n", "1;a=b;c=\"d; e\\\"f\";g\r\nx\r\n0;h\r\n\r\n",
                             "1\r\nx\r\n0\r\nA: b\r\nC:\r\n\r\n"}) {
        EXPECT_EQ(decode(text).result, Result::Done) << text;
    }
}

// Each of these was read by somebody as another size or another end.
TEST(ChunkedDecoder, RefusesBrokenExtensionsAndTrailers) {
    for (const char* text : {"2 x\r\n",
                             "2 \r\n",
                             "2\t;a\r\n",
                             "2 ;a\r\n",
                             "2; a\r\n",
                             "2;a \r\n",
                             "2;a =b\r\n",
                             "2;a= b\r\n",
                             "2;\r\n",
                             "2;=b\r\n",
                             "2;a=\r\n",
                             "2;a=b c\r\n",
                             "2;a\rb\r\n",
                             "2\rx\r\n",
                             "2;a=\"b\r\n",
                             "2;a=\"b\"c\r\n",
                             "2;a=\"\r\"\r\n",
                             "2;a=\"\\\"\r\n",
                             "0\r\nno colon\r\n\r\n",
                             "0\r\nname : v\r\n\r\n",
                             "0\r\n: v\r\n\r\n",
                             "0\r\n folded: v\r\n\r\n",
                             "0\r\nA: b\rc\r\n\r\n",
                             "0\r\nA: \x7f\r\n\r\n"}) {
        EXPECT_EQ(decode(text).result, Result::Malformed) << text;
    }
    EXPECT_EQ(decode(std::string("2;\0\r\n", 6)).result, Result::Malformed);
}

// Extensions and trailers cost the sender nothing: they may not outweigh the data for ever.
TEST(ChunkedDecoder, BoundsWhatIsNoData) {
    std::string trailers = "0\r\n";
    for (int i = 0; i < 100; ++i) trailers += "T: " + std::string(500, 'x') + "\r\n";
    EXPECT_EQ(decode(trailers).result, Result::Malformed);
    std::string extensions;
    for (int i = 0; i < 100; ++i) extensions += "1;" + std::string(500, 'x') + "\r\na\r\n";
    EXPECT_EQ(decode(extensions).result, Result::Malformed);
}

}  // namespace
}  // namespace bouguer::server
