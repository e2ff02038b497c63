// SPDX-License-Identifier: Apache-2.0
#include "api/index_kinds.h"

#include <algorithm>
#include <cmath>

#include "api/spectrum_reader.h"
#include "api/spectrum_units.h"
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

/// Puts into a refusal that the formula would do in nanometres.
void say_nanometres(Result<renderer::SpectrumPtr>& made, bool would_do) {
    if (made || !would_do) return;
    for (Problem& problem : made.error().problems)
        problem.detail += "; with the coefficients for nanometres it would be an index";
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
    auto made = renderer::sellmeier_index(*b, *c_um2);
    std::vector<double> from_nm2 = *c_um2;
    for (double& c : from_nm2) c *= 1e-6;
    say_nanometres(made, renderer::sellmeier_index(*b, from_nm2).has_value());
    if (made) warn_of_dispersion(reader.value(), **made);
    return accept_index(reader, made);
}

std::optional<ReadSpectrum> read_cauchy_index(SpectrumReader& spectra, JsonReader& reader) {
    const auto coefficients = require_numbers(spectra, reader, "cauchy_um");
    if (!coefficients) return std::nullopt;
    auto made = renderer::cauchy_index(*coefficients);
    std::vector<double> from_nm = *coefficients;
    for (std::size_t i = 0; i < from_nm.size(); ++i)
        from_nm[i] *= std::pow(1e-6, static_cast<double>(i));
    say_nanometres(made, renderer::cauchy_index(from_nm).has_value());
    const bool is_constant = std::all_of(coefficients->begin() + (coefficients->empty() ? 0 : 1),
                                         coefficients->end(), [](double c) { return c == 0; });
    if (made && !is_constant) warn_of_dispersion(reader.value(), **made);
    return accept_index(reader, made);
}

std::optional<ReadSpectrum> read_abbe_index(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto n_d = reader.require_number("n_d", kIndex);
    const auto v_d = reader.require_number("v_d", kAbbeNumber);
    if (!n_d || !v_d) return std::nullopt;
    return accept_index(reader, renderer::abbe_index(*n_d, *v_d));
}

}  // namespace bouguer::api
