// SPDX-License-Identifier: Apache-2.0
// Light of whole numbers by tables.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/film/picture_colour.h"

namespace bouguer::renderer {

/// What a conversion makes of pixels of whole numbers, found for every number once: of greys
/// exactly, of colours to 2e-5 as the sum of what the channels give alone. Curves and a matrix, of
/// nearly all files, are such a sum, and it is some ten times faster. Immutable.
class ChannelTables {
  public:
    /// For numbers from 0 to `last`, which stands for 1. Empty where colours are no such sum, as by
    /// the tables of a profile.
    [[nodiscard]] static std::optional<ChannelTables> make(const ToRec709& to_light,
                                                           std::size_t last, bool is_grey);

    /// The light of a pixel; of grey all three numbers are the same.
    [[nodiscard]] std::array<float, 3> operator()(std::array<std::size_t, 3> numbers) const;

  private:
    using Table = std::vector<float>;  ///< three a number
    Table grey_;                       ///< of pixels with three times the same
    std::array<Table, 3> channels_;    ///< without the black, but for the first
};

}  // namespace bouguer::renderer
