// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_head.h"

#include <gtest/gtest.h>

#include <string>

namespace bouguer::server {
namespace {

const HttpLimits kLimits;

/// Status of the refusal, 0 if there is none.
int refused(const std::string& text) {
    const auto head = parse_head(text, kLimits);
    return head ? 0 : head.error().status;
}

TEST(RequestHead, ReadsLineAndFields) {
    const auto head = parse_head(
        "POST /a%20b?c=d HTTP/1.1\r\nHost: h:1\r\ncontent-LENGTH:  12 \r\nX-Empty:\r\n", kLimits);
    ASSERT_TRUE(head);
    EXPECT_EQ(head->method, "POST");
    EXPECT_EQ(head->target, "/a%20b?c=d");
    EXPECT_EQ(head->path(), "/a%20b");
    EXPECT_EQ(head->content_length, 12U);
    EXPECT_TRUE(head->keep_alive);
    EXPECT_FALSE(head->chunked);
    ASSERT_NE(head->find("x-empty"), nullptr);
    EXPECT_EQ(*head->find("x-empty"), "");
    EXPECT_EQ(head->find("x"), nullptr);
}

TEST(RequestHead, AbsoluteTargetsAreMadeOrigin) {
    EXPECT_EQ(parse_head("GET http://h:1/x?y HTTP/1.1\r\nHost: h\r\n", kLimits)->target, "/x?y");
    EXPECT_EQ(parse_head("GET http://h HTTP/1.1\r\nHost: h\r\n", kLimits)->target, "/");
    EXPECT_EQ(parse_head("GET http://h?a HTTP/1.1\r\nHost: h\r\n", kLimits)->target, "/?a");
    // schemes are the same in any case [RFC 3986 §3.1]
    EXPECT_EQ(parse_head("GET HTTP://h/x HTTP/1.1\r\nHost: h\r\n", kLimits)->target, "/x");
    EXPECT_EQ(parse_head("GET httpS://h/x HTTP/1.1\r\nHost: h\r\n", kLimits)->target, "/x");
}

TEST(RequestHead, KnowsWhomItIsFor) {
    const auto of = [](const std::string& text) { return parse_head(text, kLimits)->authority; };
    EXPECT_EQ(of("GET / HTTP/1.1\r\nHost: H:81\r\n"), (Authority{"h", 81}));
    EXPECT_EQ(of("GET http://t:82/ HTTP/1.1\r\nHost: h:81\r\n"), (Authority{"t", 82}));
    EXPECT_EQ(of("GET / HTTP/1.1\r\nHost:\r\n"), Authority());
    EXPECT_EQ(of("GET / HTTP/1.0\r\nHost: h\r\n"), (Authority{"h", std::nullopt}));
    EXPECT_EQ(of("GET / HTTP/1.0\r\n"), std::nullopt);
}

TEST(RequestHead, LettersMayBeEncoded) {
    EXPECT_EQ(refused("GET /v1/%6aobs?a=%2f%00 HTTP/1.1\r\nHost: h\r\n"), 0);
    EXPECT_EQ(refused("GET /a%252fb HTTP/1.1\r\nHost: h\r\n"), 0) << "that is %2f, not a slash";
}

TEST(RequestHead, KnowsWhenTheConnectionEnds) {
    EXPECT_FALSE(parse_head("GET / HTTP/1.0\r\n", kLimits)->keep_alive);
    EXPECT_FALSE(
        parse_head("GET / HTTP/1.1\r\nHost: h\r\nConnection: te, CLOSE\r\n", kLimits)->keep_alive);
}

struct Refused {
    const char* text;
    int status;
};

class RefusedHead : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedHead, WithItsStatus) {
    EXPECT_EQ(refused(GetParam().text), GetParam().status) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Table, RefusedHead,
    ::testing::Values(
        Refused{"GET / HTTP/1.1\r\n", 400},                           // no Host
        Refused{"GET / HTTP/1.1\r\nHost: a\r\nHost: a\r\n", 400},     // two
        Refused{"GET  / HTTP/1.1\r\nHost: h\r\n", 400},               // two spaces
        Refused{"GET / HTTP/1.1 \r\nHost: h\r\n", 400},               // space at the end
        Refused{"GET /\r\nHost: h\r\n", 400},                         // HTTP/0.9
        Refused{"\r\nHost: h\r\n", 400},                              // empty line
        Refused{"GET x HTTP/1.1\r\nHost: h\r\n", 400},                // no slash
        Refused{"GET /\x7f HTTP/1.1\r\nHost: h\r\n", 400},            // control character
        Refused{"GET /\xc3\xa4 HTTP/1.1\r\nHost: h\r\n", 400},        // not ASCII
        Refused{"G@T / HTTP/1.1\r\nHost: h\r\n", 400},                // method no token
        Refused{"GET / HTTP/1.1\r\nHost: h\r\nA : b\r\n", 400},       // space before the colon
        Refused{"GET / HTTP/1.1\r\nHost: h\r\n folded\r\n", 400},     // line folding
        Refused{"GET / HTTP/1.1\r\nHost: h\r\nnocolon\r\n", 400},     // no colon
        Refused{"GET / HTTP/1.1\r\nHost: h\r\n: v\r\n", 400},         // no name
        Refused{"GET / HTTP/1.1\r\nHost: h\r\nA: b\nB: c\r\n", 400},  // bare LF
        Refused{"GET / HTTP/1.1\r\nHost: h\r\nA: b\rc\r\n", 400},     // bare CR
        Refused{"GET /v1%2fjobs HTTP/1.1\r\nHost: h\r\n", 404},       // not the slash that it hides
        Refused{"GET /v1%2Fjobs HTTP/1.1\r\nHost: h\r\n", 404},       //
        Refused{"GET /v1%5cjobs HTTP/1.1\r\nHost: h\r\n", 404},       // nor a backslash
        Refused{"GET /v1/%00 HTTP/1.1\r\nHost: h\r\n", 404},          // nor a control character
        Refused{"GET /v1/jobs%0a HTTP/1.1\r\nHost: h\r\n", 404},      //
        Refused{"GET /v1%u002fjobs HTTP/1.1\r\nHost: h\r\n", 400},    // no such encoding
        Refused{"GET /a%2 HTTP/1.1\r\nHost: h\r\n", 400},             //
        Refused{"GET /a%2?b HTTP/1.1\r\nHost: h\r\n", 400},           //
        Refused{"GET /a?b=%zz HTTP/1.1\r\nHost: h\r\n", 400},         //
        Refused{"GET /a#b HTTP/1.1\r\nHost: h\r\n", 400},             // a fragment
        Refused{"GET http:///a HTTP/1.1\r\nHost: h\r\n", 400},        // no host
        Refused{"GET http://u@h/a HTTP/1.1\r\nHost: h\r\n", 400},     // a user
        Refused{"GET ftp://h/a HTTP/1.1\r\nHost: h\r\n", 400},        //
        Refused{"GET / HTTP/1.1\r\nHost: h/x\r\n", 400},              // no host
        Refused{"GET / HTTP/1.1\r\nHost: h, h\r\n", 400},             //
        Refused{"GET / HTTP/1.1\r\nHost: h:x\r\n", 400},              //
        Refused{"GET http://h/ HTTP/1.1\r\nHost: @\r\n", 400},        // even if it does not count
        Refused{"PRI * HTTP/2.0\r\n", 505},                           // HTTP/2's preface
        Refused{"BREW / HTTP/1.1\r\nHost: h\r\n", 501},               // unknown method
        Refused{"TRACE / HTTP/1.1\r\nHost: h\r\n", 501},              //
        Refused{"CONNECT h:1 HTTP/1.1\r\nHost: h\r\n", 501},          //
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nExpect: tea\r\n", 417},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Encoding: gzip\r\n", 415},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: gzip\r\n", 501},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: gzip, chunked\r\n", 501},
        // where a request ends must not be a matter of opinion
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 3\r\nTransfer-Encoding: chunked\r\n",
                400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 3\r\nContent-Length: 3\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 3, 3\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: -1\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: +1\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 0x10\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length:\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n"
                "Transfer-Encoding: chunked\r\n",
                400},
        Refused{"POST / HTTP/1.0\r\nTransfer-Encoding: chunked\r\n", 400},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 99999999999\r\n", 413},
        Refused{"POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 99999999999999999999999\r\n", 413}));

TEST(RequestHead, BoundsTargetAndFields) {
    const std::string slashes(kLimits.target_bytes, '/');
    EXPECT_EQ(refused("GET " + slashes + " HTTP/1.1\r\nHost: h\r\n"), 0);
    EXPECT_EQ(refused("GET /" + slashes + " HTTP/1.1\r\nHost: h\r\n"), 414);
    std::string many = "GET / HTTP/1.1\r\nHost: h\r\n";
    for (std::size_t i = 1; i < kLimits.header_fields; ++i) many += "A: b\r\n";
    EXPECT_EQ(refused(many), 0);
    EXPECT_EQ(refused(many + "A: b\r\n"), 431);
}

TEST(RequestHead, NulIsRefused) {
    EXPECT_EQ(refused(std::string("GET / HTTP/1.1\r\nHost: h\r\nA: \0\r\n", 34)), 400);
}

}  // namespace
}  // namespace bouguer::server
