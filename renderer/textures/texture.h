// SPDX-License-Identifier: Apache-2.0
// What varies over a surface: a few spectra, mixed anew at every point.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/core/vec3.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// More than these a texture does not mix: red, green and blue.
inline constexpr std::size_t kMaxTextureSpectra = 3;

/// How much of each of a texture's spectra there is at a point; finite, each >= 0.
using TextureWeights = std::array<float, kMaxTextureSpectra>;

/// value(uv, lambda) = sum over i of at(uv)[i] * spectra()[i](lambda). Linear in the spectra, so
/// that filtering weights is filtering light. Immutable and thread-safe.
class Texture {
  public:
    Texture() = default;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;
    virtual ~Texture() = default;

    /// One to kMaxTextureSpectra.
    [[nodiscard]] virtual const std::vector<SpectrumPtr>& spectra() const = 0;
    /// At surface coordinates, see Geometry::surface_uv(). Weights beyond spectra() are 0.
    [[nodiscard]] virtual TextureWeights at(Vec2 uv) const = 0;
    /// Over the whole texture: for where a surface counts, but no point of it.
    [[nodiscard]] virtual TextureWeights mean() const = 0;
    [[nodiscard]] virtual std::uint64_t memory_bytes() const { return 0; }
};

using TexturePtr = std::shared_ptr<const Texture>;

/// A spectral quantity of a surface: `spectrum`, times `texture` where there is one. The unit is
/// that of the spectrum.
struct SurfaceSpectrum {
    SurfaceSpectrum() = default;
    SurfaceSpectrum(SpectrumPtr s, TexturePtr t = nullptr)  // NOLINT: a spectrum is one
        : spectrum(std::move(s)), texture(std::move(t)) {}

    /// The spectra that the texture mixes here, times `spectrum`; `spectrum` alone without one.
    [[nodiscard]] std::vector<SpectrumPtr> parts() const;

    SpectrumPtr spectrum;
    TexturePtr texture;
};

}  // namespace bouguer::renderer
