// SPDX-License-Identifier: Apache-2.0
// The built-in indices of refraction: transparent materials by formula, metals by samples.
#include <algorithm>
#include <array>
#include <map>

#include "renderer/spectrum/data_table.h"
#include "renderer/spectrum/refractive_index.h"
#include "renderer/spectrum/sampled_spectrum.h"

namespace bouguer::renderer {
namespace {

/// What a name stands for, sorted by name, and the list of it.
template <class Value>
struct Shelf {
    std::map<std::string_view, Value> values;
    std::vector<LibraryEntry> entries;

    void add(const LibraryEntry& entry, Value value) {
        values.emplace(entry.name, std::move(value));
        const auto place = std::lower_bound(
            entries.begin(), entries.end(), entry,
            [](const LibraryEntry& a, const LibraryEntry& b) { return a.name < b.name; });
        entries.insert(place, entry);
    }
    [[nodiscard]] Value find(std::string_view name) const {
        const auto it = values.find(name);
        return it == values.end() ? Value{} : it->second;
    }
};

/// name | formula | valid from nm | to nm | B1 C1 B2 C2 ... | description | source
void add_index(std::string_view line, Shelf<SpectrumPtr>& shelf) {
    const std::string_view name = next_field(line, '|');
    next_field(line, '|');  // the formula: all are Sellmeier's
    next_field(line, '|');
    next_field(line, '|');
    std::string_view coefficients = next_field(line, '|');
    std::vector<double> b, c_um2;
    while (!coefficients.empty()) {
        b.push_back(to_number(next_field(coefficients, ' ')));
        c_um2.push_back(to_number(next_field(coefficients, ' ')));
    }
    const std::string_view description = next_field(line, '|');
    shelf.add({name, "index", description, next_field(line, '|')},
              sellmeier_index(b, c_um2).value_or(nullptr));
}

const Shelf<SpectrumPtr>& indices() {
    static const Shelf<SpectrumPtr> shelf = [] {
        Shelf<SpectrumPtr> made;
        std::string_view text = embedded_text("refractive_indices");
        while (!text.empty()) {
            const std::string_view line = next_field(text, '\n');
            if (!line.empty() && !line.starts_with('#')) add_index(line, made);
        }
        return made;
    }();
    return shelf;
}

// To add a metal, add its columns "<name>-n" and "<name>-k" to a table, or a table and its line.
constexpr std::array<std::string_view, 4> kMetalTables{"metals_aluminium", "metals_brass",
                                                       "metals_noble", "metals_transition"};

void add_metals(const DataTable& table, Shelf<ComplexIndex>& shelf) {
    for (std::size_t i = 0; i + 1 < table.columns.size(); i += 2) {
        const TableColumn& n = table.columns[i];
        const TableColumn& k = table.columns[i + 1];
        const auto without_suffix = [](std::string_view text, std::string_view suffix) {
            return text.substr(0, text.size() - suffix.size());
        };
        shelf.add(
            {without_suffix(n.name, "-n"), "metal", without_suffix(n.description, ", n"), n.source},
            {std::make_shared<SampledSpectrum>(table.wavelengths_nm, n.values),
             std::make_shared<SampledSpectrum>(table.wavelengths_nm, k.values)});
    }
}

const Shelf<ComplexIndex>& metals() {
    static const Shelf<ComplexIndex> shelf = [] {
        Shelf<ComplexIndex> made;
        for (const std::string_view name : kMetalTables) add_metals(read_table(name), made);
        return made;
    }();
    return shelf;
}

}  // namespace

SpectrumPtr library_index(std::string_view name) { return indices().find(name); }
ComplexIndex library_metal(std::string_view name) { return metals().find(name); }
const std::vector<LibraryEntry>& index_entries() { return indices().entries; }
const std::vector<LibraryEntry>& metal_entries() { return metals().entries; }

}  // namespace bouguer::renderer
