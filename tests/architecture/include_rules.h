// SPDX-License-Identifier: Apache-2.0
// Who may include what: the layers renderer <- api <- server, and one room for each third-party
// library. Reads text only, so that the rules themselves can be tested.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bouguer::tests {

/// One line `#include ...` of a source.
struct Include {
    int line = 0;  ///< from 1
    bool quoted = false;
    std::string path;  ///< what stands between the quotes or brackets
};

/// The include lines of a source text, in order. Comments that span lines are not looked into.
std::vector<Include> includes_of(std::string_view text);

/// What is wrong with the includes of the file at `path` (relative to the repository, '/' between
/// folders), a sentence each: "path:line: ...". Empty: nothing. A test is held to the rules of the
/// layer that it mirrors; folders of tests/ that mirror none may include everything.
std::vector<std::string> broken_rules(std::string_view path, std::string_view text);

}  // namespace bouguer::tests
