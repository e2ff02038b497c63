// SPDX-License-Identifier: Apache-2.0
// A quantity as a function of wavelength.
#pragma once

#include <memory>
#include <vector>

namespace bouguer::renderer {

/// Immutable and thread-safe. The unit is that of the quantity: none for reflectance, transmittance
/// and relative illuminants (which are 1 at 560 nm), W m^-2 sr^-1 nm^-1 for radiance, W sr^-1 nm^-1
/// for intensity.
class Spectrum {
  public:
    Spectrum() = default;
    Spectrum(const Spectrum&) = delete;
    Spectrum& operator=(const Spectrum&) = delete;
    virtual ~Spectrum() = default;

    /// The value at `lambda_nm`, finite for every wavelength of the rendered range.
    [[nodiscard]] virtual double at(double lambda_nm) const = 0;

    /// The mean weighted by the tent that falls from `lambda_nm` to 0 at lambda_nm +- step_nm: what
    /// a quadrature of that spacing takes for the spectrum, so that it misses no line, however
    /// narrow: the nodes around a line share its energy by their distance. at() by default, which
    /// is right for what is smooth over a step; what may be narrower overrides it.
    [[nodiscard]] virtual double tent_mean(double lambda_nm, double /*step_nm*/) const {
        return at(lambda_nm);
    }

    /// Whether at() on nodes `step_nm` apart may miss some of it, so that tent_mean() differs:
    /// products of it take means, too.
    [[nodiscard]] virtual bool is_rough(double /*step_nm*/) const { return false; }

    /// Adds the wavelengths inside (low_nm, high_nm) between which the spectrum is smooth, in any
    /// order. None by default.
    virtual void add_breaks(double /*low_nm*/, double /*high_nm*/,
                            std::vector<double>& /*breaks_nm*/) const {}

    /// Whether at() is the same for every wavelength: then one number stands for the spectrum.
    [[nodiscard]] virtual bool is_constant() const { return false; }

    /// The spectrum that this one is a multiple of, and the factor; itself and 1 by default. Lets
    /// the plan see that several lamps have one colour.
    struct Multiple {
        const Spectrum* base;
        double factor;
    };
    [[nodiscard]] virtual Multiple as_multiple() const { return {this, 1.0}; }
};

using SpectrumPtr = std::shared_ptr<const Spectrum>;

}  // namespace bouguer::renderer
