// SPDX-License-Identifier: Apache-2.0
#include "api/writers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "api/error_curve.h"
#include "api/openapi.h"

namespace bouguer::api {
namespace {

using Json = nlohmann::json;

renderer::ErrorPoint point(std::uint32_t samples, double rmse) {
    renderer::ErrorPoint p;
    p.seconds = 0.5 * samples;
    p.samples = samples;
    p.rays = 100UL * samples;
    p.rmse = renderer::Estimate{rmse, 0.9 * rmse, 1.1 * rmse};
    p.relative_rmse = renderer::Estimate{2 * rmse, 1.8 * rmse, 2.2 * rmse};
    return p;
}

TEST(ProblemWriter, FollowsRfc9457) {
    const Error error{ErrorKind::InvalidInput,
                      "the document has a problem",
                      {{"/scene/camera/fov_deg", "out-of-range", "too wide", "200", "(0, 180)"}},
                      {}};
    const Json json = Json::parse(problem_json(error, "req-1"));
    EXPECT_EQ(json["type"], "/docs/problems#invalid-document");
    EXPECT_EQ(json["status"], 422);
    EXPECT_FALSE(json["title"].get<std::string>().empty());
    EXPECT_EQ(json["detail"], "the document has a problem");
    EXPECT_EQ(json["request_id"], "req-1");
    ASSERT_EQ(json["errors"].size(), 1U);
    EXPECT_EQ(json["errors"][0]["pointer"], "/scene/camera/fov_deg");
    EXPECT_EQ(json["errors"][0]["code"], "out-of-range");
    EXPECT_EQ(json["errors"][0]["found"], "200");
    EXPECT_EQ(json["errors"][0]["allowed"], "(0, 180)");
}

TEST(ProblemWriter, LeavesOutWhatIsNotThere) {
    const Json json = Json::parse(problem_json(Error{ErrorKind::NotFound, "no such job", {}, {}}));
    EXPECT_FALSE(json.contains("errors"));
    EXPECT_FALSE(json.contains("request_id"));
    const Json method =
        Json::parse(problem_json(405, "method-not-allowed", "Method Not Allowed", "GET only"));
    EXPECT_EQ(method["status"], 405);
    EXPECT_EQ(method["type"], "/docs/problems#method-not-allowed");
}

TEST(WarningWriter, CountsWhatItDoesNotList) {
    Warnings warnings;
    for (int i = 0; i < 25; ++i) warnings.add({"/a", "mesh-open", "open", "close it"});
    const Json json = Json::parse(warnings_json(warnings));
    ASSERT_EQ(json.size(), Warnings::kMostOfOneCode + 1);
    EXPECT_EQ(json[0], Json({{"pointer", "/a"},
                             {"code", "mesh-open"},
                             {"detail", "open"},
                             {"advice", "close it"}}));
    EXPECT_EQ(json.back()["code"], "more-warnings");
    EXPECT_EQ(json.back()["detail"], "more than are listed: 5 of mesh-open");
}

TEST(ProblemWriter, PrefersTheErrorsOwnCode) {
    EXPECT_EQ(code_of(Error{ErrorKind::Conflict, "", {}, "job-not-finished"}), "job-not-finished");
    EXPECT_EQ(code_of(Error{ErrorKind::Conflict, "", {}, ""}), "conflict");
}

// Text of a client that is no UTF-8 must not throw on its way out.
TEST(ProblemWriter, SurvivesBytesThatAreNoText) {
    EXPECT_TRUE(Json::accept(problem_json(Error{ErrorKind::NotFound, "no \xff\xfe", {}, {}})));
}

TEST(ProblemWriter, MapsKindsToStatuses) {
    const auto status = [](ErrorKind kind) { return status_of(Error{kind, "", {}, {}}); };
    EXPECT_EQ(status(ErrorKind::Malformed), 400);
    EXPECT_EQ(status(ErrorKind::InvalidInput), 422);
    EXPECT_EQ(status(ErrorKind::NotFound), 404);
    EXPECT_EQ(status(ErrorKind::Conflict), 409);
    EXPECT_EQ(status(ErrorKind::TooLarge), 413);
    EXPECT_EQ(status(ErrorKind::Busy), 503);
    EXPECT_EQ(status(ErrorKind::Internal), 500);
}

// A fault of the storage is over some time: the client is to ask again, and not to think that the
// server is broken.
TEST(ProblemWriter, TellsFaultsOfTheStorageFromOthers) {
    EXPECT_EQ(status_of(Error{ErrorKind::Internal, "", {}, "storage-full"}), 507);
    EXPECT_EQ(status_of(Error{ErrorKind::Internal, "", {}, "storage-failed"}), 503);
    EXPECT_EQ(status_of(Error{ErrorKind::Internal, "", {}, "storage-damaged"}), 500);
}

// rmse = 3 / sqrt(samples) exactly: a straight line of slope -1/2 in logarithms.
TEST(ErrorCurve, HasTheSlopeOfAPowerLaw) {
    std::vector<renderer::ErrorPoint> curve{point(1, 3), point(4, 1.5)};
    EXPECT_FALSE(error_slope(curve));
    curve.push_back(point(16, 0.75));
    ASSERT_TRUE(error_slope(curve));
    EXPECT_NEAR(*error_slope(curve), -0.5, 1e-12);
}

TEST(ErrorCurve, LeavesOutPointsWithoutALogarithm) {
    std::vector<renderer::ErrorPoint> curve{point(1, 3), point(4, 1.5), point(16, 0)};
    EXPECT_FALSE(error_slope(curve));
    curve.push_back(point(32, std::nan("")));
    EXPECT_FALSE(error_slope(curve));
    EXPECT_FALSE(error_slope({point(4, 1), point(4, 2), point(4, 3)}));
}

renderer::Report sample_report() {
    renderer::Report report;
    report.error = {point(1, 3), point(4, 1.5), point(16, 0.75)};
    report.error[0].rmse.reset();
    report.error[0].relative_rmse.reset();
    report.bias.depth_limit_throughput = 0.25;
    report.bias.threshold_throughput = 0.5;
    report.bias.wavelength_relative = 1e-4;
    report.bias.spectra.uplift.add("/scene/spectra/red", 0.5);
    report.bias.spectra.uplift.add("/scene/spectra/blue", 1.5);
    report.health.samples = 1000;
    report.health.rejected_nan = 2;
    report.health.rejected_negative = 1;
    report.health.rejected = {{3, 4, 5, "nan"}};
    report.plan.items = {{"absorption", true, "a material absorbs"}};
    report.plan.kernel = "hall";
    report.timings = {1, 2, 3};
    report.stopped_by = "samples";
    return report;
}

TEST(ReportWriter, KeepsTheBiasApartFromTheNoise) {
    const Json json = Json::parse(error_json(sample_report()));
    EXPECT_EQ(json["points"].size(), 3U);
    EXPECT_TRUE(json["points"][0]["rmse"].is_null());
    EXPECT_EQ(json["points"][1]["rmse"]["value"], 1.5);
    EXPECT_TRUE(json["slope"].is_null());  // two points have an rmse
    EXPECT_EQ(json["bias"]["depth_limit_throughput"], 0.25);
    EXPECT_EQ(json["bias"]["threshold_throughput"], 0.5);
    EXPECT_EQ(json["bias"]["wavelength_relative"], 1e-4);
    const Json& uplift = json["bias"]["uplift"];
    EXPECT_EQ(uplift["count"], 2);
    EXPECT_EQ(uplift["largest_delta_e_2000"], 1.5);
    EXPECT_EQ(uplift["worst"][1]["pointer"], "/scene/spectra/red");
    EXPECT_EQ(uplift["worst"][1]["delta_e_2000"], 0.5);
    EXPECT_EQ(json["bias"]["outside_range"],
              Json::parse(R"({ "count": 0, "largest_share": 0, "worst": [] })"));
}

TEST(ReportWriter, WritesEverything) {
    const Json json = Json::parse(report_json(sample_report(), {}, "sha256-aa", ""));
    EXPECT_EQ(json["format"], "bouguer-report/1");
    EXPECT_EQ(json["digest"], "sha256-aa");
    EXPECT_TRUE(json["scene_digest"].is_null());
    EXPECT_TRUE(json["health"]["unfinished_pass"].is_null());
    EXPECT_EQ(json["health"]["rejected"]["total"], 3);
    EXPECT_EQ(json["health"]["rejected"]["examples"][0]["kind"], "nan");
    EXPECT_EQ(json["plan"]["items"][0]["feature"], "absorption");
    EXPECT_EQ(json["timings"]["render_s"], 2);
    EXPECT_FALSE(json["versions"]["bouguer"].get<std::string>().empty());
}

/// Adds to `faults` where `value` and the schema `schema` of the description `whole` have not the
/// same members. Of alternatives the first is followed, unless `value` is null.
void compare(const Json& whole, const Json& schema, const Json& value, const std::string& place,
             std::vector<std::string>& faults) {
    if (schema.contains("$ref")) {
        const Json::json_pointer target(schema["$ref"].get<std::string>().substr(1));
        return compare(whole, whole[target], value, place, faults);
    }
    if (value.is_null()) return;
    if (schema.contains("oneOf")) return compare(whole, schema["oneOf"][0], value, place, faults);
    if (value.is_array()) {
        for (const Json& item : value) compare(whole, schema["items"], item, place + "/0", faults);
        return;
    }
    if (!value.is_object()) return;
    for (const Json& key : schema["required"]) {
        if (!value.contains(key.get<std::string>()))
            faults.push_back(place + " lacks " + key.dump());
    }
    for (const auto& [key, member] : value.items()) {
        if (!schema["properties"].contains(key)) {
            faults.push_back(place + "/" + key + " is not described");
            continue;
        }
        compare(whole, schema["properties"][key], member, place + "/" + key, faults);
    }
}

TEST(ReportWriter, WritesWhatTheDescriptionSays) {
    const Json whole = Json::parse(openapi_json());
    const Json report = Json::parse(report_json(sample_report(), {}, "sha256-aa", "sha256-bb"));
    std::vector<std::string> faults;
    compare(whole, whole["components"]["schemas"]["Report"], report, "", faults);
    EXPECT_EQ(faults, std::vector<std::string>());
    const Error error{ErrorKind::InvalidInput, "refused", {{"/a", "missing", "b", "c", "d"}}, {}};
    compare(whole, whole["components"]["schemas"]["Problem"],
            Json::parse(problem_json(error, "req-1")), "", faults);
    EXPECT_EQ(faults, std::vector<std::string>());
}

TEST(ReportWriter, TellsExposureWhiteAndWhatWasNotShown) {
    renderer::Report report = sample_report();
    report.image = {0.5, 7, 4, 5};
    renderer::OutputSettings output;
    output.scene_white = renderer::Chromaticity{0.3, 0.4};
    Json json = Json::parse(report_json(report, output, "", ""))["output"];
    EXPECT_EQ(json["exposure"], 0.5);
    EXPECT_EQ(json["clipped_pixels"], 7);
    EXPECT_EQ(json["out_of_gamut_pixels"], 4);
    EXPECT_EQ(json["over_range_pixels"], 5);
    EXPECT_TRUE(json["white"].is_null()) << "nothing was adapted";
    output.adaptation = renderer::Adaptation::Cat16;
    json = Json::parse(report_json(report, output, "", ""))["output"];
    EXPECT_EQ(json["white"], Json::parse("[0.3,0.4]"));
}

TEST(ComparisonWriter, WritesWhatTheDescriptionSays) {
    renderer::PictureDifference difference;
    difference.mean = std::nan("");
    const Json json = Json::parse(comparison_json(difference, {}, "one", "two"));
    const Json whole = Json::parse(openapi_json());
    std::vector<std::string> faults;
    compare(whole, whole["components"]["schemas"]["Comparison"], json, "", faults);
    EXPECT_EQ(faults, std::vector<std::string>());
    EXPECT_TRUE(json["mean"].is_null());
    EXPECT_EQ(json["b"], "two");
}

TEST(ReportWriter, WritesNullForWhatIsNotFinite) {
    renderer::Report report = sample_report();
    report.bias.depth_limit_throughput = std::nan("");
    report.error[1].seconds = std::numeric_limits<double>::infinity();
    const Json json = Json::parse(error_json(report));
    EXPECT_TRUE(json["bias"]["depth_limit_throughput"].is_null());
    EXPECT_TRUE(json["points"][1]["seconds"].is_null());
}

TEST(ReportWriter, WritesTheCurveAsCsv) {
    EXPECT_EQ(error_csv(sample_report()),
              "seconds,samples,rays,rmse,rmse_low,rmse_high,relative_rmse,relative_rmse_low,"
              "relative_rmse_high,few_events\r\n"
              "0.5,1,100,,,,,,,0\r\n"
              "2,4,400,1.5,1.35,1.6500000000000001,3,2.7,3.3000000000000003,0\r\n"
              "8,16,1600,0.75,0.675,0.8250000000000001,1.5,1.35,1.6500000000000001,0\r\n");
}

}  // namespace
}  // namespace bouguer::api
