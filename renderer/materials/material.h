// SPDX-License-Identifier: Apache-2.0
// Every kind of material. To add one: its pair of files here, its alternative below, and its reader
// in api/material_reader.cpp.
#pragma once

#include <string>
#include <variant>

#include "renderer/materials/blinn_material.h"
#include "renderer/materials/cook_torrance_material.h"
#include "renderer/materials/hall_greenberg_material.h"
#include "renderer/materials/hall_material.h"
#include "renderer/materials/phong_material.h"

namespace bouguer::renderer {

/// One alternative for every material type. A type has two functions: needs_of() for the plan, and
/// bind() for a render.
using MaterialModel = std::variant<HallMaterial, PhongMaterial, BlinnMaterial, CookTorranceMaterial,
                                   HallGreenbergMaterial>;

struct MaterialDescription {
    std::string name;
    MaterialModel model;
    /// What the surface gives out by itself, on both sides, W m^-2 sr^-1 nm^-1; null: nothing.
    SurfaceSpectrum emission = {};
    int priority = 0;  ///< of objects that give none (see ObjectDescription)
};

[[nodiscard]] inline MaterialNeeds needs_of(const MaterialDescription& material) {
    return std::visit([](const auto& model) { return needs_of(model); }, material.model);
}

/// Whether light meets another medium inside a body of a material that transmits: one with an index
/// of its own, or one that absorbs. A surface without an inside is a sheet.
[[nodiscard]] bool has_inside(const MaterialNeeds& needs);

/// The material, its emission included, in the numbers of `basis`.
[[nodiscard]] Surface bind(const MaterialDescription& material, const SpectralBasis& basis,
                           SpectralTable& table);

}  // namespace bouguer::renderer
