// SPDX-License-Identifier: Apache-2.0
// Feeds bytes to the reader of documents: nothing may crash, throw or leak, and what is accepted
// must be accepted again in its canonical form. Not part of the default build:
//
//     cmake -S . -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DBOUGUER_BUILD_FUZZERS=ON
//           -DCMAKE_BUILD_TYPE=RelWithDebInfo -DBOUGUER_SANITIZE=address,undefined,fuzzer-no-link
//     cmake --build build/fuzz --target job_document_fuzz
//     tests/fuzz/make_document_corpus.py build/fuzz/documents
//     build/fuzz/tests/fuzz/job_document_fuzz -dict=build/fuzz/documents/words
//     build/fuzz/documents/corpus
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "api/job_document.h"
#include "api/writers.h"
#include "tests/api/fake_assets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace bouguer;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto job = api::parse_job(text, api::Limits{}, tests::FakeAssets{});
    if (!job) {
        if (api::problem_json(job.error()).empty()) std::abort();
        return 0;
    }
    const auto again = api::parse_job(job->canonical, api::Limits{}, tests::FakeAssets{});
    if (!again || again->digest != job->digest || again->canonical != job->canonical) std::abort();
    return 0;
}
