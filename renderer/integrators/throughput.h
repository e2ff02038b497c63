// SPDX-License-Identifier: Apache-2.0
// What a ray carries: the share of the light at its far end that gets to the camera, number by
// number of the basis.
#pragma once

#include "renderer/core/attenuation.h"
#include "renderer/materials/absorption.h"
#include "renderer/materials/reflection_model.h"

namespace bouguer::renderer {

/// Single precision, as long as that holds it. Behind an optical depth of 80, at any wavelength,
/// what matter leaves is kept in double beside it: there is light enough, or no other, that it may
/// be all that is seen.
///
/// Keeps its memory. Not thread-safe.
class Throughput {
  public:
    explicit Throughput(std::size_t blocks) : row_(blocks, splat(0)) {}

    /// Everything gets through.
    void set_to_ones();
    /// Equation 1 over a way of `length` scene units; `table` holds the rows of `absorption`.
    void absorb(const BoundAbsorption& absorption, const SpectralTable& table, double length);
    void multiply(const Term& term);
    /// Becomes from * (a + b), of which only a may have a scale of 0. Returns the largest number.
    double blend(const Throughput& from, const Term& a, const Term& b);
    /// Leaves number `i` only, times `weight`. Returns it.
    double keep(std::size_t i, float weight);

    /// sum += this * tint * scale * a * b, where tint and b may be null.
    void accumulate(Float8* sum, double scale, const Float8* a, const Float8* b,
                    const Throughput* tint) const;
    /// Writes the numbers over a factor that it returns, so that single precision holds them: 1, or
    /// the largest of them. 0: there is nothing.
    double normalise(Float8Vector& row) const;

  private:
    [[nodiscard]] std::size_t blocks() const { return row_.size(); }
    [[nodiscard]] const Double8* dense() const { return is_dense_ ? dense_.data() : nullptr; }

    Float8Vector row_;
    Double8Vector dense_;       ///< factors of the row, while is_dense_
    bool is_dense_ = false;     ///< else they are all 1
    double optical_depth_ = 0;  ///< so far, the most of any number
};

}  // namespace bouguer::renderer
