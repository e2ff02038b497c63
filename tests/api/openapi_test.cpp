// SPDX-License-Identifier: Apache-2.0
#include "api/openapi.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "api/limits.h"
#include "renderer/spectrum/display.h"
#include "tests/support/source_folder.h"

namespace bouguer::api {
namespace {

using Json = nlohmann::json;

TEST(OpenApi, IsTheFileOfTheRepository) {
    std::ifstream file(tests::source_folder() / "api/openapi.json");
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_EQ(openapi_json(), text.str());
}

TEST(OpenApi, StandsAlone) {
    const Json whole = Json::parse(openapi_json());
    EXPECT_EQ(whole["openapi"], "3.1.0");
    EXPECT_TRUE(whole["paths"].contains("/v1/jobs/{id}/error.csv"));
    const Json leaves = whole.flatten();
    for (const auto& [place, value] : leaves.items()) {
        if (!place.ends_with("/$ref")) continue;
        const auto target = value.get<std::string>();
        ASSERT_TRUE(target.starts_with("#/")) << place << " " << target;
        EXPECT_TRUE(whole.contains(Json::json_pointer(target.substr(1)))) << place << " " << target;
    }
}

/// Every value that is not an object or array, with its JSON pointer, but for those in examples,
/// which may be of any form.
std::vector<std::pair<std::string, Json>> leaves_outside_examples() {
    std::vector<std::pair<std::string, Json>> leaves;
    const Json flat = Json::parse(openapi_json()).flatten();
    for (const auto& [place, value] : flat.items()) {
        const bool is_example = place.find("/example/") != std::string::npos ||
                                place.find("/examples/") != std::string::npos;
        if (!is_example) leaves.emplace_back(place, value);
    }
    return leaves;
}

/// Whether the schema that the last key of `pointer` belongs to is one of several.
bool is_an_alternative(const std::string& pointer) {
    return std::regex_search(pointer, std::regex("/(oneOf|anyOf|prefixItems)/[0-9]+/[^/]+$"));
}

std::string last_of(const std::string& pointer) { return pointer.substr(pointer.rfind('/') + 1); }

// A bound such as 1e30 is a text to readers of YAML 1.1.
TEST(OpenApi, BoundsAreNumbers) {
    const std::set<std::string> bounds{
        "minimum",    "maximum",       "exclusiveMinimum", "exclusiveMaximum",
        "multipleOf", "minItems",      "maxItems",         "minLength",
        "maxLength",  "minProperties", "maxProperties",
    };
    std::size_t count = 0;
    for (const auto& [place, value] : leaves_outside_examples()) {
        if (!bounds.contains(last_of(place))) continue;
        ++count;
        EXPECT_TRUE(value.is_number()) << place << " " << value;
    }
    EXPECT_GT(count, 100U);
}

// JSON Schema allows more, but generators of clients take `true` for no schema, a constant for a
// text, a whole number or a truth value, and one among alternatives for the only one.
TEST(OpenApi, IsWrittenForGenerators) {
    for (const auto& [place, value] : leaves_outside_examples()) {
        EXPECT_EQ(place.find("/const/"), std::string::npos) << place << " is within a constant";
        const std::string last = last_of(place);
        if (last == "const") {
            EXPECT_FALSE(value.is_number_float()) << place << " " << value;
            EXPECT_FALSE(is_an_alternative(place)) << place << " " << value;
            continue;
        }
        const bool is_flag = last == "required" || last == "default" ||
                             last == "additionalProperties" || last == "deprecated";
        EXPECT_TRUE(!value.is_boolean() || is_flag) << place << " is a schema without words";
    }
}

TEST(OpenApi, SaysOfEveryOperationHowItMayBeRefused) {
    const Json whole = Json::parse(openapi_json());
    const Json refused{{"$ref", "#/components/responses/Refused"}};
    for (const auto& [path, operations] : whole["paths"].items()) {
        for (const auto& [method, operation] : operations.items()) {
            if (method == "parameters") continue;
            EXPECT_EQ(operation["responses"].value("default", Json()), refused)
                << method << " " << path;
        }
    }
}

// The numbers that the schemas give are those that the readers enforce.
TEST(OpenApi, GivesTheLimits) {
    const Json schemas = Json::parse(openapi_json())["components"]["schemas"];
    const Limits limits;
    const auto& scene = schemas["Scene"]["properties"];
    EXPECT_EQ(scene["spectra"]["maxProperties"], limits.spectra);
    EXPECT_EQ(scene["materials"]["maxProperties"], limits.materials);
    EXPECT_EQ(scene["objects"]["maxItems"], limits.objects);
    EXPECT_EQ(scene["lights"]["maxItems"], limits.lights);
    EXPECT_EQ(scene["name"]["maxLength"], limits.name_bytes);
    EXPECT_EQ(schemas["Object"]["properties"]["instances"]["maxItems"], limits.instances);
    EXPECT_EQ(schemas["Mesh"]["properties"]["positions"]["maxItems"], limits.mesh_vertices);
    EXPECT_EQ(schemas["Mesh"]["properties"]["triangles"]["maxItems"], limits.mesh_triangles);
    EXPECT_EQ(schemas["SpectrumValues"]["maxItems"], limits.spectrum_samples);
    EXPECT_EQ(schemas["ProductSpectrum"]["properties"]["product"]["maxItems"],
              limits.spectrum_parts);
    EXPECT_EQ(schemas["Resolution"]["items"]["maximum"], limits.resolution);
    EXPECT_EQ(schemas["Transform"]["oneOf"][1]["maxItems"], limits.transform_steps);
    EXPECT_EQ(schemas["StopRule"]["properties"]["samples"]["maximum"], limits.samples);
    EXPECT_EQ(schemas["StopRule"]["properties"]["seconds"]["maximum"], limits.seconds);
    EXPECT_EQ(schemas["Integrator"]["properties"]["max_depth"]["maximum"], limits.max_depth);
    EXPECT_EQ(schemas["Job"]["properties"]["labels"]["maxProperties"], limits.labels);
}

TEST(OpenApi, NamesTheDisplays) {
    const Json components = Json::parse(openapi_json())["components"];
    std::vector<std::string> names;
    for (const renderer::Display& display : renderer::displays()) names.push_back(display.name);
    EXPECT_EQ(components["schemas"]["Output"]["properties"]["display"]["enum"], Json(names));
    EXPECT_EQ(components["parameters"]["Display"]["schema"]["enum"], Json(names));
}

}  // namespace
}  // namespace bouguer::api
