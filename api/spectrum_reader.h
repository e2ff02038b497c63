// SPDX-License-Identifier: Apache-2.0
// Spectra of a document: a number, a name, or an object of one of the kinds in the registry of
// spectrum_kinds.cpp. Indices of refraction have kinds of their own: index_kinds.h.
//
//     0.8 | "D65" | { "wavelengths_nm": [...], "values": [...] }
//     | { "first_nm": 380, "step_nm": 5, "values": [...] } | { "srgb": [r, g, b] }
//     | { "hex": "#ccbfb3" } | { "blackbody_K": 2856, "absolute": false }
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
#include "api/read_spectrum.h"
#include "renderer/spectrum/refractive_index.h"
#include "renderer/spectrum/spectrum_notes.h"

namespace bouguer::api {

/// Reads spectra and resolves names: first those of the scene, in whatever order they refer to each
/// other, then the built-in library. Not thread-safe.
class SpectrumReader {
  public:
    /// `definitions` is the scene's `spectra`; it need not be there.
    SpectrumReader(std::optional<JsonValue> definitions, const Limits& limits);

    /// A reflectance or transmittance: every value in [0, 1]. Null after a report.
    [[nodiscard]] renderer::SpectrumPtr factor(const JsonValue& value);
    /// What a light emits: every value finite and >= 0. Energy that it says to be outside the
    /// rendered range is noted. Null after a report.
    [[nodiscard]] renderer::SpectrumPtr emission(const JsonValue& value);
    /// An index of refraction: a number in [1, 10], a name of the scene or of renderer's
    /// library_index(), or a spectrum of any kind with values in [1, 10]. Null after a report.
    [[nodiscard]] renderer::SpectrumPtr index(const JsonValue& value);
    /// A metal: a name of renderer's library_metal(), or {"n": spectrum, "k": spectrum} with n in
    /// (0, 100] and k in [0, 100]. Both spectra are there; empty after a report.
    [[nodiscard]] std::optional<renderer::ComplexIndex> metal(const JsonValue& value);
    /// Reads the definitions that nothing has used, so that their problems are reported too.
    void read_all();

    /// Any spectrum, without a judgement of its values. Empty after a report.
    [[nodiscard]] std::optional<ReadSpectrum> any(const JsonValue& value);
    [[nodiscard]] const Limits& limits() const { return limits_; }

    /// What could not be taken exactly as it is written, of all that was read so far.
    [[nodiscard]] const renderer::SpectrumNotes& notes() const { return notes_; }
    /// For the kinds: the colour at `value` came back with this CIEDE2000.
    void note_uplift(const JsonValue& value, double delta_e_2000);

  private:
    struct Definition {
        JsonValue value;
        enum class State { Unread, Reading, Read } state = State::Unread;
        std::optional<ReadSpectrum> result;
    };

    [[nodiscard]] std::vector<std::string_view> defined_names() const;
    [[nodiscard]] bool is_known(std::string_view name) const;
    std::optional<ReadSpectrum> use(const JsonValue& value);
    std::optional<ReadSpectrum> named(const JsonValue& value);
    std::optional<renderer::ComplexIndex> named_metal(const JsonValue& value);
    std::optional<ReadSpectrum> defined(const JsonValue& reference, Definition& definition);
    std::optional<ReadSpectrum> of_a_kind(const JsonValue& value);

    const Limits& limits_;
    renderer::SpectrumNotes notes_;
    std::map<std::string, Definition, std::less<>> definitions_;
    std::size_t depth_ = 0;         ///< of references being followed
    std::size_t product_work_ = 0;  ///< of all uses so far
};

}  // namespace bouguer::api
