// SPDX-License-Identifier: Apache-2.0
#include "server/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "api/limits.h"
#include "renderer/integrators/integrator_registry.h"
#include "renderer/spectrum/observer.h"
#include "server/cli/document.h"
#include "server/cli/listen_address.h"
#include "server/http/authority.h"

namespace bouguer::server {
namespace {

/// Like CLI::Range, which lets NaN pass.
CLI::Validator within(double low, double high) {
    const std::string range =
        "[" + CLI::detail::to_string(low) + " - " + CLI::detail::to_string(high) + "]";
    return {[=](const std::string& text) {
                double value = 0;
                const bool is_good =
                    CLI::detail::lexical_cast(text, value) && low <= value && value <= high;
                return is_good ? std::string() : text + " is not a number in " + range;
            },
            "in " + range};
}

CLI::Validator listen_address() {
    return {[](const std::string& text) {
                return listen_address_from(text) ? std::string() : text + " is not HOST:PORT";
            },
            ""};
}

CLI::Validator host_name() {
    return {[](const std::string& text) {
                return authority_from(text) ? std::string() : text + " is not HOST or HOST:PORT";
            },
            ""};
}

void add_document(CLI::App& app, std::filesystem::path& document) {
    app.add_option("document", document, "a scene (bouguer-scene/1) or a job (bouguer-job/1)")
        ->required()
        ->type_name("SCENE.json");
}

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "threads that render; 0: one for each hardware thread")
        ->check(CLI::Range(0, 1024));
}

void add_overrides(CLI::App& app, Overrides& o) {
    constexpr const char* kGroup = "In place of what the document says";
    const auto integrators = renderer::integrator_names();
    app.add_option("--integrator", o.integrator, "hall (spectral) or rgb (three channels)")
        ->check(CLI::IsMember(std::vector<std::string>(integrators.begin(), integrators.end())))
        ->group(kGroup);
    app.add_option("--resolution", o.resolution, "size of the picture in pixels")
        ->type_name("WIDTHxHEIGHT")
        ->group(kGroup);
    app.add_option("--wavelength-step", o.wavelength_step, "spacing of the wavelengths, nm")
        ->check(within(1.0, 100.0))
        ->group(kGroup);
    const auto observers = renderer::observer_names();
    app.add_option("--observer", o.observer, "whose colour-matching functions count")
        ->check(CLI::IsMember(std::vector<std::string>(observers.begin(), observers.end())))
        ->group(kGroup);
    app.add_option("--max-depth", o.max_depth, "reflections and refractions in a row")
        ->check(CLI::Range(0, api::Limits{}.max_depth))
        ->group(kGroup);
}

void add_stop_overrides(CLI::App& app, Overrides& o) {
    constexpr const char* kGroup = "When to stop: whichever is first, in place of the document's";
    app.add_option("--samples", o.samples, "after so many samples a pixel")
        ->check(CLI::Range(std::uint32_t{1}, std::uint32_t{1'000'000}))
        ->group(kGroup);
    app.add_option("--seconds", o.seconds, "after so long, at the end of a pass")
        ->check(within(1e-3, 86'400.0))
        ->group(kGroup);
    app.add_option("--error", o.error, "when the relative RMSE is below, with 95 % confidence")
        ->check(within(1e-6, 1.0))
        ->group(kGroup);
}

void add_output_text(CLI::App& app, const api::OutputParameter& parameter, api::OutputTexts& texts,
                     const char* group) {
    app.add_option_function<std::string>(
           option_of(parameter.name),
           [&texts, name = std::string(parameter.name)](const std::string& text) {
               texts[name] = text;
           },
           std::string(parameter.description))
        ->group(group);
}

void add_output_overrides(CLI::App& app, Overrides& o) {
    constexpr const char* kGroup = "In place of what the document says";
    app.add_option("--seed", o.seed, "of all random numbers")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53U))
        ->group(kGroup);
    for (const auto& parameter : api::kOutputParameters)
        add_output_text(app, parameter, o.output, kGroup);
}

