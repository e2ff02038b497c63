// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/colour.h"

#include <cmath>

#include "renderer/spectrum/quadrature.h"

namespace bouguer::renderer {
namespace {

/// Sum over the nodes of weight x value(lambda).
template <class Value>
Xyz integrate(double step_nm, const Observer& observer, Value value) {
    Xyz sum;
    for (const QuadratureNode& node : quadrature(step_nm, observer))
        sum += node.weight * value(node.lambda_nm);
    return sum;
}

}  // namespace

Chromaticity chromaticity(Xyz c) {
    const double sum = c.x + c.y + c.z;
    return sum == 0 ? Chromaticity{} : Chromaticity{c.x / sum, c.y / sum};
}

std::array<double, 3> operator*(const Matrix3& m, const std::array<double, 3>& v) {
    std::array<double, 3> product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
    Matrix3 product{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    return product;
}

Matrix3 inverse(const Matrix3& m) {
    // Element (i, j) of the inverse is the cofactor of (j, i) over the determinant; taking rows and
    // columns round the corner gives the cofactor its sign.
    const auto cofactor = [&](std::size_t row, std::size_t column) {
        const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3;
        const std::size_t c1 = (column + 1) % 3, c2 = (column + 2) % 3;
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const double determinant =
        m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    Matrix3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = cofactor(j, i) / determinant;
    return result;
}

std::array<double, 3> cie1931(double lambda_nm) { return standard_observer().at(lambda_nm); }

std::vector<QuadratureNode> quadrature(double step_nm, const Observer& observer) {
    // The last node may miss 830 by the rounding of the step only.
    const auto intervals =
        static_cast<std::size_t>((kLambdaMax_nm - kLambdaMin_nm) / step_nm + 1e-9);
    std::vector<QuadratureNode> nodes(intervals + 1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].lambda_nm =
            std::min(kLambdaMin_nm + static_cast<double>(i) * step_nm, kLambdaMax_nm);
        const auto [x, y, z] = observer.at(nodes[i].lambda_nm);
        nodes[i].weight = Xyz{x, y, z} * (step_nm / observer.y_integral_nm());
    }
    return nodes;
}

Xyz xyz_of(const Spectrum& radiance, double step_nm, const Observer& observer) {
    return integrate(step_nm, observer,
                     [&](double lambda_nm) { return radiance.tent_mean(lambda_nm, step_nm); });
}

Xyz xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant, double step_nm,
                       const Observer& observer) {
    const Xyz colour = integrate(step_nm, observer, [&](double lambda_nm) {
        return reflectance.tent_mean(lambda_nm, step_nm) * illuminant.tent_mean(lambda_nm, step_nm);
    });
    return colour * (1 / xyz_of(illuminant, step_nm, observer).y);
}

Matrix3 rgb_to_xyz(Chromaticity red, Chromaticity green, Chromaticity blue, Chromaticity white) {
    // Not at unit luminance: primaries of y = 0, those of XYZ itself, have none.
    const std::array primaries{red, green, blue};
    Matrix3 m{};
    for (std::size_t j = 0; j < 3; ++j) {
        const Chromaticity c = primaries[j];
        const std::array xyz{c.x, c.y, 1 - c.x - c.y};
        for (std::size_t i = 0; i < 3; ++i) m[i][j] = xyz[i];
    }
    const std::array<double, 3> amount =
        inverse(m) * std::array{white.x / white.y, 1.0, (1 - white.x - white.y) / white.y};
    for (auto& row : m)
        for (std::size_t j = 0; j < 3; ++j) row[j] *= amount[j];
    return m;
}

const Matrix3& rec709_to_xyz() {
    static const Matrix3 matrix =
        rgb_to_xyz({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290});
    return matrix;
}

const Matrix3& xyz_to_rec709() {
    static const Matrix3 matrix = inverse(rec709_to_xyz());
    return matrix;
}

}  // namespace bouguer::renderer
