// SPDX-License-Identifier: Apache-2.0
#include "api/spectrum_units.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/refractive_index.h"

namespace bouguer::api {
namespace {

/// Where the eye has more than a hundredth of its sensitivity, nearly.
constexpr Interval kSeen_nm{430, 680};

bool meets_range(double low_nm, double high_nm) {
    return high_nm >= renderer::kLambdaMin_nm && low_nm <= renderer::kLambdaMax_nm;
}

/// A unit that wavelengths or their inverses are told in: nm = factor x value, or factor / value.
struct Unit {
    const char* name;
    double factor;
    bool is_inverse;
    [[nodiscard]] double to_nm(double x) const { return is_inverse ? factor / x : factor * x; }
};
constexpr std::array kUnits{Unit{"micrometres", 1e3, false}, Unit{"metres", 1e9, false},
                            Unit{"Angstrom", 0.1, false}, Unit{"electronvolts", 1239.842, true},
                            Unit{"wavenumbers a centimetre", 1e7, true}};

/// "; as micrometres it would be 400 to 700 nm" for every unit that makes it visible.
std::string other_units(double low, double high) {
    std::string looks;
    for (const Unit& unit : kUnits) {
        const double a = unit.to_nm(low), b = unit.to_nm(high);
        if (!meets_range(std::min(a, b), std::max(a, b))) continue;
        looks += std::string(looks.empty() ? "; as " : ", as ") + unit.name + " it would be " +
                 number_text(std::min(a, b));
        if (a != b) looks += " to " + number_text(std::max(a, b));
        looks += " nm";
    }
    return looks;
}

void refuse(const JsonValue& at, const std::string& detail, const std::string& found) {
    at.problems().add({at.pointer(), "no-visible-sample", detail, found,
                       "wavelengths in nanometres, some of them from 360 to 830"});
}

}  // namespace

bool is_visible_table(const JsonValue& at, double first_nm, double last_nm) {
    if (meets_range(first_nm, last_nm)) return true;
    refuse(at,
           "no sample lies from 360 to 830 nm, so the whole table would count as one number" +
               other_units(first_nm, last_nm),
           number_text(first_nm) + " to " + number_text(last_nm));
    return false;
}

bool is_visible_peak(const JsonValue& at, double peak_nm) {
    constexpr Interval kOfLamps_nm{50, 3000};
    if (kOfLamps_nm.contains(peak_nm)) return true;
    if (const std::string looks = other_units(peak_nm, peak_nm); !looks.empty()) {
        refuse(at, "nothing of it lies from 360 to 830 nm" + looks, number_text(peak_nm));
        return false;
    }
    at.warn("far-from-visible", "nothing of it lies from 360 to 830 nm",
            "see that the wavelength is in nanometres");
    return true;
}

void warn_of_untold(const JsonValue& at, const std::vector<double>& wavelengths_nm,
                    const std::vector<double>& values) {
    const double low = values.front() == 0 ? kSeen_nm.low : wavelengths_nm.front();
    const double high = values.back() == 0 ? kSeen_nm.high : wavelengths_nm.back();
    const double told = std::min(high, kSeen_nm.high) - std::max(low, kSeen_nm.low);
    if (told < (kSeen_nm.high - kSeen_nm.low) / 2) {
        at.warn("unit-in-doubt",
                "the samples tell " + number_text(std::max(told, 0.0)) +
                    " nm of what is visible, 430 to 680 nm: the rest counts as the nearest of them",
                "see that wavelengths are in nanometres, or let the table begin and end with 0");
        return;
    }
    const bool is_told = std::any_of(wavelengths_nm.begin(), wavelengths_nm.end(), [](double nm) {
        return nm >= renderer::kLambdaMin_nm && nm <= renderer::kLambdaMax_nm;
    });
    if (is_told) return;
    at.warn("unit-in-doubt", "no sample lies from 360 to 830 nm: a straight line counts there",
            "see that wavelengths are in nanometres, or give samples there");
}

void warn_of_dispersion(const JsonValue& at, const renderer::Spectrum& index) {
    // Known solids, liquids and gases have from 8 (gallium phosphide is below) to 106 (fluorides).
    constexpr Interval kAbbeNumbers{4, 500};
    const double abbe = renderer::abbe_number(index);
    if (index.is_constant() || kAbbeNumbers.contains(abbe)) return;
    at.warn("unit-in-doubt",
            "the index disperses as no matter does: its Abbe number is " +
                (std::isfinite(abbe) ? number_text(std::round(abbe)) : "infinite"),
            "see that the formula's coefficients are for micrometres");
}

}  // namespace bouguer::api
