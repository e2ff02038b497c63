// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_id.h"

namespace bouguer::server {
namespace {

constexpr std::string_view kHex = "0123456789abcdef";
constexpr std::uint32_t kCounterBits = 12;

bool is_dash(std::size_t i) { return i == 8 || i == 13 || i == 18 || i == 23; }

/// Appends the lowest `digits` hexadecimal digits of `value`.
void append_hex(std::string& text, std::uint64_t value, int digits) {
    for (int i = digits - 1; i >= 0; --i) {
        text += kHex[(value >> (4U * static_cast<unsigned>(i))) & 15U];
    }
}

}  // namespace

bool is_job_id(std::string_view text) {
    if (text.size() != 36) return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_dash(i) ? text[i] != '-' : kHex.find(text[i]) == std::string_view::npos) {
            return false;
        }
    }
    return true;
}

JobId JobIdMaker::make(std::int64_t now_ms) {
    const std::lock_guard lock(mutex_);
    if (now_ms > last_ms_) {
        last_ms_ = now_ms;
        // Half of the counter's range is left for ids of the same millisecond.
        counter_ = random_() & ((1U << (kCounterBits - 1)) - 1);
    } else if (++counter_ == 1U << kCounterBits) {
        ++last_ms_;
        counter_ = 0;
    }
    const auto ms = static_cast<std::uint64_t>(last_ms_);
    JobId id;
    append_hex(id, ms >> 16U, 8);
    id += '-';
    append_hex(id, ms, 4);
    id += "-7";
    append_hex(id, counter_, 3);
    id += '-';
    append_hex(id, 0x8000U | (random_() & 0x3fffU), 4);
    id += '-';
    append_hex(id, random_(), 6);
    append_hex(id, random_(), 6);
    return id;
}

}  // namespace bouguer::server
