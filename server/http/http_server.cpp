// SPDX-License-Identifier: Apache-2.0
#include "server/http/http_server.h"

#include <thread>

#include "server/http/connection_front.h"
#include "server/http/event_hub.h"
#include "server/http/image_work.h"
#include "server/http/router.h"
#include "server/http/routes/asset_routes.h"
#include "server/http/routes/compare_routes.h"
#include "server/http/routes/event_routes.h"
#include "server/http/routes/health_routes.h"
#include "server/http/routes/job_routes.h"
#include "server/http/routes/library_routes.h"
#include "server/http/routes/result_routes.h"
#include "server/http/routes/scene_routes.h"
#include "server/http/routes/web_routes.h"

namespace bouguer::server {

class HttpServer::Impl {
  public:
    Impl(JobService& jobs, AssetStore& assets, const HttpOptions& options, const AccessLog& log,
         FrontListeners listeners, const ConnectionPlan& plan)
        : deadlines_(options.deadlines),
          router_(make_router(jobs, assets, options, images_)),
          hub_(options, log),
          front_(std::move(listeners), options, plan,
                 {.handle = [this](Exchange& exchange) { router_->handle(exchange); },
                  .answer_health = [&jobs](Exchange& e) { return answer_health(jobs, e); },
                  .hub = &hub_,
                  .log = log}) {}

    [[nodiscard]] int port() const { return front_.port(); }
    [[nodiscard]] int health_port() const { return front_.health_port(); }
    [[nodiscard]] std::size_t connections() const { return front_.connections(); }

    void drain() {
        front_.begin_drain();
        hub_.close_all();
        const auto deadline = Clock::now() + deadlines_.drain;
        while (connections() > 0 && Clock::now() < deadline) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

  private:
    static std::unique_ptr<Router> make_router(JobService& jobs, AssetStore& assets,
                                               const HttpOptions& options, ImageWork& images) {
        auto router = std::make_unique<Router>(options.cors_origins);
        add_health_routes(*router, jobs);
        add_job_routes(*router, jobs, options.deadlines);
        add_event_routes(*router, jobs, options);
        add_result_routes(*router, jobs, images);
        add_compare_routes(*router, jobs, images);
        add_asset_routes(*router, assets);
        add_scene_routes(*router, jobs);
        add_library_routes(*router);
        add_web_routes(*router);
        return router;
    }

    const HttpDeadlines deadlines_;
    ImageWork images_;
    std::unique_ptr<Router> router_;
    EventHub hub_;
    ConnectionFront front_;  // last: it uses the others until it is gone
};

HttpServer::HttpServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HttpServer::~HttpServer() = default;

Result<std::unique_ptr<HttpServer>> HttpServer::start(JobService& jobs, AssetStore& assets,
                                                      HttpOptions options, AccessLog log) {
    auto all = Listener::open(options.host, options.port);
    if (!all) return tl::unexpected(all.error());
    FrontListeners listeners{std::move(*all), std::nullopt};
    if (options.health) {
        auto health = Listener::open(options.health->host, options.health->port);
        if (!health) return tl::unexpected(health.error());
        listeners.health = std::move(*health);
    }
    const ConnectionPlan plan = plan_connections(options, descriptor_limit());
    return std::unique_ptr<HttpServer>(new HttpServer(
        std::make_unique<Impl>(jobs, assets, options, log, std::move(listeners), plan)));
}

int HttpServer::port() const { return impl_->port(); }
int HttpServer::health_port() const { return impl_->health_port(); }
std::size_t HttpServer::connections() const { return impl_->connections(); }
void HttpServer::drain() { impl_->drain(); }

}  // namespace bouguer::server
