// SPDX-License-Identifier: Apache-2.0
// Two reflectances that are one colour under D65 and two under A: what triples cannot show.
#include <gtest/gtest.h>

#include "renderer/spectrum/colour_difference.h"
#include "renderer/spectrum/spectra.h"
#include "tests/accuracy/flat_faces.h"

namespace bouguer::test {
namespace {

using namespace renderer;

/// CIEDE2000 of the two tiles as they are rendered, the illuminant being the white.
double difference(const std::string& illuminant, IntegratorType integrator) {
    api::JobRequest job = example_job("colour/metamers-" + illuminant + ".json");
    job.settings.resolution = {64, 44};
    job.settings.wavelength_step_nm = 1;
    job.settings.integrator = integrator;
    const auto colours = colours_of_faces(job.scene, render_picture(job));
    const Xyz white = xyz_of(*library_spectrum(illuminant));
    return delta_e_2000(lab_of(colours.at("left tile"), white),
                        lab_of(colours.at("right tile"), white));
}

TEST(Metamers, AreOneColourUnderD65) {
    EXPECT_LT(difference("D65", IntegratorType::Hall), 0.01);
    EXPECT_LT(difference("D65", IntegratorType::Rgb), 0.01);
}

TEST(Metamers, PartUnderIlluminantAButNotInRgb) {
    EXPECT_GT(difference("A", IntegratorType::Hall), 5);
    EXPECT_LT(difference("A", IntegratorType::Rgb), 0.01);
}

}  // namespace
}  // namespace bouguer::test
