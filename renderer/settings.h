// SPDX-License-Identifier: Apache-2.0
// How a scene is to be rendered, when to stop, and what to make of the film.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/scene/description.h"
#include "renderer/spectrum/chromatic_adaptation.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {

enum class IntegratorType { Hall, Rgb };

/// Part of the picture, in pixels; row 0 is on top.
struct Crop {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Crop&) const = default;
};

enum class FilterType { Box, Triangle, Gaussian };

/// Reconstruction filter, by its radius in pixels. Samples are drawn from it (filter importance
/// sampling), so each belongs to one pixel and pixels are independent.
struct Filter {
    FilterType type = FilterType::Gaussian;
    Real radius = 1.5;
    bool operator==(const Filter&) const = default;
};

/// What decides the value of every sample. Equal scene and equal settings give equal bytes.
struct RenderSettings {
    IntegratorType integrator = IntegratorType::Hall;
    int max_depth = 64;  ///< reflections and refractions in a row, [0, 1000]
    /// A ray is not followed when what it may add to a sample, judged by the brightest light that
    /// the sample and the scene have shown, is less than this share of what the sample has found.
    Real min_throughput = 1e-3;
    Real wavelength_step_nm = 5;         ///< quadrature, [1, 100]
    std::string observer = "cie1931-2";  ///< one of observers(); XYZ is his
    Filter filter;
    int replicates = 16;  ///< independent randomisations, for the error estimate, [2, 64]
    std::uint64_t seed = 1;
    Resolution resolution;
    std::optional<Crop> crop;  ///< inside the resolution
    bool specialise = true;    ///< let the plan choose a kernel; false runs the general one
};

/// Whichever comes first. At least one is set.
struct StopRule {
    std::optional<std::uint32_t> samples;  ///< a pixel
    std::optional<double> seconds;         ///< of wall time since rendering began
    std::optional<double> error;  ///< relative RMSE; reached when the interval's upper end is below
    std::optional<double>
        limit_s{};  ///< as `seconds`, but set by whoever runs the render for others
};

/// What the channels of an EXR file are; all linear, and colorimetric: nothing is adapted.
enum class FileColour { Rec709, Xyz, DisplayP3, AcesCg };

/// "rec709", "xyz", "display-p3", "acescg", in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> kFileColourNames{"rec709", "xyz", "display-p3",
                                                                  "acescg"};

/// How the film is shown and stored.
struct OutputSettings {
    std::string display = "srgb";
    std::optional<double>
        exposure;  ///< factor on XYZ before the display; empty: the 99th percentile of Y becomes 1
    Adaptation adaptation = Adaptation::None;  ///< from the white below to the display's white
    std::optional<Chromaticity> white;  ///< that the viewer takes for white; empty: `scene_white`
    std::optional<Chromaticity> scene_white;  ///< of the scene's light, where that has one colour
    GamutMapping gamut = GamutMapping::Clip;  ///< for what the display cannot show
    FileColour exr_colour = FileColour::Rec709;

    /// What adaptation starts from. Empty: nothing says what is white, and nothing can be adapted.
    [[nodiscard]] std::optional<Chromaticity> adapted_white() const {
        return white ? white : scene_white;
    }
};

}  // namespace bouguer::renderer
