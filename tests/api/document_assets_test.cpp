// SPDX-License-Identifier: Apache-2.0
// That files are judged by their headers, all together, before one of them is read.
#include "api/document_assets.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <map>

#include "api/digest.h"
#include "api/job_document.h"
#include "tests/support/logged_source.h"

namespace bouguer::api {
namespace {

/// Files of which only the beginning is something: whoever reads on finds zeros.
class Headers final : public AssetSource {
  public:
    struct File {
        std::string first_bytes;
        std::uint64_t size;
    };
    void add(const std::string& name, std::string first_bytes, std::uint64_t size) {
        files_[name] = {std::move(first_bytes), size};
    }
    [[nodiscard]] Result<std::unique_ptr<const renderer::ByteSource>> open(
        std::string_view name) const override {
        const auto file = files_.find(name);
        if (file == files_.end()) return fail(ErrorKind::NotFound, "no such file");
        return std::make_unique<const tests::LoggedSource>(file->second.first_bytes,
                                                           file->second.size, bytes_read);
    }
    mutable std::uint64_t bytes_read = 0;

  private:
    std::map<std::string, File, std::less<>> files_;
};

std::string png_header(std::uint32_t side) {
    std::string png("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    for (int k = 0; k < 2; ++k) {
        for (int shift = 24; shift >= 0; shift -= 8) png += static_cast<char>(side >> shift);
    }
    return png + std::string("\x08\x02\0\0\0", 5);
}

std::string joined(std::initializer_list<std::string_view> parts) {
    std::string whole;
    for (const std::string_view part : parts) whole += part;
    return whole;
}

std::string ply_header(std::uint64_t vertices) {
    return joined({"ply\nformat binary_little_endian 1.0\nelement vertex ",
                   std::to_string(vertices),
                   "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                   "property list uchar int vertex_indices\nend_header\n"});
}

std::string scene(std::string_view textures, std::string_view objects) {
    return joined({R"({"format":"bouguer-scene/1","camera":{"type":"perspective","from":[0,0,9],)",
                   R"("at":[0,0,0]},"materials":{"m":{"type":"hall","k_sr":1}},"textures":{)",
                   textures, R"(},"objects":[)", objects, "]}"});
}

std::string image(std::string_view name, std::string_view path) {
    return joined({"\"", name, R"(":{"type":"image","path":")", path, "\"}"});
}

std::string mesh(std::string_view name, std::string_view path) {
    return joined({R"({"name":")", name, R"(","material":"m","shape":{"type":"file","path":")",
                   path, "\"}}"});
}

/// "pointer code" of every problem, one a line.
std::string problems_of(const Result<JobRequest>& job) {
    std::string lines;
    if (job) return "accepted";
    for (const Problem& problem : job.error().problems) {
        lines += joined({problem.pointer, " ", problem.code, "\n"});
    }
    return lines;
}

// 24 pictures of 4096 x 4096, of which two are allowed: twenty-two problems and nothing decoded.
TEST(DocumentAssets, JudgesAllPicturesBeforeOneIsDecoded) {
    Headers files;
    std::string textures, expected;
    for (char c = 'a'; c < 'a' + 24; ++c) {
        const std::string name(1, c);
        const std::string path = joined({name, ".png"});
        files.add(path, png_header(4096), 56'000);
        textures += joined({c > 'a' ? "," : "", image(name, path)});
        if (c >= 'c') expected += joined({"/textures/", name, "/path over-limit\n"});
    }
    const auto job = parse_job(scene(textures, ""), Limits{}, files);
    EXPECT_EQ(problems_of(job), expected);
    EXPECT_LE(files.bytes_read, 24U * 8192);
    ASSERT_FALSE(job.error().problems.empty());
    EXPECT_EQ(job.error().problems[0].allowed, "at most 33554432 pixels in all image textures");
}

TEST(DocumentAssets, CountsAFileOnceHoweverOftenItIsNamed) {
    Headers files;
    files.add("a.png", png_header(4096), 56'000);
    const std::string textures =
        joined({image("a", "a.png"), ",", image("b", "a.png"), ",", image("c", "a.png")});
    const auto job = parse_job(scene(textures, ""), Limits{}, files);
    // within the limits, so it is read, and found to have no pixels
    EXPECT_EQ(problems_of(job),
              "/textures/a/path bad-image\n/textures/b/path bad-image\n"
              "/textures/c/path bad-image\n");
}

// Eight meshes of a GiB each when they are built, where four GiB are allowed for a job.
TEST(DocumentAssets, JudgesAllMeshesBeforeOneIsRead) {
    Headers files;
    std::string objects, expected;
    constexpr std::uint64_t kVertices = (1U << 30U) / 80;
    for (int i = 0; i < 8; ++i) {
        const std::string name = joined({std::to_string(i), ".ply"});
        files.add(name, ply_header(kVertices), kVertices * 12 + 1000);
        objects += joined({i > 0 ? "," : "", mesh(name, name)});
        if (i >= 3)
            expected += joined({"/objects/", std::to_string(i), "/shape/path over-limit\n"});
    }
    Limits limits;
    limits.mesh_vertices = kVertices;
    const auto job = parse_job(scene("", objects), limits, files);
    EXPECT_EQ(problems_of(job), expected);
    EXPECT_LE(files.bytes_read, 8U * (64U << 10U));
}

// Pictures and meshes share what a job may have.
TEST(DocumentAssets, AddsUpWhatPicturesAndMeshesNeed) {
    Headers files;
    files.add("a.png", png_header(1000), 3'000'000);  // 3 MB decoded, and twice as much of a file
    files.add("b.ply", ply_header(10'000), 300'000);  // 0.8 MB
    Limits limits;
    limits.memory_bytes = 9'500'000;
    const std::string text = scene(image("a", "a.png"), mesh("b", "b.ply"));
    EXPECT_EQ(problems_of(parse_job(text, limits, files)), "/objects/0/shape/path over-limit\n");
    limits.memory_bytes = 10'000'000;
    EXPECT_EQ(problems_of(parse_job(text, limits, files)),
              "/objects/0/shape/path bad-mesh\n/textures/a/path bad-image\n");
}

// What is wrong with the document is told beside what is too large, and in the order of the
// readers.
TEST(DocumentAssets, TellsOtherProblemsToo) {
    Headers files;
    files.add("a.png", png_header(5000), 56'000);
    files.add("b.ply", ply_header(4), 1000);
    const std::string objects = joined({mesh("b", "b.ply"), ",", mesh("c", "none.ply")});
    const auto job = parse_job(scene(image("a", "a.png"), objects), Limits{}, files);
    EXPECT_EQ(problems_of(job),
              "/objects/1/shape/path unknown-name\n/textures/a/path over-limit\n");
}

}  // namespace
}  // namespace bouguer::api
