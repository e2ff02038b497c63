// SPDX-License-Identifier: Apache-2.0
// A file without a name, as tests of contents need it.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "server/content.h"

namespace bouguer::server::testing {

/// An open file of these bytes, gone when it is closed.
inline Content::File unnamed_file(const std::string& bytes) {
    std::FILE* stream = std::tmpfile();
    EXPECT_EQ(std::fwrite(bytes.data(), 1, bytes.size(), stream), bytes.size());
    EXPECT_EQ(std::fflush(stream), 0);
    auto file = std::make_shared<const FileDescriptor>(::dup(::fileno(stream)));
    std::fclose(stream);
    return file;
}

/// Bytes that tell where they are from: no two windows of a file are alike.
inline std::string numbered_bytes(std::size_t n) {
    std::string bytes;
    while (bytes.size() < n) bytes += std::to_string(bytes.size()) + ' ';
    bytes.resize(n);
    return bytes;
}

}  // namespace bouguer::server::testing
