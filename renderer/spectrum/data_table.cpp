// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/data_table.h"

#include <algorithm>
#include <cassert>
#include <charconv>

namespace bouguer::renderer {
std::string_view next_field(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    std::string_view field = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
    while (!field.empty() && field.back() == ' ') field.remove_suffix(1);
    return field;
}

double to_number(std::string_view text) {
    double value = 0;
    [[maybe_unused]] const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    assert(error == std::errc{} && end == text.data() + text.size());
    return value;
}

const TableColumn* DataTable::find(std::string_view name) const {
    const auto it = std::find_if(columns.begin(), columns.end(),
                                 [&](const TableColumn& c) { return c.name == name; });
    return it == columns.end() ? nullptr : &*it;
}

DataTable parse_table(std::string_view text) {
    DataTable table;
    while (!text.empty()) {
        std::string_view line = next_field(text, '\n');
        if (line.starts_with('#')) {
            line.remove_prefix(1);
            if (line.find('|') == std::string_view::npos) continue;
            const std::string_view name = next_field(line, '|');
            const std::string_view description = next_field(line, '|');
            table.columns.push_back({name, description, next_field(line, '|'), {}});
        } else if (!line.empty() && !line.starts_with("wavelength_nm")) {
            table.wavelengths_nm.push_back(to_number(next_field(line, ',')));
            for (TableColumn& column : table.columns)
                column.values.push_back(to_number(next_field(line, ',')));
        }
    }
    return table;
}

std::string_view embedded_text(std::string_view name) {
    for (const EmbeddedTable& table : embedded_tables())
        if (table.name == name) return table.text;
    assert(false && "no such table");
    return {};
}

DataTable read_table(std::string_view name) { return parse_table(embedded_text(name)); }

}  // namespace bouguer::renderer
