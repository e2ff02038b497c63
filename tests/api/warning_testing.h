// SPDX-License-Identifier: Apache-2.0
// A good scene to spoil, and what is said of it then.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "api/job_document.h"
#include "tests/support/named_bytes.h"

namespace bouguer::tests {

using Texts = std::vector<std::string>;

/// A glass ball of radius 1 in a lamp's light: nothing to warn of.
inline nlohmann::json good_scene() {
    return nlohmann::json::parse(R"({"format": "bouguer-scene/1",
        "camera": {"type": "perspective", "from": [0, 0, 9], "at": [0, 0, 0], "fov_deg": 30},
        "materials": {"glass": {"type": "hall", "k_sr": 0.1, "k_st": 0.9, "ior": 1.5}},
        "objects": [{"name": "ball", "material": "glass",
                     "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}}],
        "lights": [{"type": "point", "position": [0, 2, 0], "intensity": 1}]})");
}

/// The good scene with an opaque material that the caller uses.
inline nlohmann::json scene_with_wall() {
    nlohmann::json s = good_scene();
    s["materials"]["wall"] = {{"type", "hall"}, {"k_sr", 1}};
    return s;
}

inline nlohmann::json object(const char* name, const char* material, nlohmann::json shape) {
    return {{"name", name}, {"material", material}, {"shape", std::move(shape)}};
}

inline nlohmann::json sphere(double x, double y, double z, double radius) {
    return {{"type", "sphere"}, {"center", {x, y, z}}, {"radius", radius}};
}

/// "pointer code" of every warning; the message of a refusal.
inline Texts warned(const nlohmann::json& document) {
    const auto job = api::parse_job(document.dump(), api::Limits{}, NoAssets{});
    if (!job) return {job.error().message + " " + job.error().problems.at(0).pointer};
    Texts all;
    for (const Warning& w : job->warnings.listed()) {
        EXPECT_FALSE(w.detail.empty());
        EXPECT_FALSE(w.advice.empty());
        all.push_back(w.pointer + " " + w.code);
    }
    return all;
}

}  // namespace bouguer::tests
