// SPDX-License-Identifier: Apache-2.0
// A picture on every shape stands upright and is not mirrored, seen from outside.
#include "tests/renderer/textures/quarters.h"

namespace bouguer::renderer {
namespace {

struct View {
    const char* what;
    Shape shape;
    Vec3 from;
    Vec3 up{0, 1, 0};
    UvMapping mapping{};
};

test::SceneBuilder scene(const View& view, SurfaceSpectrum emission,
                         const Transform& transform = {}) {
    test::SceneBuilder builder;
    builder.description.camera = OrthographicCamera{view.from, {0, 0, 0}, view.up, 2};
    builder.add(view.shape, test::matt(0));
    builder.description.materials[0].emission = std::move(emission);
    builder.description.objects[0].placed.instances = {transform};
    return builder;
}

std::array<float, 4> seen(const View& view, const Transform& transform = {}) {
    return test::seen(scene(view, test::quarters(view.mapping), transform));
}

std::array<float, 4> white(const View& view, const Transform& transform = {}) {
    return test::seen(scene(view, constant_spectrum(1), transform));
}

TEST(PictureOnShapes, StandsUprightSeenFromOutside) {
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    const Sphere ball{{}, 1};
    const Cylinder can{{0, -1, 0}, {0, 1, 0}, 1};
    const UvMapping half{{0.5, 0.5}, {-1, -1}, 0};         // once over [-1, 1]^2 of a plane
    const UvMapping from_the_front{{1, 1}, {0.25, 0}, 0};  // half a turn ends at +z
    const std::vector<View> views{
        {"box +x", box, {5, 0, 0}},
        {"box -x", box, {-5, 0, 0}},
        {"box +y", box, {0, 5, 0}, {0, 0, -1}},
        {"box -y", box, {0, -5, 0}, {0, 0, 1}},
        {"box +z", box, {0, 0, 5}},
        {"box -z", box, {0, 0, -5}},
        {"sphere from -x", ball, {-5, 0, 0}},
        {"sphere from +z", ball, {0, 0, 5}, {0, 1, 0}, from_the_front},
        {"cylinder from -x", can, {-5, 0, 0}},
        {"cylinder from +z", can, {0, 0, 5}, {0, 1, 0}, from_the_front},
        {"upper cap", can, {0, 5, 0}, {0, 0, -1}},
        {"lower cap", can, {0, -5, 0}, {0, 0, 1}},
        {"cylinder along z", Cylinder{{0, 0, -1}, {0, 0, 1}, 1}, {-5, 0, 0}, {0, 0, 1}},
        {"its far cap", Cylinder{{0, 0, -1}, {0, 0, 1}, 1}, {0, 0, -5}},
        {"disk, front", Disk{{}, {0, 0, 1}, 1}, {0, 0, 5}},
        {"disk, back", Disk{{}, {0, 0, -1}, 1}, {0, 0, -5}},
        {"disk, aside", Disk{{}, {1, 0, -1e-9}, 1}, {5, 0, 0}},
        {"disk, down", Disk{{}, {0, -1, 0}, 1}, {0, -5, 0}, {0, 0, 1}},
        {"wall, front", Plane{{}, {0, 0, 1}}, {0, 0, 5}, {0, 1, 0}, half},
        {"wall, back", Plane{{}, {0, 0, -1}}, {0, 0, -5}, {0, 1, 0}, half},
        {"wall, aside", Plane{{}, {1, 0, 1e-9}}, {5, 0, 0}, {0, 1, 0}, half},
        {"wall, aside, turned a little", Plane{{}, {1, 0, -1e-9}}, {5, 0, 0}, {0, 1, 0}, half},
        {"wall, other side", Plane{{}, {-1, 0, 0}}, {-5, 0, 0}, {0, 1, 0}, half},
        {"floor", Plane{{}, {0, 1, 0}}, {0, 5, 0}, {0, 0, -1}, half},
        {"floor, turned a little", Plane{{}, {-1e-9, 1, -1e-9}}, {0, 5, 0}, {0, 0, -1}, half},
        {"ceiling", Plane{{}, {0, -1, 0}}, {0, -5, 0}, {0, 0, 1}, half},
    };
    for (const View& view : views) {
        SCOPED_TRACE(view.what);
        test::expect_quarters_of(seen(view), white(view));
    }
}

// As the object is that carries it.
TEST(PictureOnShapes, IsMirroredOnAMirroredObject) {
    const Transform mirror = Transform::scale({-1, 1, 1});
    const std::vector<View> views{
        {"box", Box{{-1, -1, -1}, {1, 1, 1}}, {0, 0, 5}},
        {"disk", Disk{{}, {0, 0, 1}, 1}, {0, 0, 5}},
        {"sphere", Sphere{{}, 1}, {5, 0, 0}},
        {"plane", Plane{{}, {0, 0, 1}}, {0, 0, 5}, {0, 1, 0}, {{0.5, 0.5}, {-1, -1}, 0}},
    };
    for (const View& view : views) {
        SCOPED_TRACE(view.what);
        const auto found = seen(view, mirror);
        test::expect_quarters_of({found[1], found[0], found[3], found[2]}, white(view, mirror));
    }
}

}  // namespace
}  // namespace bouguer::renderer
