// SPDX-License-Identifier: Apache-2.0
#include "tests/support/source_folder.h"

namespace bouguer::tests {

std::filesystem::path source_folder() { return BOUGUER_SOURCE_DIR; }

}  // namespace bouguer::tests
