// SPDX-License-Identifier: Apache-2.0
#include "api/spectrum_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "api/json_reader.h"
#include "api/nearest_name.h"
#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::SpectrumPtr;

constexpr double kLargestEmission = 1e30;
constexpr Interval kValue{0, kLargestEmission};
constexpr Interval kWavelength_nm{1e-3, 1e9};
constexpr Interval kWidth_nm{0, 1e9, true};
constexpr Interval kTemperature_K{renderer::kBlackbodyMin_K, renderer::kBlackbodyMax_K};

/// Least and largest value on the 1 nm grid of the rendered range.
ReadSpectrum with_bounds(SpectrumPtr spectrum) {
    ReadSpectrum read{std::move(spectrum), INFINITY, -INFINITY};
    for (double lambda = renderer::kLambdaMin_nm; lambda <= renderer::kLambdaMax_nm; ++lambda) {
        const double value = read.spectrum->at(lambda);
        read.low = std::min(read.low, value);
        read.high = std::max(read.high, value);
    }
    return read;
}

/// What the renderer made of it, or its refusal, reported below `value`.
std::optional<ReadSpectrum> accept(const JsonValue& value, const Result<SpectrumPtr>& made) {
    if (made) return with_bounds(*made);
    value.problems().add_below(value.pointer(), made.error());
    return std::nullopt;
}

/// Widens the bounds by those samples that fall between the points of the 1 nm grid.
void include_samples(ReadSpectrum& read, const std::vector<double>& wavelengths_nm,
                     const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (wavelengths_nm[i] < renderer::kLambdaMin_nm) continue;
        if (wavelengths_nm[i] > renderer::kLambdaMax_nm) continue;
        read.low = std::min(read.low, values[i]);
        read.high = std::max(read.high, values[i]);
    }
}

std::optional<ReadSpectrum> read_samples(SpectrumReader& spectra, JsonReader& reader) {
    const std::size_t most = spectra.limits().spectrum_samples;
    const auto at = reader.require("wavelengths_nm");
    const auto of = reader.require("values");
    const auto wavelengths = at ? at->numbers(most) : std::nullopt;
    const auto values = of ? of->numbers(most) : std::nullopt;
    if (!wavelengths || !values) return std::nullopt;
    auto read = accept(reader.value(), renderer::sampled_spectrum(*wavelengths, *values));
    if (read) include_samples(*read, *wavelengths, *values);
    return read;
}

std::optional<ReadSpectrum> read_regular(SpectrumReader& spectra, JsonReader& reader) {
    const auto first = reader.require_number("first_nm", kWavelength_nm);
    const auto step = reader.require_number("step_nm", kWavelength_nm);
    const auto of = reader.require("values");
    const auto values = of ? of->numbers(spectra.limits().spectrum_samples) : std::nullopt;
    if (!first || !step || !values) return std::nullopt;
    auto read = accept(reader.value(), renderer::regular_spectrum(*first, *step, *values));
    if (!read) return read;
    std::vector<double> wavelengths(values->size());
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        wavelengths[i] = *first + static_cast<double>(i) * *step;
    }
    include_samples(*read, wavelengths, *values);
    return read;
}

std::optional<ReadSpectrum> read_srgb(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto colour = reader.require("srgb");
    const auto rgb = colour ? colour->vec3(kUnit) : std::nullopt;
    if (!rgb) return std::nullopt;
    return accept(reader.value(), renderer::srgb_spectrum(rgb->x, rgb->y, rgb->z));
}

std::optional<ReadSpectrum> read_blackbody(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto temperature = reader.require_number("blackbody_K", kTemperature_K);
    if (!temperature) return std::nullopt;
    return accept(reader.value(), renderer::blackbody_spectrum(*temperature));
}

std::optional<ReadSpectrum> read_hex(SpectrumReader& spectra, JsonReader& reader) {
    const auto at = reader.require("hex");
    const auto hex = at ? at->text(spectra.limits().name_bytes) : std::nullopt;
    return hex ? accept(reader.value(), renderer::hex_spectrum(*hex)) : std::nullopt;
}

/// `read`, which may be narrower than the grid, with its peak at `at_nm`.
std::optional<ReadSpectrum> with_peak(std::optional<ReadSpectrum> read, double at_nm, double peak) {
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
    return with_peak(accept(reader.value(), made), *center, *peak);
}

std::optional<ReadSpectrum> read_line(SpectrumReader& /*spectra*/, JsonReader& reader) {
    const auto line = reader.require_number("line_nm", kWavelength_nm);
    const auto width = reader.require_number("width_nm", kWidth_nm);
    const auto integral = reader.require_number("integral", kValue);
    if (!line || !width || !integral) return std::nullopt;
    const auto made = renderer::line_spectrum(*line, *width, *integral);
    return with_peak(accept(reader.value(), made), *line, *integral / *width);
}

std::optional<ReadSpectrum> read_scaled(SpectrumReader& spectra, JsonReader& reader) {
    const auto of = reader.require("spectrum");
    const auto scale = reader.require_number("scale", kValue);
    const auto base = of ? spectra.any(*of) : std::nullopt;
    if (!base || !scale) return std::nullopt;
    return ReadSpectrum{renderer::scaled_spectrum(base->spectrum, *scale), base->low * *scale,
                        base->high * *scale, base->parts};
}

