// SPDX-License-Identifier: Apache-2.0
#include "server/cli/document.h"

#include <charconv>
#include <cmath>
#include <ostream>

#include "renderer/integrators/integrator_registry.h"
#include "renderer/spectrum/display.h"
#include "server/cli/command_line.h"
#include "server/storage/durable_file.h"
#include "server/storage/folder_asset_source.h"

namespace bouguer::server {
namespace {

/// The user's own machine: only what would be a mistake is refused.
api::Limits limits_of_the_command_line() {
    api::Limits limits;
    limits.body_bytes = std::size_t{1} << 30U;
    return limits;
}

std::optional<int> whole_number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<renderer::Resolution> resolution_from(std::string_view text, int most) {
    const std::size_t x = text.find('x');
    if (x == std::string_view::npos) return std::nullopt;
    const auto width = whole_number(text.substr(0, x));
    const auto height = whole_number(text.substr(x + 1));
    const auto is_good = [&](const auto& side) { return side && *side >= 1 && *side <= most; };
    if (!is_good(width) || !is_good(height)) return std::nullopt;
    return renderer::Resolution{*width, *height};
}

std::optional<double> factor_from(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    if (!std::isfinite(value) || value <= 0) return std::nullopt;
    return value;
}

std::string names_of_displays() {
    std::string names;
    for (const renderer::Display& display : renderer::displays()) {
        names += (names.empty() ? "" : ", ") + display.name;
    }
    return names;
}

bool contains(renderer::Resolution whole, const renderer::Crop& crop) {
    return crop.x + crop.width <= whole.width && crop.y + crop.height <= whole.height;
}

/// Applies options one by one and collects what does not fit.
class Applier {
  public:
    Applier(api::JobRequest& job, const Overrides& overrides) : job_(job), o_(overrides) {}

    std::vector<Problem> apply() {
        apply_settings();
        apply_stop();
        apply_output();
        return std::move(problems_);
    }

  private:
    void refuse(const char* option, const std::string& found, const std::string& allowed) {
        problems_.push_back({option, "bad-option", "this value does not fit", found, allowed});
    }

    void apply_settings() {
        renderer::RenderSettings& settings = job_.settings;
        if (o_.integrator) {
            settings.integrator =
                renderer::find_integrator(*o_.integrator).value_or(settings.integrator);
        }
        if (o_.seed) settings.seed = *o_.seed;
        if (o_.wavelength_step) settings.wavelength_step_nm = *o_.wavelength_step;
        if (o_.max_depth) settings.max_depth = *o_.max_depth;
        if (o_.resolution) {
            const int most = api::Limits().resolution;
            const auto resolution = resolution_from(*o_.resolution, most);
            const std::string sides = "WIDTHxHEIGHT, each 1 to " + std::to_string(most);
            if (!resolution) return refuse("--resolution", *o_.resolution, sides);
            settings.resolution = *resolution;
            if (settings.crop && !contains(*resolution, *settings.crop)) {
                refuse("--resolution", *o_.resolution, "a picture that holds the document's crop");
            }
        }
    }

    void apply_stop() {
        if (!o_.samples && !o_.seconds && !o_.error) return;
        job_.stop = {o_.samples, o_.seconds, o_.error};
    }

    void apply_output() {
        if (o_.display) {
            if (renderer::find_display(*o_.display) == nullptr) {
                refuse("--display", *o_.display, names_of_displays());
            }
            job_.output.display = *o_.display;
        }
        if (o_.exposure) {
            job_.output.exposure = factor_from(*o_.exposure);
            if (!job_.output.exposure && *o_.exposure != "auto") {
                refuse("--exposure", *o_.exposure, "auto or a number above 0");
            }
        }
        if (o_.color_space) {
            job_.output.exr_colour =
                *o_.color_space == "xyz" ? renderer::FileColour::Xyz : renderer::FileColour::Rec709;
        }
    }

    api::JobRequest& job_;
    const Overrides& o_;
    std::vector<Problem> problems_;
};

}  // namespace

Result<api::JobRequest> read_document(const std::filesystem::path& file) {
    const api::Limits limits = limits_of_the_command_line();
    auto text = read_file(file, limits.body_bytes);
    if (!text) return tl::unexpected(text.error());
    const FolderAssetSource assets(file.has_parent_path() ? file.parent_path() : ".");
    return api::parse_job(*text, limits, assets);
}

Result<void> apply_overrides(api::JobRequest& job, const Overrides& overrides) {
    // What is rendered is no longer what the digest names.
    if (overrides != Overrides{}) job.digest.clear();
    auto problems = Applier(job, overrides).apply();
    if (problems.empty()) return {};
    Error error{ErrorKind::InvalidInput, "the options do not fit", std::move(problems), {}};
    return tl::unexpected(std::move(error));
}

int print_error(std::ostream& out, const Error& error) {
    out << "bouguer: " << error.message << "\n";
    for (const Problem& problem : error.problems) {
        out << (problem.pointer.empty() ? "(document)" : problem.pointer) << ": " << problem.detail;
        if (!problem.found.empty() || !problem.allowed.empty()) {
            out << " (found " << (problem.found.empty() ? "nothing" : problem.found);
            if (!problem.allowed.empty()) out << ", allowed " << problem.allowed;
            out << ")";
        }
        out << "\n";
    }
    const bool is_ours = error.kind == ErrorKind::Internal || error.kind == ErrorKind::Busy;
    return is_ours ? kExitFailed : kExitBadInput;
}

}  // namespace bouguer::server
