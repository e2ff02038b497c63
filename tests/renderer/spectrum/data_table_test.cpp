// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/data_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bouguer::renderer {
namespace {

TEST(DataTable, ReadsColumnsWithTheirSources) {
    const DataTable t = parse_table(
        "# Made by hand.\n# a | first | book\n# b-2 | second, of two | page 3\n"
        "wavelength_nm,a,b-2\n400,1,2.5e-3\n405.5,-3,4\n");
    EXPECT_EQ(t.wavelengths_nm, (std::vector{400.0, 405.5}));
    ASSERT_EQ(t.columns.size(), 2U);
    EXPECT_EQ(t.columns[0].values, (std::vector<double>{1, -3}));
    ASSERT_TRUE(t.find("b-2"));
    EXPECT_EQ(t.find("b-2")->description, "second, of two");
    EXPECT_EQ(t.find("b-2")->source, "page 3");
    EXPECT_EQ(t.find("b-2")->values, (std::vector{2.5e-3, 4.0}));
    EXPECT_EQ(t.find("c"), nullptr);
}

// What parse_table() takes for granted of the files that are built in.
TEST(DataTable, EveryEmbeddedTableIsWhole) {
    EXPECT_FALSE(embedded_tables().empty());
    for (const EmbeddedTable& embedded : embedded_tables()) {
        if (embedded.name == "refractive_indices") continue;  // another form
        const DataTable t = parse_table(embedded.text);
        EXPECT_GE(t.wavelengths_nm.size(), 2U) << embedded.name;
        EXPECT_FALSE(t.columns.empty()) << embedded.name;
        EXPECT_TRUE(std::is_sorted(t.wavelengths_nm.begin(), t.wavelengths_nm.end()));
        for (const TableColumn& column : t.columns)
            EXPECT_EQ(column.values.size(), t.wavelengths_nm.size()) << column.name;
    }
}

}  // namespace
}  // namespace bouguer::renderer
