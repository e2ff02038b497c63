// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "renderer/render.h"
#include "server/cli/command_line.h"
#include "server/cli/commands.h"

namespace bouguer::server {

int run_version(const VersionOptions& /*options*/) {
    std::cout << "bouguer " << BOUGUER_VERSION << "\n";
    for (const std::string& library : renderer::library_versions()) std::cout << library << "\n";
    return kExitOk;
}

}  // namespace bouguer::server
