// SPDX-License-Identifier: Apache-2.0
// Where the checks of a scene put their warnings.
#pragma once

#include <string>
#include <utility>

#include "api/problems.h"

namespace bouguer::api {

/// Puts the scene's own pointer in front of every warning's.
class WarningSink {
  public:
    WarningSink(std::string pointer, Problems& problems)
        : pointer_(std::move(pointer)), problems_(problems) {}

    /// `pointer` is relative to the scene.
    void warn(const std::string& pointer, const char* code, std::string detail,
              std::string advice) {
        problems_.warn({pointer_ + pointer, code, std::move(detail), std::move(advice)});
    }

    [[nodiscard]] static std::string object(std::size_t index) {
        return "/objects/" + std::to_string(index);
    }

  private:
    std::string pointer_;
    Problems& problems_;
};

}  // namespace bouguer::api
