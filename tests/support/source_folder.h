// SPDX-License-Identifier: Apache-2.0
// Where the sources are: for tests that read documents of the repository.
#pragma once

#include <filesystem>

namespace bouguer::tests {

/// The top of the repository that the tests were built from.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace bouguer::tests
