// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/library_items.h"

#include <algorithm>
#include <utility>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/observer.h"
#include "renderer/spectrum/refractive_index.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::server {
namespace {

using api::JsonArray;
using api::JsonObject;
using renderer::LibraryEntry;
using renderer::SpectrumPtr;

JsonObject described(const LibraryEntry& entry) {
    JsonObject json;
    json.set("name", entry.name)
        .set("kind", entry.kind)
        .set("description", entry.description)
        .set("source", entry.source);
    if (entry.thickness_mm > 0) json.set("thickness_mm", entry.thickness_mm);
    return json;
}

LibraryCurve curve(std::string_view key, SpectrumPtr spectrum,
                   renderer::Paint paint = renderer::paints::kInk) {
    return {key, [spectrum = std::move(spectrum)](double nm) { return spectrum->at(nm); }, paint};
}

std::string quantity_of(const LibraryEntry& entry) {
    if (entry.kind == "illuminant") return "relative spectral power, 1 at 560 nm";
    if (entry.thickness_mm > 0) {
        return "internal transmittance of " + api::json_number(entry.thickness_mm) + " mm";
    }
    return std::string(entry.kind);
}

std::vector<LibraryItem> spectra() {
    std::vector<LibraryItem> items;
    for (const LibraryEntry& entry : renderer::library_entries()) {
        items.push_back({entry.name,
                         entry.description,
                         described(entry),
                         quantity_of(entry),
                         {curve("values", renderer::library_spectrum(entry.name))}});
    }
    return items;
}

std::vector<LibraryItem> indices() {
    std::vector<LibraryItem> items;
    for (const LibraryEntry& entry : renderer::index_entries()) {
        const SpectrumPtr index = renderer::library_index(entry.name);
        JsonObject json = described(entry);
        json.set("n_d", index->at(renderer::kLineD_nm)).set("v_d", renderer::abbe_number(*index));
        items.push_back({entry.name,
                         entry.description,
                         std::move(json),
                         "index of refraction",
                         {curve("values", index)}});
        items.back().from_zero = false;
    }
    return items;
}

std::vector<LibraryItem> metals() {
    std::vector<LibraryItem> items;
    for (const LibraryEntry& entry : renderer::metal_entries()) {
        const auto [n, k] = renderer::library_metal(entry.name);
        items.push_back({entry.name,
                         entry.description,
                         described(entry),
                         "complex index n + ik",
                         {curve("n", n, renderer::paints::kBlue),
                          curve("k", k, renderer::paints::kVermilion)}});
    }
    return items;
}

LibraryItem observer_item(const renderer::Observer& observer) {
    JsonObject json;
    json.set("name", observer.name())
        .set("kind", "observer")
        .set("description", observer.description())
        .set("source", observer.source());
    LibraryItem item{
        observer.name(), observer.description(), std::move(json), "colour-matching functions", {}};
    constexpr std::array kKeys{
        std::pair{std::string_view("x"), renderer::paints::kVermilion},
        std::pair{std::string_view("y"), renderer::paints::kGreen},
        std::pair{std::string_view("z"), renderer::paints::kBlue},
    };
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        item.curves.push_back({kKeys[i].first,
                               [&observer, i](double nm) { return observer.at(nm)[i]; },
                               kKeys[i].second});
    }
    item.step_nm = 1;  // as they are published
    return item;
}

std::vector<LibraryItem> observers() {
    std::vector<LibraryItem> items;
    for (const renderer::Observer& observer : renderer::observers()) {
        items.push_back(observer_item(observer));
    }
    return items;
}

std::vector<double> wavelengths(double step_nm) {
    std::vector<double> all;
    for (double nm = renderer::kLambdaMin_nm; nm <= renderer::kLambdaMax_nm; nm += step_nm) {
        all.push_back(nm);
    }
    return all;
}

std::string numbers_json(const std::vector<double>& numbers) {
    JsonArray json;
    for (const double number : numbers) json.add_json(api::json_number(number));
    return json.text();
}

std::vector<double> values_at(const LibraryCurve& curve, const std::vector<double>& at_nm) {
    std::vector<double> values;
    for (const double nm : at_nm) values.push_back(curve.at(nm));
    return values;
}

}  // namespace

const LibraryItem* LibraryShelf::find(std::string_view name) const {
    const auto it = std::find_if(items.begin(), items.end(),
                                 [&](const LibraryItem& item) { return item.name == name; });
    return it == items.end() ? nullptr : &*it;
}

std::vector<LibraryShelf> library_shelves() {
    return {{"spectra", spectra()},
            {"indices", indices()},
            {"metals", metals()},
            {"observers", observers()}};
}

std::string item_json(const LibraryItem& item) {
    const std::vector<double> at_nm = wavelengths(item.step_nm);
    JsonObject json = item.json;
    json.set_json("wavelengths_nm", numbers_json(at_nm));
    for (const LibraryCurve& curve : item.curves) {
        json.set_json(curve.key, numbers_json(values_at(curve, at_nm)));
    }
    return json.text();
}

renderer::Plot item_plot(const LibraryItem& item) {
    const std::vector<double> at_nm = wavelengths(1);
    renderer::Plot plot;
    plot.title = item.name;
    plot.subtitle = item.description;
    plot.x.title = "wavelength (nm)";
    plot.x.range = {renderer::kLambdaMin_nm, renderer::kLambdaMax_nm};
    plot.x.shows_light = true;
    plot.y.title = item.quantity;
    plot.y.shows_zero = item.from_zero;
    for (const LibraryCurve& curve : item.curves) {
        const bool is_alone = item.curves.size() == 1;
        plot.series.push_back({is_alone ? "" : std::string(curve.key),
                               at_nm,
                               values_at(curve, at_nm),
                               {},
                               {},
                               curve.paint});
    }
    return plot;
}

}  // namespace bouguer::server
