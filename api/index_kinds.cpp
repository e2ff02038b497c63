// SPDX-License-Identifier: Apache-2.0
#include "api/index_kinds.h"

#include "api/spectrum_reader.h"
#include "renderer/spectrum/refractive_index.h"

namespace bouguer::api {
namespace {

constexpr Interval kIndex{renderer::kIndexMin, renderer::kIndexMax};
constexpr Interval kAbbeNumber{0, 1e9, true};

std::optional<std::vector<double>> require_numbers(SpectrumReader& spectra, JsonReader& reader,
                                                   std::string_view key) {
    const auto of = reader.require(key);
    return of ? of->numbers(spectra.limits().spectrum_samples) : std::nullopt;
}

std::optional<ReadSpectrum> accept_index(const JsonReader& reader,
                                         const Result<renderer::SpectrumPtr>& made) {
    auto read = accept(reader.value(), made);
    if (read) read->is_index = true;
    return read;
}

}  // namespace

std::optional<ReadSpectrum> read_sellmeier_index(SpectrumReader& spectra, JsonReader& reader) {
    const auto b = require_numbers(spectra, reader, "sellmeier_b");
    const auto c_um2 = require_numbers(spectra, reader, "sellmeier_c_um2");
    if (!b || !c_um2) return std::nullopt;
    return accept_index(reader, renderer::sellmeier_index(*b, *c_um2));
}

std::optional<ReadSpectrum> read_cauchy_index(SpectrumReader& spectra, JsonReader& reader) {
    const auto coefficients = require_numbers(spectra, reader, "cauchy_um");
    if (!coefficients) return std::nullopt;
    return accept_index(reader, renderer::cauchy_index(*coefficients));
}

std::optional<ReadSpectrum> read_abbe_index(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto n_d = reader.require_number("n_d", kIndex);
    const auto v_d = reader.require_number("v_d", kAbbeNumber);
    if (!n_d || !v_d) return std::nullopt;
    return accept_index(reader, renderer::abbe_index(*n_d, *v_d));
}

}  // namespace bouguer::api
