// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/library_routes.h"

#include <algorithm>
#include <array>

#include "api/json_builder.h"
#include "api/material_reader.h"
#include "renderer/spectrum/display.h"
#include "renderer/spectrum/spectra.h"
#include "server/http/problems.h"
#include "server/http/representation.h"

namespace bouguer::server {
namespace {

using api::JsonArray;
using api::JsonObject;

constexpr double kStep_nm = 5;

JsonObject described(const renderer::LibraryEntry& entry) {
    JsonObject json;
    json.set("name", entry.name)
        .set("kind", entry.kind)
        .set("description", entry.description)
        .set("source", entry.source);
    return json;
}

std::string spectra_json() {
    JsonArray spectra;
    for (const auto& entry : renderer::library_entries()) spectra.add_json(described(entry).text());
    return spectra.text();
}

std::string materials_json() {
    JsonArray materials;
    for (const auto& [type, description] : api::material_types()) {
        materials.add_json(JsonObject().set("type", type).set("description", description).text());
    }
    return materials.text();
}

std::string displays_json() {
    JsonArray displays;
    for (const renderer::Display& display : renderer::displays()) {
        displays.add_json(
            JsonObject().set("name", display.name).set("description", display.description).text());
    }
    return displays.text();
}

std::string library_json() {
    return JsonObject()
        .set_json("spectra", spectra_json())
        .set_json("materials", materials_json())
        .set_json("displays", displays_json())
        .text();
}

/// The entry and the values of one spectrum; empty when there is none of that name.
std::optional<std::string> spectrum_json(std::string_view name) {
    const auto& entries = renderer::library_entries();
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; });
    const auto spectrum = renderer::library_spectrum(name);
    if (entry == entries.end() || !spectrum) return std::nullopt;
    JsonArray wavelengths;
    JsonArray values;
    for (double nm = renderer::kLambdaMin_nm; nm <= renderer::kLambdaMax_nm; nm += kStep_nm) {
        wavelengths.add_json(api::json_number(nm));
        values.add_json(api::json_number(spectrum->at(nm)));
    }
    return described(*entry)
        .set_json("wavelengths_nm", wavelengths.text())
        .set_json("values", values.text())
        .text();
}

/// A document that is the same as long as the process lives.
void add_document(Router& router, const std::string& path, const std::string& json) {
    router.get(path, [representation = json_representation(json)](const httplib::Request& request,
                                                                  httplib::Response& response,
                                                                  Exchange& exchange) {
        send_representation(request, response, representation, exchange.request_id);
    });
}

}  // namespace

void add_library_routes(Router& router) {
    add_document(router, "/v1/library", library_json());
    add_document(router, "/v1/library/spectra", spectra_json());
    add_document(router, "/v1/library/materials", materials_json());
    add_document(router, "/v1/library/displays", displays_json());
    router.get("/v1/library/spectra/([^/]+)", [](const httplib::Request& request,
                                                 httplib::Response& response, Exchange& exchange) {
        auto json = spectrum_json(request.matches[1].str());
        if (!json) return send_not_found(response, exchange.request_id);
        send_representation(request, response, json_representation(std::move(*json)),
                            exchange.request_id);
    });
}

}  // namespace bouguer::server
