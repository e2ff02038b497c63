// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/fresnel.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "renderer/core/every_cpu.h"

namespace bouguer::renderer {
namespace {

[[gnu::always_inline]] inline double root(double x) { return std::sqrt(x); }
[[gnu::always_inline]] inline Float8 root(Float8 x) {
    // Through memory, as the compiler sees it: only loops over arrays become vector instructions.
    float lanes[kLanes];
    __builtin_memcpy(lanes, &x, sizeof x);
    for (float& lane : lanes) lane = std::sqrt(lane);
    __builtin_memcpy(&x, lanes, sizeof x);
    return x;
}

/// One formula for a number and for eight of them. a + i b is the square root of
/// w = (n + i k)^2 - sin^2, each part found where nothing cancels; with c the cosine and s the sine
///   R_s = |c - (a + i b)|^2 / |c + (a + i b)|^2
///   R_p = R_s |c (a + i b) - s^2|^2 / |c (a + i b) + s^2|^2
template <class Number>
[[gnu::always_inline]] inline Number reflectance(Number c, Number n, Number k) {
    const Number zero = c - c;
    const Number s2 = 1.0F - c * c;
    const Number re = (n - 1.0F) * (n + 1.0F) - k * k + c * c;
    const Number im = 2.0F * n * k;
    const Number magnitude = root(re * re + im * im);
    const Number greater = root((magnitude + (re < zero ? -re : re)) / 2.0F);  // of a and b
    const Number lesser = greater > zero ? im / (2.0F * greater) : zero;
    const Number a = re < zero ? lesser : greater;
    const Number b = re < zero ? greater : lesser;
    const Number b2 = b * b;
    const Number divisor = (c + a) * (c + a) + b2;
    const Number r_s = divisor > zero ? ((c - a) * (c - a) + b2) / divisor : zero;
    const Number away = c * a - s2, along = c * a + s2;
    const Number divisor_p = along * along + c * c * b2;  // 0 for an index of 0 only: padding
    const Number ratio = divisor_p > zero ? (away * away + c * c * b2) / divisor_p : zero;
    return (r_s + r_s * ratio) / 2.0F;
}

class NormalReflectance final : public Spectrum {
  public:
    explicit NormalReflectance(ComplexIndex index) : index_(std::move(index)) {}
    [[nodiscard]] double at(double lambda_nm) const override {
        return fresnel_reflectance(1, index_.n->at(lambda_nm), index_.k->at(lambda_nm));
    }
    [[nodiscard]] bool is_constant() const override {
        return index_.n->is_constant() && index_.k->is_constant();
    }

  private:
    ComplexIndex index_;
};

}  // namespace

double fresnel_reflectance(double cosine, double n, double k) { return reflectance(cosine, n, k); }

BOUGUER_FOR_EVERY_CPU
void fresnel_reflectances(Float8* to, double cosine, const Float8* n, const Float8* k,
                          std::size_t blocks) {
    const Float8 c = splat(static_cast<float>(std::clamp(cosine, 0.0, 1.0)));
    for (std::size_t i = 0; i < blocks; ++i) to[i] = reflectance(c, n[i], k[i]);
}

SpectrumPtr normal_reflectance(const ComplexIndex& index) {
    return std::make_shared<NormalReflectance>(index);
}

}  // namespace bouguer::renderer
