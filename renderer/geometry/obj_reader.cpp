// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: polygons only.
#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include "renderer/core/hash.h"
#include "renderer/geometry/mesh_readers.h"
#include "renderer/geometry/mesh_text.h"

namespace bouguer::renderer {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Statements that say nothing about the surface.
constexpr std::array<std::string_view, 14> kIgnored{
    "g", "o", "s",   "mtllib",     "usemtl",    "usemap",   "maplib",
    "l", "p", "lod", "shadow_obj", "trace_obj", "c_interp", "d_interp"};

constexpr std::array<std::string_view, 4> kRead{"v", "vt", "vn", "f"};

bool is_keyword(std::string_view word) {
    const auto is_in = [&](const auto& words) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    return is_in(kRead) || is_in(kIgnored);
}

/// A corner of a face: indices into positions, texture coordinates and normals.
struct Corner {
    std::uint32_t v = kNone, vt = kNone, vn = kNone;
    bool operator==(const Corner&) const = default;
};

struct HashCorner {
    std::size_t operator()(const Corner& c) const { return hash(c.v, c.vt, c.vn); }
};

class ObjReader {
  public:
    explicit ObjReader(const MeshLimits& limits)
        : max_vertices_(std::min<std::size_t>(limits.max_vertices, kNone - 1)),
          max_triangles_(limits.max_triangles) {}

    Result<TriangleMesh> read(std::string_view bytes) {
        if (!may_be_obj(bytes)) return refuse_mesh("", kNoMeshFile);
        WordScanner lines(bytes);
        for (;;) {
            line_ = lines.line_number();
            const auto line = lines.line();
            if (!line) break;
            if (auto read = statement(*line); !read) {
                return tl::unexpected<Error>(std::move(read.error()));
            }
        }
        if (corners_.empty()) return refuse_mesh("", kNoMeshFile);
        return finish();
    }

  private:
    Result<void> statement(std::string_view line) {
        line = line.substr(0, line.find('#'));
        WordScanner words(line);
        const std::string_view keyword = words.word();
        if (keyword.empty()) return {};
        if (keyword == "v") return vertex(words, positions_, 3, 7);
        if (keyword == "vn") return vertex(words, normals_, 3, 3);
        if (keyword == "vt") return vertex(words, uvs_, 1, 3);
        if (keyword == "f") return face(words);
        if (std::find(kIgnored.begin(), kIgnored.end(), keyword) != kIgnored.end()) return {};
        return refuse("unknown statement");  // untold: the file may be none of ours
    }

    /// Numbers up to the end of the line: at least `least` of them and at most `most`, of which the
    /// first three are kept.
    Result<void> vertex(WordScanner& words, std::vector<Vec3>& out, int least, int most) {
        std::array<Real, 3> xyz{};
        int n = 0;
        for (std::string_view word = words.word(); !word.empty(); word = words.word(), ++n) {
            const auto number = parse_number<Real>(word);
            if (!number) return refuse("not a number: " + quoted(word));
            if (!std::isfinite(*number)) return refuse("not finite: " + quoted(word));
            if (n < 3) xyz[static_cast<std::size_t>(n)] = *number;
        }
        if (n < least || n > most) return refuse("wrong count of numbers: " + std::to_string(n));
        if (out.size() >= max_vertices_) return refuse("more vertices than allowed");
        out.push_back({xyz[0], xyz[1], xyz[2]});
        return {};
    }

    Result<void> face(WordScanner& words) {
        std::array<Corner, 3> fan;  // the first corner, the one before, this one
        std::size_t n = 0;
        for (std::string_view word = words.word(); !word.empty(); word = words.word(), ++n) {
            auto read = corner(word);
            if (!read) return tl::unexpected<Error>(std::move(read.error()));
            fan[std::min<std::size_t>(n, 2)] = *read;
            if (n < 2) continue;
            if (corners_.size() / 3 >= max_triangles_) {
                return refuse("more triangles than allowed");
            }
            corners_.insert(corners_.end(), fan.begin(), fan.end());
            fan[1] = fan[2];
        }
        if (n < 3) return refuse("a face needs three corners");
        return {};
    }

