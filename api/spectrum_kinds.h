// SPDX-License-Identifier: Apache-2.0
// The kinds of spectra that a document may have, each told by a key that no other kind has.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "api/json_reader.h"
#include "api/read_spectrum.h"

namespace bouguer::api {

class SpectrumReader;

inline constexpr double kLargestEmission = 1e30;

struct SpectrumKind {
    std::string_view key;  ///< the key that tells the kind
    /// Reads the rest of the object; empty after a report.
    std::optional<ReadSpectrum> (*read)(SpectrumReader&, JsonReader&);
};

/// The kind of an object that is a spectrum; null when none of its keys tells one.
[[nodiscard]] const SpectrumKind* find_kind(const Json& object);

/// The key of every kind.
[[nodiscard]] std::vector<std::string_view> kind_keys();

}  // namespace bouguer::api
