// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/icc_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

namespace bouguer::renderer {
namespace {

std::uint32_t u32(const std::vector<std::uint8_t>& profile, std::size_t at) {
    std::uint32_t v = 0;
    for (std::size_t i = 0; i < 4; ++i) v = v << 8U | profile.at(at + i);
    return v;
}

double number(const std::vector<std::uint8_t>& profile, std::size_t at) {
    return static_cast<std::int32_t>(u32(profile, at)) / 65536.0;
}

std::string name(const std::vector<std::uint8_t>& profile, std::size_t at) {
    return {profile.begin() + static_cast<std::ptrdiff_t>(at),
            profile.begin() + static_cast<std::ptrdiff_t>(at) + 4};
}

/// Where a tag's element stands.
std::optional<std::size_t> find_tag(const std::vector<std::uint8_t>& profile,
                                    const std::string& tag) {
    for (std::size_t i = 0; i < u32(profile, 128); ++i)
        if (name(profile, 132 + 12 * i) == tag) return u32(profile, 132 + 12 * i + 4);
    return std::nullopt;
}

// The colorants of sRGB, adapted to D50, as every published sRGB profile has them.
TEST(IccProfile, HasTheKnownColorantsOfSrgb) {
    const auto profile = icc_profile(*find_display("srgb"));
    const std::pair<const char*, std::array<double, 3>> kExpected[] = {
        {"rXYZ", {0.4361, 0.2225, 0.0139}},
        {"gXYZ", {0.3851, 0.7169, 0.0971}},
        {"bXYZ", {0.1431, 0.0606, 0.7141}}};
    for (const auto& [tag, xyz] : kExpected) {
        const auto at = find_tag(profile, tag);
        ASSERT_TRUE(at);
        EXPECT_EQ(name(profile, *at), "XYZ ");
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(number(profile, *at + 8 + 4 * i), xyz[i], 2e-4) << tag;
    }
}

// White is the profile's white, whatever the display's: the three colorants sum to D50.
TEST(IccProfile, WhiteIsD50) {
    for (const Display& display : displays()) {
        const auto profile = icc_profile(display);
        constexpr std::array kD50{0.9642, 1.0, 0.8249};
        for (std::size_t i = 0; i < 3; ++i) {
            double sum = 0;
            for (const char* tag : {"rXYZ", "gXYZ", "bXYZ"})
                sum += number(profile, *find_tag(profile, tag) + 8 + 4 * i);
            EXPECT_NEAR(sum, kD50[i], 3e-4) << display.name;
        }
    }
}

// ICC.1:2022, 7.2: what a reader checks first.
TEST(IccProfile, IsWellFormed) {
    for (const Display& display : displays()) {
        const auto profile = icc_profile(display);
        EXPECT_EQ(u32(profile, 0), profile.size());
        EXPECT_EQ(profile.size() % 4, 0U);
        EXPECT_EQ(name(profile, 12), "mntr");
        EXPECT_EQ(name(profile, 36), "acsp");
        for (std::size_t i = 0; i < u32(profile, 128); ++i) {
            const std::size_t at = u32(profile, 132 + 12 * i + 4);
            EXPECT_EQ(at % 4, 0U);
            EXPECT_LE(at + u32(profile, 132 + 12 * i + 8), profile.size());
        }
        EXPECT_EQ(profile, icc_profile(display));
    }
}

}  // namespace
}  // namespace bouguer::renderer
