// SPDX-License-Identifier: Apache-2.0
#include "api/object_reader.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "api/json_reader.h"
#include "api/material_reader.h"
#include "api/nearest_name.h"
#include "api/shape_reader.h"
#include "api/transform_reader.h"
#include "renderer/materials/material_textures.h"

namespace bouguer::api {
namespace {

using renderer::ObjectDescription;
using renderer::Transform;

constexpr std::size_t kNoMaterial = SIZE_MAX;

/// kNoMaterial after a report.
std::size_t read_material_name(const JsonValue& value, const NameIndex& materials) {
    if (!value.json().is_string()) {
        value.report_type("the name of a material");
        return kNoMaterial;
    }
    const std::string_view name = value.json().text();
    if (const auto it = materials.find(name); it != materials.end()) return it->second;
    if (value.problems().is_full()) {
        value.report("unknown-name", {});
        return kNoMaterial;
    }
    const auto words = words_of(materials);
    value.report(
        "unknown-name", "there is no material of this name." + did_you_mean(name, words),
        words.empty() ? "none: the scene has no materials" : "one of " + quoted_list(words));
    return kNoMaterial;
}

/// Reads objects one after the other and counts what they have in common.
class ObjectReader {
  public:
    ObjectReader(const NameIndex& material_names,
                 const std::vector<renderer::MaterialDescription>& materials,
                 const ReadContext& context, NameIndex& names)
        : material_names_(material_names),
          materials_(materials),
          context_(context),
          names_(names) {}

    std::optional<ObjectDescription> read(const JsonValue& value, std::size_t index) {
        JsonReader reader(value);
        if (!reader.is_object()) return std::nullopt;
        auto name = read_name(reader, index);
        const auto shape_at = reader.require("shape");
        auto shape = shape_at ? read_shape(*shape_at, context_) : std::nullopt;
        const auto material_at = reader.require("material");
        const std::size_t material =
            material_at ? read_material_name(*material_at, material_names_) : kNoMaterial;
        auto instances = read_instances(reader);
        const auto priority = read_priority(reader);
        if (shape) check_coordinates(reader, *shape, material);
        reader.reject_unknown_keys();
        if (!name || !shape || material == kNoMaterial || !instances) return std::nullopt;
        // A material that is known by name only has problems of its own.
        const int of_material = material < materials_.size() ? materials_[material].priority : 0;
        return ObjectDescription{*std::move(name),
                                 {*std::move(shape), *std::move(instances)},
                                 material,
                                 priority.value_or(of_material)};
    }

  private:
    std::optional<std::string> read_name(JsonReader& reader, std::size_t index) {
        auto name = reader.require_text("name", context_.limits.name_bytes);
        if (!name) return name;
        const auto [first, is_new] = names_.try_emplace(*name, index);
        if (is_new) return name;
        reader.find("name")->report("not-unique", "another object has this name",
                                    "a name that no other object has");
        return std::nullopt;
    }

    /// A texture needs coordinates to lie on; meshes need not have them.
    void check_coordinates(JsonReader& reader, const renderer::Shape& shape, std::size_t material) {
        const auto* mesh = std::get_if<std::shared_ptr<const renderer::TriangleMesh>>(&shape);
        if (mesh == nullptr || material >= materials_.size()) return;
        if (renderer::textures_of(materials_[material]).empty()) return;
        if ((*mesh)->uvs.empty()) {
            reader.find("material")
                ->report("mesh-without-uvs",
                         "this material has a texture, and the mesh no coordinates to lay it on",
                         "a material without textures, or a mesh with texture coordinates");
        } else if (const auto missing = (*mesh)->notes.triangles_without_uvs; missing > 0) {
            reader.find("material")
                ->warn("uvs-missing",
                       "this material has a texture, and " + std::to_string(missing) +
                           " triangles of the mesh have no texture coordinates",
                       "give coordinates to every face");
        }
    }

    /// World transforms: instance * transform for every instance, or the transform alone.
    std::optional<std::vector<Transform>> read_instances(JsonReader& reader) {
        std::optional<Transform> own = Transform{};
        if (const auto at = reader.find("transform")) own = read_transform(*at, context_.limits);
        const auto at = reader.find("instances");
        if (!at) {
            ++num_instances_;
            return own ? std::optional(std::vector{*own}) : std::nullopt;
        }
        if (!at->is_array(1, context_.limits.instances, "transforms")) return std::nullopt;
        num_instances_ += at->json().size();
        if (num_instances_ > context_.limits.instances) {
            at->report("over-limit", "the scene has too many instances",
                       "at most " + std::to_string(context_.limits.instances) + " in all objects");
            return std::nullopt;
        }
        std::vector<Transform> placed;
        for (std::size_t i = 0; i < at->json().size(); ++i) {
            const auto instance = read_transform(at->element(i), context_.limits);
            if (instance && own) placed.push_back(*instance * *own);
        }
        if (placed.size() < at->json().size()) return std::nullopt;
        return placed;
    }

    const NameIndex& material_names_;
    const std::vector<renderer::MaterialDescription>& materials_;
    const ReadContext& context_;
    NameIndex& names_;
    std::size_t num_instances_ = 0;
};

}  // namespace

std::vector<std::string_view> words_of(const NameIndex& names) {
    std::vector<std::string_view> words;
    words.reserve(names.size());
    for (const auto& [name, index] : names) words.push_back(name);
    return words;
}

std::vector<ObjectDescription> read_objects(
    const JsonValue& value, const NameIndex& material_names,
    const std::vector<renderer::MaterialDescription>& materials, const ReadContext& context,
    NameIndex& names) {
    std::vector<ObjectDescription> objects;
    if (!value.is_array(0, context.limits.objects, "objects")) return objects;
    ObjectReader reader(material_names, materials, context, names);
    for (std::size_t i = 0; i < value.json().size(); ++i) {
        auto object = reader.read(value.element(i), i);
        if (object) objects.push_back(*std::move(object));
    }
    return objects;
}

}  // namespace bouguer::api
