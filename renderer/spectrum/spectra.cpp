// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectra.h"

#include <memory>
#include <utility>

#include "renderer/spectrum/scaled_spectrum.h"

namespace bouguer::renderer {
namespace {

/// The constant 1, which every constant is a multiple of.
class UnitSpectrum final : public Spectrum {
  public:
    [[nodiscard]] double at(double) const override { return 1; }
    [[nodiscard]] bool is_constant() const override { return true; }
};

}  // namespace

SpectrumPtr constant_spectrum(double value) {
    static const auto unit = std::make_shared<const UnitSpectrum>();
    return scaled_spectrum(unit, value);
}

SpectrumPtr scaled_spectrum(SpectrumPtr base, double factor) {
    // A multiple of a multiple is one multiple: chains of them cost nothing.
    if (const auto scaled = std::dynamic_pointer_cast<const ScaledSpectrum>(base)) {
        return std::make_shared<ScaledSpectrum>(scaled->base(), factor * scaled->factor());
    }
    return std::make_shared<ScaledSpectrum>(std::move(base), factor);
}

}  // namespace bouguer::renderer
