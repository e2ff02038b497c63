// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/throughput.h"

#include <algorithm>

namespace bouguer::renderer {

void Throughput::set_to_ones() {
    std::fill(row_.begin(), row_.end(), splat(1));
    is_dense_ = false;
    optical_depth_ = 0;
}

void Throughput::absorb(const BoundAbsorption& absorption, const SpectralTable& table,
                        double length) {
    const SplitRow log_t = table.split_row(absorption.log_t);
    optical_depth_ += absorption.steepest * length;
    if (optical_depth_ <= kSingleDepth) return attenuate(row_.data(), log_t, length, blocks());
    if (!is_dense_) dense_.assign(blocks(), Double8{} + 1.0);
    is_dense_ = true;
    attenuate(dense_.data(), log_t, length, blocks());
}

void Throughput::multiply(const Term& term) {
    renderer::multiply(row_.data(), term.scale, term.colour, blocks());
}

double Throughput::blend(const Throughput& from, const Term& a, const Term& b) {
    const Term& first = a.scale == 0 ? b : a;
    const float peak = renderer::blend(row_.data(), from.row_.data(), first.scale, first.colour,
                                       a.scale == 0 ? 0 : b.scale, b.colour, blocks());
    optical_depth_ = from.optical_depth_;
    is_dense_ = from.is_dense_;
    if (!is_dense_) return static_cast<double>(peak);
    dense_ = from.dense_;
    return largest(row_.data(), dense_.data(), blocks());
}

double Throughput::keep(std::size_t i, float weight) {
    auto* values = reinterpret_cast<float*>(row_.data());
    const float kept = values[i] * weight;
    std::fill(row_.begin(), row_.end(), splat(0));
    values[i] = kept;
    const double factor = is_dense_ ? reinterpret_cast<const double*>(dense_.data())[i] : 1;
    return static_cast<double>(kept) * factor;
}

void Throughput::accumulate(Float8* sum, double scale, const Float8* a, const Float8* b,
                            const Throughput* tint) const {
    const Double8* dense_tint = tint != nullptr ? tint->dense() : nullptr;
    if (is_dense_ || dense_tint != nullptr) {
        const Float8* tint_row = tint != nullptr ? tint->row_.data() : nullptr;
        return renderer::accumulate(sum, {row_.data(), dense(), tint_row, dense_tint}, scale, a, b,
                                    blocks());
    }
    renderer::accumulate(sum, row_.data(), static_cast<float>(scale), a,
                         b != nullptr ? b : (tint != nullptr ? tint->row_.data() : nullptr),
                         b != nullptr && tint != nullptr ? tint->row_.data() : nullptr, blocks());
}

double Throughput::normalise(Float8Vector& row) const {
    constexpr double kLeast = 1e-300;
    row = row_;
    if (!is_dense_) return 1;
    const double peak = largest(row_.data(), dense_.data(), blocks());
    if (peak < kLeast) return 0;
    std::fill(row.begin(), row.end(), splat(0));
    renderer::accumulate(row.data(), {row_.data(), dense_.data()}, 1 / peak, nullptr, nullptr,
                         blocks());
    return peak;
}

}  // namespace bouguer::renderer
