// SPDX-License-Identifier: Apache-2.0
// The tables of renderer/spectrum/data, which the build embeds as text, and their reader.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace bouguer::renderer {

/// A file of the data folder as it stands, without the ".csv" of its name.
struct EmbeddedTable {
    std::string_view name, text;
};
/// Every table, in the order of the folder's CMakeLists.txt.
std::span<const EmbeddedTable> embedded_tables();

/// One spectrum of a table: one value a wavelength, in the unit of the file.
struct TableColumn {
    std::string_view name, description, source;
    std::vector<double> values;
};

/// Columns over a common list of wavelengths. The texts point into the program: they never end.
struct DataTable {
    std::vector<double> wavelengths_nm;  ///< increasing
    std::vector<TableColumn> columns;
    /// The column of that name; null when there is none.
    [[nodiscard]] const TableColumn* find(std::string_view name) const;
};

/// Reads the form that data/make_data.py writes: "# name | description | source" lines, a heading,
/// rows of numbers. The tables are part of the program: a fault in one is a bug, found by the
/// tests.
DataTable parse_table(std::string_view text);

/// The text of the embedded file of that name, which must exist.
std::string_view embedded_text(std::string_view name);

/// Reads the embedded table of that name, which must exist. Thread-safe.
DataTable read_table(std::string_view name);

/// Cuts the text before the first `separator` off `text` and returns it without spaces around.
std::string_view next_field(std::string_view& text, char separator);
/// The number that `text`, which is one, stands for.
double to_number(std::string_view text);

}  // namespace bouguer::renderer
