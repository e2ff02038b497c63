// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>
#include <unistd.h>

#include <iostream>
#include <thread>

#include "api/json_builder.h"
#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/document.h"
#include "server/cli/listen_address.h"
#include "server/cli/stop_signal.h"
#include "server/http/http_server.h"
#include "server/jobs/job_manager.h"
#include "server/log.h"
#include "server/storage/durable_file.h"
#include "server/storage/folder_asset_source.h"
#include "server/storage/folder_asset_store.h"
#include "server/storage/folder_result_store.h"
#include "server/storage/sqlite_job_store.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

/// Half of the machine's memory.
std::uint64_t default_memory_bytes() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page_bytes = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_bytes <= 0) return SchedulerLimits().memory_bytes;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes) / 2;
}

/// As many open files as the system lets us have: connections need one each.
void raise_descriptor_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    limit.rlim_cur = limit.rlim_max;
    (void)setrlimit(RLIMIT_NOFILE, &limit);
}

JobManagerOptions manager_options(const ServeOptions& options) {
    JobManagerOptions result;
    result.threads = options.threads > 0 ? options.threads
                                         : static_cast<int>(std::thread::hardware_concurrency());
    result.scheduler.tasks = options.queue;
    result.scheduler.memory_bytes =
        options.memory_gib > 0 ? static_cast<std::uint64_t>(options.memory_gib * (1U << 30U))
                               : default_memory_bytes();
    result.documents.memory_bytes =
        std::min(result.documents.memory_bytes, result.scheduler.memory_bytes);
    return result;
}

void log_request(const AccessRecord& record) {
    log_event(record.error.empty() ? LogLevel::Info : LogLevel::Error, "request",
              {{"request_id", record.request_id},
               {"method", record.method},
               {"path", record.path},
               {"status", std::to_string(record.status)},
               {"milliseconds", api::json_number(record.milliseconds)},
               {"bytes", std::to_string(record.bytes)},
               {"client", record.client},
               {"error", record.error}});
}

/// The parts of a running daemon, in the order in which they need each other.
struct Daemon {
    std::unique_ptr<SqliteJobStore> jobs;
    std::unique_ptr<FolderResultStore> results;
    std::unique_ptr<FolderAssetStore> uploads;
    std::unique_ptr<FolderAssetSource> assets;
    std::unique_ptr<JobManager> manager;
    std::unique_ptr<HttpServer> http;
};

Result<void> make_folders(const ServeOptions& options, const fs::path& assets) {
    std::error_code error;
    fs::create_directories(options.data, error);
    if (!error) fs::create_directories(assets, error);
    if (!error) return {};
    return fail(ErrorKind::Internal, "cannot make the data folder: " + error.message());
}

Result<Daemon> start(const ServeOptions& options, const ListenAddress& address) {
    Daemon daemon;
    const fs::path assets = options.assets.empty() ? options.data / "assets" : options.assets;
    if (auto made = make_folders(options, assets); !made) return tl::unexpected(made.error());
    auto jobs = SqliteJobStore::open(options.data / "jobs.sqlite");
    if (!jobs) return tl::unexpected(jobs.error());
    daemon.jobs = std::move(*jobs);
    auto results = FolderResultStore::open(options.data / "results");
    if (!results) return tl::unexpected(results.error());
    daemon.results = std::move(*results);
    const fs::path uploads = options.data / "assets";
    auto store = FolderAssetStore::open(uploads);
    if (!store) return tl::unexpected(store.error());
    daemon.uploads = std::move(*store);
    daemon.assets = std::make_unique<FolderAssetSource>(assets, uploads);
    daemon.manager = std::make_unique<JobManager>(*daemon.jobs, *daemon.results, *daemon.assets,
                                                  manager_options(options));
    if (auto started = daemon.manager->start(); !started) return tl::unexpected(started.error());
    HttpOptions http;
    http.host = address.host;
    http.port = address.port;
    http.cors_origins = options.cors_origins;
    auto server = HttpServer::start(*daemon.manager, *daemon.uploads, http, log_request);
    if (!server) return tl::unexpected(server.error());
    daemon.http = std::move(*server);
    return daemon;
}

void drain(Daemon& daemon) {
    log_event(LogLevel::Info, "draining", {});
    daemon.manager->refuse_new();
    daemon.http->drain();
    daemon.http.reset();
    daemon.manager->stop();
    log_event(LogLevel::Info, "stopped", {});
}

}  // namespace

int run_serve(const ServeOptions& options) {
    StopSignal stop;
    const auto asked = listen_address_from(options.listen);
    if (!asked) {
        std::cerr << "bouguer: --listen wants HOST:PORT, e.g. 127.0.0.1:8080\n";
        return kExitBadInput;
    }
    if (!is_loopback(asked->host) && !options.allow_remote) {
        std::cerr << "bouguer: " << asked->host
                  << " can be reached from other machines, and there is no login; say "
                     "--allow-remote if that is wanted\n";
        return kExitBadInput;
    }
    raise_descriptor_limit();
    auto daemon = start(options, *asked);
    if (!daemon) {
        print_error(std::cerr, daemon.error());
        return kExitFailed;
    }
    const ListenAddress address{asked->host, daemon->http->port()};
    const fs::path port_file = options.data / "port";
    if (auto written = replace_file(port_file, std::to_string(address.port) + "\n"); !written) {
        print_error(std::cerr, written.error());
        return kExitFailed;
    }
    std::cout << "listening on " << url_of(address) << std::endl;
    log_event(LogLevel::Info, "listening", {{"url", url_of(address)}});
    stop.wait();
    drain(*daemon);
    std::error_code ignored;
    fs::remove(port_file, ignored);
    return kExitOk;
}

}  // namespace bouguer::server
