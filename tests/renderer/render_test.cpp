// SPDX-License-Identifier: Apache-2.0
#include "renderer/render.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <thread>

#include "renderer/film/unit_result.h"
#include "renderer/pass_plan.h"
#include "tests/support/parallel_render.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer {
namespace {

using test::clear;
using test::matt;
using test::SceneBuilder;

HallMaterial coloured(HallMaterial material, double red) {
    material.reflectance = sampled_spectrum({400, 700}, {1 - red, red}).value();
    return material;
}

/// A floor, a ball of the given material and a coloured one beside it, under two lamps.
SceneBuilder still_life(HallMaterial ball) {
    SceneBuilder builder;
    builder.description.camera = PerspectiveCamera{{0, 4, 12}, {0, 1, 0}, {0, 1, 0}, 40};
    builder.add(Plane{{0, 0, 0}, {0, 1, 0}}, matt(0.7))
        .add(Sphere{{-1.2, 1, 0}, 1}, std::move(ball))
        .add(Sphere{{1.2, 1, 0}, 1}, coloured(matt(0.5), 0.9))
        .light(PointLight{{5, 8, 5}, scaled_spectrum(library_spectrum("D65"), 100)})
        .light(DirectionalLight{{1, -1, -1}, scaled_spectrum(library_spectrum("A"), 0.2)});
    return builder;
}

HallMaterial green_glass() {
    HallMaterial glass = clear(1.3);
    glass.k_st = 0.9;
    glass.k_sr = 0.1;
    glass.n = 20;
    glass.mirror = true;
    glass.absorption = Absorption{sampled_spectrum({400, 550, 700}, {0.3, 0.9, 0.4}).value(), 1};
    return glass;
}

RenderSettings small(int width = 70, int height = 45) {
    RenderSettings settings;
    settings.resolution = {width, height};
    return settings;
}

std::vector<float> render_on(int threads, std::shared_ptr<const Scene> scene,
                             const RenderSettings& settings, std::uint32_t samples) {
    StopRule stop;
    stop.samples = samples;
    const auto render = Render::create(std::move(scene), settings, stop).value();
    bouguer::test::run_to_end(*render, threads);
    return render->picture()->xyz;
}

TEST(Render, GivesTheSameBitsForAnyNumberOfThreads) {
    auto builder = still_life(green_glass());
    builder.description.ambient = AmbientDescription{0.3, HemisphereWeights{}, nullptr};
    const auto scene = builder.build();
    const auto one = render_on(1, scene, small(), 20);
    EXPECT_EQ(one, render_on(2, scene, small(), 20));
    EXPECT_EQ(one, render_on(7, scene, small(), 20));
}

TEST(Render, DependsOnTheSeed) {
    const auto scene = still_life(green_glass()).build();
    RenderSettings other = small();
    other.seed = 2;
    EXPECT_NE(test::render(scene, small(), 2)->picture()->xyz,
              test::render(scene, other, 2)->picture()->xyz);
}

// A unit traced twice, or on its own, is the same unit.
TEST(Render, TracesUnitsAsPureFunctions) {
    const auto scene = still_life(green_glass()).build();
    StopRule stop;
    stop.samples = 4;
    const auto render = Render::create(scene, small(), stop).value();
    const Unit unit{2, 32, 32, 8, 8, 2, 2};
    UnitResult first(unit, 2);
    UnitResult second(unit, 2);
    render->trace(first);
    render->trace(second);
    for (int y = 32; y < 40; ++y) {
        for (int x = 32; x < 40; ++x) {
            for (std::uint32_t slot = 0; slot < 2; ++slot)
                EXPECT_EQ(first.at(x, y, slot).sum, second.at(x, y, slot).sum);
        }
    }
}

// Leaving out what the scene does not need never changes the picture: every combination of
// transparency, ambient and colour.
class Specialisation : public testing::TestWithParam<std::tuple<bool, bool, bool>> {};

TEST_P(Specialisation, GivesThePictureOfTheGeneralKernel) {
    const auto [transparent, with_ambient, grey] = GetParam();
    HallMaterial ball = transparent ? green_glass() : matt(0.5);
    if (grey && transparent) ball.absorption = test::absorbing(0.8);
    auto builder = still_life(ball);
    if (grey) {
        builder.description.materials.back().model = matt(0.4);
        builder.description.lights.pop_back();
    }
    if (with_ambient)
        builder.description.ambient = AmbientDescription{0.3, HemisphereWeights{}, nullptr};
    const auto scene = builder.build();
    RenderSettings general = small();
    general.specialise = false;
    const auto special_render = test::render(scene, small(), 4);
    const auto general_render = test::render(scene, general, 4);
    EXPECT_EQ(special_render->report().plan.kernel == general_render->report().plan.kernel,
              transparent && with_ambient);
    EXPECT_EQ(special_render->report().plan.values_per_path, grey ? 1U : 95U);
    const auto special = special_render->picture()->xyz;
    const auto all = general_render->picture()->xyz;
    ASSERT_EQ(special.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        // One number instead of a quadrature rounds differently; without that the bits are the
        // same.
        if (grey) {
            ASSERT_NEAR(special[i], all[i], 2e-6 * (1 + all[i])) << i;
        } else {
            ASSERT_EQ(special[i], all[i]) << i;
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Features, Specialisation,
                         testing::Combine(testing::Bool(), testing::Bool(), testing::Bool()));

TEST(Render, ShowsAPictureAfterEveryPass) {
    StopRule stop;
    stop.samples = 7;
    const auto render = Render::create(still_life(matt(0.5)).build(), small(), stop).value();
    EXPECT_FALSE(render->picture());
    std::vector<std::uint32_t> samples;
    while (auto unit = render->next_unit()) {
        render->trace(*unit);
        if (render->merge(*unit, 0)) samples.push_back(render->samples_done());
    }
    EXPECT_EQ(samples, (std::vector<std::uint32_t>{1, 2, 4, 7}));
    EXPECT_EQ(render->report().stopped_by, "samples");
    EXPECT_EQ(render->report().error.size(), 4U);
    EXPECT_FALSE(render->report().error[0].rmse) << "from one sample the error is unknown";
    EXPECT_TRUE(render->report().error[1].rmse);
    EXPECT_EQ(render->progress(0), 1);
}

TEST(Render, HandsOutAUnitAgainThatWasGivenBack) {
    StopRule stop;
    stop.samples = 1;
    const auto render = Render::create(still_life(matt(0.5)).build(), small(), stop).value();
    const auto unit = render->next_unit();
    render->give_back(unit);
    EXPECT_EQ(render->next_unit(), unit);
}

TEST(Render, GivesUpAUnitWhenAsked) {
    StopRule stop;
    stop.samples = 1;
    const auto render = Render::create(still_life(matt(0.5)).build(), small(), stop).value();
    std::atomic<bool> give_up = true;
    TraceLimits limits;
    limits.give_up = &give_up;
    const auto unit = render->next_unit();
    render->trace(*unit, limits);
    EXPECT_EQ(unit->cursor, 0U);
    EXPECT_EQ(unit->counters.rays, 0U) << "what is traced again is counted once";
    give_up = false;
    render->trace(*unit, limits);
    EXPECT_TRUE(unit->is_complete());
}

/// Renders on so many threads and leaves every unit after each sample.
std::vector<float> render_in_pieces(int threads, std::shared_ptr<const Scene> scene,
                                    const RenderSettings& settings, std::uint32_t samples) {
    StopRule stop;
    stop.samples = samples;
    const auto render = Render::create(std::move(scene), settings, stop).value();
    TraceLimits limits;
    limits.pause_at = TraceLimits::Clock::now();
    std::mutex mutex;
    std::size_t most = 0;
    const auto work = [&] {
        std::unique_lock lock(mutex);
        while (!render->finished()) {
            const auto unit = render->next_unit();
            lock.unlock();
            const std::size_t before = unit ? unit->cursor : 0;
            if (unit) render->trace(*unit, limits);
            lock.lock();
            if (!unit) continue;
            most = std::max(most, unit->cursor - before);
            if (unit->is_complete()) {
                render->merge(*unit, 0);
            } else {
                render->give_back(unit);
            }
        }
    };
    std::vector<std::thread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back(work);
    for (std::thread& thread : pool) thread.join();
    EXPECT_EQ(most, 1U) << "samples at a time";
    EXPECT_EQ(render->report().health.samples,
              samples * static_cast<std::uint64_t>(settings.resolution.width) *
                  static_cast<std::uint64_t>(settings.resolution.height));
    return render->picture()->xyz;
}

TEST(Render, GivesTheSameBitsWhenUnitsAreLeftAndTakenUpAgain) {
    const auto scene = still_life(green_glass()).build();
    const auto whole = render_on(2, scene, small(), 5);
    EXPECT_EQ(whole, render_in_pieces(1, scene, small(), 5));
    EXPECT_EQ(whole, render_in_pieces(4, scene, small(), 5));
}

TEST(Render, CountsTheRaysOfUnitsThatWereLeft) {
    StopRule stop;
    stop.samples = 1;
    const auto render = Render::create(still_life(matt(0.5)).build(), small(4, 4), stop).value();
    TraceLimits limits;
    limits.pause_at = TraceLimits::Clock::now();
    std::uint64_t rays = 0;
    while (auto unit = render->next_unit()) {
        render->trace(*unit, limits);
        if (unit->is_complete()) {
            render->merge(*unit, 0);
        } else {
            render->give_back(unit);
        }
        EXPECT_GT(render->rays(), rays);
        rays = render->rays();
    }
    EXPECT_EQ(rays, render->report().error.back().rays);
}

// 4 x 4 pixels are one unit; seven of its samples were traced when the time was over.
TEST(Render, ShowsWhatThereIsOfAFirstPassWhoseTimeIsOver) {
    const auto scene = still_life(matt(0.5)).build();
    StopRule stop;
    stop.seconds = 3;
    stop.limit_s = 5;
    const auto render = Render::create(scene, small(4, 4), stop).value();
    EXPECT_GE(render->deadline_s().value(), 3);
    EXPECT_LE(render->deadline_s().value(), 4);
    TraceLimits limits;
    limits.pause_at = TraceLimits::Clock::now();
    const auto unit = render->next_unit();
    for (int i = 0; i < 7; ++i) render->trace(*unit, limits);
    render->give_back(unit);
    render->end_late();
    EXPECT_TRUE(render->finished());
    EXPECT_EQ(render->samples_done(), 0U);
    EXPECT_EQ(render->next_unit(), nullptr);
    const Report report = render->report();
    EXPECT_EQ(report.stopped_by, "seconds");
    EXPECT_TRUE(report.error.empty()) << "nothing is known of it";
    ASSERT_TRUE(report.health.unfinished_pass);
    EXPECT_EQ(report.health.unfinished_pass->pixels, 16U);
    EXPECT_EQ(report.health.unfinished_pass->without_sample, 9U);
    const auto shown = render->picture()->xyz;
    const auto whole = test::render(scene, small(4, 4), 1)->picture()->xyz;
    for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_EQ(shown[i], i < 21 ? whole[i] : 0) << i;
    EXPECT_TRUE(encode_png(*render->picture(), {}));
}

TEST(Render, KeepsTheNewestCompletePassWhenTheTimeIsOver) {
    const auto scene = still_life(matt(0.5)).build();
    StopRule stop;
    stop.limit_s = 5;
    const auto render = Render::create(scene, small(4, 4), stop).value();
    const auto first = render->next_unit();
    render->trace(*first);
    EXPECT_TRUE(render->merge(*first, 1e-3));
    const auto second = render->next_unit();
    TraceLimits limits;
    limits.pause_at = TraceLimits::Clock::now();
    render->trace(*second, limits);
    render->give_back(second);
    render->end_late();
    EXPECT_EQ(render->report().stopped_by, "server-limit");
    EXPECT_FALSE(render->report().health.unfinished_pass);
    EXPECT_EQ(render->samples_done(), 1U);
    EXPECT_EQ(render->picture()->xyz, test::render(scene, small(4, 4), 1)->picture()->xyz);
}

TEST(Render, GivesUpASampleWhenTheTimeIsOver) {
    const auto scene = still_life(green_glass()).build();
    StopRule stop;
    stop.samples = 1;
    const auto render = Render::create(scene, small(), stop).value();
    TraceLimits limits;
    limits.give_up_at = TraceLimits::Clock::now();
    const auto unit = render->next_unit();
    render->trace(*unit, limits);
    EXPECT_EQ(unit->cursor, 0U);
    EXPECT_EQ(unit->counters.rays, 0U);
}

// A grey scene takes one number a path, whatever stands in materials that no object has.
TEST(Render, IgnoresColoursThatNoObjectHas) {
    auto builder = SceneBuilder()
                       .add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.5))
                       .light(DirectionalLight{{0, 0, -1}, library_spectrum("D65")});
    const auto before = test::render(builder.build(), small(4, 4), 2)->picture()->xyz;
    builder.description.materials.push_back({"unused", coloured(matt(0.5), 0.9)});
    const auto render = test::render(builder.build(), small(4, 4), 2);
    EXPECT_EQ(render->report().plan.values_per_path, 1U);
    EXPECT_EQ(render->picture()->xyz, before);
}

TEST(Render, StopsBySeconds) {
    StopRule stop;
    stop.seconds = 10;
    const auto render = Render::create(still_life(matt(0.5)).build(), small(), stop).value();
    double clock = 0;
    while (auto unit = render->next_unit()) {
        render->trace(*unit);
        render->merge(*unit, clock += 0.5);
    }
    EXPECT_EQ(render->report().stopped_by, "seconds");
    EXPECT_GE(clock, 10);
}

TEST(Render, StopsAtAnError) {
    StopRule stop;
    stop.error = 0.05;
    stop.samples = 4096;
    const auto render = Render::create(still_life(matt(0.5)).build(), small(), stop).value();
    while (auto unit = render->next_unit()) {
        render->trace(*unit);
        render->merge(*unit, 0);
    }
    const Report report = render->report();
    EXPECT_EQ(report.stopped_by, "error");
    EXPECT_LE(report.error.back().relative_rmse->high, 0.05);
    EXPECT_GT(report.error[report.error.size() - 2].relative_rmse->high, 0.05);
}

// The pixels of a crop are those of the whole picture.
TEST(Render, CropsWithoutChangingPixels) {
    const auto scene = still_life(green_glass()).build();
    const Picture whole = *test::render(scene, small(), 3)->picture();
    RenderSettings settings = small();
    settings.crop = Crop{11, 7, 40, 9};
    const Picture part = *test::render(scene, settings, 3)->picture();
    ASSERT_EQ(part.width, 40);
    ASSERT_EQ(part.height, 9);
    for (std::size_t y = 0; y < 9; ++y) {
        for (std::size_t i = 0; i < 120; ++i)
            EXPECT_EQ(part.xyz[y * 120 + i], whole.xyz[((y + 7) * 70 + 11) * 3 + i]);
    }
}

// No lamps, nothing to see: black, without noise, and it ends.
TEST(Render, RendersDarknessWithoutError) {
    const auto render = test::render(SceneBuilder().build(), small(8, 8), 16);
    const Picture picture = *render->picture();
    for (const float v : picture.xyz) EXPECT_EQ(v, 0);
    ASSERT_TRUE(render->report().error.back().rmse);
    EXPECT_EQ(render->report().error.back().rmse->value, 0);
}

// A grey card under D65 has the colour of D65, at the default 5 nm: x = 0.31272, y = 0.32903 [CIE
// 015:2018].
TEST(Render, ShowsAGreyCardInTheColourOfItsLamp) {
    SceneBuilder builder;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.5))
        .light(DirectionalLight{{0, 0, -1}, library_spectrum("D65")});
    for (const bool specialise : {true, false}) {
        RenderSettings settings = small(4, 4);
        settings.specialise = specialise;
        const auto xyz = test::render(builder.build(), settings, 2)->picture()->xyz;
        const double sum = xyz[0] + xyz[1] + xyz[2];
        EXPECT_NEAR(xyz[0] / sum, 0.31272, 1e-4);
        EXPECT_NEAR(xyz[1] / sum, 0.32903, 1e-4);
    }
}