    /// v, v/vt, v//vn or v/vt/vn.
    Result<Corner> corner(std::string_view word) {
        Corner result;
        const std::string_view whole = word;
        const std::array<std::pair<std::uint32_t*, std::size_t>, 3> places{
            std::pair{&result.v, positions_.size()}, std::pair{&result.vt, uvs_.size()},
            std::pair{&result.vn, normals_.size()}};
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t slash = word.find('/');
            const std::string_view text = word.substr(0, slash);
            const bool may_be_empty = i == 1 && slash != std::string_view::npos;
            if (!text.empty() || !may_be_empty) {
                const auto index = resolve(text, places[i].second);
                if (!index) return refuse("no such corner: " + quoted(whole));
                *places[i].first = *index;
            }
            if (slash == std::string_view::npos) return result;
            word.remove_prefix(slash + 1);
        }
        return refuse("no such corner: " + quoted(whole));
    }

    /// Indices count from 1; negative ones count back from the newest.
    static std::optional<std::uint32_t> resolve(std::string_view text, std::size_t count) {
        const auto index = parse_number<std::int64_t>(text);
        const auto n = static_cast<std::int64_t>(count);
        if (!index || *index == 0 || *index > n || *index < -n) return std::nullopt;
        return static_cast<std::uint32_t>(*index > 0 ? *index - 1 : n + *index);
    }

    /// One vertex for every combination of position, texture coordinate and normal that is used.
    Result<TriangleMesh> finish() {
        const auto all_have = [&](std::uint32_t Corner::*index) {
            return std::none_of(corners_.begin(), corners_.end(),
                                [&](const Corner& c) { return c.*index == kNone; });
        };
        const bool with_uvs = all_have(&Corner::vt);
        const bool with_normals = all_have(&Corner::vn);
        TriangleMesh mesh;
        mesh.triangles.resize(corners_.size() / 3);
        std::unordered_map<Corner, std::uint32_t, HashCorner> known;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Corner key{corners_[i].v, with_uvs ? corners_[i].vt : kNone,
                             with_normals ? corners_[i].vn : kNone};
            const auto [it, is_new] =
                known.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.triangles[i / 3][i % 3] = it->second;
            if (!is_new) continue;
            if (mesh.positions.size() >= max_vertices_) {
                return refuse_mesh("", "more vertices than allowed");
            }
            mesh.positions.push_back(positions_[key.v]);
            if (with_uvs) mesh.uvs.push_back({uvs_[key.vt].x, uvs_[key.vt].y});
            if (with_normals) mesh.normals.push_back(normals_[key.vn]);
        }
        return mesh;
    }

    [[nodiscard]] tl::unexpected<Error> refuse(const std::string& what) const {
        return refuse_mesh("line " + std::to_string(line_), what);
    }

    std::size_t max_vertices_;
    std::size_t max_triangles_;
    std::uint64_t line_ = 0;
    std::vector<Vec3> positions_, normals_, uvs_;
    std::vector<Corner> corners_;  ///< three a triangle
};

}  // namespace

bool may_be_obj(std::string_view first_bytes) {
    if (first_bytes.find('\0') != std::string_view::npos) return false;
    const std::string_view space = " \t\r\v\f";
    while (!first_bytes.empty()) {
        std::string_view line = first_bytes.substr(0, first_bytes.find('\n'));
        const bool is_cut = line.size() == first_bytes.size();
        first_bytes.remove_prefix(std::min(line.size() + 1, first_bytes.size()));
        line = line.substr(0, line.find('#'));
        const std::size_t begin = line.find_first_not_of(space);
        if (begin == std::string_view::npos) continue;
        const std::string_view word = line.substr(begin, line.find_first_of(space, begin) - begin);
        return is_keyword(word) || (is_cut && word.size() == line.size() - begin);
    }
    return true;
}

Result<TriangleMesh> read_obj(std::string_view bytes, const MeshLimits& limits) {
    return ObjReader(limits).read(bytes);
}

}  // namespace bouguer::renderer
