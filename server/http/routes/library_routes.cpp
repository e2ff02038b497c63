// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/library_routes.h"

#include <array>
#include <memory>
#include <utility>

#include "api/json_builder.h"
#include "api/material_reader.h"
#include "renderer/film/image_file.h"
#include "renderer/integrators/integrator_registry.h"
#include "renderer/spectrum/display.h"
#include "server/http/problems.h"
#include "server/http/representation.h"
#include "server/http/routes/library_items.h"

namespace bouguer::server {
namespace {

using api::JsonArray;
using api::JsonObject;
using httplib::Request;
using httplib::Response;

constexpr std::string_view kPlotEnding = ".png";

std::string materials_json() {
    JsonArray materials;
    for (const auto& [type, description] : api::material_types()) {
        materials.add_json(JsonObject().set("type", type).set("description", description).text());
    }
    return materials.text();
}

std::string chromaticity_json(renderer::Chromaticity c) {
    return JsonArray().add_json(api::json_number(c.x)).add_json(api::json_number(c.y)).text();
}

std::string displays_json() {
    constexpr std::array kCorners{"red", "green", "blue", "white"};
    JsonArray displays;
    for (const renderer::Display& display : renderer::displays()) {
        JsonObject chromaticities;
        for (std::size_t i = 0; i < kCorners.size(); ++i) {
            chromaticities.set_json(kCorners[i], chromaticity_json(display.chromaticities[i]));
        }
        displays.add_json(JsonObject()
                              .set("name", display.name)
                              .set("description", display.description)
                              .set_json("chromaticities", chromaticities.text())
                              .text());
    }
    return displays.text();
}

std::string integrators_json() {
    JsonArray integrators;
    for (const std::string_view name : renderer::integrator_names()) {
        integrators.add_json(JsonObject().set("name", name).text());
    }
    return integrators.text();
}

std::string shelf_json(const LibraryShelf& shelf) {
    JsonArray items;
    for (const LibraryItem& item : shelf.items) items.add_json(item.json.text());
    return items.text();
}

/// A document that is the same as long as the process lives.
void add_document(Router& router, const std::string& path, const std::string& json) {
    router.get(path, [representation = json_representation(json)](
                         const Request& request, Response& response, Exchange& exchange) {
        send_representation(request, response, representation, exchange);
    });
}

void send_plot(const LibraryItem& item, const Request& request, Response& response,
               Exchange& exchange) {
    auto png = renderer::encode_png(renderer::draw_plot(item_plot(item)));
    if (!png) return send_problem(response, png.error(), exchange.request_id);
    send_representation(request, response, made_representation(std::move(*png), "image/png"),
                        exchange);
}

/// The item of a path that ends in its name, as Accept asks; with ".png" behind it, its plot.
void send_item(const LibraryShelf& shelf, const Request& request, Response& response,
               Exchange& exchange) {
    std::string name = request.matches[1].str();
    if (const LibraryItem* item = shelf.find(name)) {
        constexpr std::array<std::string_view, 2> kOffers{"application/json", "image/png"};
        const auto chosen = choose_type(request, response, kOffers, exchange.request_id);
        if (!chosen) return;
        if (*chosen == 1) return send_plot(*item, request, response, exchange);
        return send_representation(request, response, json_representation(item_json(*item)),
                                   exchange);
    }
    const LibraryItem* plotted = nullptr;
    if (name.ends_with(kPlotEnding)) {
        name.resize(name.size() - kPlotEnding.size());
        plotted = shelf.find(name);
    }
    if (plotted == nullptr) return send_not_found(response, exchange.request_id);
    send_plot(*plotted, request, response, exchange);
}

}  // namespace

void add_library_routes(Router& router) {
    JsonObject library;
    const auto add_part = [&](std::string_view name, const std::string& json) {
        library.set_json(name, json);
        add_document(router, "/v1/library/" + std::string(name), json);
    };
    for (LibraryShelf& made : library_shelves()) {
        const auto shelf = std::make_shared<const LibraryShelf>(std::move(made));
        add_part(shelf->path, shelf_json(*shelf));
        router.get("/v1/library/" + std::string(shelf->path) + "/([^/]+)",
                   [shelf](const Request& request, Response& response, Exchange& exchange) {
                       send_item(*shelf, request, response, exchange);
                   });
    }
    add_part("materials", materials_json());
    add_part("displays", displays_json());
    add_part("integrators", integrators_json());
    add_document(router, "/v1/library", library.text());
}

}  // namespace bouguer::server
