// SPDX-License-Identifier: Apache-2.0
// The bytes of an answer or of a stored file, in memory or in a file: what is large is read piece
// by piece while it is sent, and never held as a whole.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "renderer/core/result.h"
#include "server/file_descriptor.h"

namespace bouguer::server {

/// Immutable; copies and parts share the bytes or the open file. Thread-safe.
class Content {
  public:
    using File = std::shared_ptr<const FileDescriptor>;

    Content() = default;         ///< no bytes
    Content(std::string bytes);  // NOLINT(google-explicit-constructor): a string is a content
    /// `length` bytes of an open regular file from `offset` on. Whoever makes it has seen that they
    /// are there; the file may be renamed or removed meanwhile, but must not be written to.
    Content(File file, std::uint64_t offset, std::size_t length);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    /// Bytes of memory that this one keeps occupied; nearly nothing when they are in a file.
    [[nodiscard]] std::size_t memory_bytes() const { return memory_ ? memory_->size() : 0; }
    [[nodiscard]] bool is_in_memory() const { return file_ == nullptr; }

    /// The bytes, as long as this content or a copy lives, if they are in memory; else nothing.
    [[nodiscard]] std::string_view view() const {
        return memory_ ? std::string_view(*memory_).substr(begin_, size_) : std::string_view();
    }

    /// Appends the bytes [offset, offset + n), as many of them as there are, to `to`. May wait for
    /// the disk. Error{Internal}, code "file-failed": they cannot be read or are no longer there.
    [[nodiscard]] Result<void> read(std::size_t offset, std::size_t n, std::string& to) const;
    /// Everything at once. Errors as read().
    [[nodiscard]] Result<std::string> all() const;
    /// The bytes [offset, offset + n), as many of them as there are.
    [[nodiscard]] Content part(std::size_t offset, std::size_t n) const;

  private:
    std::shared_ptr<const std::string> memory_;  ///< null: in file_, or no bytes
    File file_;
    std::uint64_t begin_ = 0;  ///< in memory_ or file_
    std::size_t size_ = 0;
};

}  // namespace bouguer::server
