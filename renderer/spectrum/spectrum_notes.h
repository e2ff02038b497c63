// SPDX-License-Identifier: Apache-2.0
// What became of spectra that cannot be rendered exactly as they were written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// One spectrum: where it stands, in the words of whoever read it, and how far off it is.
struct SpectrumNote {
    std::string where;
    double value = 0;
    bool operator==(const SpectrumNote&) const = default;
};

/// The notes of one kind. However many there are, only the worst are kept.
class SpectrumNoteList {
  public:
    static constexpr std::size_t kMostKept = 20;

    void add(std::string where, double value);
    [[nodiscard]] std::size_t count() const { return count_; }  ///< of all that were added
    /// The kMostKept largest, largest first; equal ones in the order of addition.
    [[nodiscard]] const std::vector<SpectrumNote>& worst() const { return worst_; }
    [[nodiscard]] double largest() const { return worst_.empty() ? 0 : worst_.front().value; }
    bool operator==(const SpectrumNoteList&) const = default;

  private:
    std::size_t count_ = 0;
    std::vector<SpectrumNote> worst_;
};

/// Every kind of note.
struct SpectrumNotes {
    /// Display colours that became smooth reflectances: CIEDE2000 between the colour that was asked
    /// for and that of the reflectance under D65.
    SpectrumNoteList uplift;
    /// Lights that give energy outside the rendered range, where it is left out: its share of all
    /// their energy, in (0, 1].
    SpectrumNoteList outside_range;
    bool operator==(const SpectrumNotes&) const = default;
};

/// The share of the integral of `spectrum` from `low_nm` to `high_nm` that lies outside the
/// rendered range; 0 for one that is 0 everywhere. The integrals over each side and over the range
/// itself are taken in 256 steps of the spectrum's own means.
[[nodiscard]] double share_outside_range(const Spectrum& spectrum, double low_nm, double high_nm);

}  // namespace bouguer::renderer