/// The product of all. Its bounds are those on the grid, unless a factor is narrower than that.
ReadSpectrum multiplied(const std::vector<ReadSpectrum>& factors) {
    renderer::SpectrumPtr spectrum = factors.front().spectrum;
    for (std::size_t i = 1; i < factors.size(); ++i) {
        spectrum = renderer::product_spectrum(std::move(spectrum), factors[i].spectrum);
    }
    ReadSpectrum product = with_bounds(std::move(spectrum));
    product.parts = 0;
    bool is_narrow = false;
    double high = 1;
    for (const ReadSpectrum& factor : factors) {
        product.parts += factor.parts;
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

struct SpectrumKind {
    std::string_view key;  ///< the key that tells the kind
    std::optional<ReadSpectrum> (*read)(SpectrumReader&, JsonReader&);
};

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
};

std::vector<std::string_view> kind_keys() {
    std::vector<std::string_view> keys;
    for (const SpectrumKind& kind : kKinds) keys.push_back(kind.key);
    return keys;
}

/// No key tells the kind: helps with the key that comes nearest to one that would.
void report_no_kind(const JsonValue& value) {
    std::string hint;
    for (const auto& [key, member] : value.json().items()) {
        if (hint.empty()) hint = did_you_mean(key, kind_keys());
    }
    value.report("unknown-type", "no key of this object tells the kind of spectrum." + hint,
                 "an object with one of the keys " + quoted_list(kind_keys()));
}

}  // namespace

SpectrumReader::SpectrumReader(std::optional<JsonValue> definitions, const Limits& limits)
    : limits_(limits) {
    if (!definitions) return;
    if (!definitions->json().is_object()) {
        definitions->report_type("an object of spectra by name");
        return;
    }
    // Too many are known by name only: nobody reads them.
    auto state = Definition::State::Unread;
    if (definitions->json().size() > limits.spectra) {
        definitions->report("over-limit", "there are too many spectra",
                            "at most " + std::to_string(limits.spectra) + " spectra");
        state = Definition::State::Read;
    }
    for (const auto& [name, json] : definitions->json().items()) {
        definitions_.emplace(name, Definition{definitions->member(name), state, {}});
    }
}

SpectrumPtr SpectrumReader::factor(const JsonValue& value) {
    return within(value, 1, "values in [0, 1] from 360 to 830 nm");
}

SpectrumPtr SpectrumReader::emission(const JsonValue& value) {
    return within(value, kLargestEmission, "values in [0, 1e30] from 360 to 830 nm");
}

SpectrumPtr SpectrumReader::within(const JsonValue& value, double high, std::string_view allowed) {
    const auto read = any(value);
    if (!read) return nullptr;
    if (read->low >= 0 && read->high <= high) return read->spectrum;
    value.problems().add(
        {value.pointer(), "out-of-range", "the spectrum leaves the allowed range",
         "values from " + number_text(read->low) + " to " + number_text(read->high),
         std::string(allowed)});
    return nullptr;
}

void SpectrumReader::read_all() {
    for (auto& [name, definition] : definitions_) {
        static_cast<void>(defined(definition.value, definition));
    }
}

std::optional<ReadSpectrum> SpectrumReader::any(const JsonValue& value) {
    if (value.json().is_string()) return named(value);
    if (value.json().is_object()) return of_a_kind(value);
    if (!value.json().is_number()) {
        value.report_type("a spectrum: a number, a name or an object");
        return std::nullopt;
    }
    const auto number = value.number(kValue);
    if (!number) return std::nullopt;
    return ReadSpectrum{renderer::constant_spectrum(*number), *number, *number};
}

std::optional<ReadSpectrum> SpectrumReader::named(const JsonValue& value) {
    const auto& name = value.json().get_ref<const std::string&>();
    if (const auto it = definitions_.find(name); it != definitions_.end()) {
        return defined(value, it->second);
    }
    if (auto spectrum = renderer::library_spectrum(name)) return with_bounds(std::move(spectrum));
    std::vector<std::string_view> known;
    for (const auto& [defined_name, definition] : definitions_) known.push_back(defined_name);
    for (const auto& entry : renderer::library_entries()) known.push_back(entry.name);
    value.report("unknown-name",
                 "there is no spectrum of this name in the scene or in the library." +
                     (value.problems().is_full() ? "" : did_you_mean(name, known)),
                 "one of " + quoted_list(known));
    return std::nullopt;
}

std::optional<ReadSpectrum> SpectrumReader::defined(const JsonValue& reference,
                                                    Definition& definition) {
    if (definition.state == Definition::State::Read) return definition.result;
    if (definition.state == Definition::State::Reading) {
        reference.report("cyclic-reference", "this spectrum is defined by itself",
                         "references that do not lead back");
        return std::nullopt;
    }
    if (depth_ >= limits_.spectrum_references) {
        reference.report(
            "over-limit", "spectra refer to each other in too long a chain",
            "at most " + std::to_string(limits_.spectrum_references) + " references in a row");
        return std::nullopt;
    }
    definition.state = Definition::State::Reading;
    ++depth_;
    definition.result = any(definition.value);
    --depth_;
    definition.state = Definition::State::Read;
    return definition.result;
}

std::optional<ReadSpectrum> SpectrumReader::of_a_kind(const JsonValue& value) {
    for (const SpectrumKind& kind : kKinds) {
        if (!value.json().contains(kind.key)) continue;
        JsonReader reader(value);
        auto read = kind.read(*this, reader);
        reader.reject_unknown_keys();
        return read;
    }
    report_no_kind(value);
    return std::nullopt;
}

}  // namespace bouguer::api
