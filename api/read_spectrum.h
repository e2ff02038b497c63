// SPDX-License-Identifier: Apache-2.0
// A spectrum as the readers of a document hold it, until it is known what it is used for.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "api/json_value.h"
#include "renderer/core/result.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::api {

/// A spectrum and the least and largest value that it takes in the rendered range.
struct ReadSpectrum {
    renderer::SpectrumPtr spectrum;
    double low = 0, high = 0;
    std::size_t parts = 1;    ///< how many spectra are evaluated for one value
    std::size_t samples = 1;  ///< pieces between which the parts are smooth, all told
    bool is_index = false;    ///< of refraction, by its kind or its name: it is nothing else
    /// Where the document itself tells the values, nm; empty for those that are told everywhere
    /// (a constant, a black body) or by the library.
    std::optional<Interval> told_nm{};

    /// About how many values must be looked up to integrate a product over a quadrature: parts x
    /// (samples + 100 parts). 0 of what is no product.
    [[nodiscard]] std::size_t product_work() const {
        constexpr std::size_t kSamplesOfAPart = 100;
        return parts > 1 ? parts * (samples + kSamplesOfAPart * parts) : 0;
    }
};

/// `spectrum` with its bounds on the 1 nm grid of the rendered range.
[[nodiscard]] ReadSpectrum with_bounds(renderer::SpectrumPtr spectrum);

/// What the renderer made of `value`, or its refusal, reported below `value`.
[[nodiscard]] std::optional<ReadSpectrum> accept(const JsonValue& value,
                                                 const Result<renderer::SpectrumPtr>& made);

/// Of samples, as many values as wavelengths: widens the bounds by those that fall between the
/// points of the 1 nm grid, and keeps the wavelengths that are told.
void include_samples(ReadSpectrum& read, const std::vector<double>& wavelengths_nm,
                     const std::vector<double>& values);

}  // namespace bouguer::api
