// SPDX-License-Identifier: Apache-2.0
// A digest of bytes that come piece by piece.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace bouguer::api {

/// As sha256_hex() of all pieces together. Not thread-safe.
class RunningDigest {
  public:
    RunningDigest();
    ~RunningDigest();
    RunningDigest(const RunningDigest&) = delete;
    RunningDigest& operator=(const RunningDigest&) = delete;

    void add(std::string_view bytes);
    /// Lower-case hexadecimal; once, after the last piece.
    [[nodiscard]] std::string hex();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bouguer::api
