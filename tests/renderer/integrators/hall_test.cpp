// SPDX-License-Identifier: Apache-2.0
// The seed's equations against closed forms. Spectra are constant, so X = Y = Z = the radiance.
#include "renderer/integrators/hall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/hall_look.h"
#include "tests/support/meshes.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer {
namespace {

using test::clear;
using test::exact_settings;
using test::glass;
using test::in_environment;
using test::look;
using test::matt;
using test::SceneBuilder;
using test::Seen;
using test::slab;
using test::sun;

// Each face passes k_st F_st = 0.9 * 0.8.
TEST(HallTransmission, WeighsEachFace) {
    HallMaterial m = clear(1.3);
    m.k_st = 0.9;
    m.transmittance = constant_spectrum(0.8);
    EXPECT_NEAR(look(*in_environment().add(slab(1), m).build(), {0, 0, 5}, {0, 0, 0}).y,
                0.72 * 0.72, 1e-6);
}

// A disk has no inside: it weighs once, bends nothing and absorbs nothing.
TEST(HallTransmission, TreatsADiskAsASheet) {
    const auto scene = in_environment().add(Disk{{0, 0, 0}, {0, 0, 1}, 2}, glass(1.5, 0.1)).build();
    EXPECT_NEAR(look(*scene, {0, 0, 5}, {0.5, 0, 0}).y, 1, 1e-6);
}

// ---- equation 4 ----

// k_sr I F (L.N)^n'.
TEST(HallReflection, IsThePowerOfTheCosine) {
    for (const double degrees : {0.0, 30.0, 60.0, 89.0}) {
        for (const double n : {0.0, 1.0, 2.5, 20.0}) {
            HallMaterial m = matt(0.8);
            m.k_sr = 0.5;
            m.n = n;
            const Real angle = degrees_to_radians(degrees);
            const auto scene = SceneBuilder()
                                   .add(Plane{{0, 0, 0}, {0, 0, 1}}, m)
                                   .light(sun({std::sin(angle), 0, -std::cos(angle)}, 2))
                                   .build();
            const double expected = 0.5 * 2 * 0.8 * std::pow(std::cos(angle), n);
            EXPECT_NEAR(look(*scene, {0, 1, 5}, {0, 0, 0}).y, expected, 1e-6)
                << degrees << " degrees, n' = " << n;
        }
    }
}

TEST(HallReflection, SeesNothingOfALampBehindAnOpaqueSurface) {
    const auto scene =
        SceneBuilder().add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(1)).light(sun({0, 0, 1})).build();
    EXPECT_EQ(look(*scene, {0, 0, 5}, {0, 0, 0}).y, 0);
}

// Intensity 3 W/sr/nm at 200 cm is 3 / 2^2 = 0.75 W/m^2/nm.
TEST(HallReflection, FallsWithTheSquareOfTheDistanceInMetres) {
    SceneBuilder builder;
    builder.description.metres_per_unit = 0.01;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(1))
        .light(PointLight{{0, 0, 200}, constant_spectrum(3)});
    EXPECT_NEAR(look(*builder.build(), {0, 5, 5}, {0, 0, 0}).y, 0.75, 1e-6);
}

TEST(HallReflection, IsDarkInTheShadowOfAnOpaqueBody) {
    const auto scene = SceneBuilder()
                           .add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(1))
                           .add(Sphere{{0, 0, 5}, 1}, matt(1))
                           .light(sun({0, 0, -1}))
                           .build();
    EXPECT_EQ(look(*scene, {5, 0, 1}, {0, 0, 0}).y, 0);
    EXPECT_NEAR(look(*scene, {5, 0, 1}, {1.5, 0, 0}).y, 1, 1e-6);
}

// Light that comes straight through a clear body of 2 units with t = 0.9 and k_st = 0.8 a face:
// 0.8^2 * 0.9^2.
TEST(HallReflection, IsTintedInTheShadowOfAClearBody) {
    HallMaterial m = glass(1.5, 0.9);
    m.k_st = 0.8;
    const auto scene = SceneBuilder()
                           .add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(1))
                           .add(Sphere{{0, 0, 5}, 1}, m)
                           .light(sun({0, 0, -1}))
                           .build();
    EXPECT_NEAR(look(*scene, {5, 0, 1}, {0, 0, 0}).y, 0.64 * 0.81, 1e-6);
}

