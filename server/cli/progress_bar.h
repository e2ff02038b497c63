// SPDX-License-Identifier: Apache-2.0
// One line on a terminal that says how a render is going.
#pragma once

#include <string>

#include "server/jobs/job.h"

namespace bouguer::server {

/// "[#####     ]  50 %  8 samples  1.2 Mrays/s  error 2.1 %  3 s left".
[[nodiscard]] std::string progress_line(const JobProgress& progress);

/// Draws on standard error if that is a terminal; otherwise does nothing. Clears its line at the
/// end.
class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void draw(const JobProgress& progress);

  private:
    const bool is_terminal_;
};

}  // namespace bouguer::server
