// SPDX-License-Identifier: Apache-2.0
// The built-in library: every column of the embedded tables that is listed here.
#include <algorithm>
#include <array>

#include "renderer/spectrum/data_table.h"
#include "renderer/spectrum/sampled_spectrum.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

/// A table whose columns are spectra of the library.
struct LibraryTable {
    std::string_view name;
    std::string_view kind;
    /// Where the columns are scaled to 1; 0: they stay as published.
    double unit_at_nm;
    double thickness_mm = 0;  ///< that a transmittance is for
};

// To add spectra to the library, add columns to a table, or a table and its line here.
constexpr std::array kTables{
    LibraryTable{"illuminants_a_e", "illuminant", 560},
    LibraryTable{"illuminants_daylight", "illuminant", 560},
    LibraryTable{"illuminants_fluorescent", "illuminant", 560},
    LibraryTable{"illuminants_led", "illuminant", 560},
    LibraryTable{"reflectances_colorchecker", "reflectance", 0},
    LibraryTable{"filters_1mm", "transmittance", 0, 1},
    LibraryTable{"filters_10mm", "transmittance", 0, 10},
};

struct Library {
    std::vector<LibraryEntry> entries;  ///< sorted by name
    std::vector<SpectrumPtr> spectra;   ///< in the order of entries
};

SpectrumPtr spectrum_of(const DataTable& table, const TableColumn& column, double unit_at_nm) {
    auto spectrum = std::make_shared<SampledSpectrum>(table.wavelengths_nm, column.values);
    if (unit_at_nm == 0) return spectrum;
    std::vector<double> values = column.values;
    for (double& v : values) v /= spectrum->at(unit_at_nm);
    return std::make_shared<SampledSpectrum>(table.wavelengths_nm, std::move(values));
}

Library make_library() {
    std::vector<std::pair<LibraryEntry, SpectrumPtr>> all;
    for (const LibraryTable& listed : kTables) {
        const DataTable table = read_table(listed.name);
        for (const TableColumn& column : table.columns)
            all.emplace_back(LibraryEntry{column.name, listed.kind, column.description,
                                          column.source, listed.thickness_mm},
                             spectrum_of(table, column, listed.unit_at_nm));
    }
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.first.name < b.first.name; });
    Library library;
    for (auto& [entry, spectrum] : all) {
        library.entries.push_back(entry);
        library.spectra.push_back(std::move(spectrum));
    }
    return library;
}

const Library& library() {
    static const Library made = make_library();
    return made;
}

}  // namespace

SpectrumPtr library_spectrum(std::string_view name) {
    const auto& entries = library().entries;
    const auto it = std::lower_bound(
        entries.begin(), entries.end(), name,
        [](const LibraryEntry& entry, std::string_view wanted) { return entry.name < wanted; });
    if (it == entries.end() || it->name != name) return nullptr;
    return library().spectra[static_cast<std::size_t>(it - entries.begin())];
}

const std::vector<LibraryEntry>& library_entries() { return library().entries; }

}  // namespace bouguer::renderer
