// SPDX-License-Identifier: Apache-2.0
// Makes spectra of every kind. Refusals are values: Error{InvalidInput} whose problems point into
// the kind's own fields.
#pragma once

#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// The same value at every wavelength.
SpectrumPtr constant_spectrum(double value);

/// Linear between samples, constant beyond the first and last. Needs at least two, increasing,
/// finite and >= 0.
Result<SpectrumPtr> sampled_spectrum(std::vector<double> wavelengths_nm,
                                     std::vector<double> values);

/// Like sampled_spectrum on first, first + step, ...
Result<SpectrumPtr> regular_spectrum(double first_nm, double step_nm, std::vector<double> values);

/// Planck's law relative to its value at 560 nm, so that it is 1 there like every illuminant.
/// `temperature_K` in [100, 1e9]; every value is finite, as a float too. A colder body gives out so
/// little at 560 nm (2e-72 of its 830 nm at 50 K) that no relative spectrum can be written down: it
/// is refused with that reason.
Result<SpectrumPtr> blackbody_spectrum(double temperature_K);
inline constexpr double kBlackbodyMin_K = 100;
inline constexpr double kBlackbodyMax_K = 1e9;

/// Planck's law itself, W m^-2 sr^-1 per metre of wavelength [CODATA 2018 constants]; finite for
/// every temperature above 0 K.
double planck_W_per_m3_sr(double lambda_nm, double temperature_K);

/// Planck's law itself as a radiance, W m^-2 sr^-1 nm^-1, of a body in (0, 1e9] K; a cold one gives
/// 0 where its light is below what a number can hold.
Result<SpectrumPtr> blackbody_radiance_spectrum(double temperature_K);

/// peak exp(-(lambda - center)^2 / (2 sigma^2)) with the full width at half maximum `fwhm_nm`; both
/// above 0, `peak` >= 0. Quadratures find it however narrow it is.
Result<SpectrumPtr> gaussian_spectrum(double center_nm, double fwhm_nm, double peak);

/// An emission line: a rectangle `width_nm` wide about `line_nm` whose integral over wavelength is
/// `integral` (unit of the quantity x nm). Quadratures find it however narrow it is.
Result<SpectrumPtr> line_spectrum(double line_nm, double width_nm, double integral);

/// A smooth reflectance in [0, 1] whose colour under D65 is the display colour r, g, b
/// (sRGB-encoded, [0, 1]) [Jakob and Hanika 2019]. `round_trip_delta_e` gets the
/// CIEDE2000 that remains.
Result<SpectrumPtr> srgb_spectrum(double r, double g, double b,
                                  double* round_trip_delta_e = nullptr);

/// srgb_spectrum() of "#rgb" or "#rrggbb", hexadecimal. Pointer of a refusal: /hex.
Result<SpectrumPtr> hex_spectrum(std::string_view hex, double* round_trip_delta_e = nullptr);

/// a * b, e.g. a lamp behind a filter.
SpectrumPtr product_spectrum(SpectrumPtr a, SpectrumPtr b);

/// factor * base.
SpectrumPtr scaled_spectrum(SpectrumPtr base, double factor);

/// A spectrum of the built-in library ("D65", "F11", "ColorChecker-red", "IVG530", ...); null when
/// there is none of that name. Indices of refraction: refractive_index.h.
SpectrumPtr library_spectrum(std::string_view name);

struct LibraryEntry {
    std::string_view name;
    /// "illuminant" (1 at 560 nm), "reflectance", "transmittance" (internal), "index" or "metal".
    std::string_view kind;
    std::string_view description, source;
    double thickness_mm = 0;  ///< that an internal transmittance is for; 0: not one
};
/// Everything library_spectrum() knows, sorted by name.
const std::vector<LibraryEntry>& library_entries();

}  // namespace bouguer::renderer
