// SPDX-License-Identifier: Apache-2.0
// What the spacing of the wavelengths costs and saves: renders a scene at 1, 2, 5, 10, 20 and 40 nm
// and by rgb, with the same rays each time, and prints as CSV the run time and how far each
// picture's colours are from those at 1 nm.
//
//     quadrature SCENE.json [WIDTH HEIGHT [SAMPLES [ROUNDS]]]
//
// seconds: of one processor, the median of the rounds. time_ratio: over that at 1 nm in the same
// round, the median likewise; each round renders everything once. delta_e: CIEDE2000 over the
// pixels, the white being that of the first lamp. relative_rms: root mean square of the differences
// in X, Y and Z over their mean. relative_max: the largest difference of a pixel in X, Y or Z over
// its Y at 1 nm. claimed: what the job's own report says, bias.wavelength_relative.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "renderer/film/image_file.h"
#include "renderer/lights/light.h"
#include "renderer/scene/scene.h"
#include "renderer/spectrum/colour_difference.h"
#include "tests/support/parallel_render.h"
#include "tests/support/scene_files.h"

namespace {

using namespace bouguer;
using namespace bouguer::renderer;

struct Variant {
    IntegratorType integrator = IntegratorType::Hall;
    double step_nm = 1;
    std::vector<double> seconds{};
    Picture picture{};
    Report report{};
};

struct Difference {
    double mean = 0, p95 = 0, max = 0;  ///< CIEDE2000
    double relative_rms = 0, relative_max = 0;
};

void render(Variant& variant, const std::shared_ptr<const Scene>& scene, RenderSettings settings,
            std::uint32_t samples) {
    settings.integrator = variant.integrator;
    settings.wavelength_step_nm = variant.step_nm;
    // So that no ray is dropped at one spacing and followed at another.
    settings.min_throughput = 0;
    StopRule stop;
    stop.samples = samples;
    const auto render = Render::create(scene, settings, stop).value();
    const std::clock_t start = std::clock();
    test::run_to_end(*render, 1);
    variant.seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    variant.picture = *render->picture();
    variant.report = render->report();
}

std::vector<Xyz> pixels_of(const Picture& picture) {
    std::vector<Xyz> pixels;
    for (std::size_t i = 0; i < picture.xyz.size(); i += 3)
        pixels.push_back({picture.xyz[i], picture.xyz[i + 1], picture.xyz[i + 2]});
    return pixels;
}

/// `white` is the brightest that the reference shows. Pixels darker than a thousandth of it do not
/// count.
Difference compare(const Picture& picture, const Picture& reference, Xyz white) {
    const std::vector<Xyz> found = pixels_of(picture), expected = pixels_of(reference);
    Difference difference;
    std::vector<double> delta_e;
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Xyz a = found[i], b = expected[i];
        if (b.y < 1e-3 * white.y) continue;
        delta_e.push_back(delta_e_2000(lab_of(a, white), lab_of(b, white)));
        difference.mean += delta_e.back();
        squares += std::pow(a.x - b.x, 2) + std::pow(a.y - b.y, 2) + std::pow(a.z - b.z, 2);
        sum += b.x + b.y + b.z;
        difference.relative_max = std::max({difference.relative_max, std::abs(a.x - b.x) / b.y,
                                            std::abs(a.y - b.y) / b.y, std::abs(a.z - b.z) / b.y});
    }
    const auto pixels = static_cast<double>(delta_e.size());
    std::sort(delta_e.begin(), delta_e.end());
    difference.mean /= pixels;
    difference.relative_rms = std::sqrt(squares / (3 * pixels)) / (sum / (3 * pixels));
    difference.p95 = delta_e[delta_e.size() * 95 / 100];
    difference.max = delta_e.back();
    return difference;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
    return median(ratios);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: quadrature SCENE.json [WIDTH HEIGHT [SAMPLES [ROUNDS]]]\n");
        return 2;
    }
    const auto number = [&](int i, int fallback) {
        return argc > i ? std::atoi(argv[i]) : fallback;
    };
    auto job = test::load_job(argv[1]);
    job.settings.resolution = {number(2, 160), number(3, 120)};
    const auto samples = static_cast<std::uint32_t>(number(4, 16));
    const auto scene = build_scene(job.scene).value();

    std::vector<Variant> variants;
    for (const double step_nm : {1, 2, 5, 10, 20, 40})
        variants.push_back({IntegratorType::Hall, step_nm});
    variants.push_back({IntegratorType::Rgb, 5});
    for (int round = 0; round < number(5, 3); ++round)
        for (Variant& variant : variants) render(variant, scene, job.settings, samples);

    const Variant& reference = variants.front();
    const Xyz lamp = xyz_of(*scene->lights().front().spectrum());
    const Xyz white = lamp * (1 / (lamp.y * automatic_exposure(reference.picture)));
    std::printf(
        "basis,step_nm,values,rays,seconds,time_ratio,delta_e_mean,delta_e_p95,delta_e_max,"
        "relative_rms,relative_max,claimed\n");
    for (const Variant& variant : variants) {
        const Difference d = compare(variant.picture, reference.picture, white);
        const bool is_rgb = variant.integrator == IntegratorType::Rgb;
        std::printf("%s,%s,%zu,%llu,%.4f,%.4f,%.5f,%.5f,%.5f,%.3g,%.3g,%s\n",
                    variant.report.plan.basis.c_str(),
                    is_rgb ? "" : std::to_string(static_cast<int>(variant.step_nm)).c_str(),
                    variant.report.plan.values_per_path,
                    static_cast<unsigned long long>(variant.report.error.back().rays),
                    median(variant.seconds), median_ratio(variant.seconds, reference.seconds),
                    d.mean, d.p95, d.max, d.relative_rms, d.relative_max,
                    is_rgb ? "" : std::to_string(*variant.report.bias.wavelength_relative).c_str());
    }
    return 0;
}
