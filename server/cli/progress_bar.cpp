// SPDX-License-Identifier: Apache-2.0
#include "server/cli/progress_bar.h"

#include <unistd.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace bouguer::server {
namespace {

constexpr int kWidth = 30;
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

std::string progress_line(const JobProgress& progress) {
    std::ostringstream line;
    const int filled = static_cast<int>(std::lround(kWidth * progress.fraction));
    line << '[' << std::string(static_cast<std::size_t>(filled), '#')
         << std::string(static_cast<std::size_t>(kWidth - filled), ' ') << "] " << std::setw(3)
         << std::lround(100 * progress.fraction) << " %  " << progress.samples << " samples";
    line << std::fixed << std::setprecision(2);
    if (progress.seconds > 0) {
        line << "  " << static_cast<double>(progress.rays) / progress.seconds / 1e6 << " Mrays/s";
    }
    if (progress.relative_rmse) line << "  error " << 100 * progress.relative_rmse->value << " %";
    if (progress.seconds_left) {
        line << "  " << std::setprecision(0) << std::ceil(*progress.seconds_left) << " s left";
    }
    return line.str();
}

ProgressBar::ProgressBar() : is_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (is_terminal_) std::cerr << kClearLine << std::flush;
}

void ProgressBar::draw(const JobProgress& progress) {
    if (is_terminal_) std::cerr << kClearLine << progress_line(progress) << std::flush;
}

}  // namespace bouguer::server
