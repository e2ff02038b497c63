// SPDX-License-Identifier: Apache-2.0
// Prints how far the rendered ColorChecker is from its own spectra, and from the published charts
// patch by patch, with what differs most: lightness L, chroma C or hue H, rendered less published.
//
//     colorchecker [STEP_NM]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/accuracy/colorchecker.h"

namespace {

using namespace bouguer::test;
using bouguer::renderer::Lab;

struct Part {
    char name;
    double size;
};

/// The largest of the differences in L, C and H, which as squares make up that of L*a*b*.
Part largest_part(const Lab& a, const Lab& b) {
    const double d_l = a.L - b.L;
    const double d_c = std::hypot(a.a, a.b) - std::hypot(b.a, b.b);
    const double squared = std::pow(a.a - b.a, 2) + std::pow(a.b - b.b, 2) - d_c * d_c;
    const double d_h = std::copysign(std::sqrt(std::max(squared, 0.0)), a.b * b.a - a.a * b.b);
    Part largest{'L', d_l};
    for (const Part part : {Part{'C', d_c}, Part{'H', d_h}})
        if (std::abs(part.size) > std::abs(largest.size)) largest = part;
    return largest;
}

}  // namespace

int main(int argc, char** argv) {
    const double step_nm = argc > 1 ? std::atof(argv[1]) : 1;
    std::printf("largest CIEDE2000 of 24 patches, rendered at %g nm against spectra at 1 nm\n",
                step_nm);
    for (const char* illuminant : {"D65", "D50", "A", "F11"})
        std::printf("  %-4s %.2g\n", illuminant,
                    worst_delta_e(render_colorchecker(illuminant, step_nm)));

    const auto charts = published_charts();
    std::printf("\nunder D50, CIEDE2000 against published charts\n%-15s  %6s  %6s  %6s", "rendered",
                "L", "a", "b");
    for (const PublishedChart& chart : charts) std::printf("  %18s", chart.name.c_str());
    std::printf("\n");
    const auto patches = render_colorchecker("D50", step_nm);
    std::vector<double> sums(charts.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Lab& lab = patches[i].rendered;
        std::printf("%-15s  %6.2f  %6.2f  %6.2f", patches[i].name.c_str(), lab.L, lab.a, lab.b);
        for (std::size_t c = 0; c < charts.size(); ++c) {
            const double delta_e = bouguer::renderer::delta_e_2000(lab, charts[c].patches[i]);
            const Part part = largest_part(lab, charts[c].patches[i]);
            sums[c] += delta_e;
            std::printf("  %8.2f  %c %+6.2f", delta_e, part.name, part.size);
        }
        std::printf("\n");
    }
    std::printf("%-39s", "mean");
    for (const double sum : sums)
        std::printf("  %8.2f          ", sum / static_cast<double>(patches.size()));
    std::printf("\n");
    return 0;
}
