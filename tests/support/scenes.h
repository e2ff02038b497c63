// SPDX-License-Identifier: Apache-2.0
// Small scenes for tests, built in C++, and renders of them.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "renderer/film/unit_result.h"
#include "renderer/render.h"
#include "renderer/scene/scene.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer::test {

/// A matt grey Hall material: k_sr = 1, n = 1, no reflected ray.
inline HallMaterial matt(double reflectance) {
    HallMaterial m;
    m.reflectance = constant_spectrum(reflectance);
    m.transmittance = constant_spectrum(1);
    m.k_sr = 1;
    return m;
}

/// A clear body: everything is transmitted, nothing reflected.
inline HallMaterial clear(double ior) {
    HallMaterial m;
    m.reflectance = constant_spectrum(1);
    m.transmittance = constant_spectrum(1);
    m.k_st = 1;
    m.ior = constant_spectrum(ior);
    return m;
}

inline Absorption absorbing(double transmittance, double thickness = 1) {
    return {constant_spectrum(transmittance), thickness};
}

/// Collects a scene description piece by piece.
class SceneBuilder {
  public:
    SceneBuilder() { description.camera = PerspectiveCamera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 40}; }

    SceneBuilder& add(Shape shape, MaterialModel material) {
        return place({std::move(shape)}, std::move(material));
    }
    SceneBuilder& place(PlacedShape placed, MaterialModel material, int priority = 0) {
        const std::string name = "object " + std::to_string(description.objects.size());
        description.materials.push_back({name, std::move(material), {}});
        description.objects.push_back(
            {name, std::move(placed), description.materials.size() - 1, priority});
        return *this;
    }
    SceneBuilder& light(LightDescription light) {
        description.lights.push_back(std::move(light));
        return *this;
    }
    [[nodiscard]] std::shared_ptr<const Scene> build() const {
        return Scene::build(description).value();
    }

    SceneDescription description;
};

/// A finished render of so many samples a pixel, on this thread.
inline std::unique_ptr<Render> render(std::shared_ptr<const Scene> scene,
                                      const RenderSettings& settings, std::uint32_t samples) {
    StopRule stop;
    stop.samples = samples;
    auto render = Render::create(std::move(scene), settings, stop).value();
    while (auto unit = render->next_unit()) {
        render->trace(*unit);
        render->merge(*unit, 0);
    }
    return render;
}

}  // namespace bouguer::renderer::test
