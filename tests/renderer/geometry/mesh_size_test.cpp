// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_size.h"

#include <gtest/gtest.h>

#include "tests/support/logged_source.h"

namespace bouguer::renderer {
namespace {

std::string ply_header(std::uint64_t vertices, std::uint64_t faces) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string refusal(const std::string& bytes, const MeshLimits& limits = {}) {
    const auto size = read_mesh_size(MemorySource(bytes), limits);
    return size ? "none" : size.error().message;
}

TEST(MeshSize, OfAPlyStandsInItsHeader) {
    std::uint64_t bytes_read = 0;
    const tests::LoggedSource file(ply_header(5'000'000, 7'000'000), std::uint64_t{1} << 30U,
                                   bytes_read);
    const auto size = read_mesh_size(file);
    ASSERT_TRUE(size) << size.error().message;
    EXPECT_EQ(size->vertices, 5'000'000U);
    EXPECT_EQ(size->triangles, 7'000'000U);
    EXPECT_LE(bytes_read, 64U << 10U);
}

TEST(MeshSize, OfAPlyMayStandBehindLongComments) {
    std::string header = ply_header(3, 1);
    const std::string comment = "comment " + std::string(1000, 'x') + "\n";
    for (int i = 0; i < 100; ++i) header.insert(header.find("element"), comment);
    const auto size = read_mesh_size(MemorySource(header + std::string(100, '\0')));
    ASSERT_TRUE(size) << size.error().message;
    EXPECT_EQ(size->vertices, 3U);
}

TEST(MeshSize, OfAPlyIsJudgedByTheFilesLength) {
    EXPECT_EQ(refusal(ply_header(3, 1)), "element \"vertex\": the file is cut short");
    EXPECT_EQ(refusal(ply_header(4, 1) + std::string(1000, '\0'), {3, 10}),
              "element \"vertex\": more vertices than allowed");
    EXPECT_EQ(refusal(ply_header(4, 11) + std::string(1000, '\0'), {5, 10}),
              "element \"face\": more triangles than allowed");
}

TEST(MeshSize, OfAnObjIsCounted) {
    const std::string obj =
        "# f 1 2 3\no thing\nv 0 0 0\n  v 1 0 0 # v\r\nv 0 1 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\n"
        "f 1 2 3\nf 1/1/1 2/1/1 3/1/1 4/1/1\nusemtl f\nf 2 3 4";
    const auto size = read_mesh_size(MemorySource(obj));
    ASSERT_TRUE(size) << size.error().message;
    EXPECT_EQ(size->vertices, 4U);
    EXPECT_EQ(size->triangles, 4U);
    const auto mesh = read_mesh(obj);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ((*mesh)->triangles.size() + (*mesh)->dropped_triangles, 4U);
    EXPECT_EQ(refusal(obj, {3, 10}), "line 6: more vertices than allowed");
    EXPECT_EQ(refusal(obj, {10, 2}), "line 10: more triangles than allowed");
}

// A line that a backslash continues is one, and the backslash no word; not so in a comment.
TEST(MeshSize, OfAnObjIsThatOfJoinedLines) {
    for (const std::string end : {"\n", "\r\n"}) {
        std::string bytes =
            "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\n# C:\\\nv 1 1 0\nv 0 1 0\nf 1 2 \\\n3\\\n 4 \\\n\n";
        for (std::size_t at = 0; (at = bytes.find('\n', at)) != std::string::npos; at += end.size())
            bytes.replace(at, 1, end);
        const auto size = read_mesh_size(MemorySource(bytes));
        ASSERT_TRUE(size);
        EXPECT_EQ(size->vertices, 4U);
        EXPECT_EQ(size->triangles, 2U);
    }
}

// Lines that the pieces of the file cut in two count once.
TEST(MeshSize, OfALargeObjIsThatOfItsLines) {
    std::string obj;
    for (int i = 0; i < 30'000; ++i) obj += "v 0.25 0.5 " + std::to_string(i) + "\n";
    for (int i = 0; i < 20'000; ++i) obj += "f 1 2 " + std::to_string(i + 3) + "\n";
    const auto size = read_mesh_size(MemorySource(obj));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->vertices, 30'000U);
    EXPECT_EQ(size->triangles, 20'000U);
}

// A file of the machine that is no mesh is neither read nor repeated.
TEST(MeshSize, RefusesOtherFilesByTheirFirstBytes) {
    std::uint64_t bytes_read = 0;
    const auto sparse = read_mesh_size(tests::LoggedSource("", 900U << 20U, bytes_read));
    ASSERT_FALSE(sparse);
    EXPECT_LE(bytes_read, 64U << 10U);
    for (const char* text : {"root:x:0:0:secret\n", "# configuration\n\nsecret = 1\n",
                             "v 0 0 0\nsecret = 1\n", "secret", "plyable secret\n"}) {
        for (const std::string& message :
             {refusal(text), read_mesh(text) ? "none" : read_mesh(text).error().message}) {
            EXPECT_EQ(message.find("secret"), std::string::npos) << message;
        }
    }
}

}  // namespace
}  // namespace bouguer::renderer
