// SPDX-License-Identifier: Apache-2.0
// Where the files of finished jobs are kept. Every backend passes
// tests/server/storage/result_store_contract.h.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "server/content.h"
#include "server/jobs/job.h"

namespace bouguer::server {

/// File name -> bytes: everything that came of one job.
using ResultFiles = std::map<std::string, std::string>;

struct StoredFile {
    Content content;
    std::string digest;  ///< sha256 hex of the content, as it was when it was stored
};

/// Thread-safe for different jobs; one job is written by one thread. What put() has returned for
/// survives a crash. Errors: Internal when the store itself fails.
class ResultStore {
  public:
    virtual ~ResultStore() = default;

    /// Stores all files of a job or none, in place of what an earlier put() stored. InvalidInput:
    /// an id or a name that is not is_job_id() or is_result_name().
    [[nodiscard]] virtual Result<void> put(const JobId& id, const ResultFiles& files) = 0;
    /// NotFound; Internal, code "result-damaged", when the bytes are no longer those of the digest.
    [[nodiscard]] virtual Result<StoredFile> get(const JobId& id,
                                                 const std::string& name) const = 0;
    /// Sorted; empty when nothing is stored.
    [[nodiscard]] virtual Result<std::vector<std::string>> names(const JobId& id) const = 0;
    /// Removes all files of the job, for good when it returns; no error when there are none.
    [[nodiscard]] virtual Result<void> remove(const JobId& id) = 0;
    /// Every job that has results, in no order.
    [[nodiscard]] virtual Result<std::vector<JobId>> jobs() const = 0;
    /// Keeps the results of a job that nobody knows where they are not taken for those of one.
    [[nodiscard]] virtual Result<void> set_aside(const JobId& id) = 0;
};

/// Whether `name` can name a result: 1 to 64 of a-z 0-9 . - _, and no dot in front.
[[nodiscard]] bool is_result_name(std::string_view name);

/// Checks the arguments of put(). For backends.
[[nodiscard]] Result<void> check_results(const JobId& id, const ResultFiles& files);

}  // namespace bouguer::server
