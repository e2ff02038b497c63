// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

// CODATA 2018; all three are exact.
constexpr double kPlanck_J_s = 6.62607015e-34;
constexpr double kLightSpeed_m_per_s = 299792458;
constexpr double kBoltzmann_J_per_K = 1.380649e-23;
constexpr double kReference_nm = 560;

/// h c / (lambda k T)
double exponent(double lambda_m, double temperature_K) {
    return kPlanck_J_s * kLightSpeed_m_per_s / (lambda_m * kBoltzmann_J_per_K * temperature_K);
}

/// Planck's law over its value at 560 nm.
class BlackbodySpectrum final : public Spectrum {
  public:
    explicit BlackbodySpectrum(double temperature_K) : temperature_K_(temperature_K) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        const double x = exponent(lambda_nm * 1e-9, temperature_K_);
        const double x0 = exponent(kReference_nm * 1e-9, temperature_K_);
        // (e^x0 - 1) / (e^x - 1) = e^(x0 - x) (1 - e^-x0) / (1 - e^-x): x alone may overflow.
        const double ratio = std::exp(x0 - x) * std::expm1(-x0) / std::expm1(-x);
        return std::pow(kReference_nm / lambda_nm, 5) * ratio;
    }

  private:
    double temperature_K_;
};

/// Planck's law as a radiance.
class BlackbodyRadiance final : public Spectrum {
  public:
    explicit BlackbodyRadiance(double temperature_K) : temperature_K_(temperature_K) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        return planck_W_per_m3_sr(lambda_nm, temperature_K_) * 1e-9;  // per nm, not per m
    }

  private:
    double temperature_K_;
};

tl::unexpected<Error> refuse(std::string_view code, std::string detail, std::string allowed) {
    Problem problem{"/blackbody_K", std::string(code), std::move(detail), "", std::move(allowed)};
    return tl::unexpected<Error>(
        Error{ErrorKind::InvalidInput, problem.detail, {std::move(problem)}, {}});
}

}  // namespace

double planck_W_per_m3_sr(double lambda_nm, double temperature_K) {
    const double lambda_m = lambda_nm * 1e-9;
    const double c1 = 2 * kPlanck_J_s * kLightSpeed_m_per_s * kLightSpeed_m_per_s;
    return c1 / std::pow(lambda_m, 5) / std::expm1(exponent(lambda_m, temperature_K));
}

Result<SpectrumPtr> blackbody_spectrum(double temperature_K) {
    if (temperature_K >= kBlackbodyMin_K && temperature_K <= kBlackbodyMax_K)
        return std::make_shared<BlackbodySpectrum>(temperature_K);
    std::string detail = "a black body's temperature must be in [100, 1e9] K";
    if (temperature_K > 0 && temperature_K < kBlackbodyMin_K)
        detail +=
            ": a colder one gives so little at 560 nm that its spectrum relative to that overflows";
    return refuse(std::isfinite(temperature_K) ? "out-of-range" : "not-finite", std::move(detail),
                  "a number in [100, 1e9]");
}

Result<SpectrumPtr> blackbody_radiance_spectrum(double temperature_K) {
    if (temperature_K > 0 && temperature_K <= kBlackbodyMax_K)
        return std::make_shared<BlackbodyRadiance>(temperature_K);
    return refuse(std::isfinite(temperature_K) ? "out-of-range" : "not-finite",
                  "a black body's temperature must be above 0 and at most 1e9 K",
                  "a number in (0, 1e9]");
}

}  // namespace bouguer::renderer
