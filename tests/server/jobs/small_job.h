// SPDX-License-Identifier: Apache-2.0
// A job document whose picture takes milliseconds.
#pragma once

#include <string>

namespace bouguer::server {

/// A grey ball on a floor, 16 x 12 pixels; `rest` follows the scene, e.g. R"(,"priority":3)".
inline std::string small_job(int samples = 4, const std::string& rest = {},
                             const std::string& resolution = "[16,12]") {
    return R"({"format":"bouguer-job/1","scene":{"format":"bouguer-scene/1","name":"ball",)"
           R"("camera":{"type":"perspective","from":[0,1,5],"at":[0,1,0],"up":[0,1,0],)"
           R"("fov_deg":40,"resolution":)" +
           resolution +
           R"(},"materials":{"grey":{"type":"hall","reflectance":0.5,"k_sr":1,"n":1}},)"
           R"("objects":[{"name":"ball","shape":{"type":"sphere","center":[0,1,0],"radius":1},)"
           R"("material":"grey"},{"name":"floor","shape":{"type":"plane","point":[0,0,0],)"
           R"("normal":[0,1,0]},"material":"grey"}],)"
           R"("lights":[{"type":"directional","direction":[-1,-2,-1],"irradiance":"D65"}]},)"
           R"("stop":{"samples":)" +
           std::to_string(samples) + "}" + rest + "}";
}

/// Would run for hours.
inline std::string endless_job(const std::string& rest = {}) {
    return small_job(1'000'000, rest, "[64,48]");
}

}  // namespace bouguer::server
