// SPDX-License-Identifier: Apache-2.0
// Every kind of material. To add one: its own file, its alternative here, and its binding beside
// hall_surface.cpp.
#pragma once

#include <string>
#include <variant>

#include "renderer/materials/hall_material.h"

namespace bouguer::renderer {

/// One alternative for every material type.
using MaterialModel = std::variant<HallMaterial>;

struct MaterialDescription {
    std::string name;
    MaterialModel model;
};

}  // namespace bouguer::renderer
