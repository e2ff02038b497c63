// SPDX-License-Identifier: Apache-2.0
// The tables of the SQLite job store and how a connection is set up.
#pragma once

#include <SQLiteCpp/Database.h>

#include "renderer/core/result.h"

namespace bouguer::server {

/// The pragma by which a commit waits for the disk, so that it survives a power loss: as
/// prepare_database() leaves it.
inline constexpr const char* kFlushedCommits = "PRAGMA synchronous = FULL";

/// Sets the pragmas, checks the file and makes or migrates the tables. Error{Internal}: damaged,
/// locked by another process, or written by a newer version. Throws SQLite::Exception for the rest.
[[nodiscard]] Result<void> prepare_database(SQLite::Database& database);

}  // namespace bouguer::server
