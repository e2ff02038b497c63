// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/refractive_index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {
namespace {

constexpr double kF_nm = 486.1327, kD_nm = 587.5618, kC_nm = 656.2725;

std::string problem_of(const Result<SpectrumPtr>& index) {
    if (index) return "none";
    EXPECT_EQ(index.error().kind, ErrorKind::InvalidInput);
    const Problem& p = index.error().problems.at(0);
    return p.pointer + " " + p.code;
}

// Data sheets: n_d and Abbe number; the textbooks' 1.333 for water and 2.417 for diamond.
TEST(LibraryIndex, HasTheCataloguesNumbers) {
    struct {
        std::string_view name;
        double n_d, v_d, tolerance;
    } constexpr kExpected[] = {
        {"N-BK7", 1.51680, 64.17, 0.005},       {"N-SF11", 1.78472, 25.68, 0.005},
        {"N-F2", 1.62005, 36.43, 0.005},        {"SF11", 1.78472, 25.76, 0.005},
        {"fused-silica", 1.45846, 67.82, 0.02}, {"sapphire", 1.76817, 72.3, 0.1},
        {"diamond", 2.4175, 55.3, 0.5},         {"water", 1.333, 55.7, 0.2},
    };
    for (const auto& [name, n_d, v_d, tolerance] : kExpected) {
        const SpectrumPtr index = library_index(name);
        ASSERT_TRUE(index) << name;
        EXPECT_NEAR(index->at(kD_nm), n_d, name == "water" ? 5e-4 : 2e-5) << name;
        EXPECT_NEAR(abbe_number(*index), v_d, tolerance) << name;
    }
    EXPECT_EQ(library_index("glass"), nullptr);
}

// Minimum deviation of a 60 degree prism: 2 asin(n sin 30) - 60, for N-BK7 in air.
TEST(LibraryIndex, BendsLightInAPrismAsItShould) {
    const SpectrumPtr bk7 = library_index("N-BK7");
    const auto deviation_deg = [&](double lambda_nm) {
        return 2 * std::asin(bk7->at(lambda_nm) / 2) * 180 / kPi - 60;
    };
    EXPECT_NEAR(deviation_deg(587.56), 38.64670, 2e-5);
    EXPECT_NEAR(deviation_deg(486.13), 39.13811, 2e-5);
    EXPECT_NEAR(deviation_deg(656.27), 38.42914, 2e-5);
}

// The tables of Johnson and Christy at 2.26 eV (548.6 nm).
TEST(LibraryMetal, HoldsThePublishedRows) {
    const ComplexIndex gold = library_metal("Au");
    ASSERT_TRUE(gold.n && gold.k);
    EXPECT_NEAR(gold.n->at(548.6), 0.43, 1e-9);
    EXPECT_NEAR(gold.k->at(548.6), 2.455, 1e-9);
    EXPECT_FALSE(library_metal("gold").n);
}

// Fresnel at normal incidence: silver is bright throughout, gold and copper dark in the blue.
TEST(LibraryMetal, HasTheColoursOfMetals) {
    const auto reflectance = [](std::string_view name, double lambda_nm) {
        const ComplexIndex metal = library_metal(name);
        const double n = metal.n->at(lambda_nm), k2 = std::pow(metal.k->at(lambda_nm), 2);
        return ((n - 1) * (n - 1) + k2) / ((n + 1) * (n + 1) + k2);
    };
    EXPECT_GT(reflectance("Ag", 450), 0.95);
    EXPECT_GT(reflectance("Al", 450), 0.9);
    EXPECT_LT(reflectance("Au", 450), 0.42);
    EXPECT_GT(reflectance("Au", 650), 0.95);
    EXPECT_LT(reflectance("Cu", 450), 0.6);
    EXPECT_GT(reflectance("Cu", 650), 0.93);
    EXPECT_LT(reflectance("brass", 450), reflectance("brass", 600) - 0.2);
    EXPECT_LT(reflectance("Ti", 550), 0.6);
}

TEST(LibraryMetal, EveryEntryIsThereAndFinite) {
    EXPECT_GE(metal_entries().size(), 7U);
    for (const LibraryEntry& entry : metal_entries()) {
        const ComplexIndex metal = library_metal(entry.name);
        ASSERT_TRUE(metal.n && metal.k) << entry.name;
        EXPECT_FALSE(entry.source.empty());
        for (double lambda_nm = 360; lambda_nm <= 830; lambda_nm += 5) {
            EXPECT_GT(metal.n->at(lambda_nm), 0) << entry.name;
            EXPECT_GT(metal.k->at(lambda_nm), 1) << entry.name;
        }
    }
    for (const LibraryEntry& entry : index_entries())
        EXPECT_TRUE(library_index(entry.name)) << entry.name;
}

TEST(Sellmeier, IsItsFormula) {
    const auto n = sellmeier_index({1, 0.5}, {0.01, 100});
    ASSERT_TRUE(n);
    EXPECT_DOUBLE_EQ((*n)->at(500),
                     std::sqrt(1 + 0.25 / (0.25 - 0.01) + 0.5 * 0.25 / (0.25 - 100)));
}

TEST(Sellmeier, RefusesPolesAndIndicesBelowOne) {
    EXPECT_EQ(problem_of(sellmeier_index({1, 0.1}, {0.01, 0.25})), "/sellmeier_c_um2/1 pole");
    EXPECT_NE(sellmeier_index({1}, {0.25}).error().problems[0].detail.find("500"),
              std::string::npos);
    // A term of no strength has no pole.
    EXPECT_TRUE(sellmeier_index({1, 0}, {0.01, 0.25}));
    // An infrared pole just past the range: the index falls below 1 before it. At 359 nm: above 10.
    EXPECT_EQ(problem_of(sellmeier_index({0.1}, {0.7})), "/sellmeier_b out-of-range");
    EXPECT_EQ(problem_of(sellmeier_index({200}, {0.12})), "/sellmeier_b out-of-range");
    EXPECT_EQ(problem_of(sellmeier_index({1}, {0.01, 0.02})), "/sellmeier_c_um2 length-mismatch");
    EXPECT_EQ(problem_of(sellmeier_index({}, {})), "/sellmeier_b wrong-count");
    EXPECT_EQ(problem_of(sellmeier_index({std::nan("")}, {0.01})), "/sellmeier_b/0 not-finite");
}

TEST(Cauchy, IsItsFormulaAndRefusesWhatIsNoIndex) {
    const auto n = cauchy_index({1.5, 0.004, 1e-4});
    ASSERT_TRUE(n);
    EXPECT_DOUBLE_EQ((*n)->at(500), 1.5 + 0.004 / 0.25 + 1e-4 / 0.0625);
    EXPECT_EQ(problem_of(cauchy_index({0.999, 1e-4})), "/cauchy_um out-of-range");
    EXPECT_NE(cauchy_index({0.999, 1e-4}).error().problems[0].detail.find("nm"), std::string::npos);
    EXPECT_TRUE((*cauchy_index({1.5}))->is_constant());
}

TEST(Abbe, GoesThroughItsTwoNumbers) {
    const auto n = abbe_index(1.5168, 64.17);
    ASSERT_TRUE(n);
    EXPECT_NEAR((*n)->at(kD_nm), 1.5168, 1e-12);
    EXPECT_NEAR(0.5168 / ((*n)->at(kF_nm) - (*n)->at(kC_nm)), 64.17, 1e-9);
    // Two numbers are nearly the whole of a crown glass.
    for (const double lambda_nm : {404.7, 435.8, 546.1, 706.5})
        EXPECT_NEAR((*n)->at(lambda_nm), library_index("N-BK7")->at(lambda_nm), 1.5e-3);
    EXPECT_EQ(problem_of(abbe_index(0.9, 50)), "/n_d out-of-range");
    EXPECT_EQ(problem_of(abbe_index(1.5, 0)), "/v_d out-of-range");
    EXPECT_EQ(problem_of(abbe_index(1.5, std::nan(""))), "/v_d not-finite");
    // So strong a dispersion that the index of the red end is below 1.
    EXPECT_EQ(problem_of(abbe_index(1.05, 0.5)), "/v_d out-of-range");
}

// A constant index is not dispersive, and its Abbe number says so.
TEST(Abbe, IsInfiniteWithoutDispersion) {
    EXPECT_TRUE(std::isinf(abbe_number(*constant_spectrum(1.5))));
}

}  // namespace
}  // namespace bouguer::renderer
