// SPDX-License-Identifier: Apache-2.0
#include "api/spectrum_kinds.h"

#include <algorithm>
#include <array>

#include "api/index_kinds.h"
#include "api/spectrum_reader.h"
#include "api/spectrum_units.h"
#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

constexpr Interval kValue{0, kLargestEmission};
constexpr Interval kWavelength_nm{1e-3, 1e9};
constexpr Interval kWidth_nm{0, 1e9, true};
constexpr Interval kTemperature_K{renderer::kBlackbodyMin_K, renderer::kBlackbodyMax_K};
constexpr Interval kAnyTemperature_K{0, renderer::kBlackbodyMax_K, true};

std::optional<ReadSpectrum> read_samples(SpectrumReader& spectra, JsonReader& reader) {
    const std::size_t most = spectra.limits().spectrum_samples;
    const auto at = reader.require("wavelengths_nm");
    const auto of = reader.require("values");
    const auto wavelengths = at ? at->numbers(most) : std::nullopt;
    const auto values = of ? of->numbers(most) : std::nullopt;
    if (!wavelengths || !values) return std::nullopt;
    if (!wavelengths->empty()) {
        const auto [first, last] = std::minmax_element(wavelengths->begin(), wavelengths->end());
        if (*first > 0 && !is_visible_table(*at, *first, *last)) return std::nullopt;
    }
    auto read = accept(reader.value(), renderer::sampled_spectrum(*wavelengths, *values));
    if (!read) return read;
    include_samples(*read, *wavelengths, *values);
    warn_of_untold(*at, *wavelengths, *values);
    return read;
}

std::optional<ReadSpectrum> read_regular(SpectrumReader& spectra, JsonReader& reader) {
    const auto first = reader.require_number("first_nm", kWavelength_nm);
    const auto step = reader.require_number("step_nm", kWavelength_nm);
    const auto of = reader.require("values");
    const auto values = of ? of->numbers(spectra.limits().spectrum_samples) : std::nullopt;
    if (!first || !step || !values) return std::nullopt;
    const double last = *first + *step * static_cast<double>(values->size() - 1);
    if (!values->empty() && !is_visible_table(*reader.find("first_nm"), *first, last))
        return std::nullopt;
    auto read = accept(reader.value(), renderer::regular_spectrum(*first, *step, *values));
    if (!read) return read;
    std::vector<double> wavelengths(values->size());
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        wavelengths[i] = *first + static_cast<double>(i) * *step;
    }
    include_samples(*read, wavelengths, *values);
    warn_of_untold(reader.value(), wavelengths, *values);
    return read;
}

/// A colour that became a reflectance; its round trip is noted.
std::optional<ReadSpectrum> uplifted(SpectrumReader& spectra, const JsonReader& reader,
                                     const Result<renderer::SpectrumPtr>& made,
                                     double delta_e_2000) {
    auto read = accept(reader.value(), made);
    if (read) spectra.note_uplift(reader.value(), delta_e_2000);
    return read;
}

std::optional<ReadSpectrum> read_srgb(SpectrumReader& spectra, JsonReader& reader) {
    const auto colour = reader.require("srgb");
    const auto rgb = colour ? colour->vec3(kUnit) : std::nullopt;
    if (!rgb) return std::nullopt;
    double delta_e_2000 = 0;
    const auto made = renderer::srgb_spectrum(rgb->x, rgb->y, rgb->z, &delta_e_2000);
    return uplifted(spectra, reader, made, delta_e_2000);
}

std::optional<ReadSpectrum> read_blackbody(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const bool is_absolute = reader.boolean("absolute", false);
    const auto temperature =
        reader.require_number("blackbody_K", is_absolute ? kAnyTemperature_K : kTemperature_K);
    if (!temperature) return std::nullopt;
    return accept(reader.value(), is_absolute ? renderer::blackbody_radiance_spectrum(*temperature)
                                              : renderer::blackbody_spectrum(*temperature));
}

std::optional<ReadSpectrum> read_hex(SpectrumReader& spectra, JsonReader& reader) {
    const auto at = reader.require("hex");
    const auto hex = at ? at->text(spectra.limits().name_bytes) : std::nullopt;
    if (!hex) return std::nullopt;
    double delta_e_2000 = 0;
    const auto made = renderer::hex_spectrum(*hex, &delta_e_2000);
    return uplifted(spectra, reader, made, delta_e_2000);
}

/// `read`, which may be narrower than the grid, with its peak at `at_nm` and all it has to tell
/// within `reach_nm` of that.
std::optional<ReadSpectrum> with_peak(const JsonValue& at, std::optional<ReadSpectrum> read,
                                      double at_nm, double peak, double reach_nm) {
    if (read) read->told_nm = Interval{std::max(at_nm - reach_nm, 0.0), at_nm + reach_nm};
    if (read && !is_visible_peak(at, at_nm)) return std::nullopt;
    if (read && at_nm >= renderer::kLambdaMin_nm && at_nm <= renderer::kLambdaMax_nm) {
        read->high = std::max(read->high, peak);
    }
    return read;
}

