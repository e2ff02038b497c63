// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/span_math.h"

#include <gtest/gtest.h>

namespace bouguer::renderer {
namespace {

TEST(SpectralTable, PadsRowsWithZeros) {
    SpectralTable table(9);
    EXPECT_EQ(table.blocks(), 2U);
    table.add(std::vector<float>(9, 1));
    const std::size_t second = table.add({5});
    EXPECT_EQ(second, 1U);
    EXPECT_EQ(table.row(0)[1][0], 1);
    EXPECT_EQ(table.row(0)[1][1], 0);
    EXPECT_EQ(table.row(1)[0][0], 5);
    EXPECT_EQ(table.row(1)[0][1], 0);
}

}  // namespace
}  // namespace bouguer::renderer
