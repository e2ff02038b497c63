// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/refractive_index.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {
namespace {

constexpr std::size_t kMaxTerms = 8;

double inverse_square_um(double lambda_nm) {
    const double lambda_um = lambda_nm * 1e-3;
    return 1 / (lambda_um * lambda_um);
}

class SellmeierIndex final : public Spectrum {
  public:
    SellmeierIndex(const std::vector<double>& b, const std::vector<double>& c_um2) {
        for (std::size_t i = 0; i < b.size(); ++i) {
            if (b[i] == 0) continue;  // it would be 0 / 0 at its pole
            b_.push_back(b[i]);
            c_um2_.push_back(c_um2[i]);
        }
    }

    [[nodiscard]] double at(double lambda_nm) const override {
        double n2 = 1;
        for (std::size_t i = 0; i < b_.size(); ++i)
            n2 += b_[i] / (1 - c_um2_[i] * inverse_square_um(lambda_nm));
        return std::sqrt(n2);
    }

  private:
    std::vector<double> b_, c_um2_;
};

class CauchyIndex final : public Spectrum {
  public:
    explicit CauchyIndex(std::vector<double> coefficients_um)
        : coefficients_(std::move(coefficients_um)) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        const double x = inverse_square_um(lambda_nm);
        double n = 0;
        for (std::size_t i = coefficients_.size(); i-- > 0;) n = n * x + coefficients_[i];
        return n;
    }

  private:
    std::vector<double> coefficients_;
};

tl::unexpected<Error> refuse(std::vector<Problem> problems) {
    return tl::unexpected<Error>(
        Error{ErrorKind::InvalidInput, "not an index of refraction", std::move(problems), {}});
}

void check_coefficients(const std::string& pointer, const std::vector<double>& values,
                        std::vector<Problem>& problems) {
    if (values.empty() || values.size() > kMaxTerms)
        problems.push_back({pointer, "wrong-count", "a formula has one to eight terms",
                            std::to_string(values.size()), "one to eight numbers"});
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            problems.push_back({pointer + "/" + std::to_string(i), "not-finite",
                                "a coefficient must be finite", std::to_string(values[i]),
                                "a finite number"});
}

/// The spectrum, or the first wavelength of the rendered range where it is no index.
Result<SpectrumPtr> checked_index(SpectrumPtr index, const std::string& pointer) {
    for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; ++lambda_nm) {
        const double n = index->at(lambda_nm);
        if (n >= kIndexMin && n <= kIndexMax) continue;
        return refuse({{pointer, "out-of-range",
                        "the index must stay in [1, 10] from 360 to 830 nm; at " +
                            std::to_string(static_cast<int>(lambda_nm)) + " nm it does not",
                        std::to_string(n), "an index in [1, 10]"}});
    }
    return index;
}

/// Where a term of Sellmeier's formula is infinite: poles in (or at the ends of) the range.
void check_poles(const std::vector<double>& b, const std::vector<double>& c_um2,
                 std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < c_um2.size() && i < b.size(); ++i) {
        if (b[i] == 0 || !(c_um2[i] > 0)) continue;
        const double pole_nm = 1000 * std::sqrt(c_um2[i]);
        if (pole_nm < kLambdaMin_nm || pole_nm > kLambdaMax_nm) continue;
        problems.push_back(
            {"/sellmeier_c_um2/" + std::to_string(i), "pole",
             "the formula is infinite at " + std::to_string(pole_nm) + " nm, in the rendered range",
             std::to_string(c_um2[i]), "a pole outside 360 to 830 nm"});
    }
}

}  // namespace

Result<SpectrumPtr> sellmeier_index(const std::vector<double>& b,
                                    const std::vector<double>& c_um2) {
    std::vector<Problem> problems;
    check_coefficients("/sellmeier_b", b, problems);
    check_coefficients("/sellmeier_c_um2", c_um2, problems);
    if (b.size() != c_um2.size())
        problems.push_back({"/sellmeier_c_um2", "length-mismatch", "every term has a b and a c",
                            std::to_string(c_um2.size()), std::to_string(b.size()) + " numbers"});
    check_poles(b, c_um2, problems);
    if (!problems.empty()) return refuse(std::move(problems));
    return checked_index(std::make_shared<SellmeierIndex>(b, c_um2), "/sellmeier_b");
}

Result<SpectrumPtr> cauchy_index(std::vector<double> coefficients_um) {
    std::vector<Problem> problems;
    check_coefficients("/cauchy_um", coefficients_um, problems);
    if (!problems.empty()) return refuse(std::move(problems));
    if (coefficients_um.size() == 1)
        return checked_index(constant_spectrum(coefficients_um[0]), "/cauchy_um");
    return checked_index(std::make_shared<CauchyIndex>(std::move(coefficients_um)), "/cauchy_um");
}

Result<SpectrumPtr> abbe_index(double n_d, double v_d) {
    std::vector<Problem> problems;
    if (!(n_d >= kIndexMin && n_d <= kIndexMax))
        problems.push_back({"/n_d", std::isfinite(n_d) ? "out-of-range" : "not-finite",
                            "an index must be in [1, 10]", std::to_string(n_d),
                            "a number in [1, 10]"});
    if (!(std::isfinite(v_d) && v_d > 0))
        problems.push_back({"/v_d", std::isfinite(v_d) ? "out-of-range" : "not-finite",
                            "an Abbe number must be above 0", std::to_string(v_d),
                            "a number above 0"});
    if (!problems.empty()) return refuse(std::move(problems));
    const double dispersion = (n_d - 1) / v_d;  // n_F - n_C
    const double b = dispersion / (inverse_square_um(kLineF_nm) - inverse_square_um(kLineC_nm));
    const double a = n_d - b * inverse_square_um(kLineD_nm);
    return checked_index(std::make_shared<CauchyIndex>(std::vector{a, b}), "/v_d");
}

double abbe_number(const Spectrum& index) {
    const double dispersion = index.at(kLineF_nm) - index.at(kLineC_nm);
    if (dispersion == 0) return std::numeric_limits<double>::infinity();
    return (index.at(kLineD_nm) - 1) / dispersion;
}

}  // namespace bouguer::renderer
