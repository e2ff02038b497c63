// SPDX-License-Identifier: Apache-2.0
// The tables of the SQLite job store and how a connection is set up.
#pragma once

#include <SQLiteCpp/Database.h>

#include "renderer/core/result.h"

namespace bouguer::server {

/// A commit waits for the disk and survives a power loss: as prepare_database() leaves it.
inline constexpr const char* kFlushedCommits = "PRAGMA synchronous = FULL";
/// A commit survives the end of the process; a power loss may undo it, and all later ones with it
/// that are not flushed.
inline constexpr const char* kUnflushedCommits = "PRAGMA synchronous = NORMAL";

/// Sets the pragmas, checks the file and makes or migrates the tables. Error{Internal}: damaged,
/// locked by another process, or written by a newer version. Throws SQLite::Exception for the rest.
[[nodiscard]] Result<void> prepare_database(SQLite::Database& database);

}  // namespace bouguer::server
