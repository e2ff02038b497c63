// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job.h"

namespace bouguer::server {
namespace {

constexpr std::array kStateNames{
    std::pair{JobState::Queued, std::string_view("queued")},
    std::pair{JobState::Running, std::string_view("running")},
    std::pair{JobState::Done, std::string_view("done")},
    std::pair{JobState::Failed, std::string_view("failed")},
    std::pair{JobState::Cancelled, std::string_view("cancelled")},
};

}  // namespace

std::string_view to_string(JobState state) {
    for (const auto& [value, name] : kStateNames) {
        if (value == state) return name;
    }
    return "unknown";
}

std::optional<JobState> job_state_from(std::string_view name) {
    for (const auto& [value, known] : kStateNames) {
        if (known == name) return value;
    }
    return std::nullopt;
}

}  // namespace bouguer::server
