// SPDX-License-Identifier: Apache-2.0
// Reflectances from the colours of an sRGB display.
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "renderer/spectrum/display.h"
#include "renderer/spectrum/smooth_reflectance.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

using Triple = std::array<double, 3>;

/// Red, green and blue, 0 to 255, of the digits behind "#"; false: they are not such a colour.
bool read_hex(std::string_view digits, std::array<int, 3>& rgb) {
    const std::size_t width = digits.size() / 3;
    if (digits.size() != 3 && digits.size() != 6) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const char* begin = digits.data() + i * width;
        const auto [end, error] = std::from_chars(begin, begin + width, rgb[i], 16);
        if (error != std::errc{} || end != begin + width || *begin == '-') return false;
        if (width == 1) rgb[i] *= 17;  // "f" stands for "ff"
    }
    return true;
}

}  // namespace

Result<SpectrumPtr> srgb_spectrum(double r, double g, double b, double* round_trip_delta_e) {
    const Triple encoded{r, g, b};
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < 3; ++i)
        if (!(encoded[i] >= 0 && encoded[i] <= 1))
            problems.push_back({"/srgb/" + std::to_string(i),
                                std::isfinite(encoded[i]) ? "out-of-range" : "not-finite",
                                "an sRGB component must be in [0, 1]", std::to_string(encoded[i]),
                                "a number in [0, 1]"});
    if (!problems.empty())
        return tl::unexpected<Error>(
            Error{ErrorKind::InvalidInput, "not an sRGB colour", std::move(problems), {}});

    Triple linear = encoded;
    for (double& v : linear) v = srgb_decode(v);
    SpectrumPtr spectrum;
    if (r == g && g == b)
        spectrum = constant_spectrum(linear[0]);  // exact, black and white included
    else
        spectrum = std::make_shared<SmoothReflectance>(fit_smooth_reflectance(linear));
    if (round_trip_delta_e)
        *round_trip_delta_e = delta_e_2000(linear, rec709_of_reflectance(*spectrum));
    return spectrum;
}

Result<SpectrumPtr> hex_spectrum(std::string_view hex, double* round_trip_delta_e) {
    std::array<int, 3> rgb{};
    if (hex.starts_with('#') && read_hex(hex.substr(1), rgb))
        return srgb_spectrum(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0, round_trip_delta_e);
    Problem problem{"/hex", "bad-format", "not a colour in hexadecimal",
                    std::string(hex.substr(0, 20)), "\"#rgb\" or \"#rrggbb\""};
    return tl::unexpected<Error>(
        Error{ErrorKind::InvalidInput, problem.detail, {std::move(problem)}, {}});
}

}  // namespace bouguer::renderer
