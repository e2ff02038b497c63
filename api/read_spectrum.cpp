// SPDX-License-Identifier: Apache-2.0
#include "api/read_spectrum.h"

#include <algorithm>
#include <cmath>

#include "renderer/spectrum/colour.h"

namespace bouguer::api {

using renderer::SpectrumPtr;

ReadSpectrum with_bounds(SpectrumPtr spectrum) {
    ReadSpectrum read{std::move(spectrum), INFINITY, -INFINITY};
    for (double lambda = renderer::kLambdaMin_nm; lambda <= renderer::kLambdaMax_nm; ++lambda) {
        const double value = read.spectrum->at(lambda);
        read.low = std::min(read.low, value);
        read.high = std::max(read.high, value);
    }
    return read;
}

std::optional<ReadSpectrum> accept(const JsonValue& value, const Result<SpectrumPtr>& made) {
    if (made) return with_bounds(*made);
    value.problems().add_below(value.pointer(), made.error());
    return std::nullopt;
}

void include_samples(ReadSpectrum& read, const std::vector<double>& wavelengths_nm,
                     const std::vector<double>& values) {
    read.told_nm = Interval{wavelengths_nm.front(), wavelengths_nm.back()};
    read.samples = values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (wavelengths_nm[i] < renderer::kLambdaMin_nm) continue;
        if (wavelengths_nm[i] > renderer::kLambdaMax_nm) continue;
        read.low = std::min(read.low, values[i]);
        read.high = std::max(read.high, values[i]);
    }
}

}  // namespace bouguer::api
