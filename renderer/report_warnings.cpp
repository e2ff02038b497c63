// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "renderer/report.h"

namespace bouguer::renderer {
namespace {

/// Of the picture's light; less is noise to whoever looks at it.
constexpr double kNotable = 0.01;

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
    return text;
}

void add_cut(Warnings& warnings, double share, const char* code, const char* by,
             const char* advice) {
    if (!(share > kNotable)) return;
    warnings.add({"", code,
                  "rays that were cut by " + std::string(by) + " may have carried " +
                      percent(share) + " of the picture's light",
                  advice});
}

}  // namespace

Warnings warnings_of(const Report& report) {
    Warnings warnings;
    add_cut(warnings, report.bias.depth_limit_share, "light-cut-by-depth", "max_depth",
            "ask for a larger max_depth");
    add_cut(warnings, report.bias.threshold_share, "light-cut-by-threshold", "min_throughput",
            "ask for a smaller min_throughput");
    if (report.health.blackened_samples > 0) {
        warnings.add({"", "samples-blackened",
                      std::to_string(report.health.blackened_samples) + " of " +
                          std::to_string(report.health.samples) +
                          " samples are black because everything that they led to was cut",
                      "ask for a larger max_depth and a smaller min_throughput"});
    }
    for (const UnmatchedExits& of : report.health.unmatched_objects) {
        warnings.add({"", "body-lost",
                      std::to_string(of.count) + " rays lost track of whether they are inside \"" +
                          of.object + "\"",
                      "see that its mesh is closed, or give it a material that does not transmit"});
    }
    return warnings;
}

}  // namespace bouguer::renderer
