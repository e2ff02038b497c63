// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/hall_surface.h"

#include <algorithm>

namespace bouguer::renderer {
namespace {

/// Equation 1, T = t^b, as exp(b ln t): ln t for one scene unit. t = 0 gets a logarithm so low that
/// any b > 0 is opaque while b = 0 still gives 1.
std::vector<float> log_per_unit(std::vector<float> transmittance, Real thickness) {
    constexpr double kOpaque = -1e30;
    for (float& t : transmittance) {
        const double log_t = t > 0 ? std::log(static_cast<double>(t)) / thickness : kOpaque;
        t = static_cast<float>(std::clamp(log_t, kOpaque, 0.0));
    }
    return transmittance;
}

std::vector<float> raised(std::vector<float> values, Real exponent) {
    for (float& v : values) v = static_cast<float>(std::pow(static_cast<double>(v), exponent));
    return values;
}

}  // namespace

HallSurface bind_hall(const HallMaterial& material, const SpectralBasis& basis,
                      SpectralTable& table) {
    const std::vector<float> reflectance = basis.factor(*material.reflectance);
    const std::vector<float> transmittance = basis.factor(*material.transmittance);
    const std::vector<float> nothing(basis.size(), 0);
    HallSurface s;
    s.k_sr = static_cast<float>(material.k_sr);
    s.k_st = static_cast<float>(material.k_st);
    s.n = material.n;
    s.ior = material.ior;
    s.transmits = material.k_st > 0;
    s.mirror = material.mirror && material.k_sr > 0;
    s.absorbs = s.transmits && material.absorption.has_value();
    s.reflectance = table.add(reflectance);
    s.transmittance = table.add(transmittance);
    // An opaque neighbour transmits nothing and one without reflection reflects nothing, whatever
    // spectrum stands there.
    s.neighbour_reflectance =
        table.add(material.k_sr > 0 ? raised(reflectance, material.n) : nothing);
    s.neighbour_transmittance =
        table.add(s.transmits ? raised(transmittance, material.n) : nothing);
    if (s.absorbs) {
        s.log_transmittance = table.add(log_per_unit(
            basis.factor(*material.absorption->transmittance), material.absorption->thickness));
    }
    return s;
}

}  // namespace bouguer::renderer
