// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "renderer/render.h"
#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/document.h"

namespace bouguer::server {

int run_validate(const ValidateOptions& options) {
    const auto job = read_document(options.document);
    if (!job) return print_error(std::cerr, job.error());
    const auto scene = renderer::build_scene(job->scene);
    if (!scene) return print_error(std::cerr, scene.error());
    std::cout << options.document.string() << ": valid, " << job->scene.objects.size()
              << " objects, " << job->scene.materials.size() << " materials, "
              << job->scene.lights.size() << " lights; scene " << job->scene_digest << "\n";
    return kExitOk;
}

}  // namespace bouguer::server
