// SPDX-License-Identifier: Apache-2.0
// Pictures that are made for an answer: bounded, because each costs up to seconds of a handler and
// some hundred MB at the largest resolution.
#pragma once

#include <type_traits>

#include "renderer/core/result.h"
#include "server/jobs/turn.h"

namespace bouguer::server {

/// Shared by all routes that make pictures. Thread-safe.
class ImageWork {
  public:
    /// Half of the default handlers: the others go on answering.
    static constexpr int kAtOnce = 2;

    /// What `make` returns, a Result; Busy, code "images-busy", when enough are at it.
    template <class Make>
    [[nodiscard]] std::invoke_result_t<Make> run(Make make) {
        const Turn turn(under_way_);
        if (turn.is_within(kAtOnce)) return make();
        return fail(ErrorKind::Busy, "other pictures are being made; try again", "images-busy");
    }

  private:
    std::atomic<int> under_way_ = 0;
};

}  // namespace bouguer::server
