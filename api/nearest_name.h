// SPDX-License-Identifier: Apache-2.0
// "Did you mean ...?": the known word that is nearest to a misspelt one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bouguer::api {

/// Least number of insertions, deletions, substitutions and swaps of neighbours that make `a` into
/// `b`, no substring edited twice (optimal string alignment distance).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The nearest of `known`; empty when none is near (more than a third of the letters differ).
[[nodiscard]] std::string_view nearest_name(std::string_view word,
                                            const std::vector<std::string_view>& known);

/// " Did you mean \"fov_deg\"?", or nothing when no known word is near.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string_view>& known);

/// The words as a list for people, at most twenty: "\"box\", \"disk\", \"sphere\"".
[[nodiscard]] std::string quoted_list(const std::vector<std::string_view>& words);

}  // namespace bouguer::api
