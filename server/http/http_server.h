// SPDX-License-Identifier: Apache-2.0
// The daemon's HTTP side: what the main program sees of it.
#pragma once

#include <memory>

#include "renderer/core/result.h"
#include "server/http/http_options.h"
#include "server/jobs/job_service.h"
#include "server/storage/asset_store.h"

namespace bouguer::server {

/// Serves the API, the documentation and the web page from the moment it is made. Thread-safe.
class HttpServer {
  public:
    /// Binds and starts. `jobs` and `assets` outlive the server. Error{Internal} when the address
    /// cannot be bound.
    [[nodiscard]] static Result<std::unique_ptr<HttpServer>> start(JobService& jobs,
                                                                   AssetStore& assets,
                                                                   HttpOptions options,
                                                                   AccessLog log);
    /// Stops at once; call drain() first to be polite.
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// The port that was bound.
    [[nodiscard]] int port() const;
    /// That of the listener for health; 0: there is none.
    [[nodiscard]] int health_port() const;
    /// Connections that are open now, event streams included.
    [[nodiscard]] std::size_t connections() const;

    /// Accepts nothing more, finishes the requests under way, closes event streams; returns when
    /// all are gone or HttpDeadlines::drain has passed. Idempotent.
    void drain();

  private:
    class Impl;
    explicit HttpServer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace bouguer::server
