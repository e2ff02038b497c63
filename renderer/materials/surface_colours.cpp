// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/surface_colours.h"

#include <algorithm>
#include <cmath>

#include "renderer/materials/fresnel.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

using Bind = std::vector<float> (SpectralBasis::*)(const Spectrum&) const;

BoundSpectrum bind(const SurfaceSpectrum& s, const SpectralBasis& basis, SpectralTable& table,
                   Bind values) {
    BoundSpectrum bound{table.rows(), 0, s.texture.get()};
    for (const SpectrumPtr& part : s.parts()) {
        static_cast<void>(table.add((basis.*values)(*part)));
        ++bound.count;
    }
    return bound;
}

}  // namespace

BoundSpectrum bind_factor(const SurfaceSpectrum& s, const SpectralBasis& basis,
                          SpectralTable& table) {
    return bind(s, basis, table, &SpectralBasis::factor);
}

BoundSpectrum bind_emission(const SurfaceSpectrum& s, const SpectralBasis& basis,
                            SpectralTable& table) {
    return bind(s, basis, table, &SpectralBasis::emission);
}

std::size_t bind_neighbour(bool is_there, const SurfaceSpectrum& s, double exponent,
                           const SpectralBasis& basis, SpectralTable& table) {
    if (!is_there) return table.add(std::vector<float>(basis.size(), 0));
    const TextureWeights weights = s.texture ? s.texture->mean() : TextureWeights{1, 0, 0};
    std::vector<double> mean(basis.size(), 0);
    const auto parts = s.parts();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::vector<float> part = basis.factor(*parts[i]);
        for (std::size_t j = 0; j < mean.size(); ++j)
            mean[j] += static_cast<double>(weights[i]) * static_cast<double>(part[j]);
    }
    std::vector<float> powers;
    for (const double value : mean) powers.push_back(static_cast<float>(std::pow(value, exponent)));
    return table.add(powers);
}

BoundIndex bind_index(const ComplexIndex& index, const SpectralBasis& basis, SpectralTable& table) {
    if (basis.name() != "rgb")
        return {table.add(basis.factor(*index.n)), table.add(basis.factor(*index.k))};
    std::vector<float> n;
    for (const float f0 : basis.factor(*normal_reflectance(index))) {
        constexpr float kLargest = 0.9999F;  // of which the index is 40 000
        const float root = std::sqrt(std::min(f0, kLargest));
        n.push_back((1 + root) / (1 - root));
    }
    const std::size_t row = table.add(n);
    return {row, table.add(std::vector<float>(n.size(), 0))};
}

const Float8* SurfaceColours::mix(const BoundSpectrum& s, Slot slot) {
    Float8* to = blank(slot);
    const TextureWeights weights = s.texture->at(uv_);
    std::fill_n(to, blocks(), splat(0));
    for (std::size_t i = 0; i < s.count; ++i)
        if (weights[i] != 0) accumulate(to, weights[i], table_.row(s.first + i), blocks());
    return to;
}

}  // namespace bouguer::renderer
