// SPDX-License-Identifier: Apache-2.0
// The objects of a scene: shape + material + where it stands.
//
//     { "name": "ball", "shape": {...}, "material": "glass",
//       "transform": <transform>, "instances": [<transform>, ...] }
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "api/json_value.h"
#include "api/read_context.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// Names of a document and the index of what they name.
using NameIndex = std::map<std::string, std::size_t, std::less<>>;

/// The keys of `names`, for suggestions; they live as long as it does.
[[nodiscard]] std::vector<std::string_view> words_of(const NameIndex& names);

/// Reads the array of objects at `value`; `material_names` are the indices of `materials`. `names`
/// gets every name, also of objects that have problems, so that references to them are not reported
/// again. Objects with problems are left out of the result.
[[nodiscard]] std::vector<renderer::ObjectDescription> read_objects(
    const JsonValue& value, const NameIndex& material_names,
    const std::vector<renderer::MaterialDescription>& materials, const ReadContext& context,
    NameIndex& names);

}  // namespace bouguer::api
