// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using MeshPtr = std::shared_ptr<const TriangleMesh>;

void flip(TriangleMesh& mesh, std::size_t triangle) {
    std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

/// Six times the volume.
Real volume(const TriangleMesh& mesh) {
    Real sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += dot(mesh.positions[a], cross(mesh.positions[b], mesh.positions[c]));
    return sum;
}

TriangleMesh ball(Real radius) {
    TriangleMesh mesh = *test::icosphere(2, true);
    for (Vec3& p : mesh.positions) p = radius * p;
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (auto [a, b, c] : other.triangles)
        mesh.triangles.push_back({a + first, b + first, c + first});
    mesh.normals.clear();
}

MeshPtr mended(TriangleMesh mesh) {
    return mended_mesh(std::make_shared<const TriangleMesh>(std::move(mesh)));
}

TEST(MeshTopology, LeavesAGoodMeshAsItIs) {
    const MeshPtr mesh = mended(ball(1));
    EXPECT_TRUE(mesh->topology->is_closed);
    EXPECT_EQ(mesh->topology->flipped_triangles, 0U);
    EXPECT_EQ(mesh->triangles, ball(1).triangles);
    EXPECT_EQ(mended_mesh(mesh), mesh) << "once is enough";
}

TEST(MeshTopology, TurnsWhatIsInsideOut) {
    TriangleMesh mesh = ball(1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) flip(mesh, i);
    const MeshPtr right = mended(mesh);
    EXPECT_EQ(right->topology->flipped_triangles, mesh.triangles.size());
    EXPECT_GT(volume(*right), 0);
}

TEST(MeshTopology, MakesTrianglesWindAlike) {
    TriangleMesh mesh = ball(1);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) flip(mesh, i);
    const MeshPtr right = mended(mesh);
    EXPECT_TRUE(right->topology->is_closed);
    EXPECT_EQ(right->triangles, ball(1).triangles);
}

// A hollow ball stays one, also when the whole of it is inside out; a ball beside keeps its own.
TEST(MeshTopology, KeepsCavities) {
    TriangleMesh hole = ball(0.5);
    for (std::size_t i = 0; i < hole.triangles.size(); ++i) flip(hole, i);
    TriangleMesh hollow = ball(1);
    append(hollow, hole);
    EXPECT_EQ(mended(hollow)->topology->flipped_triangles, 0U);
    TriangleMesh wrong = hollow;
    for (std::size_t i = 0; i < wrong.triangles.size(); ++i) flip(wrong, i);
    EXPECT_EQ(mended(wrong)->triangles, hollow.triangles);
}

TEST(MeshTopology, LeavesOutDoubledTrianglesAndCountsOpenEdges) {
    TriangleMesh mesh = ball(1);
    const std::size_t n = mesh.triangles.size();
    mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    for (std::size_t i = n; i < 2 * n; i += 2) flip(mesh, i);  // in whatever winding
    const MeshPtr once = mended(mesh);
    EXPECT_EQ(once->topology->doubled_triangles, n);
    EXPECT_EQ(once->triangles, ball(1).triangles);
    mesh = ball(1);
    mesh.triangles.pop_back();
    const MeshPtr open = mended(mesh);
    EXPECT_FALSE(open->topology->is_closed);
    EXPECT_EQ(open->topology->open_edges, 3U);
}

// Vertices that are split for their attributes are one place.
TEST(MeshTopology, WeldsVerticesByPosition) {
    TriangleMesh soup;
    const TriangleMesh whole = ball(1);
    for (const auto& corners : whole.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.positions.size());
        for (const std::uint32_t i : corners) soup.positions.push_back(whole.positions[i]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_TRUE(mended(soup)->topology->is_closed);
}

}  // namespace
}  // namespace bouguer::renderer
