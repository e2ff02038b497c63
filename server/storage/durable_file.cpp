// SPDX-License-Identifier: Apache-2.0
#include "server/storage/durable_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "server/file_descriptor.h"

namespace bouguer::server {
namespace {

/// The error of the last system call. Names the file only by its last part: a client may read it.
tl::unexpected<Error> system_error(const char* what, const std::filesystem::path& file) {
    const std::error_code code(errno, std::generic_category());
    return fail(
        code == std::errc::no_such_file_or_directory ? ErrorKind::NotFound : ErrorKind::Internal,
        std::string("cannot ") + what + " " + file.filename().string() + ": " + code.message(),
        storage_code(code));
}

/// Writes what stands in `rest`, and shortens it as it goes.
Result<void> write_all(int fd, std::vector<iovec> rest, const std::filesystem::path& file) {
    std::size_t at = 0;
    while (at < rest.size()) {
        const auto count = static_cast<int>(std::min<std::size_t>(rest.size() - at, IOV_MAX));
        const ssize_t n = ::writev(fd, rest.data() + at, count);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return system_error("write", file);
        auto written = static_cast<std::size_t>(n);
        for (; at < rest.size() && written >= rest[at].iov_len; ++at) written -= rest[at].iov_len;
        if (at == rest.size()) break;
        rest[at].iov_base = static_cast<char*>(rest[at].iov_base) + written;
        rest[at].iov_len -= written;
    }
    return {};
}

/// What writev() takes; it only reads what the pointers lead to.
std::vector<iovec> vectors_of(std::span<const std::string_view> pieces) {
    std::vector<iovec> vectors;
    for (const std::string_view piece : pieces) {
        if (!piece.empty()) vectors.push_back({const_cast<char*>(piece.data()), piece.size()});
    }
    return vectors;
}

}  // namespace

const char* storage_code(const std::error_code& code) {
    const bool is_full = code == std::errc::no_space_on_device ||
                         code == std::error_condition(EDQUOT, std::generic_category());
    return is_full ? "storage-full" : "storage-failed";
}

Result<void> write_new_file(const std::filesystem::path& file, std::string_view bytes) {
    return write_new_file(file, std::span(&bytes, 1));
}

Result<void> write_new_file(const std::filesystem::path& file,
                            std::span<const std::string_view> pieces) {
    const FileDescriptor fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (!fd) return system_error("make", file);
    auto written = write_all(fd.get(), vectors_of(pieces), file);
    if (!written) return written;
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

Result<FileDescriptor> open_file(const std::filesystem::path& file) {
    // Without O_NONBLOCK the open of a pipe would wait for a writer.
    FileDescriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!fd) return system_error("open", file);
    struct stat info {};
    if (::fstat(fd.get(), &info) != 0) return system_error("read", file);
    if (!S_ISREG(info.st_mode)) {
        return fail(ErrorKind::NotFound, file.filename().string() + " is not a regular file");
    }
    return fd;
}

Result<Content> open_content(const std::filesystem::path& file, std::size_t max_bytes) {
    auto fd = open_file(file);
    if (!fd) return tl::unexpected(fd.error());
    struct stat info {};
    if (::fstat(fd->get(), &info) != 0) return system_error("read", file);
    if (static_cast<std::uint64_t>(info.st_size) > max_bytes) {
        return fail(ErrorKind::TooLarge, file.filename().string() + " is longer than " +
                                             std::to_string(max_bytes) + " bytes");
    }
    return Content(std::make_shared<const FileDescriptor>(*std::move(fd)), 0,
                   static_cast<std::size_t>(info.st_size));
}

Result<std::string> read_file(const std::filesystem::path& file, std::size_t max_bytes) {
    const auto opened = open_content(file, max_bytes);
    return opened ? opened->all() : tl::unexpected(opened.error());
}

}  // namespace bouguer::server
