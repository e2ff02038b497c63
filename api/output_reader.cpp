// SPDX-License-Identifier: Apache-2.0
#include "api/output_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include "api/json_builder.h"
#include "api/json_parser.h"
#include "api/json_text.h"
#include "renderer/spectrum/display.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::Adaptation;
using renderer::Chromaticity;
using renderer::OutputSettings;

constexpr Interval kExposure{0, 1e30, true};
constexpr std::string_view kIlluminant = "illuminant";

std::vector<std::string_view> list_of(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}

/// One of an enumeration whose words are `names`, in its order.
template <class Enum>
void read_word(JsonReader& reader, std::string_view key, std::span<const std::string_view> names,
               Enum& value) {
    const auto now = names[static_cast<std::size_t>(value)];
    const auto word = reader.one_of(key, list_of(names), now);
    value = static_cast<Enum>(std::find(names.begin(), names.end(), word) - names.begin());
}

void read_display(JsonReader& reader, OutputSettings& output) {
    std::vector<std::string_view> names;
    for (const renderer::Display& display : renderer::displays()) names.push_back(display.name);
    output.display = std::string(reader.one_of("display", names, output.display));
}

void read_exposure(JsonReader& reader, OutputSettings& output) {
    const auto at = reader.find("exposure");
    if (!at) return;
    if (at->json().is_text("auto")) {
        output.exposure.reset();
    } else if (at->json().is_number()) {
        output.exposure = at->number(kExposure);
    } else {
        at->report_type("\"auto\" or a number in " + kExposure.text());
    }
}

std::optional<Chromaticity> chromaticity_of_illuminant(const JsonValue& value) {
    std::vector<std::string_view> names;
    for (const renderer::LibraryEntry& entry : renderer::library_entries()) {
        if (entry.kind == kIlluminant) names.push_back(entry.name);
    }
    const auto name = value.one_of(names);
    if (!name) return std::nullopt;
    return renderer::chromaticity(renderer::xyz_of(*renderer::library_spectrum(*name)));
}

std::optional<Chromaticity> read_white(const JsonValue& value) {
    if (value.json().is_string()) return chromaticity_of_illuminant(value);
    if (!value.json().is_array()) {
        value.report_type("an illuminant's name or a chromaticity [x, y]");
        return std::nullopt;
    }
    if (!value.is_tuple(2, "numbers")) return std::nullopt;
    const auto x = value.element(0).number(kUnit);
    const auto y = value.element(1).number(kUnit);
    if (!x || !y) return std::nullopt;
    return Chromaticity{*x, *y};
}

void report_missing_white(const JsonReader& reader) {
    reader.value().problems().add({reader.value().pointer() + "/white", "missing",
                                   "adaptation must be told what is white: the scene's light has "
                                   "not one colour that could be it",
                                   "", "an illuminant's name or a chromaticity [x, y]"});
}

void read_given_white(const JsonValue& at, OutputSettings& output) {
    if (output.adaptation == Adaptation::None) {
        return at.report("unknown-key", "nothing is adapted, so no white is known here",
                         "an adaptation, or no white");
    }
    const auto white = read_white(at);
    if (!white) return;
    if (!renderer::can_be_white(output.adaptation, *white)) {
        return at.report("out-of-range", "no eye takes this colour for white",
                         "a chromaticity to which all cones of the adaptation respond");
    }
    output.white = white;
}

void read_adaptation(JsonReader& reader, OutputSettings& output) {
    const auto white = reader.find("white");
    if (white && output.adaptation == Adaptation::None) output.adaptation = Adaptation::Cat16;
    read_word(reader, "adaptation", renderer::kAdaptationNames, output.adaptation);
    if (white) return read_given_white(*white, output);
    if (output.adaptation == Adaptation::None) return output.white.reset();
    const auto known = output.adapted_white();
    if (!known || !renderer::can_be_white(output.adaptation, *known)) report_missing_white(reader);
}

/// What a text means, as JSON: a number, two of them, or a word.
std::string json_of(std::string_view text) {
    const auto number = [](std::string_view part) -> std::optional<std::string> {
        double x = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), x);
        const bool is_whole = error == std::errc{} && end == part.data() + part.size();
        return is_whole && std::isfinite(x) ? std::optional(json_number(x)) : std::nullopt;
    };
    if (const auto x = number(text)) return *x;
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return json_string(text);
    const auto x = number(text.substr(0, comma)), y = number(text.substr(comma + 1));
    return x && y ? JsonArray().add_json(*x).add_json(*y).text() : json_string(text);
}

/// A text of our own making as a tree: no limit of documents holds for it.
Result<JsonTree> read_own(std::string_view text) {
    Limits limits;
    limits.body_bytes = limits.name_bytes = SIZE_MAX;
    return read_json_tree(text, limits);
}

/// What was found, in the client's own letters.
void quote(const OutputTexts& texts, Problem& problem) {
    const std::string name = problem.pointer.substr(1, problem.pointer.find('/', 1) - 1);
    const auto text = texts.find(name);
    if (text != texts.end()) problem.found = describe_text(text->second);
}

}  // namespace

void read_output(JsonReader& reader, OutputScope scope, OutputSettings& output) {
    if (scope != OutputScope::Exr) {
        read_display(reader, output);
        read_exposure(reader, output);
        read_adaptation(reader, output);
    }
    if (scope == OutputScope::Files || scope == OutputScope::Png)
        read_word(reader, "gamut", renderer::kGamutMappingNames, output.gamut);
    if (scope == OutputScope::Files || scope == OutputScope::Exr)
        read_word(reader, "color_space", renderer::kFileColourNames, output.exr_colour);
}

Result<OutputSettings> read_output_texts(const OutputTexts& texts, OutputScope scope,
                                         const OutputSettings& base) {
    JsonObject object;
    for (const auto& [name, text] : texts) object.set_json(name, json_of(text));
    const auto tree = read_own(object.text());
    if (!tree) return tl::unexpected(tree.error());
    Problems problems(texts.size() + 1);
    JsonReader reader(JsonValue(tree->root(), "", problems));
    OutputSettings output = base;
    read_output(reader, scope, output);
    reader.reject_unknown_keys();
    if (problems.empty()) return output;
    Error error = std::move(problems).to_error(ErrorKind::InvalidInput);
    for (Problem& problem : error.problems) quote(texts, problem);
    return tl::unexpected(std::move(error));
}

Result<OutputSettings> read_report_output(std::string_view report) {
    const auto damaged =
        fail(ErrorKind::Internal, "the report says nothing of the output", "result-damaged");
    const auto whole = read_own(report);
    const auto output_at = whole ? whole->root().find("output") : std::nullopt;
    if (!output_at || !output_at->is_object()) return damaged;
    JsonObject told;
    for (const auto& [key, value] : output_at->members()) {
        if (!value.is_null()) told.set_json(key, canonical_text(value));
    }
    const auto tree = read_own(told.text());
    if (!tree) return damaged;
    Problems problems(1);
    JsonReader reader(JsonValue(tree->root(), "", problems));
    OutputSettings output;
    if (const auto at = reader.find("scene_white")) output.scene_white = read_white(*at);
    read_output(reader, OutputScope::Files, output);
    if (!problems.empty()) return damaged;
    return output;
}

}  // namespace bouguer::api
