// SPDX-License-Identifier: Apache-2.0
// From the numbers that an ICC profile describes to linear light, by Little CMS.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "renderer/core/result.h"

namespace bouguer::renderer {

/// Takes encoded numbers to linear Rec.709 by the relative colorimetric intent: the profile's white
/// becomes 1, 1, 1. Colours outside Rec.709 have components below 0 or above 1. Not thread-safe;
/// any number of them can be used at once.
class IccTransform {
  public:
    /// Of the matrix, curves and tables of any profile of version 2 or 4; its multi-process
    /// elements are left aside for the tables that stand beside them [ICC.1:2022 §9.2.20]: they
    /// would take any time. Error{InvalidInput}, "bad-image": no profile, one of something else
    /// than grey or R, G, B, one that is no device's or colour space's, one that wants more than 64
    /// MiB.
    [[nodiscard]] static Result<IccTransform> to_linear_rec709(
        std::span<const std::uint8_t> profile);
    ~IccTransform();
    IccTransform(IccTransform&&) noexcept;
    IccTransform& operator=(IccTransform&&) noexcept;

    /// 1 grey, 3 R, G, B: what the profile wants of a pixel.
    [[nodiscard]] int channels() const;
    /// `from`: channels() numbers a pixel in [0, 1]. `to`: three a pixel.
    void operator()(std::span<const float> from, std::span<float> to) const;

  private:
    struct State;
    explicit IccTransform(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace bouguer::renderer