void add_serve(CLI::App& app, ServeOptions& o) {
    app.add_option("--listen", o.listen, "address and port; port 0 is any free one")
        ->type_name("HOST:PORT")
        ->capture_default_str();
    app.add_flag("--allow-remote", o.allow_remote,
                 "let --listen be an address that other machines can reach, e.g. 0.0.0.0. There "
                 "is no login: whoever can reach the port can use the service");
    app.add_option("--data", o.data, "folder for jobs and results; made if need be")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_flag("--accept-loss", o.accept_loss,
                 "start also when jobs or results are missing in the data folder; results without "
                 "a job are moved to DATA/lost-results");
    app.add_option("--assets", o.assets,
                   "folder of the files that scenes name by a path; DATA/assets "
                   "by default")
        ->type_name("DIR");
    add_threads(app, o.threads);
    app.add_option("--memory", o.memory_gib,
                   "GiB for all running jobs together; 0: half of the machine's, or of what its "
                   "control group (container) may have")
        ->check(within(0.0, 1e6));
    app.add_option("--max-seconds", o.max_seconds,
                   "seconds of rendering that one job gets; what is there by then is its result")
        ->check(within(0.001, 1e9))
        ->type_name("SECONDS")
        ->capture_default_str();
    app.add_option("--queue", o.queue, "jobs that may wait or run; beyond: 503")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
        ->capture_default_str();
    app.add_option("--cors-origin", o.cors_origins,
                   "origin of web pages elsewhere that may call the API; may be repeated. * is "
                   "every page, for reading only")
        ->type_name("ORIGIN");
    app.add_option("--allowed-host", o.allowed_hosts,
                   "name under which this service may be asked, e.g. behind a proxy; may be "
                   "repeated. Loopback names are allowed by themselves, other addresses with "
                   "--allow-remote, too")
        ->check(host_name())
        ->type_name("HOST[:PORT]");
    const CLI::Range connections(std::size_t{1}, std::size_t{1'000'000});
    app.add_option("--max-connections", o.max_connections,
                   "connections that may be open at once, event streams included; 16384 unless "
                   "said, and never more than the limit of open files has room for. Beyond: 503, "
                   "but for /livez and /readyz, which have places of their own")
        ->check(connections)
        ->type_name("N");
    app.add_option("--max-connections-per-address", o.max_connections_per_address,
                   "of one client (an IPv4 address, an IPv6 /64), which has the same part of "
                   "buffers and of waiting requests; a quarter of all unless said")
        ->check(connections)
        ->type_name("N");
    app.add_option("--health-listen", o.health_listen,
                   "address of a listener of its own for /livez and /readyz, and for nothing else")
        ->check(listen_address())
        ->type_name("HOST:PORT");
    app.add_option("--drain-delay", o.drain_delay_s,
                   "seconds after SIGTERM in which /readyz says 503 and no job is taken, but all "
                   "else is served; then the daemon closes. A second signal ends it at once")
        ->check(CLI::Range(0, 3600))
        ->type_name("SECONDS")
        ->capture_default_str();
}

void add_render(CLI::App& app, RenderOptions& o) {
    add_document(app, o.document);
    app.add_option("-o,--output", o.outputs, "picture to write, .png or .exr; may be repeated")
        ->required()
        ->allow_extra_args(false)
        ->type_name("FILE");
    app.add_option("--report", o.report, "error against run time, health, plan and timings as JSON")
        ->type_name("FILE.json");
    add_threads(app, o.threads);
    add_overrides(app, o.overrides);
    add_stop_overrides(app, o.overrides);
    add_output_overrides(app, o.overrides);
}

void add_compare(CLI::App& app, CompareOptions& o) {
    constexpr const char* kFiles = "picture: .exr, or .png as shown";
    app.add_option("a", o.a, kFiles)->required()->type_name("A");
    app.add_option("b", o.b, kFiles)->required()->type_name("B");
    app.add_option("-o,--output", o.map, "map of the differences to write, .png")
        ->type_name("MAP.png");
    app.add_flag("--json", o.json, "as JSON");
    for (const auto& parameter : api::kOutputParameters) {
        if (parameter.is_compared)
            add_output_text(app, parameter, o.output, "How both are shown (EXR)");
    }
}

/// All subcommands and where what they read goes to.
struct CommandLine {
    CLI::App app{"Bouguer: a spectral renderer, as a service and for the shell", "bouguer"};
    bool wants_version = false;
    ServeOptions serve;
    RenderOptions render;
    ValidateOptions validate;
    PlanOptions plan;
    CompareOptions compare;
    CLI::App* serve_app = app.add_subcommand("serve", "run the daemon");
    CLI::App* render_app = app.add_subcommand("render", "render a scene into files");
    CLI::App* validate_app = app.add_subcommand("validate", "tell every problem of a document");
    CLI::App* plan_app =
        app.add_subcommand("plan", "tell what a scene needs and what is left out, and why");
    CLI::App* compare_app =
        app.add_subcommand("compare", "tell how different two pictures look, in CIEDE2000");

    CommandLine() {
        app.require_subcommand(0, 1);
        app.add_flag("--version", wants_version, "versions of the program and its libraries");
        app.footer("Exit codes: 0 done, 1 failed or interrupted, 2 bad usage or input.");
        add_serve(*serve_app, serve);
        add_render(*render_app, render);
        add_document(*validate_app, validate.document);
        add_document(*plan_app, plan.document);
        add_overrides(*plan_app, plan.overrides);
        plan_app->add_flag("--json", plan.json, "as JSON");
        add_compare(*compare_app, compare);
    }

    [[nodiscard]] std::variant<Command, UsageMessage> chosen() const {
        if (wants_version) return Command(VersionOptions{});
        if (serve_app->parsed()) return Command(serve);
        if (render_app->parsed()) return Command(render);
        if (validate_app->parsed()) return Command(validate);
        if (plan_app->parsed()) return Command(plan);
        if (compare_app->parsed()) return Command(compare);
        return UsageMessage{kExitBadInput, app.help()};
    }
};

}  // namespace

std::variant<Command, UsageMessage> read_command_line(std::span<const char* const> arguments) {
    CommandLine line;
    // CLI11 takes a vector from its end.
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
        line.app.parse(std::move(reversed));
    } catch (const CLI::ParseError& e) {
        std::ostringstream text;
        const bool is_help = line.app.exit(e, text, text) == 0;
        return UsageMessage{is_help ? kExitOk : kExitBadInput, text.str()};
    }
    return line.chosen();
}

}  // namespace bouguer::server
