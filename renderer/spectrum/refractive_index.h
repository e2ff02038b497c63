// SPDX-License-Identifier: Apache-2.0
// Indices of refraction as functions of wavelength. In the formulas L is the wavelength in
// micrometres, in vacuum or air as the source has it.
#pragma once

#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/spectrum/spectra.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// The wavelengths at which glasses are told: of helium's line d and hydrogen's F and C.
inline constexpr double kLineF_nm = 486.1327, kLineD_nm = 587.5618, kLineC_nm = 656.2725;

/// The least and the greatest index that the makers below accept, over the rendered range.
inline constexpr double kIndexMin = 1, kIndexMax = 10;

/// n^2 - 1 = sum of b L^2 / (L^2 - c), `c_um2` in square micrometres [Sellmeier 1872]. One to eight
/// terms, each with both. Error{InvalidInput}, pointers /sellmeier_b and /sellmeier_c_um2: a pole
/// in the rendered range or an index that leaves [1, 10] there, with the wavelength where it
/// happens.
Result<SpectrumPtr> sellmeier_index(const std::vector<double>& b, const std::vector<double>& c_um2);

/// n = A + B / L^2 + C / L^4 + ..., one to eight coefficients [Cauchy 1836]. Error{InvalidInput},
/// pointer /cauchy_um: an index that leaves [1, 10] in the rendered range, with the wavelength.
Result<SpectrumPtr> cauchy_index(std::vector<double> coefficients_um);

/// What a catalogue's two numbers say: n = A + B / L^2 through n_d at 587.5618 nm with the Abbe
/// number v_d = (n_d - 1) / (n_F - n_C), lines 486.1327 and 656.2725 nm. Error{InvalidInput},
/// pointers /n_d and /v_d: not above 0, or an index that leaves [1, 10] in the rendered range.
Result<SpectrumPtr> abbe_index(double n_d, double v_d);

/// (n_d - 1) / (n_F - n_C) of an index; infinite without dispersion.
double abbe_number(const Spectrum& index);

/// The complex index n + i k of a metal.
struct ComplexIndex {
    SpectrumPtr n, k;
};

/// A material of the built-in library by its index ("N-BK7", "diamond", "water"); null when there
/// is none of that name. Beyond the wavelengths that its source states the formula is continued.
SpectrumPtr library_index(std::string_view name);
/// A metal of the built-in library ("Ag", "Cu", "brass"); null pointers when there is none of that
/// name.
ComplexIndex library_metal(std::string_view name);

/// Everything library_index() and library_metal() know, sorted by name; kinds "index" and "metal".
const std::vector<LibraryEntry>& index_entries();
const std::vector<LibraryEntry>& metal_entries();

}  // namespace bouguer::renderer
