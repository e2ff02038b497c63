// SPDX-License-Identifier: Apache-2.0
// What a path carries: a vector of numbers, and what each of them weighs in XYZ. The integrators
// know only this, so the spectral renderer and the RGB baseline are one piece of code.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

class SpectralBasis {
  public:
    /// Rectangle rule on 360, 360 + step, ... <= 830 nm. `step_nm` in [1, 100].
    static SpectralBasis wavelengths(double step_nm,
                                     const Observer& observer = standard_observer());
    /// The seed's baseline: linear Rec.709 triples. A reflectance becomes its colour under D65, a
    /// lamp its own colour; negative components become 0.
    static SpectralBasis rgb();
    /// One number: for scenes where every material is grey and every lamp a multiple of
    /// `illuminant`, whose shape is taken into the weights. Uses the quadrature of
    /// wavelengths(step_nm), so the picture is the same up to rounding. `illuminant` (or what it is
    /// a multiple of) outlives the basis.
    static SpectralBasis grey(const Spectrum& illuminant, double step_nm,
                              const Observer& observer = standard_observer());

    [[nodiscard]] std::size_t size() const { return weights_.size(); }
    [[nodiscard]] const std::string& name() const {
        return name_;
    }  ///< "wavelengths", "rgb", "grey"

    /// Of the quadrature, one a number; empty for rgb and grey.
    [[nodiscard]] const std::vector<double>& wavelengths_nm() const { return lambda_nm_; }
    [[nodiscard]] bool has_wavelengths() const { return !lambda_nm_.empty(); }
    [[nodiscard]] double step_nm() const { return step_nm_; }  ///< of the quadrature

    /// A reflectance, transmittance or other factor in this basis; size() values. In grey() it must
    /// be constant.
    [[nodiscard]] std::vector<float> factor(const Spectrum& s) const;
    /// The same unrounded: of a transmittance near 1 single precision loses the logarithm.
    [[nodiscard]] std::vector<double> exact_factor(const Spectrum& s) const;
    /// A light's spectrum in this basis; size() values. In grey() it must be a multiple of the
    /// illuminant or 0.
    [[nodiscard]] std::vector<float> emission(const Spectrum& s) const;
    /// XYZ of a radiance in this basis (size() values). Sums in double, in an order that depends on
    /// size() only.
    [[nodiscard]] Xyz to_xyz(const float* radiance) const;
    /// What each of the size() numbers adds to X, Y and Z.
    [[nodiscard]] const std::vector<std::array<double, 3>>& weights() const { return weights_; }

  private:
    SpectralBasis() = default;
    void split_weights();                                               ///< fills columns_
    [[nodiscard]] std::vector<double> sample(const Spectrum& s) const;  ///< its tent means

    std::string name_;
    std::vector<double> lambda_nm_;  ///< of the quadrature; empty for rgb
    double step_nm_ = 0;             ///< of the quadrature
    std::vector<std::array<double, 3>> weights_;
    std::array<std::vector<double>, 3> columns_;  ///< weights_ by component, as to_xyz() reads them
    const Spectrum* illuminant_ = nullptr;        ///< grey only; the scene outlives its bases
};

}  // namespace bouguer::renderer
