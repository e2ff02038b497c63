// SPDX-License-Identifier: Apache-2.0
#include "api/asset_survey.h"

#include <optional>
#include <string>

#include "api/asset_reader.h"
#include "api/json_reader.h"

namespace bouguer::api {
namespace {

/// The file that an object of that type names, when it can be accepted.
std::optional<std::string> named_file(const Json& object, std::string_view type,
                                      const Limits& limits) {
    const auto type_at = object.find("type");
    if (!type_at || !type_at->is_text(type)) return std::nullopt;
    Problems unreported(0);
    JsonReader reader(JsonValue(object, "", unreported));
    auto asset = require_asset(reader, limits);
    return asset ? std::optional(std::move(asset->name)) : std::nullopt;
}

void survey_textures(const Json& textures, const ReadContext& context) {
    if (textures.size() > context.limits.textures) return;
    for (const auto& [name, texture] : textures.members()) {
        if (const auto file = named_file(texture, "image", context.limits)) {
            context.assets.expect_image(*file);
        }
    }
}

void survey_objects(const Json& objects, const ReadContext& context) {
    if (!objects.is_array() || objects.size() > context.limits.objects) return;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto shape = objects[i].find("shape");
        const auto file = shape ? named_file(*shape, "file", context.limits) : std::nullopt;
        if (file) context.assets.expect_mesh(*file);
    }
}

}  // namespace

void survey_assets(const Json& scene, const ReadContext& context) {
    if (const auto textures = scene.find("textures")) survey_textures(*textures, context);
    if (const auto objects = scene.find("objects")) survey_objects(*objects, context);
}

}  // namespace bouguer::api
