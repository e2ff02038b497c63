// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/colorchecker.h"

#include <algorithm>
#include <sstream>

#include "renderer/spectrum/spectra.h"
#include "tests/accuracy/flat_faces.h"
#include "tests/support/scene_files.h"
#include "tests/support/source_folder.h"

namespace bouguer::test {

using namespace renderer;

std::vector<PatchColour> render_colorchecker(const std::string& illuminant, double step_nm) {
    api::JobRequest job = example_job("colour/colorchecker-" + illuminant + ".json");
    job.settings.resolution = {114, 78};
    job.settings.wavelength_step_nm = step_nm;
    const auto rendered = colours_of_faces(job.scene, render_picture(job));

    const SpectrumPtr light = library_spectrum(illuminant);
    const Xyz white = xyz_of(*light);
    std::vector<PatchColour> patches;
    for (const ObjectDescription& object : job.scene.objects) {
        const SpectrumPtr reflectance = library_spectrum("ColorChecker-" + object.name);
        if (!reflectance) continue;  // the board behind the patches
        const Xyz direct = xyz_of_reflectance(*reflectance, *light) * white.y;
        patches.push_back(
            {object.name, lab_of(rendered.at(object.name), white), lab_of(direct, white)});
    }
    return patches;
}

double worst_delta_e(const std::vector<PatchColour>& patches) {
    double worst = 0;
    for (const PatchColour& patch : patches) worst = std::max(worst, patch.delta_e());
    return worst;
}

std::vector<PublishedChart> published_charts() {
    std::istringstream table(
        read_file(tests::source_folder() / "tests/accuracy/data/colorchecker_published.csv"));
    // Rows: chart, patch, L, a, b; a line that begins with # says where they are from.
    std::vector<PublishedChart> charts;
    std::string line, chart, patch;
    while (std::getline(table, line)) {
        if (line.empty() || line[0] == '#') continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        Lab lab;
        if (!(row >> chart >> patch >> lab.L >> lab.a >> lab.b)) continue;  // the heading
        if (charts.empty() || charts.back().name != chart) charts.push_back({chart, {}});
        charts.back().patches.push_back(lab);
    }
    return charts;
}

}  // namespace bouguer::test
