// SPDX-License-Identifier: Apache-2.0
#include "server/machine_memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMiB = 1U << 20U;

/// A machine of 16 GiB as its files show it.
class MachineMemory : public testing::Test {
  protected:
    MachineMemory() { write("proc/meminfo", "MemTotal:       16777216 kB\nMemFree: 1 kB\n"); }
    void write(const fs::path& file, const std::string& text) {
        fs::create_directories((folder_.path() / file).parent_path());
        std::ofstream(folder_.path() / file) << text;
    }
    void mount_v2(const std::string& top = "/") {
        write("proc/self/mountinfo",
              "22 1 8:1 / / rw - ext4 /dev/sda1 rw\n"
              "29 22 0:26 " +
                  top + " /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n");
    }
    std::uint64_t bytes() const { return machine_memory_bytes(folder_.path()); }

    TemporaryFolder folder_;
};

TEST_F(MachineMemory, IsThatOfTheMachineWithoutGroups) { EXPECT_EQ(bytes(), 16384 * kMiB); }

TEST_F(MachineMemory, IsThatOfOurGroup) {
    mount_v2();
    write("proc/self/cgroup", "0::/system.slice/bouguer.service\n");
    write("sys/fs/cgroup/system.slice/bouguer.service/memory.max", "524288000\n");
    EXPECT_EQ(bytes(), 500 * kMiB);
}

// A group may use no more than the groups around it let it.
TEST_F(MachineMemory, IsTheLeastOfTheGroupsAroundUs) {
    mount_v2();
    write("proc/self/cgroup", "0::/a/b/c\n");
    write("sys/fs/cgroup/a/memory.max", "max\n");
    write("sys/fs/cgroup/a/b/memory.max", std::to_string(300 * kMiB) + "\n");
    write("sys/fs/cgroup/a/b/c/memory.max", std::to_string(400 * kMiB) + "\n");
    EXPECT_EQ(bytes(), 300 * kMiB);
}

// Inside a container with a namespace of its own the group is "/" and stands at the mount point.
TEST_F(MachineMemory, IsThatOfAContainer) {
    mount_v2();
    write("proc/self/cgroup", "0::/\n");
    write("sys/fs/cgroup/memory.max", "524288000\n");
    EXPECT_EQ(bytes(), 500 * kMiB);
    // without a namespace the mount shows the part of the tree that is ours
    mount_v2("/docker/0123");
    write("proc/self/cgroup", "0::/docker/0123\n");
    EXPECT_EQ(bytes(), 500 * kMiB);
    write("proc/self/cgroup", "0::/../elsewhere\n");
    EXPECT_EQ(bytes(), 500 * kMiB);
}

TEST_F(MachineMemory, KnowsVersionOne) {
    write("proc/self/mountinfo",
          "35 31 0:32 / /sys/fs/cgroup/memory rw,relatime - cgroup cgroup rw,memory\n"
          "32 31 0:29 / /sys/fs/cgroup/cpu rw,relatime - cgroup cgroup rw,cpu\n"
          "41 31 0:38 / /sys/fs/cgroup/unified rw,relatime - cgroup2 cgroup2 rw\n");
    write("proc/self/cgroup", "4:memory:/box\n1:cpu,cpuacct:/box\n0::/\n");
    write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    EXPECT_EQ(bytes(), 16384 * kMiB) << "its way to say that there is none";
    write("sys/fs/cgroup/memory/box/memory.limit_in_bytes", "524288000\n");
    EXPECT_EQ(bytes(), 500 * kMiB);
}

TEST_F(MachineMemory, SurvivesWhatItDoesNotUnderstand) {
    write("proc/self/mountinfo", "\nx\n1 2 3 - cgroup2\n29 22 0:26 / /c rw - cgroup2 cgroup2 rw\n");
    write("proc/self/cgroup", "nonsense\n:\n0::/a\n");
    write("c/a/memory.max", "many\n");
    EXPECT_EQ(bytes(), 16384 * kMiB);
    EXPECT_EQ(machine_memory_bytes(folder_.path() / "nowhere"), 0U);
}

TEST(MemoryShares, LeaveSomethingForTheProgram) {
    for (const std::uint64_t machine : {500 * kMiB, 16384 * kMiB}) {
        const MemoryShares shares = share_memory(machine);
        EXPECT_LE(shares.jobs + shares.scenes + shares.buffers + shares.uploads + shares.accepted,
                  machine - machine / 4);
    }
    EXPECT_EQ(share_memory(500 * kMiB).jobs, 250 * kMiB);
}

}  // namespace
}  // namespace bouguer::server
