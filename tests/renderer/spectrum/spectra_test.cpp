// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {
namespace {

TEST(Spectra, ConstantsAreTheSameEverywhere) {
    const SpectrumPtr s = constant_spectrum(0.3);
    EXPECT_TRUE(s->is_constant());
    EXPECT_EQ(s->at(360), 0.3);
    EXPECT_EQ(s->at(830), 0.3);
}

TEST(Spectra, ScaledKnowsWhatItIsAMultipleOf) {
    const SpectrumPtr d65 = library_spectrum("D65");
    const SpectrumPtr s = scaled_spectrum(scaled_spectrum(d65, 2), 3);
    EXPECT_DOUBLE_EQ(s->at(450), 6 * d65->at(450));
    EXPECT_EQ(s->as_multiple().base, d65.get());
    EXPECT_EQ(s->as_multiple().factor, 6);
    EXPECT_FALSE(s->is_constant());
    EXPECT_TRUE(scaled_spectrum(constant_spectrum(2), 3)->is_constant());
}

TEST(Spectra, ProductsMultiply) {
    const SpectrumPtr d65 = library_spectrum("D65"), glass = library_spectrum("IVG530");
    EXPECT_DOUBLE_EQ(product_spectrum(d65, glass)->at(500), d65->at(500) * glass->at(500));
    // With a constant it is a multiple, so the plan still sees the lamp's colour.
    EXPECT_EQ(product_spectrum(d65, constant_spectrum(0.5))->as_multiple().base, d65.get());
    EXPECT_EQ(product_spectrum(constant_spectrum(0.5), d65)->as_multiple().factor, 0.5);
    EXPECT_TRUE(product_spectrum(constant_spectrum(2), constant_spectrum(3))->is_constant());
}

TEST(Spectra, HexIsSrgb) {
    double delta_e = -1;
    const auto s = hex_spectrum("#c08040", &delta_e);
    ASSERT_TRUE(s);
    EXPECT_LT(delta_e, 1e-6);
    EXPECT_EQ((*s)->at(500), (*srgb_spectrum(0xc0 / 255.0, 0x80 / 255.0, 0x40 / 255.0))->at(500));
    EXPECT_EQ((*hex_spectrum("#Fff"))->at(500), 1);
    EXPECT_EQ((*hex_spectrum("#777"))->at(500), (*hex_spectrum("#777777"))->at(500));
    for (const char* bad :
         {"", "#", "c08040", "#c0804", "#c0804g", "#-1-1-1", "#c080400", "#c 8040"}) {
        const auto refused = hex_spectrum(bad);
        ASSERT_FALSE(refused) << bad;
        EXPECT_EQ(refused.error().problems.at(0).pointer, "/hex");
    }
}

TEST(Library, IlluminantsAreOneAt560) {
    for (const LibraryEntry& entry : library_entries()) {
        if (entry.kind != "illuminant") continue;
        EXPECT_NEAR(library_spectrum(entry.name)->at(560), 1, 1e-12) << entry.name;
    }
}

// CIE 15:2018, D65: 46.6383 at 360 nm, 60.3125 at 830 nm, 100 at 560 nm.
TEST(Library, D65IsThePublishedTable) {
    EXPECT_NEAR(library_spectrum("D65")->at(360), 0.466383, 1e-9);
    EXPECT_NEAR(library_spectrum("D65")->at(830), 0.603125, 1e-9);
}

TEST(Library, EveryEntryIsDocumentedAndFinite) {
    const auto& entries = library_entries();
    EXPECT_TRUE(std::is_sorted(entries.begin(), entries.end(),
                               [](const auto& a, const auto& b) { return a.name < b.name; }));
    for (const LibraryEntry& entry : entries) {
        EXPECT_FALSE(entry.kind.empty()) << entry.name;
        EXPECT_FALSE(entry.description.empty()) << entry.name;
        EXPECT_FALSE(entry.source.empty()) << entry.name;
        const SpectrumPtr s = library_spectrum(entry.name);
        ASSERT_TRUE(s) << entry.name;
        for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; ++lambda_nm)
            ASSERT_TRUE(std::isfinite(s->at(lambda_nm)) && s->at(lambda_nm) >= 0)
                << entry.name << " at " << lambda_nm;
    }
}

// One object a name, so that two lamps of that name are seen to have one colour.
TEST(Library, GivesOneSpectrumAName) {
    EXPECT_EQ(library_spectrum("A"), library_spectrum("A"));
    EXPECT_EQ(library_spectrum("a"), nullptr);
    EXPECT_EQ(library_spectrum(""), nullptr);
}

}  // namespace
}  // namespace bouguer::renderer
