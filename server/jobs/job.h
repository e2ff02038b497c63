// SPDX-License-Identifier: Apache-2.0
// A job as the service knows it: its state, and which changes of state are legal.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "renderer/report.h"

namespace bouguer::server {

using JobId = std::string;  ///< UUIDv7, lower case [RFC 9562 §5.7]: sorts by time of submission

enum class JobState { Queued, Running, Done, Failed, Cancelled };

/// "queued", "running", "done", "failed", "cancelled".
[[nodiscard]] std::string_view to_string(JobState state);
[[nodiscard]] std::optional<JobState> job_state_from(std::string_view name);

/// The one table of legal transitions. Running -> Queued is what a restart does with interrupted
/// work.
inline constexpr std::array kLegalTransitions{
    std::pair{JobState::Queued, JobState::Running},
    std::pair{JobState::Queued, JobState::Cancelled},
    std::pair{JobState::Queued, JobState::Failed},
    std::pair{JobState::Running, JobState::Done},
    std::pair{JobState::Running, JobState::Failed},
    std::pair{JobState::Running, JobState::Cancelled},
    std::pair{JobState::Running, JobState::Queued},
};
[[nodiscard]] constexpr bool is_legal(JobState from, JobState to) {
    for (const auto& t : kLegalTransitions) {
        if (t.first == from && t.second == to) return true;
    }
    return false;
}
/// Done, Failed, Cancelled: nothing follows.
[[nodiscard]] constexpr bool is_final(JobState s) {
    return s == JobState::Done || s == JobState::Failed || s == JobState::Cancelled;
}

/// How far a job is. Of a running job it is known in memory only and lost at a restart, when
/// rendering begins again; with the end of a job it is stored.
struct JobProgress {
    double fraction = 0;  ///< [0, 1]
    std::uint32_t samples = 0, pass = 0;
    std::uint64_t rays = 0;
    double seconds = 0;
    std::optional<double> seconds_left;
    std::optional<renderer::Estimate> rmse, relative_rmse;  ///< of the newest pass; empty: unknown
    bool operator==(const JobProgress&) const = default;
};

/// What is stored of a job. Plain value.
struct Job {
    JobId id;
    JobState state = JobState::Queued;
    int priority = 0;
    std::int64_t created_ms = 0, started_ms = 0, ended_ms = 0;  ///< Unix time; 0: not yet
    std::uint64_t revision = 1;                                 ///< grows with every stored change
    std::uint32_t attempts = 0;      ///< times it began, without those that an orderly stop ended
    std::uint64_t memory_bytes = 0;  ///< that rendering it is expected to take
    std::string name;                ///< the scene's
    std::map<std::string, std::string> labels;
    std::string scene_digest, digest;  ///< "sha256-<hex>"
    std::string request;               ///< canonical job document
    std::string failure;               ///< why it failed, fit for a client
    std::string failure_code;          ///< the same as a stable name, e.g. "crashed-the-server"
    JobProgress progress;              ///< of a job that has ended: how far it came
    bool operator==(const Job&) const = default;
};

}  // namespace bouguer::server
