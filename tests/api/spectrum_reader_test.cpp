// SPDX-License-Identifier: Apache-2.0
#include "api/spectrum_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "renderer/spectrum/spectra.h"
#include "tests/api/json_testing.h"

namespace bouguer::api {
namespace {

/// Pointers and codes of what was reported, one a line, sorted.
std::string places_of(Problems problems) {
    if (problems.empty()) return {};
    const Error error = std::move(problems).to_error(ErrorKind::InvalidInput);
    std::vector<std::string> lines;
    for (const Problem& problem : error.problems) {
        lines.push_back(problem.pointer + " " + problem.code + "\n");
    }
    std::sort(lines.begin(), lines.end());
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

/// A reader over the `spectra` of a scene, and what it makes of a value at /here.
class SpectrumReaderTest : public ::testing::Test {
  protected:
    renderer::SpectrumPtr index(const char* text) {
        json_ = tests::tree_of(text);
        return reader().index(JsonValue(json_->root(), "/here", problems_));
    }
    std::optional<renderer::ComplexIndex> metal(const char* text) {
        json_ = tests::tree_of(text);
        return reader().metal(JsonValue(json_->root(), "/here", problems_));
    }
    renderer::SpectrumPtr factor(const char* text) {
        json_ = tests::tree_of(text);
        return reader().factor(JsonValue(json_->root(), "/here", problems_));
    }
    renderer::SpectrumPtr emission(const char* text) {
        json_ = tests::tree_of(text);
        return reader().emission(JsonValue(json_->root(), "/here", problems_));
    }
    /// The share of energy outside the rendered range that is noted of a light; 0 without a note.
    double share_outside(const char* text) {
        EXPECT_TRUE(emission(text)) << text;
        return notes().outside_range.largest();
    }
    /// Of the newest reader.
    const renderer::SpectrumNotes& notes() { return reader_->notes(); }
    /// What was reported since the last call.
    std::string places() { return places_of(std::exchange(problems_, Problems(limits_.problems))); }

  private:
    SpectrumReader& reader() {
        reader_.emplace(JsonValue(definitions_.root(), "/spectra", problems_), limits_);
        return *reader_;
    }

    const Limits limits_;
    const JsonTree definitions_ = tests::tree_of(R"({
        "glass": { "n_d": 1.5168, "v_d": 64.17 },
        "alias": "glass",
        "lamp": { "blackbody_K": 2856 },
        "infrared": { "wavelengths_nm": [800, 860], "values": [1, 1] },
        "oil": { "wavelengths_nm": [400, 700], "values": [1.53, 1.51] } })");
    std::optional<JsonTree> json_;
    Problems problems_{limits_.problems};
    std::optional<SpectrumReader> reader_;
};

TEST_F(SpectrumReaderTest, AnIndexIsANumberFrom1To10) {
    EXPECT_EQ(index("1.5")->at(550), 1.5);
    EXPECT_TRUE(index("1")->is_constant());
    EXPECT_EQ(index("10")->at(550), 10);
    EXPECT_EQ(places(), "");
    EXPECT_FALSE(index("0.99"));
    EXPECT_EQ(places(), "/here out-of-range\n");
    EXPECT_FALSE(index("10.01"));
    EXPECT_EQ(places(), "/here out-of-range\n");
}

// The catalogue's n_d of N-BK7 is 1.5168 (Schott 2017-01-20b).
TEST_F(SpectrumReaderTest, AnIndexIsANameOfTheSceneOrOfTheLibrary) {
    EXPECT_NEAR(index(R"("N-BK7")")->at(587.5618), 1.5168, 5e-6);
    EXPECT_NEAR(index(R"("glass")")->at(587.5618), 1.5168, 1e-12);
    EXPECT_NEAR(index(R"("alias")")->at(587.5618), 1.5168, 1e-12);
    EXPECT_NEAR(index(R"("oil")")->at(550), 1.52, 1e-12);
    EXPECT_EQ(places(), "");
    EXPECT_FALSE(index(R"("N-BK8")"));
    EXPECT_EQ(places(), "/here unknown-name\n");
    EXPECT_FALSE(index(R"("lamp")"));
    EXPECT_EQ(places(), "/here out-of-range\n");
}

TEST_F(SpectrumReaderTest, AnIndexIsAFormula) {
    // n^2 - 1 = 0.5 L^2 / (L^2 - 0.01) at L = 0.5 um: 0.5 * 0.25 / 0.24
    const auto sellmeier = index(R"({ "sellmeier_b": [0.5], "sellmeier_c_um2": [0.01] })");
    EXPECT_NEAR(sellmeier->at(500), std::sqrt(1 + 0.125 / 0.24), 1e-12);
    EXPECT_NEAR(index(R"({ "cauchy_um": [1.5, 0.004] })")->at(500), 1.5 + 0.004 / 0.25, 1e-12);
    // v_d = (n_d - 1) / (n_F - n_C)
    const auto abbe = index(R"({ "n_d": 1.6, "v_d": 30 })");
    EXPECT_NEAR(abbe->at(486.1327) - abbe->at(656.2725), 0.6 / 30, 1e-12);
    EXPECT_NEAR(index(R"({ "spectrum": "glass", "scale": 1.1 })")->at(587.5618), 1.1 * 1.5168,
                1e-12);
    EXPECT_EQ(places(), "");
}

TEST_F(SpectrumReaderTest, AnIndexThatNoGlassHasIsRefused) {
    // a pole at sqrt(0.25) um = 500 nm
    EXPECT_FALSE(index(R"({ "sellmeier_b": [1, 1], "sellmeier_c_um2": [0.01, 0.25] })"));
    EXPECT_EQ(places(), "/here/sellmeier_c_um2/1 pole\n");
    EXPECT_FALSE(index(R"({ "sellmeier_b": [1, 1], "sellmeier_c_um2": [0.01] })"));
    EXPECT_EQ(places(), "/here/sellmeier_c_um2 length-mismatch\n");
    EXPECT_FALSE(index(R"({ "sellmeier_b": [1] })"));
    EXPECT_EQ(places(), "/here/sellmeier_c_um2 missing\n");
    EXPECT_FALSE(index(R"({ "cauchy_um": [1.0, -0.01] })"));
    EXPECT_EQ(places(), "/here/cauchy_um out-of-range\n");
    EXPECT_FALSE(index(R"({ "cauchy_um": [] })"));
    EXPECT_EQ(places(), "/here/cauchy_um wrong-count\n");
    EXPECT_FALSE(index(R"({ "n_d": 0.5, "v_d": 0 })"));
    EXPECT_EQ(places(), "/here/n_d out-of-range\n/here/v_d out-of-range\n");
    EXPECT_FALSE(index(R"({ "n_d": 1.5, "vd": 30 })"));
    EXPECT_EQ(places(), "/here/v_d missing\n/here/vd unknown-key\n");
    EXPECT_FALSE(index(R"({ "wavelengths_nm": [400, 500, 700], "values": [1.5, 0.9, 1.5] })"));
    EXPECT_EQ(places(), "/here out-of-range\n");
    EXPECT_FALSE(index(R"([1.5])"));
    EXPECT_EQ(places(), "/here wrong-type\n");
}

// Samples beyond what is rendered do not matter; a sample between two whole nanometres does.
TEST_F(SpectrumReaderTest, ASampledIndexIsJudgedInTheRenderedRange) {
    EXPECT_TRUE(index(R"({ "wavelengths_nm": [200, 350, 900, 999], "values": [0, 2, 2, 0] })"));
    EXPECT_EQ(places(), "");
    EXPECT_FALSE(index(
        R"({ "wavelengths_nm": [400, 500.4, 500.5, 500.6, 700], "values": [2, 2, 0.5, 2, 2] })"));
    EXPECT_EQ(places(), "/here out-of-range\n");
}

// An index of 1 would pass for a factor by its values; what it is decides.
TEST_F(SpectrumReaderTest, AnIndexIsNothingElse) {
    for (const char* text :
         {R"("N-BK7")", R"("alias")", R"({ "n_d": 1, "v_d": 60 })",
          R"({ "spectrum": "glass", "scale": 0.5 })", R"({ "product": [0.1, "glass"] })"}) {
        EXPECT_FALSE(factor(text)) << text;
        EXPECT_EQ(places(), "/here wrong-quantity\n") << text;
    }
}

// Copper reflects red: there n is below 1 and k above 3 [Johnson and Christy 1972, table I].
TEST_F(SpectrumReaderTest, AMetalIsANameOrNAndK) {
    const auto copper = metal(R"("Cu")");
    ASSERT_TRUE(copper);
    EXPECT_LT(copper->n->at(650), 1);
    EXPECT_GT(copper->k->at(650), 3);
    const auto own =
        metal(R"({ "n": 0.2, "k": { "wavelengths_nm": [400, 700], "values": [2, 4] } })");
    ASSERT_TRUE(own);
    EXPECT_EQ(own->n->at(500), 0.2);
    EXPECT_NEAR(own->k->at(550), 3, 1e-12);
    EXPECT_TRUE(metal(R"({ "n": "glass", "k": 0 })"));
    EXPECT_EQ(places(), "");
}

TEST_F(SpectrumReaderTest, AMetalThatCannotBeIsRefused) {
    EXPECT_FALSE(metal(R"("Xx")"));
    EXPECT_EQ(places(), "/here unknown-name\n");
    EXPECT_FALSE(metal(R"(1.5)"));
    EXPECT_EQ(places(), "/here wrong-type\n");
    EXPECT_FALSE(metal(R"({})"));
    EXPECT_EQ(places(), "/here/k missing\n/here/n missing\n");
    EXPECT_FALSE(metal(R"({ "n": 0, "k": 101 })"));
    EXPECT_EQ(places(), "/here/k out-of-range\n/here/n out-of-range\n");
    EXPECT_FALSE(metal(R"({ "n": 100.5, "k": "glass", "kappa": 1 })"));
    EXPECT_EQ(places(), "/here/k wrong-quantity\n/here/kappa unknown-key\n/here/n out-of-range\n");
}

// 800 to 860 nm at one height: 30 of 60 nm lie outside; what is read beyond the samples does not.
// Transmittances come as they are written, to the last digit of double, in every form that keeps
// their value.
TEST_F(SpectrumReaderTest, AFactorKeepsItsDigits) {
    for (const double t : {1e-300, 1e-40, 0.99999993, 0.999999999999}) {
        char text[200];
        std::snprintf(text, sizeof text, "%.17g", t);
        EXPECT_EQ(factor(text)->at(550), t);
        std::snprintf(text, sizeof text,
                      R"({"wavelengths_nm": [400, 500, 600], "values": [0.5, %.17g, %.17g]})", t,
                      t);
        EXPECT_EQ(factor(text)->at(550), t);
        std::snprintf(text, sizeof text, R"({"spectrum": 1, "scale": %.17g})", t);
        EXPECT_EQ(factor(text)->at(550), t);
        EXPECT_EQ(places(), "");
    }
}

TEST_F(SpectrumReaderTest, EnergyOutsideTheRenderedRangeIsNoted) {
    EXPECT_NEAR(share_outside(R"({ "wavelengths_nm": [800, 860], "values": [2, 2] })"), 0.5, 1e-3);
    EXPECT_NEAR(share_outside(R"({ "first_nm": 800, "step_nm": 60, "values": [2, 2] })"), 0.5,
                1e-3);
    EXPECT_NEAR(share_outside(R"({ "spectrum": "infrared", "scale": 7 })"), 0.5, 1e-3);
    ASSERT_EQ(notes().outside_range.count(), 1U);
    EXPECT_EQ(notes().outside_range.worst().front().where, "/here");
    EXPECT_NEAR(share_outside(R"({ "product": ["infrared", "lamp", 0.5] })"), 0.5, 0.02);
    EXPECT_NEAR(share_outside(R"({ "line_nm": 1064, "width_nm": 1, "integral": 1 })"), 1, 1e-12);
    EXPECT_NEAR(share_outside(R"({ "line_nm": 830, "width_nm": 0.1, "integral": 1 })"), 0.5, 1e-2);
    EXPECT_NEAR(share_outside(R"({ "center_nm": 830, "fwhm_nm": 20, "peak": 1 })"), 0.5, 1e-2);
    for (const char* text :
         {"1", R"("D65")", R"("lamp")", R"({ "blackbody_K": 300, "absolute": true })",
          R"({ "wavelengths_nm": [400, 700], "values": [1, 1] })",
          R"({ "center_nm": 550, "fwhm_nm": 20, "peak": 1 })"}) {
        EXPECT_EQ(share_outside(text), 0) << text;
    }
}

// What goes through a filter has no energy of its own.
TEST_F(SpectrumReaderTest, OnlyLightsAreNotedToHaveEnergyOutside) {
    EXPECT_TRUE(factor(R"({ "wavelengths_nm": [300, 1000], "values": [1, 1] })"));
    EXPECT_EQ(notes().outside_range.count(), 0U);
}

TEST_F(SpectrumReaderTest, UpliftedColoursAreNoted) {
    EXPECT_TRUE(factor(R"({ "product": [{ "srgb": [0.1, 0.5, 0.9] }, { "hex": "#fa0" }] })"));
    const auto& uplift = notes().uplift;
    ASSERT_EQ(uplift.count(), 2U);
    // the fit meets every colour of the display far below what can be seen
    EXPECT_LT(uplift.largest(), 1e-5);
    std::vector<std::string> places{uplift.worst()[0].where, uplift.worst()[1].where};
    std::sort(places.begin(), places.end());
    EXPECT_EQ(places, (std::vector<std::string>{"/here/product/0", "/here/product/1"}));
}

// Planck's law at 500 nm and 5000 K is 1.2107e4 W m^-2 sr^-1 nm^-1.
TEST_F(SpectrumReaderTest, ABlackBodyMayBeAbsolute) {
    const auto absolute = emission(R"({ "blackbody_K": 5000, "absolute": true })");
    EXPECT_NEAR(absolute->at(500), renderer::planck_W_per_m3_sr(500, 5000) * 1e-9, 1e-9);
    EXPECT_NEAR(absolute->at(500), 1.2107e4, 1);
    EXPECT_NEAR(emission(R"({ "blackbody_K": 5000, "absolute": false })")->at(560), 1, 1e-12);
    EXPECT_TRUE(emission(R"({ "blackbody_K": 20, "absolute": true })"));
    EXPECT_EQ(places(), "");
    EXPECT_FALSE(emission(R"({ "blackbody_K": 20 })"));
    EXPECT_EQ(places(), "/here/blackbody_K out-of-range\n");
    EXPECT_FALSE(emission(R"({ "blackbody_K": 0, "absolute": true })"));
    EXPECT_EQ(places(), "/here/blackbody_K out-of-range\n");
    static_cast<void>(emission(R"({ "blackbody_K": 3000, "absolute": "yes" })"));
    EXPECT_EQ(places(), "/here/absolute wrong-type\n");
}

}  // namespace
}  // namespace bouguer::api