// The same scene by three channels: the grey card is grey in Rec.709, so again of D65's colour, and
// as bright.
TEST(Render, RendersTheBaselineInThreeChannels) {
    SceneBuilder builder;
    builder.add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.5))
        .light(DirectionalLight{{0, 0, -1}, library_spectrum("D65")});
    RenderSettings settings = small(4, 4);
    const auto spectral = test::render(builder.build(), settings, 2)->picture()->xyz;
    settings.integrator = IntegratorType::Rgb;
    const auto rgb = test::render(builder.build(), settings, 2);
    EXPECT_EQ(rgb->report().plan.values_per_path, 3U);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgb->picture()->xyz[c] / spectral[c], 1, 1e-3);
}

TEST(Render, NamesTheQuadraturesOwnError) {
    const auto scene = still_life(green_glass()).build();
    RenderSettings coarse = small(4, 4);
    coarse.wavelength_step_nm = 40;
    const double fine_error =
        *test::render(scene, small(4, 4), 1)->report().bias.wavelength_relative;
    const double coarse_error = *test::render(scene, coarse, 1)->report().bias.wavelength_relative;
    EXPECT_LT(fine_error, 1e-3);
    EXPECT_GT(coarse_error, fine_error);
    RenderSettings rgb = small(4, 4);
    rgb.integrator = IntegratorType::Rgb;
    EXPECT_FALSE(test::render(scene, rgb, 1)->report().bias.wavelength_relative);
}

TEST(PassPlan, CoversEveryPixelOnce) {
    std::set<std::pair<int, int>> pixels;
    for (const Unit& u : units_of_pass({3, 5, 100, 47}, 0, 0, 64)) {
        for (int y = u.y; y < u.y + u.height; ++y) {
            for (int x = u.x; x < u.x + u.width; ++x) EXPECT_TRUE(pixels.emplace(x, y).second);
        }
    }
    EXPECT_EQ(pixels.size(), 4700U);
    EXPECT_EQ(*pixels.begin(), std::pair(3, 5));
    EXPECT_EQ(*pixels.rbegin(), std::pair(102, 51));
}

TEST(PassPlan, DoublesSamplesUpToALimit) {
    std::vector<std::uint32_t> passes;
    for (std::uint32_t done = 0; done < 256; done += passes.back())
        passes.push_back(pass_samples(done));
    EXPECT_EQ(passes, (std::vector<std::uint32_t>{1, 1, 2, 4, 8, 16, 32, 64, 64, 64}));
}

}  // namespace
}  // namespace bouguer::renderer
