// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/claims.h"

#include <cmath>
#include <vector>

#include "tests/support/parallel_render.h"

namespace bouguer::test {
namespace {

using namespace renderer;

struct PassEnd {
    std::vector<float> xyz;
    ErrorPoint point;
};

std::map<std::uint32_t, PassEnd> render_passes(const std::shared_ptr<const Scene>& scene,
                                               const RenderSettings& settings,
                                               std::uint32_t samples, int threads, bool last_only) {
    StopRule stop;
    stop.samples = samples;
    const auto render = Render::create(scene, settings, stop).value();
    std::map<std::uint32_t, PassEnd> ends;
    run_to_end(*render, threads, [&] {
        if (last_only) ends.clear();
        ends[render->samples_done()] = {render->picture()->xyz, render->report().error.back()};
    });
    return ends;
}

double mean_square_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(static_cast<double>(a[i]) - b[i], 2);
    return sum / static_cast<double>(a.size());
}

}  // namespace

std::map<std::uint32_t, ClaimRow> compare_claims(const std::shared_ptr<const Scene>& scene,
                                                 RenderSettings settings,
                                                 const ClaimSettings& claims) {
    settings.seed = 0;
    const auto reference = render_passes(scene, settings, claims.samples * claims.reference_factor,
                                         claims.threads, true)
                               .rbegin()
                               ->second;
    const double reference_variance = std::pow(reference.point.rmse->value, 2);

    std::map<std::uint32_t, ClaimRow> rows;
    std::map<std::uint32_t, std::vector<Estimate>> intervals;
    for (int seed = 1; seed <= claims.seeds; ++seed) {
        settings.seed = static_cast<std::uint64_t>(seed);
        const auto ends = render_passes(scene, settings, claims.samples, claims.threads, false);
        for (std::uint32_t samples = 4; samples <= claims.samples; samples *= 4) {
            const PassEnd& end = ends.at(samples);
            ClaimRow& row = rows[samples];
            row.claimed += std::pow(end.point.rmse->value, 2);
            row.truth += mean_square_difference(end.xyz, reference.xyz) - reference_variance;
            intervals[samples].push_back(*end.point.rmse);
            ++row.seeds;
        }
    }
    for (auto& [samples, row] : rows) {
        row.claimed = std::sqrt(row.claimed / row.seeds);
        row.truth = std::sqrt(row.truth / row.seeds);
        for (const Estimate& e : intervals[samples])
            row.covered += e.low <= row.truth && row.truth <= e.high ? 1.0 / row.seeds : 0;
    }
    return rows;
}

}  // namespace bouguer::test
