// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/channel_tables.h"

#include <cmath>

namespace bouguer::renderer {
namespace {

constexpr std::size_t kAll = 3;  ///< in the place of a channel

/// The light of every number in one channel, or in all of them.
std::vector<float> light_of_numbers(const ToRec709& to_light, std::size_t last,
                                    std::size_t channel) {
    std::vector<float> pixels(3 * (last + 1));
    for (std::size_t i = 0; i <= last; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (channel == kAll || channel == k)
                pixels[3 * i + k] = static_cast<float>(i) / static_cast<float>(last);
    to_light(pixels);
    return pixels;
}

/// Numbers that are spread over [0, last].
std::vector<std::array<std::size_t, 3>> probes(std::size_t last) {
    constexpr std::size_t kSteps = 8;
    std::vector<std::array<std::size_t, 3>> all;
    for (std::size_t i = 0; i < kSteps * kSteps * kSteps; ++i) {
        const std::array steps{i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps};
        all.push_back({});
        for (std::size_t k = 0; k < 3; ++k) all.back()[k] = steps[k] * last / (kSteps - 1);
    }
    return all;
}

}  // namespace

std::optional<ChannelTables> ChannelTables::make(const ToRec709& to_light, std::size_t last,
                                                 bool is_grey) {
    ChannelTables tables;
    tables.grey_ = light_of_numbers(to_light, last, kAll);
    if (is_grey) return tables;
    for (std::size_t k = 0; k < 3; ++k) {
        Table& table = tables.channels_[k];
        table = light_of_numbers(to_light, last, k);
        const std::array black{table[0], table[1], table[2]};
        for (std::size_t i = 0; k > 0 && i < table.size(); ++i) table[i] -= black[i % 3];
    }
    for (const auto& numbers : probes(last)) {
        std::array<float, 3> light{};
        for (std::size_t k = 0; k < 3; ++k)
            light[k] = static_cast<float>(numbers[k]) / static_cast<float>(last);
        to_light(light);
        const auto found = tables(numbers);
        for (std::size_t k = 0; k < 3; ++k)
            if (!(std::abs(found[k] - light[k]) <= 2e-5F)) return std::nullopt;
    }
    return tables;
}

std::array<float, 3> ChannelTables::operator()(std::array<std::size_t, 3> numbers) const {
    std::array<float, 3> light{};
    const auto [r, g, b] = numbers;
    for (std::size_t k = 0; k < 3; ++k)
        light[k] = r == g && g == b ? grey_[3 * r + k]
                                    : channels_[0][3 * r + k] + channels_[1][3 * g + k] +
                                          channels_[2][3 * b + k];
    return light;
}

}  // namespace bouguer::renderer
