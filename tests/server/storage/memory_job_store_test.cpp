// SPDX-License-Identifier: Apache-2.0
#include "server/storage/memory_job_store.h"

#include "tests/server/storage/job_store_contract.h"

namespace bouguer::server {
namespace {

struct MemoryBackend {
    std::unique_ptr<JobStore> make() { return std::make_unique<MemoryJobStore>(); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Memory, JobStoreContract, MemoryBackend);

}  // namespace
}  // namespace bouguer::server
