// SPDX-License-Identifier: Apache-2.0
// The settings of the output as a query or a command line says them: "exposure" -> "2". What is
// allowed is decided where documents are read (output_reader.cpp), for all of them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "renderer/core/result.h"
#include "renderer/settings.h"

namespace bouguer::api {

/// One setting, under its name in documents and queries.
struct OutputParameter {
    std::string_view name, description;
    bool is_compared;  ///< whether comparisons know it
};

/// All of them. To add one, add its line here and its reading to output_reader.cpp.
inline constexpr std::array kOutputParameters{
    OutputParameter{"display", "that shows: srgb, display-p3, lee-9300k ...", true},
    OutputParameter{"exposure", "a factor, or auto", true},
    OutputParameter{"adaptation", "to the display's white: none, bradford, cat16", true},
    OutputParameter{"white", "that is adapted from: x,y or the name of an illuminant", true},
    OutputParameter{"gamut", "what becomes of colours beyond the display: clip, desaturate", false},
    OutputParameter{"color_space", "of EXR files: rec709, xyz, display-p3, acescg", false},
};

/// Which settings count: for both files, for one of them, or for a comparison (display, exposure,
/// adaptation and white).
enum class OutputScope { Files, Png, Exr, Comparison };

/// Name -> text. A text is a number, two numbers with a comma between them, or a word.
using OutputTexts = std::map<std::string, std::string>;

/// `base` with what `texts` say in its place. Error{InvalidInput}: every problem at once, with the
/// name as its pointer ("/exposure"); also what the scope does not know. Thread-safe.
[[nodiscard]] Result<renderer::OutputSettings> read_output_texts(
    const OutputTexts& texts, OutputScope scope, const renderer::OutputSettings& base);

/// The settings that a report (report_json()) tells; automatic exposure as the factor that was
/// found. Error{Internal}, code "result-damaged": it is no report of ours.
[[nodiscard]] Result<renderer::OutputSettings> read_report_output(std::string_view report);

}  // namespace bouguer::api
