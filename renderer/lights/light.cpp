// SPDX-License-Identifier: Apache-2.0
#include "renderer/lights/light.h"

namespace bouguer::renderer {

Light Light::make(const LightDescription& description, Vec3 origin, Real metres_per_unit) {
    Light light;
    if (const auto* point = std::get_if<PointLight>(&description)) {
        light.vector_ = point->position - origin;
        light.inverse_square_ = 1 / (metres_per_unit * metres_per_unit);
        light.spectrum_ = point->intensity;
    } else {
        const auto& directional = std::get<DirectionalLight>(description);
        light.vector_ = -normalize(directional.direction);
        light.is_directional_ = true;
        light.spectrum_ = directional.irradiance;
    }
    return light;
}

}  // namespace bouguer::renderer
