// SPDX-License-Identifier: Apache-2.0
#include "server/http/router.h"

#include <algorithm>
#include <array>
#include <exception>

#include "server/http/memory_stream.h"
#include "server/http/origin_policy.h"
#include "server/http/plain_answer.h"
#include "server/http/problems.h"
#include "server/http/query.h"

namespace bouguer::server {
namespace {

/// The exchange that this thread works on: the library's handlers have no other way to it.
thread_local Exchange* current_exchange = nullptr;

constexpr Refusal kInternal{500, "internal-error",
                            "Something went wrong inside; the request id finds it in the log."};
constexpr Refusal kOutOfMemory{503, "out-of-memory", "There is no memory for this now."};
constexpr Refusal kWrongType{415, "media-type-not-supported",
                             "Send the body with Content-Type: application/json."};
constexpr Refusal kForeignOrigin{403, "origin-not-allowed",
                                 "Pages of this origin may not change anything here."};
constexpr Refusal kWrongMethod{405, "method-not-allowed",
                               "This address exists, but not for this method."};

/// Fields that the library would act upon although the front has done so already.
constexpr std::array<std::string_view, 6> kConsumed{"Content-Length", "Transfer-Encoding", "Expect",
                                                    "Connection",     "Accept-Encoding",   "TE"};

bool is_consumed(std::string_view name) {
    return std::any_of(kConsumed.begin(), kConsumed.end(),
                       [&](std::string_view c) { return equal_ignoring_case(c, name); });
}

/// The library has seen the request line only. It gets the query and the fields as we read them, of
/// which none is lost, percent-decoded or mixed with its own REMOTE_ADDR, and the body without a
/// copy.
void fill_request(Exchange& exchange, httplib::Request& request) {
    request.headers.clear();
    for (HeaderField& field : exchange.head.fields) {
        if (is_consumed(field.name)) continue;
        // of an upload the type does not count, and the library would take it for a form
        if (exchange.head.is_upload() && equal_ignoring_case(field.name, "Content-Type")) continue;
        request.headers.emplace(field.name, field.value);
    }
    request.params = params_of(exchange.head.target);
    request.headers.emplace("Content-Length", "0");
    request.body = std::move(exchange.body);
    request.remote_addr = exchange.client;
    // ranges are a matter of the routes: the library would apply them to every answer
    request.ranges.clear();
}

bool is_json_type(std::string_view type) {
    const std::string_view essence = type.substr(0, std::min(type.find(';'), type.size()));
    const auto end = essence.find_last_not_of(" \t");
    const std::string_view name = essence.substr(0, end == std::string_view::npos ? 0 : end + 1);
    return equal_ignoring_case(name, "application/json") ||
           (name.size() > 5 && equal_ignoring_case(name.substr(name.size() - 5), "+json"));
}

bool changes_something(const std::string& method) {
    return method != "GET" && method != "HEAD" && method != "OPTIONS";
}

void replace_header(httplib::Response& response, const char* name, const std::string& value) {
    response.headers.erase(name);
    response.set_header(name, value);
}

/// A clean answer in place of whatever was begun: nothing has been sent yet.
void answer_failure(Exchange& exchange, const Refusal& refusal, const char* error) {
    current_exchange = nullptr;
    exchange.error = error;
    exchange.stream.reset();
    exchange.waiting.reset();
    exchange.content = {};
    exchange.status = refusal.status;
    exchange.close = true;
    exchange.answer = refusal_bytes(refusal, exchange.request_id);
}

}  // namespace

Router::Router(std::vector<std::string> cors_origins) : cors_origins_(std::move(cors_origins)) {
    using Handled = httplib::Server::HandlerResponse;
    engine_.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
            return before_routing(request, response) ? Handled::Handled : Handled::Unhandled;
        });
    engine_.set_error_handler(httplib::Server::HandlerWithResponse(
        [this](const httplib::Request& request, httplib::Response& response) {
            if (response.body.empty()) on_error(request, response);
            return Handled::Handled;  // or the library forgets Content-Length
        }));
    // out of the library and into handle(), before a byte of its own answer is used
    engine_.set_exception_handler([](const httplib::Request&, httplib::Response&,
                                     const std::exception_ptr& e) { std::rethrow_exception(e); });
    engine_.set_post_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
            finish(request, response);
        });
}

httplib::Server::Handler Router::remember(std::string method, const std::string& pattern,
                                          Handler handler, Query query) {
    routes_.push_back({std::move(method), std::regex(pattern)});
    return [handler = std::move(handler), query](const httplib::Request& request,
                                                 httplib::Response& response) {
        if (query == Query::None) {
            const auto empty = query_of(request).and_then(expect_empty);
            if (!empty) return send_problem(response, empty.error(), current_exchange->request_id);
        }
        handler(request, response, *current_exchange);
    };
}

