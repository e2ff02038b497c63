// SPDX-License-Identifier: Apache-2.0
// How much memory this process may use before it is killed, and what it is shared out to.
#pragma once

#include <cstdint>
#include <filesystem>

namespace bouguer::server {

/// Bytes: the least of the machine's memory and the limits of the control groups that this process
/// and the groups around it are in [cgroups(7)]: memory.max of version 2, memory.limit_in_bytes of
/// version 1. `root` is where proc/ and the mount points that it names are looked for. 0: nothing
/// can be learnt.
[[nodiscard]] std::uint64_t machine_memory_bytes(const std::filesystem::path& root = "/");

/// Upper bounds, in bytes, that are below the machine's memory together: the rest is for the
/// program, its threads, documents that are being read and the database.
struct MemoryShares {
    std::uint64_t jobs = 0;      ///< scenes, films and pictures of all running jobs
    std::uint64_t scenes = 0;    ///< kept for jobs to come
    std::uint64_t buffers = 0;   ///< requests and answers
    std::uint64_t uploads = 0;   ///< files on their way in
    std::uint64_t accepted = 0;  ///< what was read of jobs that wait
};

/// Half for the jobs and a sixteenth each for the others, which need no more than 512 MiB, the
/// uploads and what was accepted 256.
[[nodiscard]] MemoryShares share_memory(std::uint64_t machine_bytes);

}  // namespace bouguer::server
