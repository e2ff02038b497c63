// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/colour_difference.h"

#include <cmath>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {
namespace {

constexpr double kEpsilon = 216.0 / 24389;  // (6/29)^3
constexpr double kKappa = 24389.0 / 27;     // (29/3)^3
constexpr double kOpposite_deg = 180 + 1e-9;

double cos_deg(double angle_deg) { return std::cos(degrees_to_radians(angle_deg)); }
double sin_deg(double angle_deg) { return std::sin(degrees_to_radians(angle_deg)); }

/// Hue angle in [0, 360); 0 for a grey.
double hue_deg(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const double h = std::atan2(b, a) * (180 / kPi);
    return h < 0 ? h + 360 : h;
}

/// C^7 / (C^7 + 25^7)
double chroma_share(double chroma) {
    const double c7 = std::pow(chroma, 7);
    return c7 / (c7 + 6103515625.0);
}

/// h2 - h1 the short way round, equations 10.
double hue_step_deg(double h1, double h2) {
    const double step = h2 - h1;
    if (std::abs(step) <= kOpposite_deg) return step;
    return step > 0 ? step - 360 : step + 360;
}

/// The hue halfway, equations 14.
double mean_hue_deg(double h1, double h2) {
    const double sum = h1 + h2;
    if (std::abs(h1 - h2) <= kOpposite_deg) return sum / 2;
    return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

}  // namespace

double lab_f(double ratio) {
    return ratio > kEpsilon ? std::cbrt(ratio) : (kKappa * ratio + 16) / 116;
}

double lab_f_derivative(double ratio) {
    return ratio > kEpsilon ? 1 / (3 * std::cbrt(ratio * ratio)) : kKappa / 116;
}

Lab lab_of(Xyz c, Xyz white) {
    const double fx = lab_f(c.x / white.x), fy = lab_f(c.y / white.y), fz = lab_f(c.z / white.z);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

double delta_e_1976(const Lab& a, const Lab& b) {
    return std::hypot(a.L - b.L, a.a - b.a, a.b - b.b);
}

double delta_e_2000(const Lab& a, const Lab& b) {
    // The axis a* is stretched for colours of little chroma.
    const double mean_ab_chroma = (std::hypot(a.a, a.b) + std::hypot(b.a, b.b)) / 2;
    const double stretch = 1.5 - 0.5 * std::sqrt(chroma_share(mean_ab_chroma));
    const double c1 = std::hypot(stretch * a.a, a.b), c2 = std::hypot(stretch * b.a, b.b);
    const double h1 = hue_deg(stretch * a.a, a.b), h2 = hue_deg(stretch * b.a, b.b);

    // Differences; a grey has no hue to differ in.
    const bool has_hues = c1 * c2 != 0;
    const double d_lightness = b.L - a.L;
    const double d_chroma = c2 - c1;
    const double d_hue = has_hues ? 2 * std::sqrt(c1 * c2) * sin_deg(hue_step_deg(h1, h2) / 2) : 0;

    // Weights at the mean of the two.
    const double l = (a.L + b.L) / 2 - 50, c = (c1 + c2) / 2;
    const double h = has_hues ? mean_hue_deg(h1, h2) : h1 + h2;
    const double t = 1 - 0.17 * cos_deg(h - 30) + 0.24 * cos_deg(2 * h) +
                     0.32 * cos_deg(3 * h + 6) - 0.20 * cos_deg(4 * h - 63);
    const double s_l = 1 + 0.015 * l * l / std::sqrt(20 + l * l);
    const double s_c = 1 + 0.045 * c;
    const double s_h = 1 + 0.015 * c * t;
    const double turn_deg = 30 * std::exp(-((h - 275) / 25) * ((h - 275) / 25));
    const double r_t = -sin_deg(2 * turn_deg) * 2 * std::sqrt(chroma_share(c));

    const double vl = d_lightness / s_l, vc = d_chroma / s_c, vh = d_hue / s_h;
    return std::sqrt(vl * vl + vc * vc + vh * vh + r_t * vc * vh);
}

}  // namespace bouguer::renderer
