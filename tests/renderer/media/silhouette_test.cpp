// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "renderer/media/interface.h"
#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;
using test::Random;

/// A ball of glass, hollowed out.
std::shared_ptr<const TriangleMesh> shell(const TriangleMesh& ball, Real outer) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = ball.positions;
    const auto first = static_cast<std::uint32_t>(ball.positions.size());
    for (const Vec3 p : ball.positions) mesh->positions.push_back(outer * p);
    for (const auto& [a, b, c] : ball.triangles) {
        mesh->triangles.push_back({a, c, b});
        mesh->triangles.push_back({first + a, first + b, first + c});
    }
    return mesh;
}

/// Goes along a straight line through everything; false when it loses track of a body.
bool keeps_track(InterfaceFinder& finder, const Ray& line) {
    RayStart start;
    start.p = line.o;
    MediumStack media;
    LostBodies lost;
    Interface found;
    while (finder.next(start, line.d, std::numeric_limits<Real>::infinity(), media, found, lost)) {
        media = found.beyond;
        start = found.start(true);
    }
    return lost.empty() && media.current() == MediumStack::kOutside;
}

TEST(InterfaceFinder, KeepsTrackOfWhatARayGrazes) {
    // Where liquid fills the hollow, the two share each edge. A ray just misses the liquid or goes
    // in and comes out again at once; either will do, but one of the two it is.
    const auto ball = test::icosphere(2);
    const auto g = build({{shell(*ball, 2)}, {ball}});
    BodyDescription body;
    body.matter = Matter::Body;
    const BodyTable bodies(std::vector{body, body}, *g);
    InterfaceFinder finder(*g, bodies);
    Random random(3);
    int lost = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto& triangle =
            ball->triangles[static_cast<std::size_t>(i) % ball->triangles.size()];
        const Vec3 a = ball->positions[triangle[0]], b = ball->positions[triangle[1]];
        const Vec3 out = normalize(a + b);
        const Vec3 d = normalize(cross(out, b - a) + random.between(-0.9, 0.9) * (b - a));
        const Vec3 past = a + random.uniform() * (b - a) + random.between(-1e-5, 1e-5) * out;
        if (!keeps_track(finder, {past - 5 * d, d})) ++lost;
    }
    EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace bouguer::renderer
