// SPDX-License-Identifier: Apache-2.0
// Prints how far the rendered ColorChecker is from its own spectra, and from the published charts.
//
//     colorchecker [STEP_NM]

#include <cstdio>
#include <cstdlib>

#include "tests/accuracy/colorchecker.h"

int main(int argc, char** argv) {
    using namespace bouguer::test;
    const double step_nm = argc > 1 ? std::atof(argv[1]) : 1;
    std::printf("largest CIEDE2000 of 24 patches, rendered at %g nm against spectra at 1 nm\n",
                step_nm);
    for (const char* illuminant : {"D65", "D50", "A", "F11"})
        std::printf("  %-4s %.2g\n", illuminant,
                    worst_delta_e(render_colorchecker(illuminant, step_nm)));

    const auto charts = published_charts();
    std::printf("\nunder D50, CIEDE2000 against published charts\n%-15s", "");
    for (const PublishedChart& chart : charts) std::printf("  %18s", chart.name.c_str());
    std::printf("\n");
    const auto patches = render_colorchecker("D50", step_nm);
    std::vector<double> sums(charts.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        std::printf("%-15s", patches[i].name.c_str());
        for (std::size_t c = 0; c < charts.size(); ++c) {
            const double delta_e =
                bouguer::renderer::delta_e_2000(patches[i].rendered, charts[c].patches[i]);
            sums[c] += delta_e;
            std::printf("  %18.2f", delta_e);
        }
        std::printf("\n");
    }
    std::printf("%-15s", "mean");
    for (const double sum : sums)
        std::printf("  %18.2f", sum / static_cast<double>(patches.size()));
    std::printf("\n");
    return 0;
}
