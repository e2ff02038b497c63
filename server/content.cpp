// SPDX-License-Identifier: Apache-2.0
#include "server/content.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace bouguer::server {
namespace {

tl::unexpected<Error> unreadable(const std::string& why) {
    return fail(ErrorKind::Internal, "cannot read a file: " + why, "file-failed");
}

/// Fills the `n` bytes at `to` from `offset` on.
Result<void> read_exactly(int fd, std::uint64_t offset, char* to, std::size_t n) {
    while (n > 0) {
        const ssize_t got = ::pread(fd, to, n, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return unreadable(std::generic_category().message(errno));
        if (got == 0) return unreadable("it is shorter than it was");
        to += got;
        offset += static_cast<std::uint64_t>(got);
        n -= static_cast<std::size_t>(got);
    }
    return {};
}

}  // namespace

Content::Content(std::string bytes)
    : memory_(std::make_shared<const std::string>(std::move(bytes))), size_(memory_->size()) {}

Content::Content(File file, std::uint64_t offset, std::size_t length)
    : file_(std::move(file)), begin_(offset), size_(length) {}

Result<void> Content::read(std::size_t offset, std::size_t n, std::string& to) const {
    offset = std::min(offset, size_);
    n = std::min(n, size_ - offset);
    if (n == 0) return {};
    if (file_ == nullptr) {
        to.append(*memory_, begin_ + offset, n);
        return {};
    }
    const std::size_t old = to.size();
    to.resize(old + n);
    auto filled = read_exactly(file_->get(), begin_ + offset, to.data() + old, n);
    if (!filled) to.resize(old);
    return filled;
}

Result<std::string> Content::all() const {
    std::string bytes;
    if (auto got = read(0, size_, bytes); !got) return tl::unexpected(got.error());
    return bytes;
}

Content Content::part(std::size_t offset, std::size_t n) const {
    Content part = *this;
    offset = std::min(offset, size_);
    part.begin_ += offset;
    part.size_ = std::min(n, size_ - offset);
    return part;
}

}  // namespace bouguer::server
