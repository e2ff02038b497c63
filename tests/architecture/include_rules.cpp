// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <sstream>

namespace bouguer::tests {
namespace {

/// A layer and the folders that its sources may name in quotes.
struct Layer {
    std::string_view folder;
    std::array<std::string_view, 3> may_include;
};
constexpr std::array kLayers{
    Layer{"renderer/", {"renderer/"}},
    Layer{"api/", {"renderer/", "api/"}},
    Layer{"server/", {"renderer/", "api/", "server/"}},
};

/// A third-party library by the beginning of its includes, and the places that may use it.
struct Library {
    std::string_view prefix;
    std::array<std::string_view, 2> rooms;
};
constexpr std::array kLibraries{
    Library{"embree3/", {"renderer/geometry/"}},
    Library{"embree4/", {"renderer/geometry/"}},
    Library{"OpenImageIO/", {"renderer/film/", "renderer/textures/"}},
    Library{"jpeglib.h", {"renderer/film/jpeg_decoder.cpp"}},
    Library{"jerror.h", {"renderer/film/jpeg_decoder.cpp"}},
    Library{"lcms2", {"renderer/film/icc_transform.cpp"}},
    Library{"zlib.h", {"renderer/film/inflate.cpp"}},
    Library{"nlohmann/", {"api/"}},
    Library{"openssl/", {"api/digest.cpp"}},
    Library{"httplib.h", {"server/http/"}},
    Library{"SQLiteCpp/", {"server/storage/"}},
    Library{"sqlite3.h", {"server/storage/"}},
    Library{"spdlog/", {"server/"}},
    Library{"CLI/", {"server/cli/"}},
    Library{"tl/expected.hpp", {"renderer/core/"}},
};

/// Standard headers that would let a layer open a socket, a file or a thread.
constexpr std::array<std::string_view, 6> kDoers{"thread",     "future",   "fstream",
                                                 "filesystem", "unistd.h", "fcntl.h"};

/// The folder or file name of `place` itself, or anything below it.
bool is_in(std::string_view path, std::string_view place) {
    return !place.empty() && path.starts_with(place);
}

bool is_in_any(std::string_view path, std::span<const std::string_view> places) {
    return std::any_of(places.begin(), places.end(),
                       [&](auto place) { return is_in(path, place); });
}

/// "renderer/" of "renderer/film/x.cpp".
std::string_view first_folder(std::string_view path) { return path.substr(0, path.find('/') + 1); }

std::string_view trimmed(std::string_view s) {
    const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
    while (!s.empty() && is_space(static_cast<unsigned char>(s.front()))) s.remove_prefix(1);
    return s;
}

/// A test mirrors the source of the same path below tests/.
struct Subject {
    std::string_view path;  ///< without "tests/"
    bool is_test = false;
};
Subject subject_of(std::string_view path) {
    constexpr std::string_view tests = "tests/";
    return path.starts_with(tests) ? Subject{path.substr(tests.size()), true} : Subject{path};
}

std::string broken_rule(const Subject& subject, const Layer& layer, const Include& include) {
    if (include.quoted) {
        if (is_in_any(include.path, layer.may_include)) return {};
        if (subject.is_test && is_in(include.path, "tests/")) return {};
        return std::string(layer.folder) + " may not include \"" + include.path + "\"";
    }
    for (const Library& library : kLibraries) {
        if (!is_in(include.path, library.prefix)) continue;
        for (const std::string_view room : library.rooms) {
            // A test may take its layer's libraries to look at what came out; a server's test also
            // those of the layers below.
            const bool allowed = subject.is_test ? is_in_any(first_folder(room), layer.may_include)
                                                 : is_in(subject.path, room);
            if (allowed && !room.empty()) return {};
        }
        return "<" + include.path + "> belongs in " + std::string(library.rooms.front()) + " only";
    }
    const bool does = std::find(kDoers.begin(), kDoers.end(), include.path) != kDoers.end() ||
                      is_in(include.path, "sys/");
    if (does && layer.folder == "api/" && !subject.is_test) {
        return "api/ opens no socket, file or thread: <" + include.path + ">";
    }
    return {};
}

}  // namespace

std::vector<Include> includes_of(std::string_view text) {
    std::vector<Include> found;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::string_view rest = trimmed(line);
        if (!rest.starts_with('#')) continue;
        rest = trimmed(rest.substr(1));
        if (!rest.starts_with("include")) continue;
        rest = trimmed(rest.substr(std::string_view("include").size()));
        if (rest.empty() || (rest.front() != '"' && rest.front() != '<')) continue;
        const bool quoted = rest.front() == '"';
        const auto end = rest.find(quoted ? '"' : '>', 1);
        if (end == std::string_view::npos) continue;
        found.push_back({number, quoted, std::string(rest.substr(1, end - 1))});
    }
    return found;
}

std::vector<std::string> broken_rules(std::string_view path, std::string_view text) {
    const Subject subject = subject_of(path);
    std::vector<std::string> problems;
    for (const Layer& layer : kLayers) {
        if (!is_in(subject.path, layer.folder)) continue;
        for (const Include& include : includes_of(text)) {
            const std::string broken = broken_rule(subject, layer, include);
            if (broken.empty()) continue;
            problems.push_back(std::string(path) + ":" + std::to_string(include.line) + ": " +
                               broken);
        }
    }
    return problems;
}

}  // namespace bouguer::tests
