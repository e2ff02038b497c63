// SPDX-License-Identifier: Apache-2.0
#include "server/storage/memory_result_store.h"

#include "tests/server/storage/result_store_contract.h"

namespace bouguer::server {
namespace {

struct MemoryBackend {
    std::unique_ptr<ResultStore> make() { return std::make_unique<MemoryResultStore>(); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Memory, ResultStoreContract, MemoryBackend);

}  // namespace
}  // namespace bouguer::server
