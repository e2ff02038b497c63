// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/orientation.h"

#include <algorithm>
#include <utility>

namespace bouguer::renderer {
namespace {

/// How to find the stored pixel of an upright one: exchange the coordinates, then count from the
/// other end where it says so.
struct Turn {
    bool exchange, from_right, from_bottom;
};
constexpr std::array<Turn, 9> kTurns{{{},
                                      {false, false, false},
                                      {false, true, false},
                                      {false, true, true},
                                      {false, false, true},
                                      {true, false, false},
                                      {true, false, true},
                                      {true, true, true},
                                      {true, true, false}}};

}  // namespace

void turn_upright(DecodedImage& image) {
    const Turn turn = kTurns.at(static_cast<std::size_t>(image.orientation));
    const bool is_upright = image.orientation == 1;
    image.orientation = 1;
    if (is_upright) return;
    const auto stored_width = static_cast<std::size_t>(image.width);
    const auto stored_height = static_cast<std::size_t>(image.height);
    if (turn.exchange) std::swap(image.width, image.height);
    const auto width = static_cast<std::size_t>(image.width);
    const auto channels = static_cast<std::size_t>(image.channels);
    const auto stored_place = [&](std::size_t pixel) {
        std::size_t column = pixel % width, row = pixel / width;
        if (turn.exchange) std::swap(column, row);
        if (turn.from_right) column = stored_width - 1 - column;
        if (turn.from_bottom) row = stored_height - 1 - row;
        return (row * stored_width + column) * channels;
    };
    std::visit(
        [&](auto& samples) {
            auto stored = std::exchange(samples, std::decay_t<decltype(samples)>(samples.size()));
            for (std::size_t i = 0; i < samples.size(); i += channels)
                std::copy_n(
                    stored.begin() + static_cast<std::ptrdiff_t>(stored_place(i / channels)),
                    channels, samples.begin() + static_cast<std::ptrdiff_t>(i));
        },
        image.samples);
}

}  // namespace bouguer::renderer
