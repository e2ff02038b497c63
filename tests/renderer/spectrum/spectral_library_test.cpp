// SPDX-License-Identifier: Apache-2.0
// The library's spectra against what is published of them.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/colour_difference.h"
#include "renderer/spectrum/refractive_index.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

struct NamedChromaticity {
    std::string_view name;
    double x, y;
};

// CIE 15:2018: chromaticities of the lamps for the 2-degree observer, given to four or five digits.
constexpr NamedChromaticity kLamps[] = {
    {"F1", 0.3131, 0.3371},       {"F2", 0.3721, 0.3751},     {"F3", 0.4091, 0.3941},
    {"F4", 0.4402, 0.4031},       {"F5", 0.3138, 0.3452},     {"F6", 0.3779, 0.3882},
    {"F7", 0.3129, 0.3292},       {"F8", 0.3458, 0.3586},     {"F9", 0.3741, 0.3727},
    {"F10", 0.3458, 0.3588},      {"F11", 0.3805, 0.3769},    {"F12", 0.4370, 0.4042},
    {"LED-B1", 0.4560, 0.4078},   {"LED-B2", 0.4357, 0.4012}, {"LED-B3", 0.3756, 0.3723},
    {"LED-B4", 0.3422, 0.3502},   {"LED-B5", 0.3118, 0.3236}, {"LED-BH1", 0.4474, 0.4066},
    {"LED-RGB1", 0.4557, 0.4211}, {"LED-V1", 0.4548, 0.4044}, {"LED-V2", 0.3781, 0.3775},
};

// The published figures are sums at 5 nm from 380 to 780 nm.
TEST(Library, LampsHaveTheirPublishedChromaticities) {
    for (const auto& [name, x, y] : kLamps) {
        ASSERT_TRUE(library_spectrum(name)) << name;
        const Chromaticity c = chromaticity(xyz_of(*library_spectrum(name), 5));
        EXPECT_NEAR(c.x, x, 2e-4) << name;
        EXPECT_NEAR(c.y, y, 2e-4) << name;
    }
}

struct PatchColour {
    std::string_view name;
    double x, y, Y;
};

// BabelColor, average of 30 charts: x, y, Y under D50, published with the reflectances.
constexpr PatchColour kPatches[] = {
    {"ColorChecker-dark-skin", 0.4325, 0.3788, 0.1034},
    {"ColorChecker-light-skin", 0.4191, 0.3748, 0.3525},
    {"ColorChecker-blue-sky", 0.2761, 0.3004, 0.1847},
    {"ColorChecker-foliage", 0.3700, 0.4501, 0.1335},
    {"ColorChecker-blue-flower", 0.3020, 0.2877, 0.2324},
    {"ColorChecker-bluish-green", 0.2856, 0.3910, 0.4174},
    {"ColorChecker-orange", 0.5291, 0.4075, 0.3117},
    {"ColorChecker-purplish-blue", 0.2339, 0.2155, 0.1140},
    {"ColorChecker-moderate-red", 0.5008, 0.3293, 0.1979},
    {"ColorChecker-purple", 0.3326, 0.2556, 0.0644},
    {"ColorChecker-yellow-green", 0.3989, 0.4998, 0.4435},
    {"ColorChecker-orange-yellow", 0.4962, 0.4428, 0.4358},
    {"ColorChecker-blue", 0.2040, 0.1696, 0.0579},
    {"ColorChecker-green", 0.3270, 0.5033, 0.2307},
    {"ColorChecker-red", 0.5709, 0.3298, 0.1268},
    {"ColorChecker-yellow", 0.4694, 0.4732, 0.6081},
    {"ColorChecker-magenta", 0.4177, 0.2704, 0.2007},
    {"ColorChecker-cyan", 0.2151, 0.3037, 0.1903},
    {"ColorChecker-white-9.5", 0.3488, 0.3628, 0.9129},
    {"ColorChecker-neutral-8", 0.3451, 0.3596, 0.5885},
    {"ColorChecker-neutral-6.5", 0.3446, 0.3590, 0.3595},
    {"ColorChecker-neutral-5", 0.3438, 0.3589, 0.1912},
    {"ColorChecker-neutral-3.5", 0.3423, 0.3576, 0.0893},
    {"ColorChecker-black-2", 0.3439, 0.3565, 0.0320},
};

TEST(Library, ColorCheckerPatchesHaveTheirPublishedColours) {
    ASSERT_EQ(std::size(kPatches), 24U);
    const SpectrumPtr d50 = library_spectrum("D50");
    const Xyz white = xyz_of_reflectance(*constant_spectrum(1), *d50);
    for (const auto& [name, x, y, luminance] : kPatches) {
        ASSERT_TRUE(library_spectrum(name)) << name;
        const Xyz found = xyz_of_reflectance(*library_spectrum(name), *d50);
        const Xyz published{x / y * luminance, luminance, (1 - x - y) / y * luminance};
        EXPECT_LT(delta_e_2000(lab_of(found, white), lab_of(published, white)), 0.3) << name;
    }
}

// Absorption multiplies: twice the thickness is the square. At the sheet's own thickness the
// transmittance is the sheet's: N-BK7 of 10 mm passes 0.998 at 546 nm, N-SF11 0.815 at 400 nm.
TEST(Library, GlassesTransmitAsTheirSheetsSay) {
    EXPECT_NEAR(library_spectrum("N-BK7-10mm")->at(546), 0.998, 1e-3);
    EXPECT_NEAR(library_spectrum("N-SF11-10mm")->at(400), 0.815, 1e-3);
    EXPECT_GT(library_spectrum("IVG530")->at(530), 3 * library_spectrum("IVG530")->at(450));
    EXPECT_GT(library_spectrum("IVG530")->at(530), 1.5 * library_spectrum("IVG530")->at(640));
    for (const LibraryEntry& entry : library_entries()) {
        EXPECT_EQ(entry.kind == "transmittance", entry.thickness_mm > 0) << entry.name;
        if (entry.kind == "illuminant") continue;
        for (double lambda_nm = 360; lambda_nm <= 830; lambda_nm += 5)
            EXPECT_LE(library_spectrum(entry.name)->at(lambda_nm), 1) << entry.name;
    }
}

// One name, one meaning, whichever part of the library it is looked up in.
TEST(Library, NamesAreUnique) {
    std::set<std::string_view> names;
    for (const auto* entries : {&library_entries(), &index_entries(), &metal_entries()})
        for (const LibraryEntry& entry : *entries)
            EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_GE(names.size(), 85U);
}

}  // namespace
}  // namespace bouguer::renderer
