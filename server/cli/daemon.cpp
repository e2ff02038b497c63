// SPDX-License-Identifier: Apache-2.0
#include "server/cli/daemon.h"

#include <sys/resource.h>

#include <algorithm>
#include <thread>

#include "api/json_builder.h"
#include "server/http/authority.h"
#include "server/http/http_server.h"
#include "server/jobs/job_manager.h"
#include "server/log.h"
#include "server/machine_memory.h"
#include "server/storage/data_folder.h"
#include "server/storage/folder_asset_source.h"
#include "server/storage/folder_asset_store.h"
#include "server/storage/folder_result_store.h"
#include "server/storage/sqlite_job_store.h"
#include "server/storage/store_gaps.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

/// What the process may use goes to those who hold much; where that cannot be learnt, 8 GiB.
MemoryShares memory_shares() {
    const std::uint64_t machine = machine_memory_bytes();
    return share_memory(machine > 0 ? machine : std::uint64_t{8} << 30U);
}

/// As many open files as the system lets us have: connections need one each.
void raise_descriptor_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    limit.rlim_cur = limit.rlim_max;
    (void)setrlimit(RLIMIT_NOFILE, &limit);
}

JobManagerOptions manager_options(const ServeOptions& options, const MemoryShares& memory) {
    JobManagerOptions result;
    result.threads = options.threads > 0 ? options.threads
                                         : static_cast<int>(std::thread::hardware_concurrency());
    result.max_seconds = options.max_seconds;
    result.scheduler.tasks = options.queue;
    result.scheduler.memory_bytes =
        options.memory_gib > 0 ? static_cast<std::uint64_t>(options.memory_gib * (1U << 30U))
                               : memory.jobs;
    result.documents.memory_bytes =
        std::min(result.documents.memory_bytes, result.scheduler.memory_bytes);
    result.scene_cache_bytes = memory.scenes;
    result.accepted_bytes = memory.accepted;
    return result;
}

HttpOptions http_options(const ServeOptions& options, const ListenAddress& address,
                         const MemoryShares& memory) {
    HttpOptions http;
    http.host = address.host;
    http.port = address.port;
    http.cors_origins = options.cors_origins;
    for (const std::string& host : options.allowed_hosts) {
        if (auto allowed = authority_from(host)) http.allowed_hosts.push_back(std::move(*allowed));
    }
    http.max_connections = options.max_connections;
    http.max_connections_per_client = options.max_connections_per_address;
    if (const auto health = listen_address_from(options.health_listen)) {
        http.health = HealthAddress{health->host, health->port};
    }
    HttpLimits& limits = http.limits;
    limits.buffered_bytes = memory.buffers;
    limits.upload_bytes = memory.uploads;
    // One that could never fit is told so at once.
    limits.body_bytes = std::min<std::size_t>(limits.body_bytes, memory.buffers);
    limits.asset_bytes = std::min<std::size_t>(limits.asset_bytes, memory.uploads);
    return http;
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

Result<void> make_folders(const ServeOptions& options, const fs::path& assets) {
    std::error_code error;
    fs::create_directories(options.data, error);
    if (!error) fs::create_directories(assets, error);
    if (!error) return {};
    return fail(ErrorKind::Internal, "cannot make the data folder: " + error.message());
}

}  // namespace

/// In the order in which they need each other.
struct Daemon::Parts {
    std::unique_ptr<SqliteJobStore> jobs;
    std::unique_ptr<FolderResultStore> results;
    std::unique_ptr<FolderAssetStore> uploads;
    std::unique_ptr<FolderAssetSource> assets;
    std::unique_ptr<JobManager> manager;
    std::unique_ptr<HttpServer> http;
};

Daemon::Daemon(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Daemon::~Daemon() = default;
Daemon::Daemon(Daemon&& other) noexcept = default;
Daemon& Daemon::operator=(Daemon&& other) noexcept = default;

Result<Daemon> Daemon::start(const ServeOptions& options, const ListenAddress& address) {
    raise_descriptor_limit();
    auto made_parts = std::make_unique<Parts>();
    Parts& parts = *made_parts;
    const fs::path assets = options.assets.empty() ? options.data / "assets" : options.assets;
    if (auto made = make_folders(options, assets); !made) return tl::unexpected(made.error());
    auto jobs = SqliteJobStore::open(options.data / "jobs.sqlite");
    if (!jobs) return tl::unexpected(jobs.error());
    parts.jobs = std::move(*jobs);
    auto results = FolderResultStore::open(options.data / "results");
    if (!results) return tl::unexpected(results.error());
    parts.results = std::move(*results);
    if (auto settled = settle_stores(*parts.jobs, *parts.results, options.accept_loss); !settled) {
        return tl::unexpected(settled.error());
    }
    const fs::path uploads = options.data / "assets";
    auto store = FolderAssetStore::open(uploads);
    if (!store) return tl::unexpected(store.error());
    parts.uploads = std::move(*store);
    parts.assets = std::make_unique<FolderAssetSource>(assets, uploads);
    auto folder =
        DataFolder::open({options.data, options.data / "jobs.sqlite", options.data / "results"});
    if (!folder) return tl::unexpected(folder.error());
    const MemoryShares memory = memory_shares();
    JobManagerOptions managing = manager_options(options, memory);
    managing.check_storage = [folder = std::move(*folder)] { return folder.check(); };
    parts.manager =
        std::make_unique<JobManager>(*parts.jobs, *parts.results, *parts.assets, managing);
    if (auto started = parts.manager->start(); !started) return tl::unexpected(started.error());
    auto server = HttpServer::start(*parts.manager, *parts.uploads,
                                    http_options(options, address, memory), log_request);
    if (!server) return tl::unexpected(server.error());
    parts.http = std::move(*server);
    return Daemon(std::move(made_parts));
}

int Daemon::port() const { return parts_->http->port(); }

int Daemon::health_port() const { return parts_->http->health_port(); }

void Daemon::refuse_new_jobs() { parts_->manager->refuse_new(); }

void Daemon::drain() {
    refuse_new_jobs();
    parts_->http->drain();
    parts_->http.reset();
    parts_->manager->stop();
}

}  // namespace bouguer::server