void Router::get(const std::string& pattern, Handler handler, Query query) {
    engine_.Get(pattern, remember("GET", pattern, std::move(handler), query));
}
void Router::post(const std::string& pattern, Handler handler) {
    engine_.Post(pattern, remember("POST", pattern, std::move(handler)));
}
void Router::put(const std::string& pattern, Handler handler) {
    engine_.Put(pattern, remember("PUT", pattern, std::move(handler)));
}
void Router::del(const std::string& pattern, Handler handler) {
    engine_.Delete(pattern, remember("DELETE", pattern, std::move(handler)));
}

void Router::handle(Exchange& exchange) {
    try {
        process(exchange);
        return;
    } catch (const std::bad_alloc&) {
        return answer_failure(exchange, kOutOfMemory, "out of memory");
    } catch (const std::exception& e) {
        return answer_failure(exchange, kInternal, e.what());
    } catch (...) {
        return answer_failure(exchange, kInternal, "an exception of unknown type");
    }
}

void Router::process(Exchange& exchange) {
    exchange.answer.clear();
    MemoryStream stream(exchange.head.method + ' ' + exchange.head.target + " HTTP/1.1\r\n\r\n",
                        exchange.answer);
    current_exchange = &exchange;
    engine_.process(stream, exchange.close,
                    [&](httplib::Request& request) { fill_request(exchange, request); });
    current_exchange = nullptr;
}

std::string Router::allowed_methods(const std::string& path) const {
    std::string allowed;
    for (const Route& route : routes_) {
        if (!std::regex_match(path, route.path)) continue;
        if (allowed.find(route.method) != std::string::npos) continue;
        allowed += route.method + (route.method == "GET" ? ", HEAD, " : ", ");
    }
    return allowed.empty() ? allowed : allowed + "OPTIONS";
}

bool Router::before_routing(const httplib::Request& request, httplib::Response& response) const {
    const std::string& id = current_exchange->request_id;
    const std::string origin = request.get_header_value("Origin");
    if (request.method == "OPTIONS") {
        const std::string allowed = allowed_methods(request.path);
        if (allowed.empty() && request.path != "*") return false;
        response.status = 204;
        response.set_header("Allow",
                            allowed.empty() ? "GET, HEAD, POST, PUT, DELETE, OPTIONS" : allowed);
        return true;
    }
    if (!changes_something(request.method)) return false;
    if (!origin.empty() && !is_same_origin(origin, current_exchange->head.authority) &&
        !may_change(cors_origins_, origin)) {
        send_problem(response, kForeignOrigin, id);
        return true;
    }
    if (request.method != "PUT" && !request.body.empty() &&
        !is_json_type(request.get_header_value("Content-Type"))) {
        send_problem(response, kWrongType, id);
        return true;
    }
    return false;
}

void Router::on_error(const httplib::Request& request, httplib::Response& response) const {
    const std::string& id = current_exchange->request_id;
    const std::string allowed = allowed_methods(request.path);
    if (response.status == 404 && !allowed.empty()) {
        response.set_header("Allow", allowed);
        send_problem(response, kWrongMethod, id);
    } else if (response.status == 404) {
        send_not_found(response, id);
    } else {
        send_problem(response, Refusal{400, "malformed-request", "The request cannot be read."},
                     id);
    }
}

void Router::finish(const httplib::Request& request, httplib::Response& response) const {
    Exchange& exchange = *current_exchange;
    exchange.status = response.status;
    response.headers.erase("Keep-Alive");  // the library's figures, not ours
    if (exchange.stream) {
        response.headers.erase("Content-Length");
        replace_header(response, "Connection", "close");
    }
    if (!exchange.content.empty()) {
        // the library has not seen it; of HEAD it is told and not sent [RFC 9110 §9.3.2]
        replace_header(response, "Content-Length", std::to_string(exchange.content.size()));
        if (request.method == "HEAD") exchange.content = {};
    }
    if (response.status == 204 || response.status == 304) response.headers.erase("Content-Length");
    replace_header(response, "Date", http_date());
    replace_header(response, "X-Request-Id", exchange.request_id);
    replace_header(response, "X-Content-Type-Options", "nosniff");
    if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-store");
    if (cors_origins_.empty()) return;
    response.headers.emplace("Vary", "Origin");
    const std::string origin = request.get_header_value("Origin");
    if (origin.empty() || !may_read(cors_origins_, origin)) return;
    replace_header(response, "Access-Control-Allow-Origin", origin);
    replace_header(response, "Access-Control-Expose-Headers",
                   "Accept-Ranges, Content-Range, ETag, Idempotent-Replayed, Link, Location, "
                   "Preference-Applied, Retry-After, X-Request-Id");
    if (request.method != "OPTIONS") return;
    replace_header(
        response, "Access-Control-Allow-Methods",
        may_change(cors_origins_, origin) ? "GET, HEAD, POST, PUT, DELETE" : "GET, HEAD");
    replace_header(response, "Access-Control-Allow-Headers",
                   "Content-Type, Idempotency-Key, If-Match, If-None-Match, If-Range, "
                   "Last-Event-ID, Prefer, Range, X-Request-Id");
    replace_header(response, "Access-Control-Max-Age", "600");
}

}  // namespace bouguer::server