std::optional<ReadSpectrum> read_gaussian(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto center = reader.require_number("center_nm", kWavelength_nm);
    const auto fwhm = reader.require_number("fwhm_nm", kWidth_nm);
    const auto peak = reader.require_number("peak", kValue);
    if (!center || !fwhm || !peak) return std::nullopt;
    const auto made = renderer::gaussian_spectrum(*center, *fwhm, *peak);
    return with_peak(*reader.find("center_nm"), accept(reader.value(), made), *center, *peak,
                     3 * *fwhm);
}

std::optional<ReadSpectrum> read_line(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto line = reader.require_number("line_nm", kWavelength_nm);
    const auto width = reader.require_number("width_nm", kWidth_nm);
    const auto integral = reader.require_number("integral", kValue);
    if (!line || !width || !integral) return std::nullopt;
    const auto made = renderer::line_spectrum(*line, *width, *integral);
    return with_peak(*reader.find("line_nm"), accept(reader.value(), made), *line,
                     *integral / *width, *width / 2);
}

std::optional<ReadSpectrum> read_scaled(SpectrumReader& spectra, JsonReader& reader) {
    const auto of = reader.require("spectrum");
    const auto scale = reader.require_number("scale", kValue);
    const auto base = of ? spectra.any(*of) : std::nullopt;
    if (!base || !scale) return std::nullopt;
    return ReadSpectrum{renderer::scaled_spectrum(base->spectrum, *scale),
                        base->low * *scale,
                        base->high * *scale,
                        base->parts,
                        base->samples,
                        base->is_index,
                        base->told_nm};
}

/// Where both tell their values; empty when neither does, or there is no such place.
std::optional<Interval> common(const std::optional<Interval>& a, const std::optional<Interval>& b) {
    if (!a || !b) return a ? a : b;
    const Interval both{std::max(a->low, b->low), std::min(a->high, b->high)};
    return both.low < both.high ? std::optional(both) : std::nullopt;
}

/// The product of all. Its bounds are those on the grid, unless a factor is narrower than that.
ReadSpectrum multiplied(const std::vector<ReadSpectrum>& factors) {
    renderer::SpectrumPtr spectrum = factors.front().spectrum;
    for (std::size_t i = 1; i < factors.size(); ++i) {
        spectrum = renderer::product_spectrum(std::move(spectrum), factors[i].spectrum);
    }
    ReadSpectrum product = with_bounds(std::move(spectrum));
    product.parts = product.samples = 0;
    bool is_narrow = false;
    double high = 1;
    for (const ReadSpectrum& factor : factors) {
        product.parts += factor.parts;
        product.samples += factor.samples;
        product.told_nm = common(product.told_nm, factor.told_nm);
        product.is_index = product.is_index || factor.is_index;
        is_narrow = is_narrow || factor.high > with_bounds(factor.spectrum).high;
        high *= factor.high;
    }
    if (is_narrow) product.high = std::max(product.high, high);
    return product;
}

std::optional<ReadSpectrum> read_product(SpectrumReader& spectra, JsonReader& reader) {
    const auto at = reader.require("product");
    const std::size_t most = spectra.limits().spectrum_parts;
    if (!at || !at->is_array(2, most, "spectra")) return std::nullopt;
    std::vector<ReadSpectrum> factors;
    std::size_t parts = 0;
    bool is_good = true;
    for (std::size_t i = 0; i < at->json().size(); ++i) {
        const auto factor = spectra.any(at->element(i));
        is_good = is_good && factor;
        if (!is_good) continue;
        factors.push_back(*factor);
        parts += factor->parts;
        if (parts <= most) continue;
        at->report("over-limit", "the product has too many factors, with those of its factors",
                   "at most " + std::to_string(most) + " factors");
        return std::nullopt;
    }
    if (!is_good) return std::nullopt;
    return multiplied(factors);
}

/// To add a kind, write its function and its line here.
constexpr std::array kKinds{
    SpectrumKind{"wavelengths_nm", &read_samples},
    SpectrumKind{"first_nm", &read_regular},
    SpectrumKind{"step_nm", &read_regular},
    SpectrumKind{"srgb", &read_srgb},
    SpectrumKind{"hex", &read_hex},
    SpectrumKind{"blackbody_K", &read_blackbody},
    SpectrumKind{"center_nm", &read_gaussian},
    SpectrumKind{"line_nm", &read_line},
    SpectrumKind{"spectrum", &read_scaled},
    SpectrumKind{"product", &read_product},
    SpectrumKind{"sellmeier_b", &read_sellmeier_index},
    SpectrumKind{"sellmeier_c_um2", &read_sellmeier_index},
    SpectrumKind{"cauchy_um", &read_cauchy_index},
    SpectrumKind{"n_d", &read_abbe_index},
    SpectrumKind{"v_d", &read_abbe_index},
};

}  // namespace

const SpectrumKind* find_kind(const Json& object) {
    for (const SpectrumKind& kind : kKinds) {
        if (object.contains(kind.key)) return &kind;
    }
    return nullptr;
}

std::vector<std::string_view> kind_keys() {
    std::vector<std::string_view> keys;
    for (const SpectrumKind& kind : kKinds) keys.push_back(kind.key);
    return keys;
}

}  // namespace bouguer::api
