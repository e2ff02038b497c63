// SPDX-License-Identifier: Apache-2.0
#include "api/job_reader.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/camera_reader.h"
#include "api/output_reader.h"
#include "renderer/integrators/integrator_registry.h"
#include "renderer/scene/scene_white.h"
#include "renderer/spectrum/observer.h"

namespace bouguer::api {
namespace {

constexpr Interval kWavelengthStep_nm{1, 100};
constexpr Interval kFilterRadius{0, 16, true};
constexpr Interval kRelativeError{1e-6, 1};
constexpr std::int64_t kLargestSeed = 1LL << 53;
constexpr std::int64_t kHighestPriority = 100;
constexpr std::uint32_t kDefaultSamples = 16;

/// filter: type box | triangle | gaussian, radius in pixels, (0, 16]; default gaussian of 1.5, and
/// 0.5 and 1 for the others.
renderer::Filter read_filter(const JsonValue& value) {
    JsonReader reader(value);
    const std::string_view type =
        reader.one_of("type", {"box", "triangle", "gaussian"}, "gaussian");
    renderer::Filter filter;
    if (type == "box") filter = {renderer::FilterType::Box, 0.5};
    if (type == "triangle") filter = {renderer::FilterType::Triangle, 1};
    filter.radius = reader.number("radius", kFilterRadius, filter.radius);
    reader.reject_unknown_keys();
    return filter;
}

/// integrator: type hall | rgb, max_depth, min_throughput, wavelength_step_nm and observer (hall),
/// filter, replicates.
void read_integrator(const JsonValue& value, const Limits& limits,
                     renderer::RenderSettings& settings) {
    JsonReader reader(value);
    if (!reader.is_object()) return;
    const auto names = renderer::integrator_names();
    settings.integrator = renderer::find_integrator(reader.one_of("type", names, names.front()))
                              .value_or(settings.integrator);
    settings.max_depth = static_cast<int>(
        reader.integer("max_depth", 0, limits.max_depth, settings.max_depth, true));
    settings.min_throughput = reader.number("min_throughput", kUnit, settings.min_throughput);
    if (settings.integrator == renderer::IntegratorType::Hall) {
        settings.wavelength_step_nm =
            reader.number("wavelength_step_nm", kWavelengthStep_nm, settings.wavelength_step_nm);
        settings.observer =
            reader.one_of("observer", renderer::observer_names(), settings.observer);
    }
    if (const auto at = reader.find("filter")) settings.filter = read_filter(*at);
    settings.replicates =
        static_cast<int>(reader.integer("replicates", 2, 64, settings.replicates));
    reader.reject_unknown_keys();
}

/// stop: samples, seconds, error; at least one of them.
renderer::StopRule read_stop(const JsonValue& value, const Limits& limits) {
    renderer::StopRule stop;
    JsonReader reader(value);
    if (!reader.is_object()) return stop;
    if (const auto at = reader.find("samples")) {
        const auto samples = at->integer(1, limits.samples, true);
        if (samples) stop.samples = static_cast<std::uint32_t>(*samples);
    }
    if (const auto at = reader.find("seconds")) {
        stop.seconds = at->number({0, limits.seconds, true, false, true});
    }
    if (const auto at = reader.find("error")) stop.error = at->number(kRelativeError);
    if (value.json().size() == 0) {
        value.report("missing", "a stop rule needs a condition",
                     "at least one of \"samples\", \"seconds\" and \"error\"");
    }
    reader.reject_unknown_keys();
    return stop;
}

/// crop: [x, y, width, height] in pixels, inside the picture; row 0 is on top.
std::optional<renderer::Crop> read_crop(const JsonValue& value, renderer::Resolution whole,
                                        bool is_resolution_good) {
    if (!value.is_tuple(4, "numbers")) return std::nullopt;
    const std::int64_t right = is_resolution_good ? whole.width : INT32_MAX;
    const std::int64_t bottom = is_resolution_good ? whole.height : INT32_MAX;
    const auto x = value.element(0).integer(0, right - 1);
    const auto y = value.element(1).integer(0, bottom - 1);
    const auto width = value.element(2).integer(1, x ? right - *x : INT32_MAX);
    const auto height = value.element(3).integer(1, y ? bottom - *y : INT32_MAX);
    if (!x || !y || !width || !height) return std::nullopt;
    return renderer::Crop{static_cast<int>(*x), static_cast<int>(*y), static_cast<int>(*width),
                          static_cast<int>(*height)};
}

/// output: resolution (the camera's by default), crop, and how the film is shown and stored.
void read_output(const JsonValue& value, const Limits& limits, JobRequest& job) {
    JsonReader reader(value);
    if (!reader.is_object()) return;
    bool is_resolution_good = true;
    if (const auto at = reader.find("resolution")) {
        const auto resolution = read_resolution(*at, limits);
        is_resolution_good = resolution.has_value();
        job.settings.resolution = resolution.value_or(job.settings.resolution);
    }
    if (const auto at = reader.find("crop")) {
        job.settings.crop = read_crop(*at, job.settings.resolution, is_resolution_good);
    }
    read_output(reader, OutputScope::Files, job.output);
    reader.reject_unknown_keys();
}

std::map<std::string, std::string> read_labels(const JsonValue& value, const Limits& limits) {
    std::map<std::string, std::string> labels;
    if (!value.json().is_object()) {
        value.report_type("an object of strings");
        return labels;
    }
    if (value.json().size() > limits.labels) {
        value.report("over-limit", "there are too many labels",
                     "at most " + std::to_string(limits.labels) + " labels");
        return labels;
    }
    for (const auto& [name, json] : value.json().members()) {
        labels[std::string(name)] = value.member(name).text(limits.name_bytes).value_or("");
    }
    return labels;
}

/// Whether pixels x samples stays within the limit; a render without `samples` ends where it is
/// reached.
void limit_samples(const JsonReader& reader, const Limits& limits, JobRequest& job) {
    const renderer::Resolution whole = job.settings.resolution;
    const auto crop = job.settings.crop.value_or(renderer::Crop{0, 0, whole.width, whole.height});
    const double pixels = static_cast<double>(crop.width) * crop.height;
    const double most =
        std::min(static_cast<double>(limits.samples), std::floor(limits.pixel_samples / pixels));
    if (!job.stop.samples) job.stop.samples = static_cast<std::uint32_t>(std::max(1.0, most));
    if (*job.stop.samples <= most) return;
    Problems& problems = reader.value().problems();
    problems.add({reader.value().pointer() + "/stop/samples", "over-limit",
                  "pixels x samples is too much work for one job",
                  number_text(pixels * *job.stop.samples) + " samples in all",
                  "at most " + number_text(limits.pixel_samples) + ", which is " +
                      number_text(most) + " a pixel here"});
}

}  // namespace

void read_job_settings(JsonReader& reader, const Limits& limits, JobRequest& job) {
    job.settings.resolution = job.scene.resolution;
    // Of a scene that is refused nothing is known, so its adaptation is not blamed for it.
    const bool is_scene_good = reader.value().problems().empty();
    job.output.scene_white =
        is_scene_good ? renderer::scene_white(job.scene) : renderer::Chromaticity{1.0 / 3, 1.0 / 3};
    if (const auto at = reader.find("integrator")) read_integrator(*at, limits, job.settings);
    if (const auto at = reader.find("stop")) {
        job.stop = read_stop(*at, limits);
    } else {
        job.stop.samples = kDefaultSamples;
    }
    if (const auto at = reader.find("output")) read_output(*at, limits, job);
    job.settings.seed = static_cast<std::uint64_t>(reader.integer("seed", 0, kLargestSeed, 1));
    job.priority =
        static_cast<int>(reader.integer("priority", -kHighestPriority, kHighestPriority, 0));
    if (const auto at = reader.find("labels")) job.labels = read_labels(*at, limits);
    limit_samples(reader, limits, job);
}

}  // namespace bouguer::api
