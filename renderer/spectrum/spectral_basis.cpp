// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectral_basis.h"

#include <algorithm>
#include <cassert>

#include "renderer/spectrum/quadrature.h"
#include "renderer/spectrum/smooth_reflectance.h"

namespace bouguer::renderer {
namespace {

/// Sums run in this many lanes side by side, each in the order of the values: a fixed order that
/// the compiler may put into vectors.
constexpr std::size_t kLanes = 4;

std::vector<double> not_negative(const std::array<double, 3>& rgb) {
    std::vector<double> values;
    for (const double v : rgb) values.push_back(std::max(v, 0.0));
    return values;
}

std::vector<float> to_floats(const std::vector<double>& exact) {
    std::vector<float> values;
    values.reserve(exact.size());
    for (const double v : exact) values.push_back(static_cast<float>(v));
    return values;
}

}  // namespace

SpectralBasis SpectralBasis::wavelengths(double step_nm, const Observer& observer) {
    SpectralBasis basis;
    basis.name_ = "wavelengths";
    basis.step_nm_ = step_nm;
    for (const QuadratureNode& node : quadrature(step_nm, observer)) {
        basis.lambda_nm_.push_back(node.lambda_nm);
        basis.weights_.push_back({node.weight.x, node.weight.y, node.weight.z});
    }
    basis.split_weights();
    return basis;
}

SpectralBasis SpectralBasis::rgb() {
    SpectralBasis basis;
    basis.name_ = "rgb";
    const Matrix3& m = rec709_to_xyz();
    for (std::size_t i = 0; i < 3; ++i) basis.weights_.push_back({m[0][i], m[1][i], m[2][i]});
    basis.split_weights();
    return basis;
}

SpectralBasis SpectralBasis::grey(const Spectrum& illuminant, double step_nm,
                                  const Observer& observer) {
    SpectralBasis basis;
    basis.name_ = "grey";
    basis.illuminant_ = illuminant.as_multiple().base;
    const Xyz white = xyz_of(*basis.illuminant_, step_nm, observer);
    basis.weights_.push_back({white.x, white.y, white.z});
    basis.split_weights();
    return basis;
}

void SpectralBasis::split_weights() {
    for (std::size_t c = 0; c < 3; ++c)
        for (const auto& weight : weights_) columns_[c].push_back(weight[c]);
}

std::vector<double> SpectralBasis::sample(const Spectrum& s) const {
    std::vector<double> values;
    values.reserve(lambda_nm_.size());
    for (const double lambda_nm : lambda_nm_) values.push_back(s.tent_mean(lambda_nm, step_nm_));
    return values;
}

std::vector<double> SpectralBasis::exact_factor(const Spectrum& s) const {
    if (illuminant_) {
        assert(s.is_constant());
        return {s.at(kLambdaMin_nm)};
    }
    return lambda_nm_.empty() ? not_negative(rec709_of_reflectance(s)) : sample(s);
}

std::vector<float> SpectralBasis::factor(const Spectrum& s) const {
    return to_floats(exact_factor(s));
}

std::vector<float> SpectralBasis::emission(const Spectrum& s) const {
    if (illuminant_) {
        const auto [base, factor] = s.as_multiple();
        assert(base == illuminant_ || factor == 0);
        return {base == illuminant_ ? static_cast<float>(factor) : 0.0F};
    }
    if (!lambda_nm_.empty()) return to_floats(sample(s));
    const Xyz colour = xyz_of(s);
    return to_floats(not_negative(xyz_to_rec709() * std::array{colour.x, colour.y, colour.z}));
}

Xyz SpectralBasis::to_xyz(const float* radiance) const {
    std::array<std::array<double, kLanes>, 3> lanes{};
    const std::size_t whole = size() - size() % kLanes;
    for (std::size_t i = 0; i < whole; i += kLanes)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                lanes[c][lane] += columns_[c][i + lane] * static_cast<double>(radiance[i + lane]);
    for (std::size_t i = whole; i < size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            lanes[c][i - whole] += columns_[c][i] * static_cast<double>(radiance[i]);
    const auto sum = [](const std::array<double, kLanes>& v) {
        return (v[0] + v[1]) + (v[2] + v[3]);
    };
    return {sum(lanes[0]), sum(lanes[1]), sum(lanes[2])};
}

}  // namespace bouguer::renderer
