// SPDX-License-Identifier: Apache-2.0
#include "server/utc_time.h"

#include <array>
#include <chrono>
#include <ctime>

namespace bouguer::server {

std::int64_t unix_ms() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

std::string utc_text(std::int64_t unix_ms) {
    const std::int64_t ms = ((unix_ms % 1000) + 1000) % 1000;
    const auto seconds = static_cast<std::time_t>((unix_ms - ms) / 1000);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%FT%T.", &utc);
    const std::string digits = std::to_string(1000 + ms);
    return std::string(text.data(), length) + digits.substr(1) + "Z";
}

}  // namespace bouguer::server
