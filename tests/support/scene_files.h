// SPDX-License-Identifier: Apache-2.0
// The scenes of client-examples/, read as the service reads them.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "api/job_document.h"
#include "tests/support/named_bytes.h"

namespace bouguer::test {

inline std::string read_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error("cannot open " + path.string());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The files of one folder. For tests: names are trusted.
class FolderAssets final : public tests::NamedBytes {
  public:
    explicit FolderAssets(std::filesystem::path root) : root_(std::move(root)) {}
    [[nodiscard]] Result<std::string> bytes(std::string_view name) const override {
        return read_file(root_ / name);
    }

  private:
    std::filesystem::path root_;
};

/// The text of a scene or job document as a job, with the files beside `path`; throws with the
/// first problem when it is refused.
inline api::JobRequest read_job(const std::string& text, const std::filesystem::path& path) {
    auto job = api::parse_job(text, {}, FolderAssets(path.parent_path()));
    if (job) return std::move(*job);
    const auto& problems = job.error().problems;
    throw std::runtime_error(
        path.string() + ": " +
        (problems.empty() ? job.error().message : problems[0].pointer + " " + problems[0].detail));
}

/// The document in a file.
inline api::JobRequest load_job(const std::filesystem::path& path) {
    return read_job(read_file(path), path);
}

}  // namespace bouguer::test
