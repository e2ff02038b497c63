// SPDX-License-Identifier: Apache-2.0
// The kinds of spectra that are indices of refraction: formulas with a few coefficients.
//
//     { "sellmeier_b": [1.0396, 0.2318, 1.0105], "sellmeier_c_um2": [0.0060, 0.0200, 103.56] }
//     | { "cauchy_um": [1.5046, 0.0042] } | { "n_d": 1.5168, "v_d": 64.17 }
#pragma once

#include <optional>

#include "api/json_reader.h"
#include "api/read_spectrum.h"

namespace bouguer::api {

class SpectrumReader;

/// n^2 - 1 = sum of b L^2 / (L^2 - c), L in micrometres.
[[nodiscard]] std::optional<ReadSpectrum> read_sellmeier_index(SpectrumReader&, JsonReader&);
/// n = A + B / L^2 + C / L^4 + ..., L in micrometres.
[[nodiscard]] std::optional<ReadSpectrum> read_cauchy_index(SpectrumReader&, JsonReader&);
/// The two numbers of a glass catalogue: n at the line d, and the Abbe number.
[[nodiscard]] std::optional<ReadSpectrum> read_abbe_index(SpectrumReader&, JsonReader&);

}  // namespace bouguer::api
