// SPDX-License-Identifier: Apache-2.0
// Reads the command line of `bouguer`.
#pragma once

#include <span>
#include <string>
#include <variant>

#include "server/cli/options.h"

namespace bouguer::server {

/// Exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitBadInput = 2;  ///< bad usage, or a document that is refused

/// Nothing is to be run: help was asked for, or the command line is wrong.
struct UsageMessage {
    int exit_code = kExitOk;
    std::string text;  ///< for standard output when the code is 0, otherwise for standard error
};

/// `arguments` without the program's name.
[[nodiscard]] std::variant<Command, UsageMessage> read_command_line(
    std::span<const char* const> arguments);

}  // namespace bouguer::server
