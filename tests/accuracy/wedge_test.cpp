// SPDX-License-Identifier: Apache-2.0
// Equation 1 through the whole renderer, wavelength by wavelength: plates of coloured glass let
// through t^d of the light behind them, t being what their data sheet says of 1 mm.
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "renderer/spectrum/spectra.h"
#include "tests/accuracy/flat_faces.h"

namespace bouguer::test {
namespace {

using namespace renderer;

/// Below, a radiance is no normal number of single precision any more.
constexpr double kLeastTransmittance = 1e-25;

/// Light of one wavelength as JSON: at 1 nm only one node sees it.
std::string one_wavelength(int lambda_nm) {
    std::ostringstream json;
    json << R"("radiance": {"first_nm": )" << lambda_nm - 1
         << R"(, "step_nm": 1, "values": [0, 1, 0]})";
    return json.str();
}

/// The plates of wedge-law.json when they are made of `glass` (a spectrum as JSON) and the light
/// behind them has one wavelength.
std::map<std::string, Xyz> plates(const std::string& glass, int lambda_nm) {
    api::JobRequest job =
        example_job("colour/wedge-law.json",
                    {{R"("ILA400")", glass}, {R"("radiance": "D65")", one_wavelength(lambda_nm)}});
    job.settings.wavelength_step_nm = 1;
    job.settings.resolution = {15, 5};
    job.settings.filter = {FilterType::Box, 0.5};
    return colours_of_faces(job.scene, render_picture(job));
}

/// The same without colour: what arrives when nothing is absorbed.
const std::map<std::string, Xyz>& clear_plates(int lambda_nm) {
    static std::map<int, std::map<std::string, Xyz>> known;
    auto& clear = known[lambda_nm];
    if (clear.empty()) clear = plates("1", lambda_nm);
    return clear;
}

class Wedge : public testing::TestWithParam<const char*> {};

TEST_P(Wedge, LetsThroughThePowerOfTheDataSheet) {
    const SpectrumPtr t = library_spectrum(GetParam());
    const std::string glass = (std::ostringstream() << std::quoted(GetParam())).str();
    for (int lambda_nm = 360; lambda_nm <= 830; ++lambda_nm) {
        const auto coloured = plates(glass, lambda_nm);
        for (const int d_mm : {1, 2, 3, 5, 10}) {
            const double expected = std::pow(t->at(lambda_nm), d_mm);
            if (expected < kLeastTransmittance) continue;
            const std::string plate = std::to_string(d_mm) + " mm";
            const double found = coloured.at(plate).y / clear_plates(lambda_nm).at(plate).y;
            EXPECT_NEAR(found / expected, 1, 1e-6) << plate << " at " << lambda_nm << " nm";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Glasses, Wedge,
                         testing::Values("IEB470", "IEC578", "ILA400", "ILB90", "ISK167", "ITY418",
                                         "IVB490", "IVG530", "IVG550"),
                         [](const auto& glass) { return std::string(glass.param); });

}  // namespace
}  // namespace bouguer::test
