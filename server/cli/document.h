// SPDX-License-Identifier: Apache-2.0
// Documents that the command line names, and what it says in their place.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "api/job_document.h"
#include "server/cli/options.h"

namespace bouguer::server {

/// Reads a scene or job from a file; the mesh files that it names are looked for beside it. Errors
/// as api::parse_job, NotFound when there is no such file.
[[nodiscard]] Result<api::JobRequest> read_document(const std::filesystem::path& file);

/// Error{InvalidInput} with a problem for every option that does not fit; their pointers are the
/// options' names.
[[nodiscard]] Result<void> apply_overrides(api::JobRequest& job, const Overrides& overrides);

/// As api::read_output_texts(); the problems' pointers are the options' names.
[[nodiscard]] Result<renderer::OutputSettings> read_output_options(
    const api::OutputTexts& texts, api::OutputScope scope, const renderer::OutputSettings& base);

/// "--color-space" for "color_space".
[[nodiscard]] std::string option_of(std::string_view parameter);

/// Writes every warning, a line each: "warning: pointer: detail; advice [code]".
void print_warnings(std::ostream& out, const Warnings& warnings);

/// Writes the message and every problem, a line each: "pointer: detail (found X, allowed Y)".
/// Returns the program's exit code for it.
int print_error(std::ostream& out, const Error& error);

}  // namespace bouguer::server
