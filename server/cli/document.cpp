// SPDX-License-Identifier: Apache-2.0
#include "server/cli/document.h"

#include <algorithm>
#include <charconv>
#include <ostream>

#include "renderer/integrators/integrator_registry.h"
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

bool contains(renderer::Resolution whole, const renderer::Crop& crop) {
    return crop.x + crop.width <= whole.width && crop.y + crop.height <= whole.height;
}

Error options_error(std::vector<Problem> problems) {
    return {ErrorKind::InvalidInput, "the options do not fit", std::move(problems), {}};
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
        if (o_.observer) settings.observer = *o_.observer;
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
        auto output = read_output_options(o_.output, api::OutputScope::Files, job_.output);
        if (output) {
            job_.output = std::move(*output);
        } else {
            auto& more = output.error().problems;
            problems_.insert(problems_.end(), more.begin(), more.end());
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
    return tl::unexpected(options_error(std::move(problems)));
}

Result<renderer::OutputSettings> read_output_options(const api::OutputTexts& texts,
                                                     api::OutputScope scope,
                                                     const renderer::OutputSettings& base) {
    auto output = api::read_output_texts(texts, scope, base);
    if (output) return output;
    auto problems = std::move(output.error().problems);
    for (Problem& problem : problems) {
        problem.pointer = option_of(std::string_view(problem.pointer).substr(1));
    }
    return tl::unexpected(options_error(std::move(problems)));
}

std::string option_of(std::string_view parameter) {
    std::string option = "--" + std::string(parameter);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

void print_warnings(std::ostream& out, const Warnings& warnings) {
    const auto print = [&](const Warning& w) {
        out << "warning: " << (w.pointer.empty() ? "" : w.pointer + ": ") << w.detail << "; "
            << w.advice << " [" << w.code << "]\n";
    };
    for (const Warning& warning : warnings.listed()) print(warning);
    if (warnings.count() > warnings.listed().size()) print(warnings.about_unlisted());
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