// A mirror of k_sr F = 0.5 * 0.8 shows the environment at that share, at any angle: the lobe shapes
// lamps only.
TEST(HallReflection, CarriesTheMirroredRay) {
    HallMaterial m = matt(0.8);
    m.k_sr = 0.5;
    m.n = 20;
    m.mirror = true;
    const auto scene = in_environment(3).add(Plane{{0, 0, 0}, {0, 0, 1}}, m).build();
    EXPECT_NEAR(look(*scene, {0, 0, 5}, {0, 0, 0}).y, 1.2, 1e-5);
    EXPECT_NEAR(look(*scene, {0, 5, 1}, {0, 0, 0}).y, 1.2, 1e-5);
}

// A surface without reflected ray gathers a constant environment over its lobe: 2 pi / (n' + 1).
TEST(HallReflection, GathersTheEnvironmentOverItsLobe) {
    for (const double n : {1.0, 20.0}) {
        HallMaterial m = matt(0.5);
        m.n = n;
        const auto scene = in_environment().add(Plane{{0, 0, 0}, {0, 0, 1}}, m).build();
        EXPECT_NEAR(look(*scene, {0, 0, 5}, {0, 0, 0}).y, 0.5 * 2 * kPi / (n + 1), 1e-5);
    }
}

// ---- equation 3 ----

// A lamp behind a clear sheet: k_st I F_st (-L.N)^n'.
TEST(HallTransmission, LetsLampsShineThrough) {
    HallMaterial m = clear(1);
    m.k_st = 0.9;
    m.transmittance = constant_spectrum(0.5);
    m.n = 20;
    const Real angle = 0.2;
    const auto scene = SceneBuilder()
                           .add(Disk{{0, 0, 0}, {0, 0, 1}, 2}, m)
                           .light(sun({std::sin(angle), 0, std::cos(angle)}, 2))
                           .build();
    EXPECT_NEAR(look(*scene, {0, 0, 5}, {0, 0, 0}).y, 0.9 * 2 * 0.5 * std::pow(std::cos(angle), 20),
                1e-6);
}

// ---- total reflection ----

// Along a cube's diagonal every face is met at acos(1/sqrt 3) = 54.7 degrees, beyond the
// critical 41.8 of glass: no light gets out, and after ten reflections all of it is booked as cut.
TEST(HallTotalReflection, TrapsTheDiagonalOfAGlassCube) {
    const auto scene = in_environment().add(Box{{-1, -1, -1}, {1, 1, 1}}, clear(1.5)).build();
    RenderSettings settings = exact_settings();
    settings.max_depth = 10;
    const Seen seen = look(*scene, {0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}, settings);
    EXPECT_EQ(seen.y, 0);
    EXPECT_EQ(seen.counters.total_reflections, 11U);
    EXPECT_EQ(seen.counters.rays_cut_by_depth, 1U);
    EXPECT_NEAR(seen.counters.depth_throughput, 1, 1e-6);
}

// The same cube of index 1.2 (critical angle 56.4 degrees) lets it out at once.
TEST(HallTotalReflection, EndsAtTheCriticalAngle) {
    const auto scene = in_environment().add(Box{{-1, -1, -1}, {1, 1, 1}}, clear(1.2)).build();
    EXPECT_NEAR(look(*scene, {0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}).y, 1, 1e-6);
}

// ---- smooth meshes ----

// The interpolated normals of a coarse mesh lie beside the real ones. Rays keep to the real
// surface: through a clear ball of 80 triangles under two lamps nearly every ray leaves the body
// that it entered.
TEST(HallTransmission, KeepsTrackOfBodiesWithSmoothNormals) {
    HallMaterial m = glass(1.3, 0.9);
    m.k_sr = 0.1;
    m.mirror = true;
    const auto scene = in_environment()
                           .add(test::icosphere(1, true), m)
                           .light(sun({0, 0, -1}))
                           .light(sun({1, 1, 1}))
                           .build();
    TraceCounters counters;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 at{-0.95 + 1.9 * (i % 40) / 40, -0.95 + 1.9 * (i / 40) / 50, 0};
        counters += look(*scene, {0, 0, 5}, at).counters;
    }
    EXPECT_GT(counters.rays, 20'000U);
    EXPECT_TRUE(counters.lost_bodies.empty());
}

// ---- truncation ----

// Inside a closed mirror of k_sr F = 0.5 a ray cut after D = 3 reflections carries 0.5^4 of the
// light.
TEST(HallTruncation, BooksWhatTheDepthLimitCuts) {
    HallMaterial m = matt(0.5);
    m.mirror = true;
    const auto scene = SceneBuilder().add(Sphere{{0, 0, 0}, 1}, m).build();
    RenderSettings settings = exact_settings();
    settings.max_depth = 3;
    const Seen seen = look(*scene, {0.1, 0.2, 0.3}, {1, 1, 1}, settings);
    EXPECT_NEAR(seen.counters.depth_throughput, 0.0625, 1e-6);
    EXPECT_EQ(seen.counters.rays, 4U);
}

