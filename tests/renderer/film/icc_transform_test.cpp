// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/icc_transform.h"

#include <gtest/gtest.h>
#include <lcms2.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "renderer/film/icc_profile.h"
#include "renderer/spectrum/chromatic_adaptation.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    EXPECT_TRUE(cmsSaveProfileToMem(profile, nullptr, &size));
    Bytes bytes(size);
    EXPECT_TRUE(cmsSaveProfileToMem(profile, bytes.data(), &size));
    cmsCloseProfile(profile);
    return bytes;
}

std::array<float, 3> light_of(const Bytes& profile, std::vector<float> numbers) {
    const auto transform = IccTransform::to_linear_rec709(profile);
    EXPECT_TRUE(transform) << transform.error().message;
    std::array<float, 3> light{};
    (*transform)(numbers, light);
    return light;
}

void expect_refusal(const Bytes& profile, const std::string& words) {
    const auto transform = IccTransform::to_linear_rec709(profile);
    ASSERT_FALSE(transform) << words;
    EXPECT_EQ(transform.error().code, "bad-image");
    EXPECT_NE(transform.error().message.find(words), std::string::npos)
        << transform.error().message;
}

/// Square root of every number, by a table of 2 x 2 x 2 behind curves.
cmsPipeline* root_table() {
    cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, 3, 3);
    cmsToneCurve* root = cmsBuildGamma(nullptr, 0.5);
    const std::array curves{root, root, root};
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, curves.data()));
    cmsStage* table = cmsStageAllocCLut16bit(nullptr, 2, 3, 3, nullptr);
    cmsStageSampleCLut16bit(
        table,
        [](const cmsUInt16Number in[], cmsUInt16Number out[], void*) {
            // X, Y, Z of white are 0.9642, 1 and 0.8249 where 1 + 32767/32768 is 65535
            const double y = (in[0] + in[1] + in[2]) / 3.0 / 2.0;
            out[0] = static_cast<cmsUInt16Number>(y * 0.9642);
            out[1] = static_cast<cmsUInt16Number>(y);
            out[2] = static_cast<cmsUInt16Number>(y * 0.8249);
            return 1;
        },
        nullptr, 0);
    cmsPipelineInsertStage(pipeline, cmsAT_END, table);
    cmsToneCurve* line = cmsBuildGamma(nullptr, 1);
    const std::array lines{line, line, line};
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, lines.data()));
    cmsFreeToneCurve(line);
    cmsFreeToneCurve(root);
    return pipeline;
}

/// A profile of version 4 with root_table() for its colours.
cmsHPROFILE table_profile() {
    cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.3);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    cmsSetColorSpace(profile, cmsSigRgbData);
    cmsSetPCS(profile, cmsSigXYZData);
    cmsPipeline* table = root_table();
    EXPECT_TRUE(cmsWriteTag(profile, cmsSigAToB0Tag, table));
    cmsPipelineFree(table);
    return profile;
}

// Each display's own profile says what its matrix and curve say, adapted to the white of Rec.709.
TEST(IccTransform, AgreesWithTheDisplaysOfTheProfiles) {
    const auto& rec709 = *find_display("rec709-linear");
    for (const Display& display : displays()) {
        if (display.name == "xyz") continue;  // its white has no grey of its own in the profile
        const bool is_encoded = display.encode == &srgb_encode;
        const auto decode = [&](double v) { return is_encoded ? srgb_decode(v) : v; };
        const auto expected =
            rec709.from_xyz *
            (adaptation_matrix(Adaptation::Bradford, display.chromaticities[3],
                               rec709.chromaticities[3]) *
             (inverse(display.from_xyz) * std::array{decode(0.5), decode(0.25), decode(0.75)}));
        const auto light = light_of(icc_profile(display), {0.5F, 0.25F, 0.75F});
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(light[k], expected[k], 2e-4) << display.name << k;
    }
}

// The mean of the roots of 0.25, 0.25 and 1, grey.
TEST(IccTransform, ReadsTables) {
    const auto light = light_of(bytes_of(table_profile()), {0.25F, 0.25F, 1});
    for (const float v : light) EXPECT_NEAR(v, 2.0 / 3, 2e-3);
}

TEST(IccTransform, ReadsGreys) {
    cmsToneCurve* gamma = cmsBuildGamma(nullptr, 1.8);
    const Bytes profile = bytes_of(cmsCreateGrayProfile(cmsD50_xyY(), gamma));
    cmsFreeToneCurve(gamma);
    EXPECT_EQ(IccTransform::to_linear_rec709(profile)->channels(), 1);
    for (const float v : light_of(profile, {0.5F})) EXPECT_NEAR(v, std::pow(0.5, 1.8), 1e-4);
}

// Multi-process elements may be any number of steps in no more bytes: the tables count.
TEST(IccTransform, LeavesMultiProcessElementsAside) {
    cmsHPROFILE profile = table_profile();
    cmsPipeline* black = cmsPipelineAlloc(nullptr, 3, 3);
    const std::array<double, 9> zeros{};
    cmsPipelineInsertStage(black, cmsAT_END,
                           cmsStageAllocMatrix(nullptr, 3, 3, zeros.data(), nullptr));
    for (const auto tag : {cmsSigDToB0Tag, cmsSigDToB1Tag})
        EXPECT_TRUE(cmsWriteTag(profile, tag, black));
    cmsPipelineFree(black);
    EXPECT_NEAR(light_of(bytes_of(profile), {0.25F, 0.25F, 1})[0], 2.0 / 3, 2e-3);
}

TEST(IccTransform, RefusesWhatDescribesNoPicture) {
    expect_refusal({}, "cannot be read");
    expect_refusal(Bytes(200, 'x'), "cannot be read");
    const Bytes whole = icc_profile(*find_display("srgb"));
    const auto with = [&](std::size_t at, std::string_view name) {
        Bytes other = whole;
        std::copy(name.begin(), name.end(), other.begin() + static_cast<std::ptrdiff_t>(at));
        return other;
    };
    expect_refusal(with(16, "CMYK"), "is one of CMYK");
    expect_refusal(with(16, "Lab "), "is one of Lab ");
    expect_refusal(with(12, "link"), "is of the class link");
    expect_refusal(with(12, "nmcl"), "is of the class nmcl");
    Bytes without_curve = whole;
    const std::string_view red = "rTRC";
    const auto at = std::search(without_curve.begin(), without_curve.end(), red.begin(), red.end());
    *at = 'x';
    expect_refusal(without_curve, "describes no colours");
    for (std::size_t size = 0; size < whole.size(); ++size)
        static_cast<void>(IccTransform::to_linear_rec709(std::span(whole).first(size)));
}

// 255 x 255 x 255 x 3 numbers of 16 bits are 99 MB, claimed by one byte.
TEST(IccTransform, RefusesTablesThatAreTooLarge) {
    Bytes profile = bytes_of(table_profile());
    const std::string_view table = "mAB ";
    const auto at = std::search(profile.begin(), profile.end(), table.begin(), table.end());
    ASSERT_NE(at, profile.end());
    const auto offset = [&](std::ptrdiff_t field) {
        return at[field] << 24 | at[field + 1] << 16 | at[field + 2] << 8 | at[field + 3];
    };
    for (int k = 0; k < 3; ++k) at[offset(24) + k] = 255;  // points along each axis
    expect_refusal(profile, "64 MiB");
}

}  // namespace
}  // namespace bouguer::renderer
