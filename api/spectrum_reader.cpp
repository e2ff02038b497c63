// SPDX-License-Identifier: Apache-2.0
#include "api/spectrum_reader.h"

#include "api/json_reader.h"
#include "api/nearest_name.h"
#include "api/spectrum_kinds.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::SpectrumPtr;

constexpr Interval kFactor{0, 1};
constexpr Interval kEmission{0, kLargestEmission};
constexpr Interval kIndex{renderer::kIndexMin, renderer::kIndexMax};
constexpr Interval kMetalN{0, 100, true};
constexpr Interval kMetalK{0, 100};
/// Less than this share of a light's energy is not worth a note.
constexpr double kLeastShare = 1e-6;
/// More than a spectrum of the library has.
constexpr std::size_t kLibrarySamples = 600;

/// No key tells the kind: helps with the key that comes nearest to one that would.
void report_no_kind(const JsonValue& value) {
    std::string hint;
    for (const auto& [key, member] : value.json().members()) {
        if (hint.empty()) hint = did_you_mean(key, kind_keys());
    }
    value.report("unknown-type", "no key of this object tells the kind of spectrum." + hint,
                 "an object with one of the keys " + quoted_list(kind_keys()));
}

/// `what` is what the name should be of: "spectrum".
void report_unknown_name(const JsonValue& value, const std::string& what,
                         const std::vector<std::string_view>& known) {
    const std::string_view name = value.json().text();
    value.report("unknown-name",
                 "there is no " + what + " of this name in the scene or in the library." +
                     (value.problems().is_full() ? "" : did_you_mean(name, known)),
                 "one of " + quoted_list(known));
}

void append_names(std::vector<std::string_view>& names,
                  const std::vector<renderer::LibraryEntry>& entries) {
    for (const renderer::LibraryEntry& entry : entries) names.push_back(entry.name);
}

ReadSpectrum index_with_bounds(SpectrumPtr index) {
    ReadSpectrum read = with_bounds(std::move(index));
    read.is_index = true;
    return read;
}

/// The spectrum, when all its values from 360 to 830 nm are allowed; null after a report.
SpectrumPtr within(const JsonValue& value, const ReadSpectrum& read, const Interval& allowed) {
    if (allowed.contains(read.low) && allowed.contains(read.high)) return read.spectrum;
    value.problems().add({value.pointer(), "out-of-range", "the spectrum leaves the allowed range",
                          "values from " + number_text(read.low) + " to " + number_text(read.high),
                          "values in " + allowed.text() + " from 360 to 830 nm"});
    return nullptr;
}

/// Likewise of what is no index of refraction.
SpectrumPtr no_index(const JsonValue& value, const ReadSpectrum& read, const Interval& allowed) {
    if (!read.is_index) return within(value, read, allowed);
    value.report("wrong-quantity", "this is an index of refraction, which has no meaning here",
                 "a spectrum with values in " + allowed.text());
    return nullptr;
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
    for (const auto& [name, json] : definitions->json().members()) {
        definitions_.emplace(name, Definition{definitions->member(name), state, {}});
    }
}

SpectrumPtr SpectrumReader::factor(const JsonValue& value) {
    const auto read = use(value);
    return read ? no_index(value, *read, kFactor) : nullptr;
}

SpectrumPtr SpectrumReader::emission(const JsonValue& value) {
    const auto read = use(value);
    SpectrumPtr spectrum = read ? no_index(value, *read, kEmission) : nullptr;
    if (!spectrum || !read->told_nm) return spectrum;
    const double share =
        renderer::share_outside_range(*spectrum, read->told_nm->low, read->told_nm->high);
    if (share > kLeastShare) notes_.outside_range.add(value.pointer(), share);
    return spectrum;
}

void SpectrumReader::note_uplift(const JsonValue& value, double delta_e_2000) {
    notes_.uplift.add(value.pointer(), delta_e_2000);
}

SpectrumPtr SpectrumReader::index(const JsonValue& value) {
    if (value.json().is_number()) {
        const auto n = value.number(kIndex);
        return n ? renderer::constant_spectrum(*n) : nullptr;
    }
    if (value.json().is_string() && !is_known(value.json().text())) {
        auto known = defined_names();
        append_names(known, renderer::index_entries());
        report_unknown_name(value, "index of refraction", known);
        return nullptr;
    }
    const auto read = use(value);
    return read ? within(value, *read, kIndex) : nullptr;
}

