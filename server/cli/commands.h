// SPDX-License-Identifier: Apache-2.0
// The subcommands. Each has a source of its own and returns the program's exit code.
#pragma once

#include "server/cli/options.h"

namespace bouguer::server {

/// Runs the daemon until SIGTERM or SIGINT, then drains: accepts nothing more, lets the units under
/// way end, puts running jobs back into the stored queue. A second signal ends it at once.
[[nodiscard]] int run_serve(const ServeOptions& options);

/// Renders here, by the same scheduler, workers and task as the daemon. On SIGINT or SIGTERM writes
/// the newest complete pass, if there is one, and returns kExitFailed.
[[nodiscard]] int run_render(const RenderOptions& options);

[[nodiscard]] int run_validate(const ValidateOptions& options);
[[nodiscard]] int run_plan(const PlanOptions& options);
/// Prints how different two pictures look, and writes the map of it when one is asked for.
[[nodiscard]] int run_compare(const CompareOptions& options);
[[nodiscard]] int run_version(const VersionOptions& options);

}  // namespace bouguer::server
