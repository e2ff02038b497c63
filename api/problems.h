// SPDX-License-Identifier: Apache-2.0
// Where readers put what they find wrong: everything is collected, nothing stops the reading.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/core/warning.h"

namespace bouguer::api {

/// The problems of one document, up to a limit; the rest is counted. Not thread-safe.
class Problems {
  public:
    explicit Problems(std::size_t limit) : limit_(limit) {}

    void add(Problem problem);
    /// Refusals of the renderer: their pointers are relative to `pointer`, and get it in front.
    void add_below(const std::string& pointer, const Error& error);
    /// An error that is not the document's (disk, memory): the reading fails with it.
    void fail_with(Error error) { failure_ = std::move(error); }

    /// Notes what is valid and probably not meant.
    void warn(Warning warning) { warnings_.add(std::move(warning)); }
    [[nodiscard]] const Warnings& warnings() const { return warnings_; }

    [[nodiscard]] bool empty() const { return count_ == 0 && !failure_; }
    /// Whether further problems will only be counted: then details need not be worked out.
    [[nodiscard]] bool is_full() const { return listed_.size() >= limit_; }
    [[nodiscard]] std::size_t count() const { return count_; }

    /// What the reader returns when !empty(): `kind`, unless fail_with() was called.
    [[nodiscard]] Error to_error(ErrorKind kind) &&;

  private:
    std::size_t limit_;
    std::size_t count_ = 0;
    std::vector<Problem> listed_;
    std::optional<Error> failure_;
    Warnings warnings_;
};

/// `key` as a token of a JSON pointer: "~" and "/" escaped [RFC 6901 §3].
[[nodiscard]] std::string pointer_token(std::string_view key);

}  // namespace bouguer::api
