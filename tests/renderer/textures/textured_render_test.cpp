// SPDX-License-Identifier: Apache-2.0
// Textures all the way into a picture: on what is reflected, what goes through and what shines.
#include "tests/renderer/textures/quarters.h"

namespace bouguer::renderer {
namespace {

using test::expect_quarters_of;
using test::quarters;
using test::seen;

/// The square [-1, 1]^2 at height z, u to the right and v up.
Shape square(Real z) {
    TriangleMesh mesh;
    mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// Looks straight down on the square and nothing else.
test::SceneBuilder above() {
    test::SceneBuilder builder;
    builder.description.camera = OrthographicCamera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2};
    return builder;
}

TEST(TexturedRender, ReflectsByTheTexture) {
    const auto lit = [](SurfaceSpectrum reflectance) {
        HallMaterial surface = test::matt(1);
        surface.reflectance = std::move(reflectance);
        auto scene = above();
        scene.add(square(0), surface).light(DirectionalLight{{0, 0, -1}, constant_spectrum(1)});
        return seen(scene);
    };
    expect_quarters_of(lit(quarters()), lit(constant_spectrum(1)));
}

TEST(TexturedRender, ShinesByTheTexture) {
    const auto shining = [](SurfaceSpectrum emission) {
        auto scene = above();
        scene.add(square(0), test::matt(0));
        scene.description.materials[0].emission = std::move(emission);
        return seen(scene);
    };
    expect_quarters_of(shining(quarters()), shining(constant_spectrum(1)));
}

TEST(TexturedRender, LetsThroughByTheTexture) {
    const auto behind = [](SurfaceSpectrum transmittance) {
        HallMaterial pane = test::clear(1);
        pane.transmittance = std::move(transmittance);
        auto scene = above();
        scene.add(square(1), pane).add(square(0), test::matt(0));
        scene.description.materials[1].emission = constant_spectrum(1);
        return seen(scene);
    };
    expect_quarters_of(behind(quarters()), behind(constant_spectrum(1)));
}

}  // namespace
}  // namespace bouguer::renderer
