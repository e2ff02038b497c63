// SPDX-License-Identifier: Apache-2.0
// From a complete request to the bytes of its answer. The HTTP library parses the target, finds the
// route and writes the answer; what it does not do or does otherwise than the standards is here.
#pragma once

#include <httplib.h>

#include <functional>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "server/http/exchange.h"
#include "server/http/httplib_compat.h"

namespace bouguer::server {

/// What a route makes of the query of its target.
enum class Query {
    None,     ///< there is nothing to ask for: a parameter is refused (but query_of()'s `v`)
    Ignored,  ///< one that means something to its neighbours may stand behind it as well
    Read      ///< the handler reads it by query_of() and refuses what it does not know
};

/// Routes are added before the first handle(); from then on every member is thread-safe.
class Router {
  public:
    /// Fills `response`; may throw, which becomes a 500 without the exception's text.
    using Handler = std::function<void(const httplib::Request& request, httplib::Response& response,
                                       Exchange& exchange)>;

    explicit Router(std::vector<std::string> cors_origins);

    /// `pattern`: a regular expression (ECMAScript) for the whole path. GET routes serve HEAD too.
    void get(const std::string& pattern, Handler handler, Query query = Query::None);
    void post(const std::string& pattern, Handler handler);
    /// The body may be of any media type: what is put is judged by its content.
    void put(const std::string& pattern, Handler handler);
    void del(const std::string& pattern, Handler handler);

    /// Answers `exchange`: an answer, a stream or a wait. Never throws.
    void handle(Exchange& exchange);

  private:
    struct Route {
        std::string method;
        std::regex path;
    };

    httplib::Server::Handler remember(std::string method, const std::string& pattern,
                                      Handler handler, Query query = Query::None);
    void process(Exchange& exchange);
    /// "GET, HEAD, OPTIONS" ...; empty when no route has this path.
    [[nodiscard]] std::string allowed_methods(const std::string& path) const;
    /// Answers what needs no route; false: go on.
    [[nodiscard]] bool before_routing(const httplib::Request& request,
                                      httplib::Response& response) const;
    void on_error(const httplib::Request& request, httplib::Response& response) const;
    void finish(const httplib::Request& request, httplib::Response& response) const;

    HttplibEngine engine_;
    std::vector<Route> routes_;
    const std::vector<std::string> cors_origins_;
};

}  // namespace bouguer::server
