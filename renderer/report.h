// SPDX-License-Identifier: Apache-2.0
// What is said about a render: its error against run time, its health, its plan. Plain data; api/
// writes it as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/warning.h"
#include "renderer/spectrum/spectrum_notes.h"

namespace bouguer::renderer {

/// A value with its 95 % interval.
struct Estimate {
    double value = 0, low = 0, high = 0;
    bool operator==(const Estimate&) const = default;
};

/// One point of the curve error(t), at the end of a pass.
struct ErrorPoint {
    double seconds = 0;         ///< of wall time since the render began
    std::uint32_t samples = 0;  ///< a pixel
    std::uint64_t rays = 0;     ///< traced in all
    std::optional<Estimate>
        rmse;  ///< pooled over pixels and X, Y, Z; empty: unknown (fewer than two replicates)
    std::optional<Estimate> relative_rmse;  ///< rmse over the mean of X, Y, Z over the picture
    bool few_events =
        false;  ///< the variance sits in so few pixels that the interval cannot be trusted
};

/// Where the claim stops: parts of the error that are not noise. No interval covers them.
struct Bias {
    double depth_limit_throughput = 0;  ///< mean weight in Y, a sample, of rays cut at max_depth
    double threshold_throughput = 0;    ///< likewise of rays below min_throughput
    /// Of the picture's light, what those rays may have carried, had each met the brightest that
    /// its sample met.
    double depth_limit_share = 0, threshold_share = 0;
    std::optional<double>
        wavelength_relative;  ///< largest relative error in X, Y or Z of the quadrature against 1
                              ///< nm, over the scene's own lamp x surface products; empty: not a
                              ///< quadrature (rgb)
    SpectrumNotes spectra{};  ///< of the document; the renderer itself leaves them empty
};

/// Rays that were inside an object and met its outside or an end elsewhere, or came out of it
/// without having been inside.
struct UnmatchedExits {
    std::string object;
    std::uint64_t count = 0;
};

struct RejectedSample {
    int x = 0, y = 0;
    std::uint32_t sample = 0;
    std::string kind;
};

/// A first pass that the time did not suffice for.
struct UnfinishedPass {
    std::uint64_t pixels = 0, without_sample = 0;  ///< the latter are black
};

/// The ledger: everything that did not reach the picture as it was computed.
struct Health {
    std::uint64_t samples = 0;  ///< offered to the film
    std::uint64_t rejected_nan = 0, rejected_infinite = 0, rejected_negative = 0;
    std::vector<RejectedSample> rejected;  ///< the first few, to replay
    std::uint64_t rays_cut_by_depth = 0, rays_cut_by_threshold = 0;
    std::uint64_t blackened_samples = 0;  ///< black because everything they led to was cut
    std::uint64_t unmatched_exits =
        0;  ///< rays that left a body they had not entered, or ended in one they had not left
    std::vector<UnmatchedExits> unmatched_objects;  ///< whose they are, in the scene's order
    std::uint64_t medium_stack_overflows = 0;  ///< more bodies inside each other than are tracked
    std::uint64_t shadow_rays_cut = 0;    ///< shadow rays that met more surfaces than are followed
    std::uint64_t total_reflections = 0;  ///< for information
    std::uint64_t dropped_triangles = 0;  ///< of zero area or doubled, left out
    std::optional<UnfinishedPass> unfinished_pass;  ///< that the picture is of; empty: a whole one
    [[nodiscard]] std::uint64_t rejected_total() const {
        return rejected_nan + rejected_infinite + rejected_negative;
    }
};

/// One thing that a scene may need.
struct PlanItem {
    std::string feature;  ///< "transparency", "absorption", "ambient", "wavelengths" ...
    bool needed = false;
    std::string reason;  ///< a sentence: why it is needed, or why it is left out
};

/// What the scene needs, what is left out, and the kernel chosen.
struct Plan {
    std::vector<PlanItem> items;
    std::string kernel;               ///< e.g. "hall<transparency=0,ambient=1>"
    std::string basis;                ///< "wavelengths", "grey" or "rgb"
    std::size_t values_per_path = 0;  ///< how many numbers a path carries
    std::uint64_t triangles = 0;
    std::size_t objects = 0, lights = 0;
    std::uint64_t memory_bytes_estimate = 0;  ///< film and geometry
};

struct Timings {
    double scene_s = 0, render_s = 0, output_s = 0;
};

/// What a display made of a picture.
struct ImageInfo {
    double exposure = 1;                    ///< used by the display
    std::uint64_t clipped_pixels = 0;       ///< outside the display's range, for either reason:
    std::uint64_t out_of_gamut_pixels = 0;  ///< outside the triangle of its primaries
    std::uint64_t over_range_pixels = 0;    ///< brighter than one of its channels can be
};

/// What came of a render.
struct Report {
    std::vector<ErrorPoint> error;
    Bias bias;
    Health health;
    Plan plan;
    Warnings warnings;  ///< of the document, which the renderer leaves to its reader, and of the
                        ///< picture
    Timings timings;
    std::string stopped_by;  ///< "samples", "seconds", "error", "cancel", "server-limit"; empty
                             ///< while it runs
    ImageInfo image;         ///< of the newest PNG
};

/// What the picture itself gives cause to warn of: light that was cut, pixels that cuts blackened,
/// bodies that rays lost track of.
[[nodiscard]] Warnings warnings_of(const Report& report);

}  // namespace bouguer::renderer
