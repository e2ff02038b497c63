// SPDX-License-Identifier: Apache-2.0
// The daemon's log: one line of JSON on standard error for every request and every change of state.
// It is written by a thread of its own: whoever logs never waits, whether somebody reads it or not.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace bouguer::server {

enum class LogLevel { Info, Warning, Error };

/// Nothing below `level` is written. At the start everything is.
void set_log_level(LogLevel level);

/// Writes {"time": ..., "level": ..., "event": `event`, fields ...}, without empty fields. All text
/// is escaped, so that nothing a client sends can make a second line or hide in one. Thread-safe;
/// does not throw and never waits for the reader. Lines that find no room are dropped, and event
/// "log-dropped" tells how many ("count"). What waits is written when the program ends in order, as
/// far as the reader takes it at once; a crash loses it.
void log_event(LogLevel level, std::string_view event,
               std::initializer_list<std::pair<std::string_view, std::string>> fields) noexcept;

}  // namespace bouguer::server
