// SPDX-License-Identifier: Apache-2.0
#include "api/json_builder.h"
#include "api/writers.h"
#include "renderer/spectrum/display.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {

std::string library_json() {
    JsonArray spectra;
    for (const renderer::LibraryEntry& entry : renderer::library_entries()) {
        spectra.add_json(JsonObject()
                             .set("name", entry.name)
                             .set("kind", entry.kind)
                             .set("description", entry.description)
                             .set("source", entry.source)
                             .text());
    }
    JsonArray displays;
    for (const renderer::Display& display : renderer::displays()) {
        displays.add_json(
            JsonObject().set("name", display.name).set("description", display.description).text());
    }
    return JsonObject()
        .set_json("spectra", spectra.text())
        .set_json("displays", displays.text())
        .text();
}

}  // namespace bouguer::api
