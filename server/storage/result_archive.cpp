// SPDX-License-Identifier: Apache-2.0
#include "server/storage/result_archive.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <sstream>

#include "api/digest.h"

namespace bouguer::server {
namespace {

constexpr std::size_t kBlock = 512;  ///< everything begins at a multiple of it
constexpr std::size_t kMostManifestBytes = std::size_t{1} << 20U;

/// Where the fields of a header stand, in bytes [POSIX.1-1988, 10.1.1].
struct Field {
    std::size_t at, bytes;
};
constexpr Field kName{0, 100}, kMode{100, 8}, kUser{108, 8}, kGroup{116, 8}, kSize{124, 12},
    kTime{136, 12}, kChecksum{148, 8}, kType{156, 1}, kMagic{257, 8};

constexpr std::string_view kMagicText{"ustar\00000", 8};

std::size_t padding_of(std::uint64_t bytes) { return (kBlock - bytes % kBlock) % kBlock; }

/// Octal digits with zeros in front and a NUL behind.
void put_octal(std::string& header, Field field, std::uint64_t value) {
    for (std::size_t i = field.bytes - 1; i-- > 0; value /= 8) {
        header[field.at + i] = static_cast<char>('0' + value % 8);
    }
}

std::optional<std::uint64_t> octal_in(std::string_view header, Field field) {
    const std::string_view text = header.substr(field.at, field.bytes - 1);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 8);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Of all bytes, those of the checksum itself taken as blanks.
std::uint64_t checksum_of(std::string_view header) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
        const bool is_own = i >= kChecksum.at && i < kChecksum.at + kChecksum.bytes;
        sum += is_own ? ' ' : static_cast<unsigned char>(header[i]);
    }
    return sum;
}

std::string header_of(const std::string& name, std::uint64_t bytes, std::int64_t mtime_s) {
    std::string header(kBlock, '\0');
    header.replace(kName.at, name.size(), name);
    put_octal(header, kMode, 0644);
    put_octal(header, kUser, 0);
    put_octal(header, kGroup, 0);
    put_octal(header, kSize, bytes);
    put_octal(header, kTime, static_cast<std::uint64_t>(mtime_s));
    header[kType.at] = '0';
    header.replace(kMagic.at, kMagic.bytes, kMagicText);
    put_octal(header, {kChecksum.at, 7}, checksum_of(header));
    header[kChecksum.at + 7] = ' ';
    return header;
}

tl::unexpected<Error> damaged() {
    return fail(ErrorKind::Internal, "the stored results are damaged", "result-damaged");
}

Result<std::string> read_at(int fd, std::uint64_t offset, std::size_t bytes) {
    std::string text(bytes, '\0');
    std::size_t done = 0;
    while (done < bytes) {
        const ssize_t n =
            ::pread(fd, text.data() + done, bytes - done, static_cast<off_t>(offset + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) {
            return fail(ErrorKind::Internal,
                        std::string("cannot read the results: ") + std::strerror(errno),
                        "storage-failed");
        }
        if (n == 0) return damaged();
        done += static_cast<std::size_t>(n);
    }
    return text;
}

struct Member {
    std::string name;
    std::uint64_t offset, bytes;
};

/// The member whose header stands at `offset`; empty at the end of the archive.
Result<std::optional<Member>> read_member(int fd, std::uint64_t offset) {
    const auto header = read_at(fd, offset, kBlock);
    if (!header) return tl::unexpected(header.error());
    if (header->find_first_not_of('\0') == std::string::npos) return std::optional<Member>();
    const auto size = octal_in(*header, kSize);
    const auto checksum = octal_in(*header, {kChecksum.at, 7});
    if (!size || !checksum || *checksum != checksum_of(*header)) return damaged();
    const std::string name(header->c_str(), strnlen(header->c_str(), kName.bytes));
    return std::optional(Member{name, offset + kBlock, *size});
}

}  // namespace

ArchiveText::ArchiveText(const ResultFiles& files, std::int64_t mtime_s) {
    for (const auto& [name, bytes] : files) {
        manifest_ += api::sha256_hex(bytes) + "  " + name + "\n";
    }
    add(kManifest, manifest_, mtime_s);
    for (const auto& [name, bytes] : files) add(name, bytes, mtime_s);
    static constexpr std::array<char, 2 * kBlock> kEnd{};
    pieces_.emplace_back(kEnd.data(), kEnd.size());
}

void ArchiveText::add(const std::string& name, std::string_view bytes, std::int64_t mtime_s) {
    static constexpr std::array<char, kBlock> kZeros{};
    headers_.push_back(std::make_unique<const std::string>(header_of(name, bytes.size(), mtime_s)));
    pieces_.emplace_back(*headers_.back());
    pieces_.push_back(bytes);
    pieces_.emplace_back(kZeros.data(), padding_of(bytes.size()));
}

std::map<std::string, std::string> read_manifest(const std::string& text) {
    std::map<std::string, std::string> digests;
    std::istringstream lines(text);
    std::string digest;
    std::string name;
    while (lines >> digest >> name) digests[name] = digest;
    return digests;
}

Result<std::map<std::string, ArchivedFile>> read_archive(int fd) {
    struct stat info {};
    if (::fstat(fd, &info) != 0) return damaged();
    const auto size = static_cast<std::uint64_t>(info.st_size);
    const auto manifest = read_member(fd, 0);
    if (!manifest) return tl::unexpected(manifest.error());
    if (!*manifest || (*manifest)->name != kManifest || (*manifest)->bytes > kMostManifestBytes) {
        return damaged();
    }
    const auto text = read_at(fd, (*manifest)->offset, (*manifest)->bytes);
    if (!text) return tl::unexpected(text.error());
    auto missing = read_manifest(*text);
    std::map<std::string, ArchivedFile> files;
    std::uint64_t at = (*manifest)->offset + text->size() + padding_of(text->size());
    while (true) {
        const auto member = read_member(fd, at);
        if (!member) return tl::unexpected(member.error());
        if (!*member) break;
        auto [name, offset, bytes] = **member;
        if (offset > size || bytes > size - offset || !missing.contains(name)) return damaged();
        files[name] = {offset, bytes, missing[name]};
        missing.erase(name);
        at = offset + bytes + padding_of(bytes);
    }
    if (!missing.empty()) return damaged();
    return files;
}

}  // namespace bouguer::server
