// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "renderer/render.h"
#include "renderer/spectrum/colour.h"
#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/document.h"

namespace bouguer::server {
namespace {

/// What is accepted and yet not rendered exactly as it is written.
void print_notes(std::ostream& out, const renderer::SpectrumNotes& notes) {
    if (const auto& uplift = notes.uplift; uplift.count() > 0) {
        out << "  display colours that became spectra: " << uplift.count()
            << "; the worst comes back within CIEDE2000 " << uplift.largest() << ", at "
            << uplift.worst().front().where << "\n";
    }
    if (const auto& outside = notes.outside_range; outside.count() > 0) {
        out << "  lights with energy outside " << renderer::kLambdaMin_nm << " to "
            << renderer::kLambdaMax_nm << " nm, which is left out: " << outside.count()
            << "; as much as " << 100 * outside.largest() << " % of it, at "
            << outside.worst().front().where << "\n";
    }
}

}  // namespace

int run_validate(const ValidateOptions& options) {
    const auto job = read_document(options.document);
    if (!job) return print_error(std::cerr, job.error());
    const auto scene = renderer::build_scene(job->scene);
    if (!scene) return print_error(std::cerr, scene.error());
    std::cout << options.document.string() << ": valid, " << job->scene.objects.size()
              << " objects, " << job->scene.materials.size() << " materials, "
              << job->scene.lights.size() << " lights; scene " << job->scene_digest << "\n";
    print_notes(std::cout, job->notes);
    print_warnings(std::cerr, job->warnings);
    return kExitOk;
}

}  // namespace bouguer::server
