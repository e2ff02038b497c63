// SPDX-License-Identifier: Apache-2.0
// What the Hall kernel sees along one ray.
#pragma once

#include "renderer/integrators/hall.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer::test {

/// Every wavelength, and no ray cut because it weighs little.
inline RenderSettings exact_settings() {
    RenderSettings settings;
    settings.min_throughput = 0;
    settings.wavelength_step_nm = 1;
    return settings;
}

/// Y, which is the radiance itself where that is the same at all wavelengths, and what the walk
/// counted.
struct Seen {
    double y;
    TraceCounters counters;
};

/// Mean of `samples` samples of the radiance that arrives at `from` from the direction of `at`.
inline Seen look(const Scene& scene, Vec3 from, Vec3 at,
                 const RenderSettings& settings = exact_settings(), std::uint32_t samples = 1) {
    const auto integrator =
        make_hall(scene, SpectralBasis::wavelengths(settings.wavelength_step_nm), settings, {});
    const auto scratch = integrator->make_scratch();
    Seen seen{};
    const Ray ray{from - scene.geometry().origin(), normalize(at - from)};
    for (std::uint32_t s = 0; s < samples; ++s) {
        seen.y += integrator->trace(ray, PixelSampler(1, 0, 0, s, 1), *scratch, seen.counters).y /
                  samples;
    }
    return seen;
}

/// Light in `direction` that lights what faces it with `irradiance` (W/m^2/nm).
inline DirectionalLight sun(Vec3 direction, double irradiance = 1) {
    return {direction, constant_spectrum(irradiance)};
}

/// An empty scene before an environment of constant radiance.
inline SceneBuilder in_environment(double radiance = 1) {
    SceneBuilder builder;
    builder.description.environment = ConstantEnvironment{constant_spectrum(radiance)};
    return builder;
}

/// A clear body that absorbs: `transmittance` a unit of length.
inline HallMaterial glass(double ior, double transmittance) {
    HallMaterial m = clear(ior);
    m.absorption = absorbing(transmittance);
    return m;
}

/// From z = -thickness to 0, so wide that no ray of a test sees its rim.
inline Box slab(Real thickness) {
    constexpr Real kWide = 1e4;
    return {{-kWide, -kWide, -thickness}, {kWide, kWide, 0}};
}

}  // namespace bouguer::renderer::test
