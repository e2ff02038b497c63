// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: polygons; what else there is, is named.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "renderer/geometry/mesh_readers.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/obj_statements.h"
#include "renderer/geometry/polygon_mesh.h"

namespace bouguer::renderer {
namespace {

constexpr std::uint32_t kNone = PolygonCorner::kNone;

class ObjReader {
  public:
    explicit ObjReader(const MeshLimits& limits)
        : limits_(limits), max_vertices_(std::min<std::size_t>(limits.max_vertices, kNone - 1)) {}

    Result<TriangleMesh> read(std::string_view bytes) {
        if (!may_be_obj(bytes)) return refuse_mesh("", kNoMeshFile);
        WordScanner lines(without_mark(bytes));
        for (;;) {
            line_ = lines.line_number();
            const auto line = whole_line(lines);
            if (!line) break;
            if (auto read = statement(*line); !read) {
                return tl::unexpected<Error>(std::move(read.error()));
            }
        }
        if (mesh_.sizes.empty()) return refuse_without_faces();
        // Programs that know smoothing groups write normals too, as a rule.
        if (is_smooth_ && mesh_.normals.empty())
            mesh_.notes.dropped.add("smoothing groups: without normals faces are flat");
        return triangle_mesh(std::move(mesh_), limits_);
    }

  private:
    /// A line without its comment, and with those that continue it: a backslash at the end joins
    /// the next. A comment ends with its line, whatever that ends with: with a path, for one.
    std::optional<std::string_view> whole_line(WordScanner& lines) {
        auto line = lines.line();
        if (!line || !goes_on(*line)) return line ? without_comment(*line) : line;
        joined_.clear();
        while (line && goes_on(*line)) {
            line->remove_suffix(1);
            joined_.append(*line).push_back(' ');
            line = lines.line();
        }
        return joined_.append(without_comment(line.value_or("")));
    }

    static bool goes_on(std::string_view line) {
        return line.ends_with('\\') && line.find('#') == std::string_view::npos;
    }
    static std::string_view without_comment(std::string_view line) {
        return line.substr(0, line.find('#'));
    }

    Result<void> statement(std::string_view line) {
        WordScanner words(line);
        const std::string_view word = words.word();
        if (word.empty()) return {};
        const ObjKeyword* keyword = find_obj_keyword(word);
        // Untold: the file may be none of ours.
        if (keyword == nullptr) return refuse("unknown statement");
        switch (keyword->means) {
            case ObjStatement::Vertex:
                return vertex(words);
            case ObjStatement::TextureVertex:
                return texture_vertex(words);
            case ObjStatement::Normal:
                return normal(words);
            case ObjStatement::Face:
                return face(words);
            case ObjStatement::Material:
                mesh_.notes.materials.add(rest_of(words));
                return {};
            case ObjStatement::Smoothing:
                if (!is_off(words.word())) is_smooth_ = true;
                return {};
            case ObjStatement::Map:
                if (!is_off(words.word())) mesh_.notes.dropped.add("texture maps (usemap)");
                return {};
            case ObjStatement::Dropped:
                mesh_.notes.dropped.add(keyword->of);
                return {};
            case ObjStatement::Nothing:
                return {};
        }
        return {};
    }

    static bool is_off(std::string_view word) {
        return word.empty() || word == "off" || word == "0";
    }

    /// Numbers up to the end of the line: at least `least` of them and at most `most`. The first
    /// three are kept in xyz_, the count in num_read_.
    Result<void> numbers(WordScanner& words, std::size_t so_far, int least, int most) {
        xyz_ = {};
        num_read_ = 0;
        for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
            const auto number = parse_number<Real>(word);
            if (!number) return refuse("not a number: " + quoted(word));
            if (!std::isfinite(*number)) return refuse("not finite: " + quoted(word));
            if (num_read_ < 3) xyz_[static_cast<std::size_t>(num_read_)] = *number;
            ++num_read_;
        }
        if (num_read_ < least || num_read_ > most)
            return refuse("wrong count of numbers: " + std::to_string(num_read_));
        if (so_far >= max_vertices_) return refuse("more vertices than allowed");
        return {};
    }

