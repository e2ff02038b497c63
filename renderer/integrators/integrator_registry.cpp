// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/integrator_registry.h"

#include <algorithm>
#include <array>

#include "renderer/integrators/hall.h"

namespace bouguer::renderer {
namespace {

std::unique_ptr<Integrator> make_recursive(const Scene& scene, const SceneNeeds& needs,
                                           const RenderSettings& settings) {
    return make_hall(scene, choose_basis(scene, needs, settings), settings,
                     choose_hall_features(needs, settings));
}

std::string recursive_kernel_name(const SceneNeeds& needs, const RenderSettings& settings) {
    return hall_kernel_name(choose_hall_features(needs, settings));
}

/// `rgb` is the seed's baseline: the same transport on three numbers, which choose_basis() gives
/// it.
constexpr std::array kIntegrators{
    IntegratorEntry{IntegratorType::Hall, "hall", &make_recursive, &recursive_kernel_name},
    IntegratorEntry{IntegratorType::Rgb, "rgb", &make_recursive, &recursive_kernel_name},
};

}  // namespace

const IntegratorEntry& integrator_entry(IntegratorType type) {
    return *std::find_if(kIntegrators.begin(), kIntegrators.end(),
                         [&](const auto& e) { return e.type == type; });
}

std::vector<std::string_view> integrator_names() {
    std::vector<std::string_view> names;
    for (const IntegratorEntry& entry : kIntegrators) names.push_back(entry.name);
    return names;
}

std::optional<IntegratorType> find_integrator(std::string_view name) {
    for (const IntegratorEntry& entry : kIntegrators) {
        if (entry.name == name) return entry.type;
    }
    return std::nullopt;
}

}  // namespace bouguer::renderer
