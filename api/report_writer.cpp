// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "api/error_curve.h"
#include "api/json_value.h"
#include "api/writers.h"
#include "renderer/render.h"

namespace bouguer::api {
namespace {

// nlohmann-json writes numbers that are not finite as null.
using OrderedJson = nlohmann::ordered_json;
using renderer::Estimate;
using renderer::Report;

std::string text_of(const OrderedJson& json) {
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

OrderedJson or_null(const std::optional<double>& value) {
    return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

OrderedJson estimate_object(const std::optional<Estimate>& estimate) {
    if (!estimate) return nullptr;
    return {{"value", estimate->value}, {"low", estimate->low}, {"high", estimate->high}};
}

OrderedJson point_object(const renderer::ErrorPoint& point) {
    return {{"seconds", point.seconds},
            {"samples", point.samples},
            {"rays", point.rays},
            {"rmse", estimate_object(point.rmse)},
            {"relative_rmse", estimate_object(point.relative_rmse)},
            {"few_events", point.few_events}};
}

/// `unit` names what the values are.
OrderedJson note_list(const renderer::SpectrumNoteList& notes, const std::string& unit) {
    OrderedJson worst = OrderedJson::array();
    for (const renderer::SpectrumNote& note : notes.worst()) {
        worst.push_back({{"pointer", note.where}, {unit, note.value}});
    }
    return {{"count", notes.count()}, {"largest_" + unit, notes.largest()}, {"worst", worst}};
}

OrderedJson notes_object(const renderer::SpectrumNotes& notes) {
    return {{"uplift", note_list(notes.uplift, "delta_e_2000")},
            {"outside_range", note_list(notes.outside_range, "share")}};
}

OrderedJson bias_object(const renderer::Bias& bias) {
    OrderedJson json = {{"depth_limit_throughput", bias.depth_limit_throughput},
                        {"threshold_throughput", bias.threshold_throughput},
                        {"depth_limit_share", bias.depth_limit_share},
                        {"threshold_share", bias.threshold_share},
                        {"wavelength_relative", or_null(bias.wavelength_relative)}};
    json.update(notes_object(bias.spectra));
    return json;
}

OrderedJson error_object(const Report& report) {
    OrderedJson points = OrderedJson::array();
    for (const renderer::ErrorPoint& point : report.error) points.push_back(point_object(point));
    return {{"confidence", 0.95},
            {"points", points},
            {"slope", or_null(error_slope(report.error))},
            {"bias", bias_object(report.bias)},
            {"stopped_by", report.stopped_by}};
}

OrderedJson warning_array(const Warnings& warnings) {
    OrderedJson array = OrderedJson::array();
    const auto add = [&](const Warning& w) {
        array.push_back(
            {{"pointer", w.pointer}, {"code", w.code}, {"detail", w.detail}, {"advice", w.advice}});
    };
    for (const Warning& warning : warnings.listed()) add(warning);
    if (warnings.count() > warnings.listed().size()) add(warnings.about_unlisted());
    return array;
}

OrderedJson unfinished_pass_object(const std::optional<renderer::UnfinishedPass>& pass) {
    if (!pass) return nullptr;
    return {{"pixels", pass->pixels}, {"without_sample", pass->without_sample}};
}

OrderedJson unmatched_objects(const renderer::Health& health) {
    OrderedJson objects = OrderedJson::array();
    for (const renderer::UnmatchedExits& of : health.unmatched_objects)
        objects.push_back({{"object", of.object}, {"count", of.count}});
    return objects;
}

OrderedJson health_object(const renderer::Health& health) {
    OrderedJson examples = OrderedJson::array();
    for (const renderer::RejectedSample& sample : health.rejected) {
        examples.push_back(
            {{"x", sample.x}, {"y", sample.y}, {"sample", sample.sample}, {"kind", sample.kind}});
    }
    return {{"samples", health.samples},
            {"rejected",
             {{"total", health.rejected_total()},
              {"nan", health.rejected_nan},
              {"infinite", health.rejected_infinite},
              {"negative", health.rejected_negative},
              {"examples", examples}}},
            {"rays_cut_by_depth", health.rays_cut_by_depth},
            {"rays_cut_by_threshold", health.rays_cut_by_threshold},
            {"blackened_samples", health.blackened_samples},
            {"unmatched_exits", health.unmatched_exits},
            {"unmatched_objects", unmatched_objects(health)},
            {"medium_stack_overflows", health.medium_stack_overflows},
            {"shadow_rays_cut", health.shadow_rays_cut},
            {"total_reflections", health.total_reflections},
            {"dropped_triangles", health.dropped_triangles},
            {"unfinished_pass", unfinished_pass_object(health.unfinished_pass)}};
}

OrderedJson plan_object(const renderer::Plan& plan) {
    OrderedJson items = OrderedJson::array();
    for (const renderer::PlanItem& item : plan.items) {
        items.push_back(
            {{"feature", item.feature}, {"needed", item.needed}, {"reason", item.reason}});
    }
    return {{"items", items},
            {"kernel", plan.kernel},
            {"basis", plan.basis},
            {"values_per_path", plan.values_per_path},
            {"triangles", plan.triangles},
            {"objects", plan.objects},
            {"lights", plan.lights},
            {"memory_bytes_estimate", plan.memory_bytes_estimate}};
}

template <class Names, class Enum>
std::string_view name_in(const Names& names, Enum value) {
    return names[static_cast<std::size_t>(value)];
}

OrderedJson chromaticity_or_null(const std::optional<renderer::Chromaticity>& c) {
    return c ? OrderedJson{c->x, c->y} : OrderedJson(nullptr);
}

/// Under the names of a document's `output`.
OrderedJson seen_object(double exposure, const renderer::OutputSettings& output) {
    const bool is_adapted = output.adaptation != renderer::Adaptation::None;
    return {{"display", output.display},
            {"exposure", exposure},
            {"adaptation", name_in(renderer::kAdaptationNames, output.adaptation)},
            {"white", chromaticity_or_null(is_adapted ? output.adapted_white() : std::nullopt)}};
}

/// read_report_output() takes it up again.
OrderedJson output_object(const renderer::ImageInfo& image,
                          const renderer::OutputSettings& output) {
    OrderedJson json = seen_object(image.exposure, output);
    json["scene_white"] = chromaticity_or_null(output.scene_white);
    json["gamut"] = name_in(renderer::kGamutMappingNames, output.gamut);
    json["color_space"] = name_in(renderer::kFileColourNames, output.exr_colour);
    json["clipped_pixels"] = image.clipped_pixels;
    json["out_of_gamut_pixels"] = image.out_of_gamut_pixels;
    json["over_range_pixels"] = image.over_range_pixels;
    return json;
}

OrderedJson digest_or_null(std::string_view digest) {
    return digest.empty() ? OrderedJson(nullptr) : OrderedJson(digest);
}

std::string csv_number(double x) { return std::isfinite(x) ? number_text(x) : std::string(); }

std::string csv_estimate(const std::optional<Estimate>& estimate) {
    if (!estimate) return ",,";
    return csv_number(estimate->value) + "," + csv_number(estimate->low) + "," +
           csv_number(estimate->high);
}

}  // namespace

std::string plan_json(const renderer::Plan& plan) { return text_of(plan_object(plan)); }

std::string notes_json(const renderer::SpectrumNotes& notes) {
    return text_of(notes_object(notes));
}

std::string health_json(const renderer::Health& health) { return text_of(health_object(health)); }

std::string error_json(const Report& report) { return text_of(error_object(report)); }

std::string error_csv(const Report& report) {
    std::string csv =
        "seconds,samples,rays,rmse,rmse_low,rmse_high,relative_rmse,relative_rmse_low,"
        "relative_rmse_high,few_events\r\n";
    for (const renderer::ErrorPoint& point : report.error) {
        csv += csv_number(point.seconds) + "," + std::to_string(point.samples) + "," +
               std::to_string(point.rays) + "," + csv_estimate(point.rmse) + "," +
               csv_estimate(point.relative_rmse) + "," + (point.few_events ? "1" : "0") + "\r\n";
    }
    return csv;
}

std::string report_json(const Report& report, const renderer::OutputSettings& output,
                        std::string_view job_digest, std::string_view scene_digest) {
    OrderedJson versions = OrderedJson::object();
    versions["bouguer"] = BOUGUER_VERSION;
    versions["libraries"] = renderer::library_versions();
    const OrderedJson json = {{"format", "bouguer-report/1"},
                              {"digest", digest_or_null(job_digest)},
                              {"scene_digest", digest_or_null(scene_digest)},
                              {"error", error_object(report)},
                              {"health", health_object(report.health)},
                              {"warnings", warning_array(report.warnings)},
                              {"plan", plan_object(report.plan)},
                              {"timings",
                               {{"scene_s", report.timings.scene_s},
                                {"render_s", report.timings.render_s},
                                {"output_s", report.timings.output_s}}},
                              {"output", output_object(report.image, output)},
                              {"versions", versions}};
    return text_of(json);
}

std::string warnings_json(const Warnings& warnings) { return text_of(warning_array(warnings)); }

std::string comparison_json(const renderer::PictureDifference& difference,
                            const renderer::OutputSettings& output, std::string_view a,
                            std::string_view b) {
    const OrderedJson json = {{"a", a},
                              {"b", b},
                              {"metric", "CIEDE2000"},
                              {"width", difference.width},
                              {"height", difference.height},
                              {"mean", difference.mean},
                              {"percentile_95", difference.percentile_95},
                              {"maximum", difference.maximum},
                              {"maximum_at", {difference.maximum_x, difference.maximum_y}},
                              {"compared_pixels", difference.compared_pixels},
                              {"unknown_pixels", difference.unknown_pixels},
                              {"seen", seen_object(difference.exposure, output)}};
    return text_of(json);
}

}  // namespace bouguer::api