// A mirror of k_sr F = 0.5 that shines by itself with radiance 1: of 1 + 1/2 + 1/4 + ..., a ray
// that may add less than a tenth of what is found already, 1/8 of 1.75, ends the sum.
TEST(HallTruncation, BooksWhatTheThresholdCuts) {
    HallMaterial m = matt(0.5);
    m.mirror = true;
    SceneBuilder builder;
    builder.add(Sphere{{0, 0, 0}, 1}, m);
    builder.description.materials.back().emission = {constant_spectrum(1), nullptr};
    const auto scene = builder.build();
    RenderSettings settings = exact_settings();
    settings.min_throughput = 0.1;
    const Seen seen = look(*scene, {0.1, 0.2, 0.3}, {1, 1, 1}, settings);
    EXPECT_NEAR(seen.y, 1.75, 1e-6);
    EXPECT_EQ(seen.counters.rays_cut_by_threshold, 1U);
    EXPECT_NEAR(seen.counters.threshold_throughput, 0.125, 1e-6);
    EXPECT_NEAR(seen.counters.threshold_light, 0.125, 1e-6);
    EXPECT_EQ(seen.counters.blackened_samples, 0U);
}

// Nothing found is nothing to compare with: light behind an optical density of 9 is followed.
TEST(HallTruncation, FollowsWeakRaysWhereThereIsNoOtherLight) {
    RenderSettings settings = exact_settings();
    settings.min_throughput = 0.5;
    const auto scene = in_environment().add(slab(3), glass(1, 1e-3)).build();
    const Seen seen = look(*scene, {0.1, 0.2, 5}, {0.1, 0.2, -10}, settings);
    EXPECT_NEAR(seen.y, 1e-9, 1e-14);
}

TEST(HallTruncation, SaysWhatTheDepthLimitBlackened) {
    HallMaterial m = matt(0.5);
    m.mirror = true;
    const auto scene = SceneBuilder().add(Sphere{{0, 0, 0}, 1}, m).build();
    RenderSettings settings = exact_settings();
    settings.max_depth = 3;
    EXPECT_EQ(look(*scene, {0.1, 0.2, 0.3}, {1, 1, 1}, settings).counters.blackened_samples, 1U);
}

// Two transparent bodies that split every ray in two, as deep as a client may ask: the tree stays
// bounded.
TEST(HallTruncation, BoundsTheTreeOfRays) {
    HallMaterial m = clear(1.3);
    m.k_sr = 1;
    m.mirror = true;
    const auto scene =
        in_environment().add(Sphere{{0, 0, 0}, 1}, m).add(Sphere{{0, 0, 3}, 1}, m).build();
    RenderSettings settings = exact_settings();
    settings.max_depth = 64;
    const Seen seen = look(*scene, {0.1, 0.2, -5}, {0, 0, 0}, settings);
    // Near another surface a ray asks twice.
    EXPECT_LE(seen.counters.rays, std::uint64_t{2} * kMaxNodesPerSample);
    EXPECT_GT(seen.counters.rays_cut_by_depth, 0U);
}

// ---- equation 2 ----

AmbientDescription ambient(double k_a, double illuminant) {
    return {k_a, HemisphereWeights{}, constant_spectrum(illuminant)};
}

// K_a sum k_i R_i^n_i with two neighbours: 0.5 * 2 * (0.25 * 0.8^1 + 0.125 * 0.5^3).
TEST(HallAmbient, SumsTheNeighboursWithGivenWeights) {
    SceneBuilder builder;
    HallMaterial cubed = matt(0.5);
    cubed.n = 3;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.9))
        .add(Sphere{{5, 0, 1}, 1}, matt(0.8))
        .add(Sphere{{-5, 0, 1}, 1}, cubed);
    builder.description.ambient = ambient(0.5, 2);
    builder.description.ambient->weights =
        ExplicitWeights{{99, 0.25, 0.125}};  // the shaded object's own weight does not count
    EXPECT_NEAR(look(*builder.build(), {0, 5, 5}, {0, 0, 0}).y,
                0.5 * 2 * (0.25 * 0.8 + 0.125 * 0.125), 1e-6);
}

// A disk of radius r parallel to the floor at height h covers r^2 / (r^2 + h^2) of the
// cosine-weighted hemisphere below its centre: 0.2 for r = 1, h = 2. 4096 stratified samples.
TEST(HallAmbient, WeighsNeighboursByTheHemisphereTheyCover) {
    SceneBuilder builder;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.9))
        .add(Disk{{0, 0, 2}, {0, 0, 1}, 1}, matt(0.5));
    builder.description.ambient = ambient(1, 1);
    EXPECT_NEAR(look(*builder.build(), {5, 0, 1}, {0, 0, 0}, exact_settings(), 4096).y, 0.2 * 0.5,
                1e-3);
}

