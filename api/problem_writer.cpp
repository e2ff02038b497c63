// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <nlohmann/json.hpp>

#include "api/writers.h"

namespace bouguer::api {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct KindEntry {
    ErrorKind kind;
    int status;
    std::string_view code;
    std::string_view title;
};

/// The one table of what an error is on the wire.
constexpr std::array kKinds{
    KindEntry{ErrorKind::Malformed, 400, "malformed-document", "The document cannot be read"},
    KindEntry{ErrorKind::InvalidInput, 422, "invalid-document", "The document is refused"},
    KindEntry{ErrorKind::NotFound, 404, "not-found", "There is no such thing"},
    KindEntry{ErrorKind::Conflict, 409, "conflict", "The state of things does not allow it"},
    KindEntry{ErrorKind::TooLarge, 413, "content-too-large", "The content is too large"},
    KindEntry{ErrorKind::Busy, 503, "busy", "There is no room now"},
    KindEntry{ErrorKind::Internal, 500, "internal-error", "Something failed on our side"},
};

/// Errors whose code says more than their kind: a fault of the storage is over some time, and what
/// was asked can be asked again.
constexpr std::array kCodes{
    KindEntry{ErrorKind::Internal, 507, "storage-full", "There is no space on the disk now"},
    KindEntry{ErrorKind::Internal, 503, "storage-failed", "The storage does not work now"},
};

const KindEntry& entry_of(const Error& error) {
    for (const KindEntry& entry : kCodes) {
        if (entry.code == error.code) return entry;
    }
    for (const KindEntry& entry : kKinds) {
        if (entry.kind == error.kind) return entry;
    }
    return kKinds.back();
}

OrderedJson problem_object(int status, std::string_view code, std::string_view title,
                           std::string_view detail) {
    OrderedJson json;
    json["type"] = "/docs/problems#" + std::string(code);
    json["title"] = title;
    json["status"] = status;
    json["detail"] = detail;
    return json;
}

OrderedJson problem_entry(const Problem& problem) {
    OrderedJson json;
    json["pointer"] = problem.pointer;
    json["code"] = problem.code;
    json["detail"] = problem.detail;
    if (!problem.found.empty()) json["found"] = problem.found;
    if (!problem.allowed.empty()) json["allowed"] = problem.allowed;
    return json;
}

std::string finish(OrderedJson json, std::string_view request_id) {
    if (!request_id.empty()) json["request_id"] = request_id;
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

int status_of(const Error& error) { return entry_of(error).status; }

std::string code_of(const Error& error) {
    return error.code.empty() ? std::string(entry_of(error).code) : error.code;
}

std::string problem_json(const Error& error, std::string_view request_id) {
    OrderedJson json =
        problem_object(status_of(error), code_of(error), entry_of(error).title, error.message);
    if (!error.problems.empty()) {
        json["errors"] = OrderedJson::array();
        for (const Problem& problem : error.problems) {
            json["errors"].push_back(problem_entry(problem));
        }
    }
    return finish(std::move(json), request_id);
}

std::string problem_json(int status, std::string_view code, std::string_view title,
                         std::string_view detail, std::string_view request_id) {
    return finish(problem_object(status, code, title, detail), request_id);
}

}  // namespace bouguer::api
