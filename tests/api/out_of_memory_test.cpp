// SPDX-License-Identifier: Apache-2.0
// Reads documents while allocations fail, each in turn: it must be an error and never the end of
// the process. An executable of its own, since it has the allocator of all of it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <string>

#include "api/digest_list.h"
#include "api/job_document.h"
#include "api/writers.h"
#include "tests/api/fake_assets.h"
#include "tests/api/malformed_documents.h"
#include "tests/support/named_bytes.h"

namespace {

constexpr std::size_t kNever = SIZE_MAX;

/// Which allocations of this thread fail, counted from the moment it is set.
struct Failing {
    std::size_t first = kNever, last = kNever;
    std::size_t seen = 0;
};
thread_local Failing failing;

void* allocate(std::size_t size) {
    const std::size_t number = failing.seen++;
    if (failing.first <= number && number <= failing.last) throw std::bad_alloc();
    void* memory = std::malloc(size > 0 ? size : 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace bouguer::api {
namespace {

/// The meshes of FakeAssets. No pictures: the library that decodes them does not live through every
/// allocation of its own that fails.
class Meshes final : public tests::NamedBytes {
  public:
    Meshes() {
        for (const char* name : {"triangle.ply", "noise.ply"}) {
            files_[name] = tests::FakeAssets{}.bytes(name).value();
        }
    }
    [[nodiscard]] Result<std::string> bytes(std::string_view name) const override {
        const auto file = files_.find(name);
        if (file == files_.end()) return fail(ErrorKind::NotFound, "no such file");
        return file->second;
    }

  private:
    std::map<std::string, std::string, std::less<>> files_;
};

/// Runs `read`, which returns a Result, with every allocation failing once, alone or with all that
/// follow. What it returns then is its usual answer or that memory ran out.
template <class Read>
void fail_each_allocation(const std::string& name, const Read& read) {
    const auto usual = read();
    for (const bool with_all_later : {false, true}) {
        for (std::size_t first = 0;; ++first) {
            failing = {first, with_all_later ? kNever - 1 : first, 0};
            const auto result = read();
            const bool has_failed = failing.seen > first;
            failing = {};
            if (!has_failed) break;
            if (!result && result.error().code == "out-of-memory") {
                EXPECT_EQ(status_of(result.error()), 503);
                continue;
            }
            ASSERT_EQ(result.has_value(), usual.has_value()) << name << ", allocation " << first;
        }
    }
}

/// The document that the malformed ones were made of has something of everything.
TEST(OutOfMemory, IsAnErrorWhereverItRunsOut) {
    const Meshes assets;
    const Limits limits;
    const auto read = [&](const std::string& body) {
        return [&, body] { return parse_job(body, limits, assets); };
    };
    auto document = nlohmann::json::parse(tests::wellformed_document());
    document["scene"]["textures"].erase("photo");
    document["scene"]["objects"][0]["shape"] = {{"type", "file"}, {"path", "triangle.ply"}};
    const std::string body = document.dump();
    ASSERT_TRUE(parse_job(body, limits, assets));
    fail_each_allocation("well-formed", read(body));
    const auto documents = tests::malformed_documents();
    for (std::size_t i = 0; i < documents.size(); i += 40) {
        fail_each_allocation(documents[i].name, read(documents[i].body));
    }
    fail_each_allocation(
        "digests", [&] { return parse_digest_list(R"({"digests": ["sha256-0", 3]})", limits); });
}

}  // namespace
}  // namespace bouguer::api