// Eight rays a sample find the same weight in an eighth of the samples.
TEST(HallAmbient, MaySpendSeveralRaysASample) {
    SceneBuilder builder;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.9))
        .add(Disk{{0, 0, 2}, {0, 0, 1}, 1}, matt(0.5));
    builder.description.ambient = ambient(1, 1);
    builder.description.ambient->weights = HemisphereWeights{8};
    const Seen seen = look(*builder.build(), {5, 0, 1}, {0, 0, 0}, exact_settings(), 512);
    EXPECT_NEAR(seen.y, 0.2 * 0.5, 1e-3);
    EXPECT_EQ(seen.counters.rays, 9 * 512U);
}

TEST(HallAmbient, IsZeroWithoutNeighbours) {
    SceneBuilder builder;
    builder.add(Sphere{{0, 0, 0}, 1}, matt(0.9));
    builder.description.ambient = ambient(1, 1);
    EXPECT_EQ(look(*builder.build(), {0, 0, 5}, {0, 0, 0}, exact_settings(), 64).y, 0);
}

// Without an illuminant of its own the ambient light is what arrives from the lamps, shadowed or
// not.
TEST(HallAmbient, TakesTheLightOfTheLamps) {
    SceneBuilder builder;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.9)).add(Sphere{{5, 0, 1}, 1}, matt(0.8));
    builder.light(sun({0, 0, 1}, 2)).light(sun({0, 1, 1}, 3));  // both from below
    builder.description.ambient = AmbientDescription{0.5, ExplicitWeights{{0, 0.25}}, nullptr};
    EXPECT_NEAR(look(*builder.build(), {0, 5, 5}, {0, 0, 0}).y, 0.5 * 5 * 0.25 * 0.8, 1e-6);
}

// Where light comes out of a clear body, equation 3 sums the neighbours' transmittances: opaque
// K_a I_a k_sr F_sr = 0.5 * 2 * 0.6 * 0.8, whatever stands around.
TEST(HallAmbient, IsTheSurfacesOwnColourWhereItIsConstant) {
    HallMaterial m = matt(0.8);
    m.k_sr = 0.6;
    SceneBuilder builder;
    builder.add(Sphere{{0, 0, 0}, 1}, m).add(Sphere{{5, 0, 0}, 1}, matt(1));
    builder.description.ambient = AmbientDescription{0.5, ConstantWeights{}, constant_spectrum(2)};
    EXPECT_NEAR(look(*builder.build(), {0, 0, 5}, {0, 0, 0}).y, 0.48, 1e-6);
}

// A body that gives out light is seen as bright as it is, through glass of transmittance 0.5 a
// face by its quarter, and lights no neighbour.
TEST(HallEmission, IsSeenAndLightsNothing) {
    SceneBuilder builder;
    builder.add(Sphere{{0, 0, 0}, 1}, matt(0.5));
    builder.description.materials.back().emission = constant_spectrum(3);
    builder.add(Plane{{0, 0, -2}, {0, 0, 1}}, matt(1));
    EXPECT_NEAR(look(*builder.build(), {0, 0, 9}, {0, 0, 0}).y, 3, 1e-6);
    EXPECT_EQ(look(*builder.build(), {5, 0, 9}, {5, 0, -2}).y, 0);
    HallMaterial pane = clear(1);
    pane.k_st = 0.5;
    builder.add(Box{{-2, -2, 3}, {2, 2, 4}}, pane);
    EXPECT_NEAR(look(*builder.build(), {0.1, 0, 9}, {0, 0, 0}).y, 0.75, 1e-6);
}

// ones give nothing, clear ones F_st^n. The body's front adds the reflectances by equation 4.
TEST(HallAmbient, SumsTransmittancesWhereLightComesOut) {
    SceneBuilder builder;
    HallMaterial neighbour = clear(1);
    neighbour.transmittance = constant_spectrum(0.5);
    builder.add(slab(1), clear(1))
        .add(Sphere{{5, 0, 9}, 1}, neighbour)
        .add(Sphere{{-5, 0, 9}, 1}, matt(0.25));
    builder.description.ambient = ambient(1, 1);
    builder.description.ambient->weights = ExplicitWeights{{0, 0.1, 0.2}};
    // front: 0.2 * 0.25 (the clear one has k_sr = 0); back: 0.1 * 0.5
    EXPECT_NEAR(look(*builder.build(), {0, 0, 5}, {0, 0, 0}).y, 0.2 * 0.25 + 0.1 * 0.5, 1e-6);
}

}  // namespace
}  // namespace bouguer::renderer
