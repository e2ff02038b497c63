// SPDX-License-Identifier: Apache-2.0
// `bouguer`: reads the command line and runs the subcommand.
#include <csignal>
#include <exception>
#include <iostream>
#include <span>

#include "server/cli/command_line.h"
#include "server/cli/commands.h"

namespace {

using namespace bouguer::server;

int run(const Command& command) {
    struct Runner {
        int operator()(const ServeOptions& options) const { return run_serve(options); }
        int operator()(const RenderOptions& options) const { return run_render(options); }
        int operator()(const ValidateOptions& options) const { return run_validate(options); }
        int operator()(const PlanOptions& options) const { return run_plan(options); }
        int operator()(const CompareOptions& options) const { return run_compare(options); }
        int operator()(const VersionOptions& options) const { return run_version(options); }
    };
    return std::visit(Runner{}, command);
}

/// What was printed has to arrive: a full disk behind standard output is a failure.
int with_output(int exit_code) {
    std::cout.flush();
    return exit_code == kExitOk && !std::cout ? kExitFailed : exit_code;
}

int say(const UsageMessage& message) {
    (message.exit_code == kExitOk ? std::cout : std::cerr) << message.text;
    return message.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    // A reader that goes away is an error of the write and not the end of the program.
    (void)std::signal(SIGPIPE, SIG_IGN);
    try {
        const std::span<const char* const> arguments(argv, static_cast<std::size_t>(argc));
        const auto line = read_command_line(arguments.subspan(1));
        if (const auto* command = std::get_if<Command>(&line)) return with_output(run(*command));
        return with_output(say(std::get<UsageMessage>(line)));
    } catch (const std::exception& e) {
        std::cerr << "bouguer: " << e.what() << "\n";
        return kExitFailed;
    }
}
