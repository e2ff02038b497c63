// SPDX-License-Identifier: Apache-2.0
// A scene as plain data: what comes in. Names are resolved and every value is in range; the readers
// of api/ see to that.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/geometry/shape.h"
#include "renderer/materials/material.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

struct Resolution {
    int width = 640;
    int height = 480;
    bool operator==(const Resolution&) const = default;
};

/// `fov_deg` is the full vertical angle of view, in (0, 180).
struct PerspectiveCamera {
    Vec3 from, at, up{0, 1, 0};
    Real fov_deg = 40;
};

/// `height` is what the picture's height shows, scene units.
struct OrthographicCamera {
    Vec3 from, at, up{0, 1, 0};
    Real height = 1;
};

using CameraDescription = std::variant<PerspectiveCamera, OrthographicCamera>;

struct ObjectDescription {
    std::string name;
    PlacedShape placed;
    std::size_t material = 0;  ///< index into materials
    /// Where bodies that light goes through overlap, the one with the higher number is there; at
    /// equal numbers the one that stands first in the scene [Schmidt and Budge 2002].
    int priority = 0;
};

/// Irradiance falls with the square of the distance in metres.
struct PointLight {
    Vec3 position;
    SpectrumPtr intensity;  ///< W sr^-1 nm^-1
};

/// `direction` is where the light goes to (from the sun downwards).
struct DirectionalLight {
    Vec3 direction{0, -1, 0};
    SpectrumPtr irradiance;  ///< on a surface that faces it, W m^-2 nm^-1
};

using LightDescription = std::variant<PointLight, DirectionalLight>;

/// What rays that leave the scene see: the same radiance in every direction, W m^-2 sr^-1 nm^-1.
struct ConstantEnvironment {
    SpectrumPtr radiance;
};

/// Weights k_i from the share of the cosine-weighted hemisphere that each neighbour covers (its
/// form factor), by `rays` random directions a shaded point; fewer where the point weighs little in
/// the sample.
struct HemisphereWeights {
    int rays = 1;
};

/// Weights k_i given for each object, in the order of the scene's objects.
struct ExplicitWeights {
    std::vector<Real> k;
};

/// What equation 2 replaces, to compare with: in the place of the neighbours' sum stands the
/// surface's own colour (k_sr F_sr; k_d R_d), as if the same light came from everywhere.
struct ConstantWeights {};

/// Equation 2. With `illuminant` I_a(lambda) = illuminant(lambda) K_a sum_i k_i R_i(lambda)^{n_i};
/// without, the light that arrives unshadowed from all lamps takes its place, so that a brighter
/// lamp brightens the whole picture.
struct AmbientDescription {
    Real k_a = 0;
    std::variant<HemisphereWeights, ExplicitWeights, ConstantWeights> weights;
    SpectrumPtr illuminant;  ///< may be null
};

struct SceneDescription {
    std::string name;
    Real metres_per_unit = 1;
    CameraDescription camera;
    Resolution resolution;
    std::vector<MaterialDescription> materials;
    std::vector<ObjectDescription> objects;
    std::vector<LightDescription> lights;
    std::optional<ConstantEnvironment> environment;
    std::optional<AmbientDescription> ambient;
};

}  // namespace bouguer::renderer
