// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/result_files.h"

#include <array>
#include <chrono>

#include "api/error_curve.h"
#include "api/writers.h"
#include "renderer/film/error_plot.h"
#include "renderer/film/image_file.h"

namespace bouguer::server {
namespace {

using renderer::OutputSettings;
using renderer::Report;
using Writer = std::string (*)(const Report&, const OutputSettings&, const JobDigests&);

/// The plot of an error curve; empty when it cannot be drawn.
std::string plot(const std::vector<renderer::ErrorPoint>& curve) {
    return renderer::encode_png(draw_plot(renderer::error_plot(curve))).value_or("");
}

struct ResultName {
    std::string_view name, media_type;
    Writer write;                     ///< null: an image
    std::string_view made_from = {};  ///< not empty: made of that file when it is asked for
};

/// To add a file made of the report: its line here.
constexpr std::array kResults{
    ResultName{"image.png", "image/png", nullptr},
    ResultName{"image.exr", "image/x-exr", nullptr},
    ResultName{"report.json", "application/json",
               [](const Report& report, const OutputSettings& output, const JobDigests& digests) {
                   return api::report_json(report, output, digests.job, digests.scene);
               }},
    ResultName{"error.json", "application/json",
               [](const Report& report, const OutputSettings&, const JobDigests&) {
                   return api::error_json(report);
               }},
    ResultName{"error.csv", "text/csv",
               [](const Report& report, const OutputSettings&, const JobDigests&) {
                   return api::error_csv(report);
               }},
    ResultName{"error.png", "image/png",
               [](const Report& report, const OutputSettings&, const JobDigests&) {
                   return plot(report.error);
               },
               "error.json"},
    ResultName{"plan.json", "application/json",
               [](const Report& report, const OutputSettings&, const JobDigests&) {
                   return api::plan_json(report.plan);
               }},
    ResultName{"health.json", "application/json",
               [](const Report& report, const OutputSettings&, const JobDigests&) {
                   return api::health_json(report.health);
               }},
};

const ResultName* find_result(std::string_view name) {
    for (const ResultName& result : kResults) {
        if (result.name == name) return &result;
    }
    return nullptr;
}

Result<void> add_images(const renderer::Picture& picture, const OutputSettings& output,
                        Report& report, ResultFiles& files) {
    auto png = renderer::encode_png(picture, output, &report.image);
    if (!png) return tl::unexpected(png.error());
    auto exr = renderer::encode_exr(picture, output);
    if (!exr) return tl::unexpected(exr.error());
    files["image.png"] = std::move(*png);
    files["image.exr"] = std::move(*exr);
    return {};
}

}  // namespace

std::string_view media_type_of(std::string_view name) {
    const ResultName* result = find_result(name);
    return result == nullptr ? std::string_view{} : result->media_type;
}

bool is_image(std::string_view name) {
    const ResultName* result = find_result(name);
    return result != nullptr && result->write == nullptr;
}

std::string_view source_of(std::string_view name) {
    const ResultName* result = find_result(name);
    return result == nullptr ? std::string_view{} : result->made_from;
}

Result<std::string> made_from_source(std::string_view source) {
    const auto curve = api::read_error_curve(source);
    if (!curve) return tl::unexpected(curve.error());
    return plot(*curve);
}

std::optional<std::string> report_file(std::string_view name, const Report& report,
                                       const OutputSettings& output, const JobDigests& digests) {
    const ResultName* result = find_result(name);
    if (result == nullptr || result->write == nullptr) return std::nullopt;
    return result->write(report, output, digests);
}

Result<ResultFiles> result_files(const renderer::Picture* picture, Report& report,
                                 const OutputSettings& output, const JobDigests& digests) {
    const auto begin = std::chrono::steady_clock::now();
    ResultFiles files;
    if (picture != nullptr) {
        if (auto added = add_images(*picture, output, report, files); !added) {
            return tl::unexpected(added.error());
        }
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    report.timings.output_s = spent.count();
    for (const ResultName& result : kResults) {
        if (result.write == nullptr || !result.made_from.empty()) continue;
        files[std::string(result.name)] = result.write(report, output, digests);
    }
    return files;
}

}  // namespace bouguer::server
