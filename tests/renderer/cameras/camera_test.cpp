// SPDX-License-Identifier: Apache-2.0
#include "renderer/cameras/camera.h"

#include <gtest/gtest.h>

namespace bouguer::renderer {
namespace {

constexpr Resolution kWide{640, 480};

Camera make(const CameraDescription& description, Resolution resolution = kWide, Vec3 origin = {}) {
    auto camera = Camera::create(description, resolution, origin);
    EXPECT_TRUE(camera);
    return camera.value();
}

void expect_near(Vec3 a, Vec3 b, Real tolerance = 1e-14) {
    EXPECT_LE(length(a - b), tolerance) << "(" << a.x << ", " << a.y << ", " << a.z << ") is not ("
                                        << b.x << ", " << b.y << ", " << b.z << ")";
}

/// Looks along -z with y up, so that x is to the right.
PerspectiveCamera ahead(Real fov_deg) { return {{0, 0, 0}, {0, 0, -3}, {0, 1, 0}, fov_deg}; }

TEST(PerspectiveCamera, LooksAtTheMiddle) {
    const Ray ray =
        make(PerspectiveCamera{{1, 2, 3}, {4, 6, 3}, {0, 0, 1}, 40}).generate({320, 240});
    expect_near(ray.o, {1, 2, 3});
    expect_near(ray.d, {0.6, 0.8, 0});
}

// Half of 90 degrees up: the middle of the upper edge is seen along (0, 1, -1).
TEST(PerspectiveCamera, HasRowZeroOnTop) {
    const Camera camera = make(ahead(90));
    expect_near(camera.generate({320, 0}).d, normalize({0, 1, -1}));
    expect_near(camera.generate({320, 480}).d, normalize({0, -1, -1}));
}

// Pixels are square: 640/480 of the vertical extent lies to the right.
TEST(PerspectiveCamera, HasSquarePixels) {
    const Camera camera = make(ahead(90));
    expect_near(camera.generate({640, 240}).d, normalize({4.0 / 3, 0, -1}));
    expect_near(camera.generate({0, 0}).d, normalize({-4.0 / 3, 1, -1}));
}

// The angle between the rays to the upper and the lower edge is the vertical angle of view.
TEST(PerspectiveCamera, SpansItsAngleOfView) {
    for (const Real fov : {1e-3, 20.0, 40.0, 120.0, 179.0}) {
        const Camera camera = make(ahead(fov));
        const Vec3 top = camera.generate({320, 0}).d;
        const Vec3 bottom = camera.generate({320, 480}).d;
        const Real angle = 2 * std::asin(length(top - bottom) / 2);
        EXPECT_NEAR(angle, degrees_to_radians(fov), 1e-12);
    }
}

// Only the part of `up` across the line of sight matters, and not its length.
TEST(PerspectiveCamera, TakesAnyUpThatIsNotAlongTheView) {
    auto tilted = ahead(50);
    tilted.up = {0, 1e-3, 7};
    expect_near(make(tilted).generate({12, 34}).d, make(ahead(50)).generate({12, 34}).d, 1e-12);
}

TEST(PerspectiveCamera, GivesUnitDirections) {
    const Camera camera = make(ahead(150));
    for (const Vec2 film : {Vec2{0, 0}, Vec2{640, 480}, Vec2{-700, 1000}, Vec2{320.5, 1e-9}}) {
        EXPECT_NEAR(length(camera.generate(film).d), 1, 1e-15);
    }
}

// A camera a million units away from zero sees what the same camera sees at zero.
TEST(Camera, IsRelativeToTheOrigin) {
    const Vec3 far{1e6, -2e6, 3e6};
    const Vec3 from{0.25, 0.5, 8};
    const Vec3 at{0, 0.5, 0};
    const Ray near_ray = make(PerspectiveCamera{from, at}).generate({100, 50});
    const Ray far_ray =
        make(PerspectiveCamera{from + far, at + far}, kWide, far).generate({100, 50});
    expect_near(far_ray.o, near_ray.o, 1e-15);
    expect_near(far_ray.d, near_ray.d, 1e-15);
}

// `height` is what the picture's height shows; rays are parallel and begin in one plane.
TEST(OrthographicCamera, ShowsItsHeight) {
    const Camera camera = make(OrthographicCamera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 3});
    expect_near(camera.generate({320, 240}).o, {0, 0, 5});
    expect_near(camera.generate({320, 0}).o, {0, 1.5, 5});
    expect_near(camera.generate({640, 480}).o, {2, -1.5, 5});
    expect_near(camera.generate({17, 400}).d, {0, 0, -1});
}

std::vector<std::string> pointers(const CameraDescription& description) {
    const auto camera = Camera::create(description, kWide, {});
    if (camera) return {};
    EXPECT_EQ(camera.error().kind, ErrorKind::InvalidInput);
    std::vector<std::string> found;
    for (const Problem& p : camera.error().problems) found.push_back(p.pointer);
    return found;
}

TEST(Camera, RefusesWhatCannotSee) {
    using Found = std::vector<std::string>;
    const Vec3 x{1, 0, 0};
    const Real nan = std::nan("");
    EXPECT_EQ(pointers(PerspectiveCamera{x, x}), Found{"/from"});
    EXPECT_EQ(pointers(PerspectiveCamera{{nan, 0, 0}, x}), Found{"/from"});
    EXPECT_EQ(pointers(PerspectiveCamera{{1e6, 0, 0}, {1e6, 1e-8, 0}, x}), Found{"/from"});
    EXPECT_EQ(pointers(PerspectiveCamera{{}, x, x}), Found{"/up"});
    EXPECT_EQ(pointers(PerspectiveCamera{{}, x, -1e-9 * x}), Found{"/up"});
    EXPECT_EQ(pointers(PerspectiveCamera{{}, x, {}}), Found{"/up"});
    EXPECT_EQ(pointers(PerspectiveCamera{{}, x, {0, nan, 0}}), Found{"/up"});
    EXPECT_EQ(pointers(PerspectiveCamera{{}, x, {0, 1, 0}, 180}), Found{"/fov_deg"});
    EXPECT_EQ(pointers(OrthographicCamera{{}, x, x, -1}), (Found{"/up", "/height"}));
    EXPECT_EQ(pointers(OrthographicCamera{{}, x, {0, 1, 0}, 1e-9}), Found{});
}

}  // namespace
}  // namespace bouguer::renderer
