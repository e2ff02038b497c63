// SPDX-License-Identifier: Apache-2.0
// Light of different wavelengths on different ways.
#include <gtest/gtest.h>

#include "renderer/integrators/hall.h"
#include "renderer/media/refraction.h"
#include "renderer/spectrum/refractive_index.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer {
namespace {

using test::clear;
using test::SceneBuilder;

constexpr double kStep_nm = 5;

/// An equilateral prism of BK7 whose apex edge runs along z; apex up, centre in the origin.
std::shared_ptr<const TriangleMesh> prism() {
    auto mesh = std::make_shared<TriangleMesh>();
    for (const double z : {-5.0, 5.0})
        for (const double turn : {90.0, 210.0, 330.0})
            mesh->positions.push_back(
                {std::cos(degrees_to_radians(turn)), std::sin(degrees_to_radians(turn)), z});
    mesh->triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                       {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

HallMaterial bk7() {
    HallMaterial m = clear(1);
    m.ior = library_index("N-BK7");
    return m;
}

/// Angles of ray and deviation at minimum deviation of the line d: n = sin((60 + delta) / 2) /
/// sin(30), 38.64670 degrees for BK7.
constexpr double kMinimumDeviation_deg = 38.64670;
constexpr double kIncidence_deg = (60 + kMinimumDeviation_deg) / 2;

/// How far a ray of that incidence is turned at `lambda_nm`, by Snell's law at both faces.
double deviation_deg(double lambda_nm) {
    const double n = library_index("N-BK7")->at(lambda_nm);
    const double inside = std::asin(std::sin(degrees_to_radians(kIncidence_deg)) / n);
    const double out = std::asin(n * std::sin(degrees_to_radians(60) - inside));
    return kIncidence_deg + out * 180 / kPi - 60;
}

TEST(Dispersion, IsThatOfTheCatalogue) {
    EXPECT_NEAR(deviation_deg(kLineD_nm), kMinimumDeviation_deg, 1e-4);
    // Minimum deviations of the lines F and C are 39.13811 and 38.42914; off the minimum by so
    // little a ray is turned hardly more.
    EXPECT_NEAR(deviation_deg(kLineF_nm), 39.13811, 2e-3);
    EXPECT_NEAR(deviation_deg(kLineC_nm), 38.42914, 2e-3);
}

/// A ray that meets the left face under kIncidence_deg goes horizontally inside, for the line d,
/// and leaves in this direction when it is turned by so much.
Vec3 turned(double deviation) {
    // The outward normal of the left face points up to the left, 150 degrees from +x; against it,
    // and turned away from the apex by the incidence.
    const double angle = degrees_to_radians(-30 + kIncidence_deg - deviation);
    return {std::cos(angle), std::sin(angle), 0};
}

/// What is seen through the prism of a disk that gives out 1 per nm and covers the directions of
/// all deviations within `half_width` of `deviation`.
Xyz seen_through_prism(double deviation, double half_width, std::uint32_t samples) {
    constexpr Real kFar = 1e3;
    const Vec3 entry{-0.25 * std::sqrt(3.0), 0.25, 0.013}, exit{-entry.x, entry.y, entry.z};
    SceneBuilder builder;
    builder.add(prism(), bk7());
    builder.add(Disk{exit + turned(deviation) * kFar, turned(deviation),
                     kFar * std::tan(degrees_to_radians(half_width))},
                test::matt(0));
    builder.description.materials.back().emission = constant_spectrum(1);
    const auto scene = builder.build();
    RenderSettings settings;
    settings.wavelength_step_nm = kStep_nm;
    const auto integrator = make_hall(*scene, SpectralBasis::wavelengths(kStep_nm), settings, {});
    const auto scratch = integrator->make_scratch();
    TraceCounters counters;
    const Vec3 d = turned(0);
    Xyz sum;
    for (std::uint32_t s = 0; s < samples; ++s) {
        const Ray ray{entry - 5.0 * d - scene->geometry().origin(), d};
        sum += integrator->trace(ray, PixelSampler(1, 0, 0, s, 1), *scratch, counters) *
               (1.0 / samples);
    }
    return sum;
}

/// The same by the colour-matching functions over those wavelengths.
Xyz expected(double deviation, double half_width) {
    constexpr double kFine_nm = 0.05;
    Xyz sum;
    for (double nm = kLambdaMin_nm; nm < kLambdaMax_nm; nm += kFine_nm) {
        if (std::abs(deviation_deg(nm) - deviation) > half_width) continue;
        const auto [x, y, z] = cie1931(nm);
        sum += Xyz{x, y, z} * (kFine_nm / kYIntegral_nm);
    }
    return sum;
}

// A band of about 40 nm about yellow, one about blue, one about red. 2^14 samples: the standard
// error of a share of a tenth is 2.5 %, of stratified ones far less.
TEST(Dispersion, SendsEveryWavelengthItsOwnWay) {
    for (const double deviation : {kMinimumDeviation_deg, 39.3, 38.45}) {
        const Xyz seen = seen_through_prism(deviation, 0.08, 1U << 14U);
        const Xyz right = expected(deviation, 0.08);
        ASSERT_GT(right.y, 0.01);
        EXPECT_NEAR(seen.x, right.x, 0.03 * right.x) << deviation;
        EXPECT_NEAR(seen.y, right.y, 0.03 * right.y) << deviation;
        EXPECT_NEAR(seen.z, right.z, 0.03 * std::max(right.z, right.y)) << deviation;
    }
}

// All directions together are all light: what ended is made up for.
TEST(Dispersion, LosesNothingOnAverage) {
    const Xyz seen = seen_through_prism(kMinimumDeviation_deg, 5, 1U << 12U);
    EXPECT_NEAR(seen.x, xyz_of(*constant_spectrum(1)).x, 0.01);
    EXPECT_NEAR(seen.y, 1, 0.01);
    EXPECT_NEAR(seen.z, xyz_of(*constant_spectrum(1)).z, 0.01);
}

// Under 29.18 degrees of incidence the light meets the second face at the critical angle, which is
// 41.06 degrees for the line F and 41.33 for C: blue is turned back. Together with what gets out
// nothing is missing, and twice parted is parted once.
TEST(Dispersion, KeepsTheLightThatIsTurnedBack) {
    SceneBuilder builder;
    builder.description.environment = ConstantEnvironment{constant_spectrum(1)};
    builder.add(prism(), bk7());
    const auto scene = builder.build();
    RenderSettings settings;
    settings.max_depth = 60;
    settings.min_throughput = 0;
    const auto integrator = make_hall(*scene, SpectralBasis::wavelengths(5), settings, {});
    const auto scratch = integrator->make_scratch();
    TraceCounters counters;
    constexpr std::uint32_t kSamples = 1U << 12U;
    const double angle = degrees_to_radians(-30 + 29.18);
    for (const double height : {-0.3, 0.0, 0.25}) {
        double y = 0;
        for (std::uint32_t s = 0; s < kSamples; ++s)
            y += integrator
                     ->trace({Vec3{-5, height, 0.01} - scene->geometry().origin(),
                              Vec3{std::cos(angle), std::sin(angle), 0}},
                             PixelSampler(1, 0, 0, s, 1), *scratch, counters)
                     .y /
                 kSamples;
        EXPECT_NEAR(y, 1, 0.01) << height;
    }
    EXPECT_GT(counters.total_reflections, kSamples / 4);
    EXPECT_LT(counters.total_reflections, kSamples * 30);
}

TEST(Dispersion, IsSaidInThePlan) {
    SceneBuilder builder;
    builder.add(prism(), bk7()).light(DirectionalLight{{0, -1, 0}, constant_spectrum(1)});
    const auto needs = [&](const RenderSettings& settings) {
        for (const PlanItem& item : make_plan(*builder.build(), settings).items)
            if (item.feature == "dispersion") return item.needed;
        return false;
    };
    RenderSettings settings;
    EXPECT_TRUE(needs(settings));
    settings.integrator = IntegratorType::Rgb;
    EXPECT_FALSE(needs(settings)) << "one index stands for all";
}

}  // namespace
}  // namespace bouguer::renderer
