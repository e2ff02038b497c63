// SPDX-License-Identifier: Apache-2.0
#include "server/storage/durable_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "server/file_descriptor.h"

namespace bouguer::server {
namespace {

/// The stable name of a failure of the disk.
const char* storage_code(const std::error_code& code) {
    const bool is_full = code == std::errc::no_space_on_device ||
                         code == std::error_condition(EDQUOT, std::generic_category());
    return is_full ? "storage-full" : "storage-failed";
}

/// The error of the last system call. Names the file only by its last part: a client may read it.
tl::unexpected<Error> system_error(const char* what, const std::filesystem::path& file) {
    const std::error_code code(errno, std::generic_category());
    return fail(
        code == std::errc::no_such_file_or_directory ? ErrorKind::NotFound : ErrorKind::Internal,
        std::string("cannot ") + what + " " + file.filename().string() + ": " + code.message(),
        storage_code(code));
}

Result<void> write_all(int fd, std::string_view bytes, const std::filesystem::path& file) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return system_error("write", file);
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return {};
}

}  // namespace

Result<void> write_new_file(const std::filesystem::path& file, std::string_view bytes) {
    const FileDescriptor fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (!fd) return system_error("make", file);
    if (auto written = write_all(fd.get(), bytes, file); !written) return written;
    if (::fsync(fd.get()) != 0) return system_error("flush", file);
    return {};
}

Result<void> sync_folder(const std::filesystem::path& folder) {
    const FileDescriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!fd) return system_error("open", folder);
    if (::fsync(fd.get()) != 0) return system_error("flush", folder);
    return {};
}

Result<void> replace_file(const std::filesystem::path& file, std::string_view bytes) {
    std::filesystem::path temporary = file;
    temporary += ".part-" + std::to_string(::getpid());
    ::unlink(temporary.c_str());
    if (auto written = write_new_file(temporary, bytes); !written) {
        ::unlink(temporary.c_str());
        return written;
    }
    if (::rename(temporary.c_str(), file.c_str()) != 0) {
        auto error = system_error("rename", file);
        ::unlink(temporary.c_str());
        return error;
    }
    return sync_folder(file.has_parent_path() ? file.parent_path() : ".");
}

Result<std::string> read_file(const std::filesystem::path& file, std::size_t max_bytes) {
    // Without O_NONBLOCK the open of a pipe would wait for a writer.
    const FileDescriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!fd) return system_error("open", file);
    struct stat info {};
    if (::fstat(fd.get(), &info) != 0) return system_error("read", file);
    if (!S_ISREG(info.st_mode)) {
        return fail(ErrorKind::NotFound, file.filename().string() + " is not a regular file");
    }
    if (static_cast<std::uint64_t>(info.st_size) > max_bytes) {
        return fail(ErrorKind::TooLarge, file.filename().string() + " is longer than " +
                                             std::to_string(max_bytes) + " bytes");
    }
    std::string bytes(static_cast<std::size_t>(info.st_size), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = ::read(fd.get(), bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return system_error("read", file);
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
    }
    bytes.resize(done);
    return bytes;
}

}  // namespace bouguer::server
