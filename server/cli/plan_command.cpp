// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "api/writers.h"
#include "renderer/render.h"
#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/document.h"

namespace bouguer::server {
namespace {

void print_table(const renderer::Plan& plan) {
    std::size_t width = 0;
    for (const auto& item : plan.items) width = std::max(width, item.feature.size());
    for (const auto& item : plan.items) {
        std::cout << (item.needed ? "needed    " : "left out  ") << std::left
                  << std::setw(static_cast<int>(width) + 2) << item.feature << item.reason << "\n";
    }
    std::cout << "kernel    " << plan.kernel << "\n"
              << "basis     " << plan.basis << ", " << plan.values_per_path << " values a path\n"
              << "scene     " << plan.objects << " objects, " << plan.triangles << " triangles, "
              << plan.lights << " lights\n"
              << "memory    " << std::fixed << std::setprecision(1)
              << static_cast<double>(plan.memory_bytes_estimate) / (1U << 20U) << " MiB\n";
}

}  // namespace

int run_plan(const PlanOptions& options) {
    auto job = read_document(options.document);
    if (!job) return print_error(std::cerr, job.error());
    if (auto applied = apply_overrides(*job, options.overrides); !applied) {
        return print_error(std::cerr, applied.error());
    }
    const auto scene = renderer::build_scene(job->scene);
    if (!scene) return print_error(std::cerr, scene.error());
    print_warnings(std::cerr, job->warnings);
    const renderer::Plan plan = renderer::make_plan(**scene, job->settings);
    if (options.json) {
        std::cout << api::plan_json(plan) << "\n";
    } else {
        print_table(plan);
    }
    return kExitOk;
}

}  // namespace bouguer::server
