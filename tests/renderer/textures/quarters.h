// SPDX-License-Identifier: Apache-2.0
// A picture of four grey quarters, and what is seen of it.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <utility>

#include "renderer/textures/image_texture.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer::test {

/// Grey, 0.1 and 0.2 above 0.3 and 0.4, without a filter.
inline SurfaceSpectrum quarters(const UvMapping& mapping = {}) {
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 2;
    image->samples = std::vector<float>{0.1F, 0.2F, 0.3F, 0.4F};
    ImageTextureOptions options;
    options.encoding = ColourEncoding::Linear;
    options.filter = TextureFilter::Nearest;
    options.mapping = mapping;
    return {constant_spectrum(1), image_texture(std::move(image), options).value()};
}

/// Y in the middle of the picture's quarters: upper left, upper right, lower left, lower right.
inline std::array<float, 4> seen(const SceneBuilder& scene) {
    RenderSettings settings;
    settings.resolution = {16, 16};
    const Picture picture = *render(scene.build(), settings, 4)->picture();
    const auto y = [&](std::size_t column, std::size_t row) {
        return picture.xyz[3 * (16 * row + column) + 1];
    };
    return {y(4, 4), y(12, 4), y(4, 12), y(12, 12)};
}

inline void expect_quarters_of(const std::array<float, 4>& found,
                               const std::array<float, 4>& whole) {
    const std::array expected{0.1F, 0.2F, 0.3F, 0.4F};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i] / whole[i], expected[i], 1e-5) << i;
}

}  // namespace bouguer::renderer::test
