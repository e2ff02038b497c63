// SPDX-License-Identifier: Apache-2.0
#include "renderer/media/refraction.h"

#include <gtest/gtest.h>

namespace bouguer::renderer {
namespace {

Vec3 incident(Real angle_rad) { return {std::sin(angle_rad), 0, -std::cos(angle_rad)}; }
constexpr Vec3 kUp{0, 0, 1};

// Snell: sin 45 / 1.5 = 0.471405, so the cosine is 0.881917 and the path in a slab is 1/0.881917
// = 1.133893 thick.
TEST(Refract, FollowsSnell) {
    const auto t = refract(incident(kPi / 4), kUp, 1 / 1.5);
    ASSERT_TRUE(t);
    EXPECT_NEAR(t->x, 0.4714045, 1e-7);
    EXPECT_NEAR(-1 / t->z, 1.133893, 1e-6);
    EXPECT_NEAR(length(*t), 1, 1e-15);
}

// Critical angle of 1.5 to 1: asin(1/1.5) = 41.81031 degrees.
TEST(Refract, ReflectsTotallyBeyondTheCriticalAngle) {
    EXPECT_TRUE(refract(incident(degrees_to_radians(41.81030)), kUp, 1.5));
    EXPECT_FALSE(refract(incident(degrees_to_radians(41.81032)), kUp, 1.5));
    EXPECT_FALSE(refract(incident(kPi / 2), kUp, 1.5));
    EXPECT_TRUE(refract(incident(kPi / 2), kUp, 1 / 1.5)) << "grazing, into the denser side";
}

TEST(Refract, ChangesNothingBetweenEqualIndices) {
    for (const Real angle : {0.0, 0.5, 1.0, 1.5, 1.57}) {
        const auto t = refract(incident(angle), kUp, 1);
        ASSERT_TRUE(t);
        EXPECT_NEAR(t->x, incident(angle).x, 1e-15);
        EXPECT_NEAR(t->z, incident(angle).z, 1e-15);
    }
}

TEST(Reflect, MirrorsAboutTheNormal) {
    const Vec3 r = reflect(incident(0.3), kUp);
    EXPECT_NEAR(r.x, std::sin(0.3), 1e-15);
    EXPECT_NEAR(r.z, std::cos(0.3), 1e-15);
}

}  // namespace
}  // namespace bouguer::renderer
