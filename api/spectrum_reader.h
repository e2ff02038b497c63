// SPDX-License-Identifier: Apache-2.0
// Spectra of a document: a number, a name, or an object of one of the kinds in the registry of
// spectrum_reader.cpp.
//
//     0.8 | "D65" | { "wavelengths_nm": [...], "values": [...] }
//     | { "first_nm": 380, "step_nm": 5, "values": [...] } | { "srgb": [r, g, b] }
//     | { "hex": "#ccbfb3" } | { "blackbody_K": 2856 }
//     | { "center_nm": 550, "fwhm_nm": 20, "peak": 1 } | { "line_nm": 589.3, "width_nm": 0.1,
//     "integral": 1 } | { "spectrum": <spectrum>, "scale": 400 } | { "product": [<spectrum>,
//     <spectrum>, ...] }
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/json_value.h"
#include "api/limits.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::api {

/// A spectrum and the least and largest value that it takes in the rendered range.
struct ReadSpectrum {
    renderer::SpectrumPtr spectrum;
    double low = 0, high = 0;
    std::size_t parts = 1;  ///< how many spectra are evaluated for one value
};

/// Reads spectra and resolves names: first those of the scene, in whatever order they refer to each
/// other, then the built-in library. Not thread-safe.
class SpectrumReader {
  public:
    /// `definitions` is the scene's `spectra`; it need not be there.
    SpectrumReader(std::optional<JsonValue> definitions, const Limits& limits);

    /// A reflectance or transmittance: every value in [0, 1]. Null after a report.
    [[nodiscard]] renderer::SpectrumPtr factor(const JsonValue& value);
    /// What a light emits: every value finite and >= 0. Null after a report.
    [[nodiscard]] renderer::SpectrumPtr emission(const JsonValue& value);
    /// Reads the definitions that nothing has used, so that their problems are reported too.
    void read_all();

    /// Any spectrum, without a judgement of its values. Empty after a report.
    [[nodiscard]] std::optional<ReadSpectrum> any(const JsonValue& value);
    [[nodiscard]] const Limits& limits() const { return limits_; }

  private:
    struct Definition {
        JsonValue value;
        enum class State { Unread, Reading, Read } state = State::Unread;
        std::optional<ReadSpectrum> result;
    };

    std::optional<ReadSpectrum> named(const JsonValue& value);
    std::optional<ReadSpectrum> defined(const JsonValue& reference, Definition& definition);
    std::optional<ReadSpectrum> of_a_kind(const JsonValue& value);
    renderer::SpectrumPtr within(const JsonValue& value, double high, std::string_view allowed);

    const Limits& limits_;
    std::map<std::string, Definition, std::less<>> definitions_;
    std::size_t depth_ = 0;  ///< of references being followed
};

}  // namespace bouguer::api