    /// x y z, then a weight, which polygons do not have, or a colour, or both.
    Result<void> vertex(WordScanner& words) {
        auto read = numbers(words, mesh_.positions.size(), 3, 8);
        if (!read) return read;
        if (num_read_ >= 5) mesh_.notes.dropped.add("vertex colours");
        mesh_.positions.push_back({xyz_[0], xyz_[1], xyz_[2]});
        return read;
    }
    Result<void> texture_vertex(WordScanner& words) {
        auto read = numbers(words, mesh_.uvs.size(), 1, 3);
        if (read) mesh_.uvs.push_back({xyz_[0], xyz_[1]});
        return read;
    }
    Result<void> normal(WordScanner& words) {
        auto read = numbers(words, mesh_.normals.size(), 3, 3);
        if (read) mesh_.normals.push_back({xyz_[0], xyz_[1], xyz_[2]});
        return read;
    }

    /// What is left of the line: names may have spaces.
    static std::string_view rest_of(const WordScanner& words) {
        std::string_view rest = words.rest();
        while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
        while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
        return rest;
    }

    Result<void> face(WordScanner& words) {
        std::uint32_t n = 0;
        for (std::string_view word = words.word(); !word.empty(); word = words.word(), ++n) {
            auto read = corner(word);
            if (!read) return tl::unexpected<Error>(std::move(read.error()));
            mesh_.corners.push_back(*read);
        }
        if (n < 3) return refuse("a face needs three corners");
        mesh_.sizes.push_back(n);
        mesh_.lines.push_back(line_);
        if (mesh_.num_triangles() > limits_.max_triangles)
            return refuse("more triangles than allowed");
        return {};
    }

    /// v, v/vt, v//vn or v/vt/vn; what is not there may be left empty.
    Result<PolygonCorner> corner(std::string_view word) {
        PolygonCorner result;
        const std::string_view whole = word;
        const std::array<std::pair<std::uint32_t*, std::size_t>, 3> places{
            std::pair{&result.v, mesh_.positions.size()}, std::pair{&result.vt, mesh_.uvs.size()},
            std::pair{&result.vn, mesh_.normals.size()}};
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t slash = word.find('/');
            const std::string_view text = word.substr(0, slash);
            if (i == 0 || !text.empty()) {
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

    [[nodiscard]] tl::unexpected<Error> refuse_without_faces() const {
        if (mesh_.notes.dropped.empty()) return refuse_mesh("", kNoMeshFile);
        return refuse_mesh("", "an OBJ file without faces; it has " + mesh_.notes.dropped.text());
    }

    [[nodiscard]] tl::unexpected<Error> refuse(const std::string& what) const {
        return refuse_mesh("line " + std::to_string(line_), what);
    }

    MeshLimits limits_;
    std::size_t max_vertices_;
    std::uint64_t line_ = 0;
    bool is_smooth_ = false;
    std::string joined_;  ///< a line of several
    std::array<Real, 3> xyz_{};
    int num_read_ = 0;
    PolygonMesh mesh_;
};

}  // namespace

bool may_be_obj(std::string_view first_bytes) {
    if (first_bytes.find('\0') != std::string_view::npos) return false;
    const std::string_view space = " \t\r\v\f";
    first_bytes = without_mark(first_bytes);
    while (!first_bytes.empty()) {
        std::string_view line = first_bytes.substr(0, first_bytes.find('\n'));
        const bool is_cut = line.size() == first_bytes.size();
        first_bytes.remove_prefix(std::min(line.size() + 1, first_bytes.size()));
        line = line.substr(0, line.find('#'));
        const std::size_t begin = line.find_first_not_of(space);
        if (begin == std::string_view::npos) continue;
        const std::string_view word = line.substr(begin, line.find_first_of(space, begin) - begin);
        return find_obj_keyword(word) != nullptr || (is_cut && word.size() == line.size() - begin);
    }
    return true;
}

Result<TriangleMesh> read_obj(std::string_view bytes, const MeshLimits& limits) {
    return ObjReader(limits).read(bytes);
}

}  // namespace bouguer::renderer
