// SPDX-License-Identifier: Apache-2.0
// Textures all the way into a picture: on what is reflected, what goes through and what shines.
#include <gtest/gtest.h>

#include "renderer/textures/image_texture.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer {
namespace {

/// Grey, 0.1 and 0.2 above 0.3 and 0.4, without a filter.
SurfaceSpectrum quarters() {
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 2;
    image->samples = std::vector<float>{0.1F, 0.2F, 0.3F, 0.4F};
    return {
        constant_spectrum(1),
        image_texture(std::move(image), {ColourEncoding::Linear, TextureFilter::Nearest, {}, {}})
            .value()};
}

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

/// Y in the middle of the picture's quarters: upper left, upper right, lower left, lower right.
std::array<float, 4> seen(const test::SceneBuilder& scene) {
    RenderSettings settings;
    settings.resolution = {16, 16};
    const Picture picture = *test::render(scene.build(), settings, 4)->picture();
    const auto y = [&](std::size_t column, std::size_t row) {
        return picture.xyz[3 * (16 * row + column) + 1];
    };
    return {y(4, 4), y(12, 4), y(4, 12), y(12, 12)};
}

void expect_quarters_of(const std::array<float, 4>& found, const std::array<float, 4>& whole) {
    const std::array expected{0.1F, 0.2F, 0.3F, 0.4F};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i] / whole[i], expected[i], 1e-5) << i;
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
