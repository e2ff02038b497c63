// SPDX-License-Identifier: Apache-2.0
#include "server/machine_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// A place where a hierarchy of control groups that limit memory can be seen.
struct Mount {
    fs::path point;        ///< below `root`
    fs::path top;          ///< the group that stands at the mount point
    const char* file;      ///< of a group, with its limit
    std::string own_line;  ///< how the line of proc/self/cgroup begins after the number
};

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

bool has_option(const std::string& options, const std::string& wanted) {
    std::istringstream in(options);
    for (std::string option; std::getline(in, option, ',');) {
        if (option == wanted) return true;
    }
    return false;
}

/// proc/self/mountinfo [proc(5)]: "id parent device ROOT POINT options ... - TYPE source OPTIONS".
std::optional<Mount> mount_of(const std::string& line) {
    const std::vector<std::string> words = words_of(line);
    const auto dash = std::find(words.begin(), words.end(), "-");
    if (words.size() < 10 || words.end() - dash < 4) return std::nullopt;
    const std::string& type = *(dash + 1);
    if (type == "cgroup2") return Mount{words[4], words[3], "memory.max", ":"};
    if (type == "cgroup" && has_option(*(dash + 3), "memory")) {
        return Mount{words[4], words[3], "memory.limit_in_bytes", "memory"};
    }
    return std::nullopt;
}

/// The group that this process is in: proc/self/cgroup has "number:controllers:/path" for each
/// hierarchy, and "0::/path" for that of version 2.
std::optional<fs::path> own_group(const fs::path& root, const Mount& mount) {
    std::ifstream in(root / "proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {
        const auto first = line.find(':');
        const auto second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const bool is_it = mount.own_line == ":" ? controllers.empty() && line.starts_with("0:")
                                                 : has_option(controllers, mount.own_line);
        if (is_it) return fs::path(line.substr(second + 1));
    }
    return std::nullopt;
}

/// The limit of one group; "max" and what is missing are none.
std::uint64_t limit_in(const fs::path& file) {
    std::ifstream in(file);
    std::uint64_t bytes = 0;
    return in >> bytes ? bytes : kNoLimit;
}

/// Of our group and those around it, as far as they can be seen.
std::uint64_t group_limit(const fs::path& root, const Mount& mount) {
    const auto group = own_group(root, mount);
    if (!group) return kNoLimit;
    const fs::path point = root / mount.point.relative_path();
    std::uint64_t least = limit_in(point / mount.file);
    // A container sees its own group at the mount point, whatever its path is outside.
    fs::path folder = point;
    for (const fs::path& part : group->lexically_relative(mount.top)) {
        if (part == "..") break;
        folder /= part;
        least = std::min(least, limit_in(folder / mount.file));
    }
    return least;
}

/// "MemTotal:  16303424 kB"
std::uint64_t physical_memory(const fs::path& root) {
    std::ifstream in(root / "proc/meminfo");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("MemTotal:")) continue;
        const std::vector<std::string> words = words_of(line);
        if (words.size() < 2) return kNoLimit;
        return std::strtoull(words[1].c_str(), nullptr, 10) << 10U;
    }
    return kNoLimit;
}

}  // namespace

std::uint64_t machine_memory_bytes(const fs::path& root) {
    std::uint64_t least = physical_memory(root);
    std::ifstream in(root / "proc/self/mountinfo");
    for (std::string line; std::getline(in, line);) {
        if (const auto mount = mount_of(line)) least = std::min(least, group_limit(root, *mount));
    }
    return least == kNoLimit ? 0 : least;
}

MemoryShares share_memory(std::uint64_t machine_bytes) {
    const auto sixteenth = [&](std::uint64_t most) { return std::min(machine_bytes / 16, most); };
    return {machine_bytes / 2, sixteenth(512U << 20U), sixteenth(512U << 20U),
            sixteenth(256U << 20U), sixteenth(256U << 20U)};
}

}  // namespace bouguer::server
