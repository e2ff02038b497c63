// SPDX-License-Identifier: Apache-2.0
// What is thin is there: gaps between panes, and panes, of a ten-millionth of the scene.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/meshes.h"
#include "tests/support/poses.h"

namespace bouguer::renderer {
namespace {

using test::glass;
using test::Pose;
using test::PosedScene;
using test::Seen;

constexpr double kShare = 0.9;
constexpr Real kThin = 1e-6;  // of 10

HallMaterial pane() {
    HallMaterial m = glass(1, 0.5);
    m.k_st = kShare;
    return m;
}

class Gap : public testing::TestWithParam<Pose> {
  protected:
    static void expect(PosedScene& scene, double expected, const char* what) {
        for (const Vec3 at : {Vec3{0.3, 0.7, 0}, Vec3{-2.1, 1.2, 0}}) {
            for (const Real side : {5.0, -5.0}) {
                const Seen seen = scene.look(at + Vec3{0, 0, side}, at);
                EXPECT_NEAR(seen.y, expected, 1e-5) << what << " from " << side;
                EXPECT_TRUE(seen.counters.lost_bodies.empty()) << what;
            }
        }
    }
};

// Two panes of 1: four faces with a gap, three without.
TEST_P(Gap, OfATenMillionthIsReal) {
    for (const bool mesh : {false, true}) {
        for (const Real gap : {0.0, kThin}) {
            PosedScene scene(GetParam());
            scene.environment(1);
            scene.add(test::box_mesh({-5, -5, gap}, {5, 5, gap + 1}), pane());
            scene.add(test::box_or_mesh(mesh, {-5, -5, -1}, {5, 5, 0}), pane());
            expect(scene, std::pow(kShare, gap > 0 ? 4 : 3) * 0.25, mesh ? "mesh" : "box");
        }
    }
}

TEST_P(Gap, PanesOfATenMillionthHaveTwoFaces) {
    for (const bool mesh : {false, true}) {
        PosedScene scene(GetParam());
        scene.environment(1);
        scene.add(test::box_or_mesh(mesh, {-5, -5, 0}, {5, 5, kThin}), pane());
        expect(scene, kShare * kShare, mesh ? "mesh" : "box");
    }
}

INSTANTIATE_TEST_SUITE_P(All, Gap, testing::ValuesIn(test::poses()), test::pose_name);

// Along a smooth ball of 320 flat triangles the light falls as N.L, and no facet is black.
TEST(Terminator, HasNoBlackBand) {
    const auto scene = test::SceneBuilder()
                           .add(test::icosphere(2, true), test::matt(1))
                           .light(test::sun({-1, 0, 0}))
                           .build();
    for (int i = 0; i < 400; ++i) {
        const Real angle = degrees_to_radians(88.0 * (i % 20) / 19);
        const Real turn = 2 * kPi * (i / 20) / 20;
        const Vec3 n{std::cos(angle), std::sin(angle) * std::cos(turn),
                     std::sin(angle) * std::sin(turn)};
        EXPECT_NEAR(test::look(*scene, 3 * n, {0, 0, 0}).y, n.x, 0.03) << i;
    }
}

}  // namespace
}  // namespace bouguer::renderer
