// SPDX-License-Identifier: Apache-2.0
// Wavelengths that are probably not in nanometres.
#pragma once

#include "api/json_value.h"
#include "api/read_spectrum.h"

namespace bouguer::api {

/// Whether a table from `first_nm` to `last_nm` tells anything from 360 to 830 nm. One that does
/// not would count as one constant; it is refused at `at`, "no-visible-sample", with the unit that
/// it looks like.
[[nodiscard]] bool is_visible_table(const JsonValue& at, double first_nm, double last_nm);

/// Likewise a line or a bell: refused only where another unit would make it visible. One that may
/// be meant, in the ultraviolet or infrared, is only warned of when no lamp has it.
[[nodiscard]] bool is_visible_peak(const JsonValue& at, double peak_nm);

/// Warns of a table that tells less than half of what is visible, or of which no sample is. Where
/// it ends at 0, 0 is meant beyond. `wavelengths_nm` increase; as many values, two or more.
void warn_of_untold(const JsonValue& at, const std::vector<double>& wavelengths_nm,
                    const std::vector<double>& values);

/// Warns of a formula of an index whose dispersion no matter has.
void warn_of_dispersion(const JsonValue& at, const renderer::Spectrum& index);

}  // namespace bouguer::api
