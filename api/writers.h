// SPDX-License-Identifier: Apache-2.0
// Typed values -> the JSON texts that go over the wire. Numbers that are not finite are written as
// null; bytes that are no UTF-8 are replaced. All of it is thread-safe.
#pragma once

#include <string>
#include <string_view>

#include "renderer/core/result.h"
#include "renderer/core/warning.h"
#include "renderer/film/picture_difference.h"
#include "renderer/report.h"
#include "renderer/settings.h"

namespace bouguer::api {

/// application/problem+json [RFC 9457]: type, title, status, detail, errors[{pointer, code, detail,
/// found, allowed}], request_id. `type` is "/docs/problems#<code>". The one place that maps
/// ErrorKind to a status is status_of().
[[nodiscard]] std::string problem_json(const Error& error, std::string_view request_id = {});
/// The same for what HTTP itself refuses (404, 405, 416 ...): `code` in words,
/// "method-not-allowed"; `title` is the status in words.
[[nodiscard]] std::string problem_json(int status, std::string_view code, std::string_view title,
                                       std::string_view detail, std::string_view request_id = {});
[[nodiscard]] int status_of(const Error& error);
/// The stable name of the error: its own code, or that of its kind ("invalid-document" ...).
[[nodiscard]] std::string code_of(const Error& error);

[[nodiscard]] std::string plan_json(const renderer::Plan& plan);
/// "uplift" and "outside_range": of each the number, the largest value and the worst, by pointer.
[[nodiscard]] std::string notes_json(const renderer::SpectrumNotes& notes);
/// An array of pointer, code, detail and advice; of those that are not listed the number, as the
/// last.
[[nodiscard]] std::string warnings_json(const Warnings& warnings);
[[nodiscard]] std::string health_json(const renderer::Health& health);
/// The error curve with its bias parts and the fitted slope of log rmse against log samples (null
/// below three points).
[[nodiscard]] std::string error_json(const renderer::Report& report);
/// One line a point, RFC 4180; a column is empty where a value is unknown.
[[nodiscard]] std::string error_csv(const renderer::Report& report);
/// Everything: error, bias, health, plan, timings, output, versions, digests. `job_digest`,
/// `scene_digest` may be empty.
[[nodiscard]] std::string report_json(const renderer::Report& report,
                                      const renderer::OutputSettings& output,
                                      std::string_view job_digest, std::string_view scene_digest);

/// How two pictures, named `a` and `b`, differ as `output` shows them.
[[nodiscard]] std::string comparison_json(const renderer::PictureDifference& difference,
                                          const renderer::OutputSettings& output,
                                          std::string_view a, std::string_view b);

}  // namespace bouguer::api
