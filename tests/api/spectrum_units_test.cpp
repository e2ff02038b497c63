// SPDX-License-Identifier: Apache-2.0
// Wavelengths that are probably not in nanometres.
#include "api/spectrum_units.h"

#include <gtest/gtest.h>

#include "tests/api/warning_testing.h"

namespace bouguer::api {
namespace {

using nlohmann::json;
using tests::Texts;
using tests::warned;

/// The good scene with this lamp.
json lit_by(json spectrum) {
    json s = tests::good_scene();
    s["lights"][0]["intensity"] = std::move(spectrum);
    return s;
}

json glass_of(json ior) {
    json s = tests::good_scene();
    s["materials"]["glass"]["ior"] = std::move(ior);
    return s;
}

/// "pointer code", and "detail" where that names another unit, of the first problem.
std::string refused(const json& document) {
    const auto job = parse_job(document.dump(), Limits{}, tests::NoAssets{});
    if (job) return "accepted";
    const Problem& problem = job.error().problems.at(0);
    const std::size_t as = problem.detail.find("; ");
    return problem.pointer + " " + problem.code +
           (as == std::string::npos ? "" : problem.detail.substr(as));
}

json table(std::vector<double> wavelengths, std::vector<double> values) {
    return {{"wavelengths_nm", std::move(wavelengths)}, {"values", std::move(values)}};
}

// A table in another unit would count as one number.
TEST(SpectrumUnits, TablesWithoutAVisibleSampleAreRefused) {
    const std::string at = "/lights/0/intensity/wavelengths_nm no-visible-sample";
    EXPECT_EQ(refused(lit_by(table({0.4, 0.55, 0.7}, {1, 2, 3}))),
              at + "; as micrometres it would be 400 to 700 nm");
    EXPECT_EQ(refused(lit_by(table({4e-7, 7e-7}, {1, 2}))),
              at + "; as metres it would be 400 to 700 nm");
    EXPECT_EQ(refused(lit_by(table({4000, 7000}, {1, 2}))),
              at + "; as Angstrom it would be 400 to 700 nm");
    EXPECT_EQ(refused(lit_by(table({2, 4}, {1, 2}))),
              at + "; as electronvolts it would be 309.9605 to 619.921 nm");
    EXPECT_EQ(refused(lit_by(table({16000, 25000}, {1, 2}))),
              at + "; as wavenumbers a centimetre it would be 400 to 625 nm");
    EXPECT_EQ(refused(lit_by(table({1000, 1500}, {1, 2}))), at) << "infrared, in any unit";
    EXPECT_EQ(refused(lit_by({{"first_nm", 0.4}, {"step_nm", 0.1}, {"values", {1, 2, 3, 4}}})),
              "/lights/0/intensity/first_nm no-visible-sample; as micrometres it would be 400 to "
              "700.0000000000001 nm");
    json s = glass_of(table({0.4, 0.7}, {1.53, 1.51}));
    EXPECT_EQ(refused(s).substr(0, 55), "/materials/glass/ior/wavelengths_nm no-visible-sample; ");
    s = tests::good_scene();
    s["spectra"]["measured"] = table({0.4, 0.7}, {0.5, 0.6});
    s["materials"]["glass"]["absorption"]["transmittance"] = "measured";
    EXPECT_EQ(refused(s).substr(0, 50), "/spectra/measured/wavelengths_nm no-visible-sample");
}

TEST(SpectrumUnits, LinesAndBellsInAnotherUnitAreRefused) {
    EXPECT_EQ(refused(lit_by({{"line_nm", 0.5461}, {"width_nm", 1e-4}, {"integral", 1}})),
              "/lights/0/intensity/line_nm no-visible-sample; as micrometres it would be 546.1 nm");
    EXPECT_EQ(refused(lit_by({{"center_nm", 5461}, {"fwhm_nm", 10}, {"peak", 1}})),
              "/lights/0/intensity/center_nm no-visible-sample; as Angstrom it would be 546.1 nm");
    json s = tests::good_scene();
    s["lights"].push_back(s["lights"][0]);
    s["lights"][1]["intensity"] = {{"line_nm", 1064}, {"width_nm", 1}, {"integral", 1}};
    EXPECT_EQ(warned(s), Texts{"/lights/1 lamp-without-light"}) << "a laser that nobody sees";
    s["lights"][1]["intensity"]["line_nm"] = 1e6;
    EXPECT_EQ(warned(s), (Texts{"/lights/1/intensity/line_nm far-from-visible",
                                "/lights/1 lamp-without-light"}));
}

// What a table does not tell counts as its nearest sample, also where it is not known at all.
TEST(SpectrumUnits, TablesThatTellLittleAreNamed) {
    const Texts doubt{"/lights/0/intensity/wavelengths_nm unit-in-doubt"};
    EXPECT_EQ(warned(lit_by(table({800, 860}, {2, 2}))), doubt);
    EXPECT_EQ(warned(lit_by(table({560, 2500}, {1, 2}))), doubt) << "120 of 250 nm";
    EXPECT_EQ(warned(lit_by(table({550, 2500}, {1, 2}))), Texts{});
    EXPECT_EQ(warned(lit_by(table({540, 550, 560}, {0, 1, 0}))), Texts{}) << "0 beyond is meant";
    EXPECT_EQ(warned(lit_by(table({500, 510}, {0, 1}))), doubt) << "1 beyond is a guess";
    EXPECT_EQ(warned(lit_by(table({300, 1000}, {1, 2}))), doubt) << "no sample is visible";
}

// N-BK7 [Schott 2017-01-20b].
TEST(SpectrumUnits, FormulasInAnotherUnitAreNamed) {
    const std::vector<double> b{1.03961212, 0.231792344, 1.01046945};
    const std::vector<double> c{0.00600069867, 0.0200179144, 103.560653};
    const auto sellmeier = [&](double factor) {
        std::vector<double> scaled = c;
        for (double& x : scaled) x *= factor;
        return glass_of({{"sellmeier_b", b}, {"sellmeier_c_um2", scaled}});
    };
    EXPECT_EQ(warned(sellmeier(1)), Texts{});
    EXPECT_EQ(warned(sellmeier(1e-12)), Texts{"/materials/glass/ior unit-in-doubt"}) << "metres";
    EXPECT_NE(refused(sellmeier(1e6)).find("for nanometres it would be an index"),
              std::string::npos);
    const auto cauchy = [&](double factor) {
        return glass_of({{"cauchy_um", {1.5046, 0.0042 * factor}}});
    };
    EXPECT_EQ(warned(cauchy(1)), Texts{});
    EXPECT_EQ(warned(cauchy(1e-12)), Texts{"/materials/glass/ior unit-in-doubt"});
    EXPECT_EQ(warned(cauchy(0)), Texts{}) << "said to be constant";
    EXPECT_NE(refused(cauchy(1e6)).find("for nanometres it would be an index"), std::string::npos);
}

// Every use of a product is integrated anew: 64 factors of 10 000 samples are 64 x 646 400.
TEST(SpectrumUnits, ProductsAreBounded) {
    std::vector<double> wavelengths(10'000), values(10'000, 0.5);
    for (std::size_t i = 0; i < wavelengths.size(); ++i)
        wavelengths[i] = 400 + 0.04 * static_cast<double>(i);
    json s = tests::good_scene();
    s["spectra"]["table"] = table(wavelengths, values);
    s["spectra"]["power"]["product"] = json::array_t(64, "table");
    s["materials"]["glass"]["reflectance"] = "power";
    EXPECT_EQ(refused(s), "/materials/glass/reflectance over-limit");
    s["spectra"]["power"]["product"] = {"table", "table"};
    EXPECT_EQ(warned(s), Texts{});
    s["lights"] =
        json::array_t(1000, {{"type", "point"}, {"position", {0, 2, 0}}, {"intensity", "power"}});
    EXPECT_EQ(refused(s), "/lights/246/intensity over-limit") << "2 x 20 200 each";
}

}  // namespace
}  // namespace bouguer::api
