// SPDX-License-Identifier: Apache-2.0
// To be preloaded (LD_PRELOAD): fsync and fdatasync of every file whose path contains the text of
// SLOPPY_SYNC succeed and do nothing. power_loss.sh shows with it that it sees what sloppiness
// costs.
#include <dlfcn.h>
#include <unistd.h>

#include <climits>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

bool is_sloppy(int fd) {
    const char* text = std::getenv("SLOPPY_SYNC");
    if (text == nullptr) return false;
    char path[PATH_MAX + 1] = {};
    const std::string link = "/proc/self/fd/" + std::to_string(fd);
    return ::readlink(link.c_str(), path, PATH_MAX) > 0 && std::strstr(path, text) != nullptr;
}

int sync_unless_sloppy(int fd, const char* call) {
    if (is_sloppy(fd)) return 0;
    return reinterpret_cast<int (*)(int)>(::dlsym(RTLD_NEXT, call))(fd);
}

}  // namespace

extern "C" int fsync(int fd) { return sync_unless_sloppy(fd, "fsync"); }
extern "C" int fdatasync(int fd) { return sync_unless_sloppy(fd, "fdatasync"); }
