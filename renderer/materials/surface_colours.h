// SPDX-License-Identifier: Apache-2.0
// The colours of surfaces in the numbers of one render: rows of a table, or mixtures of rows where
// a texture varies them.
#pragma once

#include <array>
#include <cstddef>

#include "renderer/core/span_math.h"
#include "renderer/spectrum/refractive_index.h"
#include "renderer/spectrum/spectral_basis.h"
#include "renderer/textures/texture.h"

namespace bouguer::renderer {

/// A SurfaceSpectrum bound to a basis: `count` rows of the table from `first` on, mixed by
/// `texture` where there is one. The scene outlives it.
struct BoundSpectrum {
    std::size_t first = 0;
    std::size_t count = 1;
    const Texture* texture = nullptr;
};

/// Puts a factor (a reflectance, a transmittance) into `table` as it stands in `basis`.
[[nodiscard]] BoundSpectrum bind_factor(const SurfaceSpectrum& s, const SpectralBasis& basis,
                                        SpectralTable& table);
/// Likewise what a surface emits.
[[nodiscard]] BoundSpectrum bind_emission(const SurfaceSpectrum& s, const SpectralBasis& basis,
                                          SpectralTable& table);
/// What a surface gives as a neighbour (equation 2): the mean of a factor over the surface, raised
/// to its exponent n_i, as one row whose number is returned; zeros unless `is_there`.
[[nodiscard]] std::size_t bind_neighbour(bool is_there, const SurfaceSpectrum& s, double exponent,
                                         const SpectralBasis& basis, SpectralTable& table);

/// Rows of n and k of a complex index.
struct BoundIndex {
    std::size_t n = 0, k = 0;
};
/// Where the basis has wavelengths, n and k there. In an RGB basis each channel gets the real index
/// that has the channel's reflectance at normal incidence, n = (1 + sqrt F0) / (1 - sqrt F0)
/// [Cook and Torrance 1982, "Spectral composition of the reflected light"].
[[nodiscard]] BoundIndex bind_index(const ComplexIndex& index, const SpectralBasis& basis,
                                    SpectralTable& table);

/// Looks up the colours of one point of a surface at a time. Not thread-safe; the table is shared.
class SurfaceColours {
  public:
    /// Rows that are alive side by side: every answer in a slot of its own stays valid until the
    /// next in that slot.
    enum Slot : std::size_t { kFirst, kSecond, kThird, kNumSlots };

    explicit SurfaceColours(const SpectralTable& table)
        : table_(table), mixed_(kNumSlots * table.blocks(), splat(0)) {}

    /// Goes to another point; `uv` are its surface coordinates, which count for textures only.
    void move_to(Vec2 uv) { uv_ = uv; }

    /// The colour at the point: a row of the table where nothing varies, else a mixture in `slot`.
    [[nodiscard]] const Float8* row(const BoundSpectrum& s, Slot slot) {
        return s.texture == nullptr ? table_.row(s.first) : mix(s, slot);
    }
    [[nodiscard]] const Float8* row(std::size_t number) const { return table_.row(number); }

    /// A row to write to.
    [[nodiscard]] Float8* blank(Slot slot) { return mixed_.data() + slot * table_.blocks(); }
    [[nodiscard]] std::size_t blocks() const { return table_.blocks(); }

  private:
    const Float8* mix(const BoundSpectrum& s, Slot slot);

    const SpectralTable& table_;
    Float8Vector mixed_;
    Vec2 uv_;
};

}  // namespace bouguer::renderer
