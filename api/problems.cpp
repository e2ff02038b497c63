// SPDX-License-Identifier: Apache-2.0
#include "api/problems.h"

#include <utility>

namespace bouguer::api {

void Problems::add(Problem problem) {
    ++count_;
    if (!is_full()) listed_.push_back(std::move(problem));
}

void Problems::add_below(const std::string& pointer, const Error& error) {
    if (error.kind != ErrorKind::InvalidInput && error.kind != ErrorKind::Malformed) {
        return fail_with(error);
    }
    if (error.problems.empty()) {
        add({pointer, error.code.empty() ? "out-of-range" : error.code, error.message, {}, {}});
    }
    for (Problem problem : error.problems) {
        problem.pointer.insert(0, pointer);
        add(std::move(problem));
    }
}

Error Problems::to_error(ErrorKind kind) && {
    if (failure_) return *std::move(failure_);
    std::string message = count_ == 1 ? std::string("the document has a problem")
                                      : "the document has " + std::to_string(count_) + " problems";
    if (count_ > listed_.size()) {
        message += ", of which the first " + std::to_string(listed_.size()) + " are listed";
    }
    return {kind, std::move(message), std::move(listed_), {}};
}

std::string pointer_token(std::string_view key) {
    std::string token;
    token.reserve(key.size());
    for (const char c : key) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return token;
}

}  // namespace bouguer::api
