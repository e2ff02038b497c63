// SPDX-License-Identifier: Apache-2.0
// Errors as values: what a function that can be refused returns.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace bouguer {

/// One thing that is wrong with a client's document.
struct Problem {
    std::string pointer;  ///< where: RFC 6901 JSON pointer into the document; "" is the whole of it
    std::string code;     ///< stable, for programs: "unknown-key", "out-of-range", "not-finite" ...
    std::string detail;   ///< for people: one sentence
    std::string found;    ///< what stands there, shortened; may be empty
    std::string allowed;  ///< what would be accepted, e.g. "a number in [0, 1]"; may be empty
    bool operator==(const Problem&) const = default;
};

/// Why an operation was refused. The HTTP status and the exit code follow from it, each in one
/// place.
enum class ErrorKind {
    Malformed,     ///< not a document of the right language at all (400)
    InvalidInput,  ///< a document whose values are refused (422)
    NotFound,      ///< 404
    Conflict,      ///< the state of things does not allow it (409)
    TooLarge,      ///< over a limit that is checked before reading (413)
    Busy,          ///< no room now; try again later (503)
    Internal       ///< the environment or we failed: disk, memory (500)
};

struct Error {
    ErrorKind kind = ErrorKind::Internal;
    std::string message;  ///< one sentence, fit for a client
    std::vector<Problem>
        problems;      ///< every problem of the document, for InvalidInput and Malformed
    std::string code;  ///< stable name of the error when `kind` alone is too coarse
};

template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for `return fail(ErrorKind::NotFound, "no such job")`.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorKind kind, std::string message,
                                                std::string code = {}) {
    return tl::unexpected<Error>(Error{kind, std::move(message), {}, std::move(code)});
}

}  // namespace bouguer
