// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/geometry/mesh_file.h"
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

/// A cube of side 2 about a point.
TriangleMesh cube_at(Vec3 middle, Real scale = 1) {
    TriangleMesh mesh = *test::cube();
    for (Vec3& p : mesh.positions) p = scale * p + middle;
    return mesh;
}

void flip_all(TriangleMesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) flip(mesh, i);
}

// Two cubes with a wall in common, in the same triangles: the wall is inside the whole. What is
// left of 24 triangles is the surface of a box of 2 x 2 x 4.
TEST(MeshTopology, DissolvesWallsBetweenBodiesThatTouch) {
    TriangleMesh both = cube_at({0, 0, 0});
    TriangleMesh mirrored = cube_at({0, 0, 0});
    for (Vec3& p : mirrored.positions) p.x = 2 - p.x;
    flip_all(mirrored);
    append(both, mirrored);
    const MeshPtr mesh = mended(both);
    EXPECT_TRUE(mesh->topology->is_closed);
    EXPECT_EQ(mesh->topology->doubled_triangles, 4U);
    EXPECT_EQ(mesh->topology->flipped_triangles, 0U);
    EXPECT_DOUBLE_EQ(volume(*mesh), 6 * 16);
}

// Four triangles at an edge: each cube is closed by itself, and turned by itself.
TEST(MeshTopology, TakesBodiesThatTouchAlongAnEdgeForTwo) {
    TriangleMesh wrong = cube_at({2, 2, 0});
    flip_all(wrong);
    TriangleMesh both = cube_at({0, 0, 0});
    append(both, wrong);
    const MeshPtr mesh = mended(both);
    EXPECT_TRUE(mesh->topology->is_closed);
    EXPECT_EQ(mesh->topology->flipped_triangles, 12U);
    EXPECT_DOUBLE_EQ(volume(*mesh), 6 * 16);
}

/// Upper and lower half of a double pyramid of that height over the square of corners (+-1, +-1).
TriangleMesh cap(Real height) {
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, height}};
    for (std::uint32_t i = 0; i < 4; ++i) mesh.triangles.push_back({i, (i + 1) % 4, 4});
    if (height < 0) flip_all(mesh);
    return mesh;
}

// Four caps on one square, none closed by itself: the outer two wind outwards and the inner two the
// other way, a shell that is thin at its rim. It stays as it is; inside out it is turned as a
// whole.
TEST(MeshTopology, KeepsPiecesTogetherThatOnlyCloseTogether) {
    TriangleMesh shell = cap(2);
    append(shell, cap(-2));
    TriangleMesh hole = cap(1);
    append(hole, cap(-1));
    flip_all(hole);
    append(shell, hole);
    EXPECT_EQ(mended(shell)->triangles, shell.triangles);
    EXPECT_TRUE(mended(shell)->topology->is_closed);
    TriangleMesh wrong = shell;
    flip_all(wrong);
    EXPECT_EQ(mended(wrong)->triangles, shell.triangles);
}

// Thousands of bubbles in glass wind inwards and stay bubbles. A ball in the hole of a ring is in
// its box, and not inside it.
TEST(MeshTopology, TellsWhatIsInsideFromWhatIsBeside) {
    TriangleMesh glass = cube_at({0, 0, 0});
    for (int i = 0; i < 6'000; ++i) {
        TriangleMesh bubble = cube_at(
            {-0.9 + 0.1 * (i % 19), -0.9 + 0.1 * (i / 19 % 19), -0.9 + 0.1 * (i / 361)}, 0.02);
        flip_all(bubble);
        append(glass, bubble);
    }
    EXPECT_EQ(mended(glass)->topology->flipped_triangles, 0U);
    TriangleMesh wrong = glass;
    flip_all(wrong);
    EXPECT_EQ(mended(wrong)->triangles, glass.triangles);

    TriangleMesh ring = *test::torus(3, 0.5, 24, 12);
    const std::size_t triangles = ring.triangles.size();
    TriangleMesh inside_out = ball(0.4);
    flip_all(inside_out);
    append(ring, inside_out);
    const MeshPtr mesh = mended(ring);
    EXPECT_EQ(mesh->topology->flipped_triangles, inside_out.triangles.size());
    EXPECT_TRUE(std::equal(mesh->triangles.begin(),
                           mesh->triangles.begin() + static_cast<std::ptrdiff_t>(triangles),
                           ring.triangles.begin()));
}

// Shells in shells: solid in hollow in solid.
TEST(MeshTopology, TurnsShellsInShellsTogether) {
    TriangleMesh onion;
    for (int i = 0; i < 7; ++i) {
        TriangleMesh shell = ball(7 - i);
        if (i % 2 != 0) flip_all(shell);
        append(onion, shell);
    }
    EXPECT_EQ(mended(onion)->topology->flipped_triangles, 0U);
    TriangleMesh wrong = onion;
    flip_all(wrong);
    EXPECT_EQ(mended(wrong)->triangles, onion.triangles);
}

// A corner on an edge of a larger triangle, and a triangle without area between, as modellers write
// it: it is not rendered, but closes the surface.
TEST(MeshTopology, CountsFlatTrianglesAsSurface) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}};
    const auto checked = checked_mesh(mesh);
    ASSERT_TRUE(checked);
    EXPECT_EQ((*checked)->triangles.size(), 5U);
    EXPECT_EQ((*checked)->flat_triangles.size(), 1U);
    EXPECT_TRUE(mended_mesh(*checked)->topology->is_closed);
    mesh.triangles.pop_back();
    EXPECT_EQ(mended(mesh)->topology->open_edges, 3U);
}

// The projective plane of six vertices: no edge is open, and it has one side.
TEST(MeshTopology, NamesSurfacesWithOneSide) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {2, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                      {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    const MeshPtr found = mended(mesh);
    EXPECT_TRUE(found->topology->is_one_sided);
    EXPECT_FALSE(found->topology->is_closed);
}

// A sheet has no outside: it keeps the way that most of it winds.
TEST(MeshTopology, MakesOpenPiecesWindAsMostOfThemDo) {
    TriangleMesh sheet = ball(1);
    sheet.triangles.resize(200);
    TriangleMesh mixed = sheet;
    flip(mixed, 7);
    flip(mixed, 100);
    EXPECT_EQ(mended(mixed)->triangles, sheet.triangles);
    EXPECT_EQ(mended(mixed)->topology->flipped_triangles, 2U);
}

}  // namespace
}  // namespace bouguer::renderer
