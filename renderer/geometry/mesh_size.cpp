// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_size.h"

#include <string>
#include <string_view>

#include "renderer/geometry/mesh_readers.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/ply_header.h"

namespace bouguer::renderer {
namespace {

constexpr std::size_t kPiece = 64U << 10U;
constexpr std::size_t kLongestPlyHeader = 1U << 20U;

/// Counts what the lines of an OBJ file add, as its bytes come.
class ObjCounter {
  public:
    explicit ObjCounter(const MeshLimits& limits) : limits_(limits) {}

    /// Error{InvalidInput}: over the limits.
    Result<void> add(std::string_view piece) {
        for (const char c : piece) {
            if (ends_with_backslash_ && continues(c)) continue;
            if (c == '\n') {
                if (auto fits = end_line(); !fits) return fits;
            } else if (c == '\\' && !is_comment_) {
                ends_with_backslash_ = true;
            } else if (is_space(c) || is_comment_ || c == '#') {
                is_comment_ = is_comment_ || c == '#';
                is_in_word_ = false;
            } else {
                add_to_word(c);
            }
        }
        return {};
    }
    [[nodiscard]] MeshSize size() const { return size_; }

  private:
    /// Behind a backslash: whether `c` is the end of a line, or the first half of one, which the
    /// next line goes on with. Else the backslash was a letter.
    bool continues(char c) {
        if (c == '\r') return true;
        ends_with_backslash_ = false;
        if (c != '\n') {
            add_to_word('\\');
            return false;
        }
        is_in_word_ = false;
        ++line_;
        return true;
    }
    void add_to_word(char c) {
        if (!is_in_word_) ++words_;
        if (words_ == 1) keyword_ = is_in_word_ ? '?' : c;  // of one letter, or none that counts
        is_in_word_ = true;
    }
    Result<void> end_line() {
        if (words_ > 0 && keyword_ == 'v') ++size_.vertices;
        if (words_ > 3 && keyword_ == 'f') size_.triangles += words_ - 3;
        words_ = 0;
        is_in_word_ = is_comment_ = false;
        if (size_.vertices > limits_.max_vertices) return refuse("more vertices than allowed");
        if (size_.triangles > limits_.max_triangles) return refuse("more triangles than allowed");
        ++line_;
        return {};
    }
    [[nodiscard]] tl::unexpected<Error> refuse(const std::string& what) const {
        return refuse_mesh("line " + std::to_string(line_), what);
    }

    const MeshLimits& limits_;
    std::uint64_t line_ = 1;
    std::uint64_t words_ = 0;
    char keyword_ = '?';
    bool is_in_word_ = false, is_comment_ = false, ends_with_backslash_ = false;
    MeshSize size_;
};

Result<MeshSize> ply_size(const ByteSource& file, std::string first_bytes,
                          const MeshLimits& limits) {
    auto header = read_ply_header(first_bytes, file.size());
    if (!header && first_bytes.size() < file.size()) {  // its end may not be here
        auto more = file.read(0, kLongestPlyHeader);
        if (!more) return tl::unexpected(std::move(more).error());
        first_bytes = *std::move(more);
        header = read_ply_header(first_bytes, file.size());
    }
    if (!header) return tl::unexpected(std::move(header).error());
    if (auto few = check_ply_counts(*header, limits); !few) {
        return tl::unexpected(std::move(few).error());
    }
    return MeshSize{count_of(*header, "vertex"), count_of(*header, "face")};
}

Result<MeshSize> obj_size(const ByteSource& file, const MeshLimits& limits) {
    ObjCounter counter(limits);
    for (std::uint64_t at = 0; at < file.size(); at += kPiece) {
        const auto piece = file.read(at, kPiece);
        if (!piece) return tl::unexpected(piece.error());
        if (piece->find('\0') != std::string::npos) return refuse_mesh("", kNoMeshFile);
        const std::string_view text = *piece;
        if (auto fits = counter.add(at == 0 ? without_mark(text) : text); !fits) {
            return tl::unexpected(std::move(fits).error());
        }
    }
    if (auto fits = counter.add("\n\n"); !fits) return tl::unexpected(std::move(fits).error());
    return counter.size();
}

}  // namespace

Result<MeshSize> read_mesh_size(const ByteSource& file, const MeshLimits& limits) {
    auto first_bytes = file.read(0, kPiece);
    if (!first_bytes) return tl::unexpected(std::move(first_bytes).error());
    if (is_ply(*first_bytes)) return ply_size(file, *std::move(first_bytes), limits);
    if (!may_be_obj(*first_bytes)) return refuse_mesh("", kNoMeshFile);
    return obj_size(file, limits);
}

}  // namespace bouguer::renderer
