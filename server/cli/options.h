// SPDX-License-Identifier: Apache-2.0
// What the command line may say, as plain data: one struct a subcommand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "api/output_texts.h"

namespace bouguer::server {

/// Said on the command line in place of what the document says.
struct Overrides {
    std::optional<std::string> integrator;  ///< "hall", "rgb"
    std::optional<std::uint32_t> samples;   ///< any of these three replaces the whole stop rule
    std::optional<double> seconds, error;
    std::optional<std::uint64_t> seed;
    api::OutputTexts output;                ///< as in queries: "exposure" -> "auto"
    std::optional<std::string> resolution;  ///< "640x480"
    std::optional<double> wavelength_step;  ///< nm
    std::optional<std::string> observer;
    std::optional<int> max_depth;
    bool operator==(const Overrides&) const = default;
};

struct ServeOptions {
    std::string listen = "127.0.0.1:8080";
    bool allow_remote = false;  ///< whether `listen` may be reachable from other machines
    std::filesystem::path data = "bouguer-data";
    bool accept_loss = false;      ///< start on a data folder where something is missing
    std::filesystem::path assets;  ///< empty: DATA/assets
    int threads = 0;               ///< 0: one for each hardware thread
    double memory_gib = 0;  ///< of all running jobs together; 0: half of machine_memory_bytes()
    double max_seconds = 86'400;  ///< of rendering one job
    std::size_t queue = 1000;     ///< jobs that wait or run
    std::vector<std::string> cors_origins;
    std::vector<std::string> allowed_hosts;       ///< HOST or HOST:PORT, as requests may name us
    std::size_t max_connections = 0;              ///< 0: as HttpOptions has it
    std::size_t max_connections_per_address = 0;  ///< likewise
    std::string health_listen;                    ///< HOST:PORT; empty: no listener of its own
    int drain_delay_s = 0;  ///< from SIGTERM, when /readyz turns, to the closing of the listener
};

struct RenderOptions {
    std::filesystem::path document;
    std::vector<std::filesystem::path> outputs;  ///< .png or .exr
    std::optional<std::filesystem::path> report;
    Overrides overrides;
    int threads = 0;  ///< 0: one for each hardware thread
};

struct ValidateOptions {
    std::filesystem::path document;
};

struct PlanOptions {
    std::filesystem::path document;
    Overrides overrides;
    bool json = false;
};

struct CompareOptions {
    std::filesystem::path a, b;                ///< .exr or .png
    std::optional<std::filesystem::path> map;  ///< .png to write
    api::OutputTexts output;                   ///< how they are shown
    bool json = false;
};

struct VersionOptions {};

using Command = std::variant<ServeOptions, RenderOptions, ValidateOptions, PlanOptions,
                             CompareOptions, VersionOptions>;

}  // namespace bouguer::server
