// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/smooth_reflectance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/colour_difference.h"
#include "renderer/spectrum/quadrature.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

using Triple = std::array<double, 3>;

double normalised(double lambda_nm) {
    return (lambda_nm - kLambdaMin_nm) / (kLambdaMax_nm - kLambdaMin_nm);
}

double sigmoid(double x) { return 0.5 + 0.5 * x / std::sqrt(1 + x * x); }

double sigmoid_derivative(double x) { return 0.5 / ((1 + x * x) * std::sqrt(1 + x * x)); }

/// What a reflectance of 1 at a wavelength adds to linear Rec.709 under D65; each channel sums
/// to 1.
struct RgbNode {
    double t;
    Triple weight;
};

std::vector<RgbNode> make_rgb_nodes() {
    const SpectrumPtr d65 = library_spectrum("D65");
    std::vector<RgbNode> nodes;
    Triple sum{};
    for (const QuadratureNode& node : quadrature(1)) {
        const Xyz c = node.weight * d65->at(node.lambda_nm);
        nodes.push_back({normalised(node.lambda_nm), xyz_to_rec709() * Triple{c.x, c.y, c.z}});
        for (std::size_t i = 0; i < 3; ++i) sum[i] += nodes.back().weight[i];
    }
    for (RgbNode& node : nodes)
        for (std::size_t i = 0; i < 3; ++i) node.weight[i] /= sum[i];
    return nodes;
}

const std::vector<RgbNode>& rgb_nodes() {
    static const std::vector<RgbNode> nodes = make_rgb_nodes();
    return nodes;
}

/// X/Xn, Y/Yn, Z/Zn of linear Rec.709 with white (1, 1, 1).
Matrix3 relative_xyz_matrix() {
    Matrix3 m = rec709_to_xyz();
    for (Triple& row : m) {
        const double white = row[0] + row[1] + row[2];
        for (double& v : row) v /= white;
    }
    return m;
}

constexpr Matrix3 kLabFromF{{{0, 116, 0}, {500, -500, 0}, {0, 200, -200}}};

/// L*a*b* of linear Rec.709, whose white is (1, 1, 1).
Triple lab_of(const Triple& linear_rgb) {
    const auto [x, y, z] = relative_xyz_matrix() * linear_rgb;
    const Lab lab = renderer::lab_of(Xyz{x, y, z}, Xyz{1, 1, 1});
    return {lab.L, lab.a, lab.b};
}

/// Colour of the reflectance with coefficients c, and its derivatives by them.
struct Linearisation {
    Triple rgb{};
    Matrix3 d_rgb_d_c{};
};

Linearisation linearise(const Triple& c) {
    Linearisation l;
    for (const auto& [t, weight] : rgb_nodes()) {
        const double x = (c[0] * t + c[1]) * t + c[2];
        const double s = sigmoid(x), ds = sigmoid_derivative(x);
        const Triple d_x{t * t, t, 1};
        for (std::size_t i = 0; i < 3; ++i) {
            l.rgb[i] += weight[i] * s;
            for (std::size_t j = 0; j < 3; ++j) l.d_rgb_d_c[i][j] += weight[i] * ds * d_x[j];
        }
    }
    return l;
}

/// d Lab / d c.
Matrix3 lab_jacobian(const Linearisation& l) {
    const Matrix3 to_xyz = relative_xyz_matrix();
    const Triple xyz = to_xyz * l.rgb;
    Matrix3 d_f = to_xyz * l.d_rgb_d_c;
    for (std::size_t i = 0; i < 3; ++i)
        for (double& v : d_f[i]) v *= lab_f_derivative(xyz[i]);
    return kLabFromF * d_f;
}

double squared(const Triple& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// The step of Levenberg and Marquardt: (J^T J + damping diag(J^T J)) step = J^T residual.
Triple damped_step(const Matrix3& j, const Triple& residual, double damping) {
    Matrix3 transposed{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) transposed[r][c] = j[c][r];
    Matrix3 normal = transposed * j;
    for (std::size_t i = 0; i < 3; ++i) normal[i][i] += damping * normal[i][i] + 1e-12;
    return inverse(normal) * (transposed * residual);
}

/// Moves c towards the colour `target` until nothing more is gained.
Triple improve(Triple c, const Triple& target_rgb) {
    const Triple target = lab_of(target_rgb);
    Linearisation here = linearise(c);
    double error = squared(minus(target, lab_of(here.rgb)));
    double damping = 1e-3;
    constexpr double kGoodEnough = 1e-18;  // Lab units squared
    for (int iteration = 0; iteration < 60 && error > kGoodEnough && damping < 1e9; ++iteration) {
        const Triple step =
            damped_step(lab_jacobian(here), minus(target, lab_of(here.rgb)), damping);
        const Triple next{c[0] + step[0], c[1] + step[1], c[2] + step[2]};
        const Linearisation there = linearise(next);
        const double next_error = squared(minus(target, lab_of(there.rgb)));
        if (next_error < error) {
            const bool has_stalled = next_error > error * (1 - 1e-9);
            c = next, here = there, error = next_error;
            damping *= 0.1;
            if (has_stalled) break;
        } else {
            damping *= 10;
        }
    }
    return c;
}

}  // namespace

double SmoothReflectance::at(double lambda_nm) const {
    const double t = normalised(lambda_nm);
    return sigmoid((c_[0] * t + c_[1]) * t + c_[2]);
}

Triple rec709_of_reflectance(const Spectrum& reflectance) {
    if (reflectance.is_constant()) {
        const double value = reflectance.at(kLambdaMin_nm);
        return {value, value, value};
    }
    Triple rgb{};
    for (const auto& [t, weight] : rgb_nodes()) {
        const double value = reflectance.at(kLambdaMin_nm + t * (kLambdaMax_nm - kLambdaMin_nm));
        for (std::size_t i = 0; i < 3; ++i) rgb[i] += weight[i] * value;
    }
    return rgb;
}

double delta_e_2000(const Triple& linear_a, const Triple& linear_b) {
    const auto [La, aa, ba] = lab_of(linear_a);
    const auto [Lb, ab, bb] = lab_of(linear_b);
    return renderer::delta_e_2000(Lab{La, aa, ba}, Lab{Lb, ab, bb});
}

Triple fit_smooth_reflectance(const Triple& linear_rgb) {
    // Start at the grey of the same mean, whose coefficients are known, and lead the colour in.
    constexpr double kMargin = 1e-3;
    const double grey =
        std::clamp((linear_rgb[0] + linear_rgb[1] + linear_rgb[2]) / 3, kMargin, 1 - kMargin);
    const double s = 2 * grey - 1;
    Triple c{0, 0, s / std::sqrt(1 - s * s)};
    for (const double share : {0.3, 0.6, 0.8, 0.9, 0.97, 1.0}) {
        Triple target{};
        for (std::size_t i = 0; i < 3; ++i) target[i] = grey + share * (linear_rgb[i] - grey);
        c = improve(c, target);
    }
    return c;
}

}  // namespace bouguer::renderer
