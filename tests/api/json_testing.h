// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <utility>

#include "api/json_parser.h"

namespace bouguer::tests {

/// The tree of a text that can be read; throws for others.
inline api::JsonTree tree_of(std::string_view text) {
    return std::move(api::read_json_tree(text, api::Limits{})).value();
}

}  // namespace bouguer::tests