std::optional<renderer::ComplexIndex> SpectrumReader::metal(const JsonValue& value) {
    if (value.json().is_string()) return named_metal(value);
    if (!value.json().is_object()) {
        value.report_type("a metal: a name or an object with n and k");
        return std::nullopt;
    }
    JsonReader reader(value);
    const auto n_value = reader.require("n");
    const auto k_value = reader.require("k");
    reader.reject_unknown_keys();
    const auto n = n_value ? use(*n_value) : std::nullopt;
    const auto k = k_value ? use(*k_value) : std::nullopt;
    renderer::ComplexIndex metal;
    if (n) metal.n = within(*n_value, *n, kMetalN);
    if (k) metal.k = no_index(*k_value, *k, kMetalK);
    if (!metal.n || !metal.k) return std::nullopt;
    return metal;
}

void SpectrumReader::read_all() {
    for (auto& [name, definition] : definitions_) {
        if (definition.state == Definition::State::Unread) {
            definition.value.warn("unused-spectrum", "nothing refers to this spectrum",
                                  "remove it, or use its name");
        }
        static_cast<void>(defined(definition.value, definition));
    }
}

/// any(), counted: every use of a product is integrated anew. Nothing more is read once they are
/// too much.
std::optional<ReadSpectrum> SpectrumReader::use(const JsonValue& value) {
    if (product_work_ > limits_.product_work) return std::nullopt;
    auto read = any(value);
    if (!read) return read;
    product_work_ += read->product_work();
    if (product_work_ <= limits_.product_work) return read;
    value.report("over-limit", "the products of spectra of this scene are too much to integrate",
                 "factors x (samples + 100 factors), summed over all uses of products, at most " +
                     std::to_string(limits_.product_work));
    return std::nullopt;
}

std::optional<ReadSpectrum> SpectrumReader::any(const JsonValue& value) {
    if (value.json().is_string()) return named(value);
    if (value.json().is_object()) return of_a_kind(value);
    if (!value.json().is_number()) {
        value.report_type("a spectrum: a number, a name or an object");
        return std::nullopt;
    }
    const auto number = value.number(kEmission);
    if (!number) return std::nullopt;
    return ReadSpectrum{renderer::constant_spectrum(*number), *number, *number};
}

std::vector<std::string_view> SpectrumReader::defined_names() const {
    std::vector<std::string_view> names;
    for (const auto& [name, definition] : definitions_) names.push_back(name);
    return names;
}

bool SpectrumReader::is_known(std::string_view name) const {
    return definitions_.contains(name) || renderer::library_spectrum(name) ||
           renderer::library_index(name);
}

std::optional<ReadSpectrum> SpectrumReader::named(const JsonValue& value) {
    const std::string_view name = value.json().text();
    if (const auto it = definitions_.find(name); it != definitions_.end()) {
        return defined(value, it->second);
    }
    if (auto spectrum = renderer::library_spectrum(name)) {
        ReadSpectrum read = with_bounds(std::move(spectrum));
        read.samples = kLibrarySamples;
        return read;
    }
    if (auto index = renderer::library_index(name)) return index_with_bounds(std::move(index));
    auto known = defined_names();
    append_names(known, renderer::library_entries());
    append_names(known, renderer::index_entries());
    report_unknown_name(value, "spectrum", known);
    return std::nullopt;
}

std::optional<renderer::ComplexIndex> SpectrumReader::named_metal(const JsonValue& value) {
    auto metal = renderer::library_metal(value.json().text());
    if (metal.n) return metal;
    std::vector<std::string_view> known;
    append_names(known, renderer::metal_entries());
    report_unknown_name(value, "metal", known);
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
    const SpectrumKind* kind = find_kind(value.json());
    if (!kind) {
        report_no_kind(value);
        return std::nullopt;
    }
    JsonReader reader(value);
    auto read = kind->read(*this, reader);
    reader.reject_unknown_keys();
    return read;
}

}  // namespace bouguer::api
