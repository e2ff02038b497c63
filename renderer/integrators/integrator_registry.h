// SPDX-License-Identifier: Apache-2.0
// The integrators by name. To add one: its pair of files, and its line in the table.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/integrators/integrator.h"
#include "renderer/plan/plan.h"

namespace bouguer::renderer {

struct IntegratorEntry {
    IntegratorType type;
    std::string_view name;
    /// `scene` outlives what is made.
    std::unique_ptr<Integrator> (*make)(const Scene& scene, const SceneNeeds& needs,
                                        const RenderSettings& settings);
    std::string (*kernel_name)(const SceneNeeds& needs, const RenderSettings& settings);
};

[[nodiscard]] const IntegratorEntry& integrator_entry(IntegratorType type);
/// In the order of the table; the first is the default.
[[nodiscard]] std::vector<std::string_view> integrator_names();
/// Empty when there is none of that name.
[[nodiscard]] std::optional<IntegratorType> find_integrator(std::string_view name);

}  // namespace bouguer::renderer
