// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_file.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace bouguer::renderer {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Mesh = std::shared_ptr<const TriangleMesh>;

const std::string kAsciiHead =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n";
const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Mesh read(const std::string& bytes) {
    auto mesh = read_mesh(bytes);
    EXPECT_TRUE(mesh) << mesh.error().message;
    return mesh.value_or(std::make_shared<const TriangleMesh>());
}

void expect_square(const TriangleMesh& mesh) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(mesh.positions, corners);
    const std::vector<Corners> fan{{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(mesh.triangles, fan);
}

TEST(MeshFile, CutsPlyPolygonsIntoFans) {
    const Mesh mesh = read(kAsciiHead + kSquare + "4 0 1 2 3\n");
    expect_square(*mesh);
    EXPECT_TRUE(mesh->normals.empty());
    EXPECT_TRUE(mesh->uvs.empty());
    EXPECT_EQ(mesh->dropped_triangles, 0U);
}

TEST(MeshFile, ReadsPlyWithOtherLineEnds) {
    std::string dos;
    for (const char c : kAsciiHead + kSquare + "4 0 1 2 3") {
        if (c == '\n') dos += '\r';
        dos += c;
    }
    expect_square(*read(dos));
}

template <class T>
void append(std::string& bytes, T value, bool swap) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (swap) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

/// The square with normals, texture coordinates, an unknown property and an unknown element, in
/// either order of bytes.
std::string binary_square(bool big_endian) {
    std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                        "_endian 1.0\nelement material 1\nproperty list ushort double values\n"
                        "element vertex 4\nproperty double x\nproperty float nx\n"
                        "property float ny\nproperty float nz\nproperty double y\n"
                        "property short quality\nproperty float z\nproperty float s\n"
                        "property float t\nelement face 2\nproperty uchar flags\n"
                        "property list uint ushort vertex_index\nend_header\n";
    append<std::uint16_t>(bytes, 2, big_endian);
    append<double>(bytes, 0.5, big_endian);
    append<double>(bytes, 0.25, big_endian);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        append<double>(bytes, x, big_endian);
        append<float>(bytes, 0, big_endian);
        append<float>(bytes, 0, big_endian);
        append<float>(bytes, 1, big_endian);
        append<double>(bytes, y, big_endian);
        append<std::int16_t>(bytes, -300, big_endian);
        append<float>(bytes, 0, big_endian);
        append<float>(bytes, static_cast<float>(x) / 2, big_endian);
        append<float>(bytes, static_cast<float>(y) / 4, big_endian);
    }
    for (const Corners& corners : {Corners{0, 1, 2}, Corners{0, 2, 3}}) {
        append<std::uint8_t>(bytes, 7, big_endian);
        append<std::uint32_t>(bytes, 3, big_endian);
        for (const std::uint32_t c : corners) {
            append<std::uint16_t>(bytes, static_cast<std::uint16_t>(c), big_endian);
        }
    }
    return bytes;
}

TEST(MeshFile, ReadsBinaryPlyOfEitherByteOrder) {
    for (const bool big_endian : {false, true}) {
        const Mesh mesh = read(binary_square(big_endian));
        expect_square(*mesh);
        ASSERT_EQ(mesh->normals.size(), 4U);
        EXPECT_EQ(mesh->normals[3], (Vec3{0, 0, 1}));
        ASSERT_EQ(mesh->uvs.size(), 4U);
        EXPECT_EQ(mesh->uvs[2], (Vec2{0.5, 0.25}));
    }
}

TEST(MeshFile, RefusesBinaryPlyCutAnywhere) {
    const std::string whole = binary_square(false);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(read_mesh(std::string_view(whole).substr(0, size))) << size;
    }
}

TEST(MeshFile, ReadsObj) {
    const Mesh mesh = read(
        "# a square\nmtllib a.mtl\no square\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\n"
        "v 0 1 0 # last\nusemtl red\ns off\nf 1 2 3 4\n");
    expect_square(*mesh);
}

TEST(MeshFile, CountsNegativeObjIndicesFromTheNewest) {
    expect_square(*read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\nv 9 9 9\n"));
}

// Two faces that share an edge but not its texture coordinates: 6 vertices, not 4.
TEST(MeshFile, SplitsObjVerticesWhereTextureCoordinatesDiffer) {
    const Mesh mesh = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.5 0.25\nvn 0 0 1\n"
        "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/2/1 4/2/1\n");
    ASSERT_EQ(mesh->positions.size(), 6U);
    ASSERT_EQ(mesh->uvs.size(), 6U);
    ASSERT_EQ(mesh->normals.size(), 6U);
    EXPECT_EQ(mesh->uvs[mesh->triangles[1][0]], (Vec2{0.5, 0.25}));
    EXPECT_EQ(mesh->positions[mesh->triangles[1][2]], (Vec3{0, 1, 0}));
}

// A corner without a normal has that of its face; the other face keeps its own.
TEST(MeshFile, GivesTheFacesNormalToCornersThatLackOne) {
    const Mesh mesh =
        read("v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3\nf 1//1 2//1 3//1\n");
    ASSERT_EQ(mesh->normals.size(), 4U);
    EXPECT_EQ(mesh->normals[mesh->triangles[0][2]], (Vec3{0, 0, 1}));
    EXPECT_NEAR(mesh->normals[mesh->triangles[1][2]].x, 0.6, 1e-15);
}

// One face of two has coordinates: it keeps them, and the other is counted.
TEST(MeshFile, KeepsCoordinatesThatSomeFacesLack) {
    const Mesh mesh = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 0 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
        "f 1/1 2/2 3/3\nf 1 4 3\n");
    ASSERT_EQ(mesh->uvs.size(), mesh->positions.size());
    EXPECT_EQ(mesh->uvs[mesh->triangles[0][1]], (Vec2{1, 0}));
    EXPECT_EQ(mesh->notes.triangles_without_uvs, 1U);
}

TEST(MeshFile, MakesNormalsUnit) {
    const Mesh mesh = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1e-200\nvn 0 300 400\n"
        "f 1//1 2//2 3//1\n");
    EXPECT_EQ(mesh->normals[mesh->triangles[0][0]], (Vec3{0, 0, 1}));
    EXPECT_NEAR(mesh->normals[mesh->triangles[0][1]].y, 0.6, 1e-15);
}

// Every statement of the format is read, is known to change no polygon, or is named.
TEST(MeshFile, KnowsTheStatementsOfObj) {
    const Mesh mesh = read(
        "\xEF\xBB\xBFmtllib a.mtl\nmg 1 0.5\nbevel on\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        "usemtl red wine\nf 1 2 \\\n  3 4\nusemtl blue\nl 1 2\np 1\ncstype bezier\ndeg 3\n"
        "usemtl red wine\n");
    expect_square(*mesh);
    EXPECT_EQ(mesh->notes.materials.text(), "red wine, blue");
    EXPECT_EQ(mesh->notes.dropped.text(), "vertex colours, lines, points, curves and surfaces");
}

// The backslash of a path at the end of a comment does not join the next line to it.
TEST(MeshFile, EndsObjCommentsWithTheirLine) {
    expect_square(
        *read("# from C:\\models\\\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\r\n 3 # \\\nf 1 3 "
              "\\\n4\n"));
}

// What asks for smooth faces, maps or other shapes changes the picture, though not the polygons.
TEST(MeshFile, NamesWhatObjAsksForAndDoesNotGet) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n";
    EXPECT_TRUE(
        read(square + "s 1\nf 1//1 2//1 3//1 4//1\ns off\nusemap off\n")->notes.dropped.empty());
    const Mesh flat = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\ns 1\nusemap wood\ntrace_obj a.obj\nshadow_obj b.obj\nf 1 2 "
        "3\n");
    EXPECT_EQ(flat->notes.dropped.text(),
              "texture maps (usemap), a shape for reflections (trace_obj), a shape for shadows "
              "(shadow_obj), smoothing groups: without normals faces are flat");
}

TEST(MeshFile, DoesNotTakeABackslashBeforeACommentForTheEndOfALine) {
    expect_square(*read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a\\# b\nf 1 2 3 4\n"));
}

TEST(MeshFile, LeavesOutWhatCornersOfObjLeaveEmpty) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    expect_square(*read(square + "f 1/ 2/ 3/ 4/\n"));
    expect_square(*read(square + "f 1// 2// 3// 4//\n"));
    const Mesh mesh = read(square + "f 1/1/ 2/1/ 3/1/ 4/1/\n");
    EXPECT_EQ(mesh->uvs.size(), 4U);
    EXPECT_TRUE(mesh->normals.empty());
}

// Of many names the first are kept, and of long ones the beginning; none reaches a terminal raw.
TEST(MeshFile, ShortensListsOfNames) {
    NameList names;
    names.add(std::string(1000, 'x'));
    EXPECT_LT(names.text().size(), 70U);
    NameList many;
    for (int i = 0; i < 1000; ++i) many.add("material " + std::to_string(i));
    EXPECT_LT(many.text().size(), 500U);
    EXPECT_TRUE(many.text().ends_with(", ..."));
    NameList odd;
    odd.add("\x1b[2J");
    EXPECT_EQ(odd.text(), "?[2J");
}

TEST(MeshFile, ReadsPlyCoordinatesByCornerAndNamesTheRest) {
    const Mesh mesh = read(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nelement face 1\n"
        "property list uchar int vertex_indices\nproperty list uchar float texcoord\n"
        "property int texnumber\nend_header\n0 0 0 255\n1 0 0 255\n1 1 0 255\n"
        "3 0 1 2 6 0 0 1 0 1 0.5 0\n");
    ASSERT_EQ(mesh->uvs.size(), 3U);
    EXPECT_EQ(mesh->uvs[mesh->triangles[0][2]], (Vec2{1, 0.5}));
    EXPECT_EQ(mesh->notes.dropped.text(), "vertex colours");
}

const std::string kPlyVertices =
    "ply\r\nformat ascii 1.0\nobj_info by hand\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\n";

// Blender, MeshLab and others do not agree on the names.
TEST(MeshFile, KnowsTheNamesOfPlyCoordinates) {
    for (const auto& [u, v] : {std::pair{"u", "v"},
                               {"s", "t"},
                               {"texture_u", "texture_v"},
                               {"texture_s", "texture_t"}}) {
        const Mesh mesh =
            read("\xEF\xBB\xBF" + kPlyVertices + "property float " + u + "\nproperty float " + v +
                 "\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
                 "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 0.5\n0 1 0 0 1\n4 0 1 2 3\n");
        expect_square(*mesh);
        ASSERT_EQ(mesh->uvs.size(), 4U) << u;
        EXPECT_EQ(mesh->uvs[2], (Vec2{1, 0.5}));
    }
}

// Two triangles whose own normals differ where they meet: six vertices. Faces of two corners are
// counted, and what else there is, is named.
TEST(MeshFile, ReadsPlyNormalsByFaceAndCountsFacesThatAreNone) {
    const Mesh mesh =
        read(kPlyVertices +
             "property float quality\nelement face 3\nproperty float nx\n"
             "property float ny\nproperty float nz\nproperty list uchar int vertex_index\n"
             "property uchar alpha\nproperty int texnumber\nelement edge 1\nproperty int vertex1\n"
             "end_header\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n0 0 2 3 0 1 2 255 0\n"
             "0 0 1 2 0 1 255 0\n0 3 4 3 0 2 3 255 1\n7\n");
    ASSERT_EQ(mesh->normals.size(), 6U);
    EXPECT_EQ(mesh->normals[mesh->triangles[0][0]], (Vec3{0, 0, 1}));
    EXPECT_NEAR(mesh->normals[mesh->triangles[1][0]].y, 0.6, 1e-15);
    EXPECT_EQ(mesh->dropped_triangles, 1U);
    EXPECT_EQ(mesh->notes.dropped.text(),
              "vertex property \"quality\", elements \"edge\", face colours, faces of one or two "
              "corners, numbers of textures: all faces have one");
}

// A vertex whose normal has no length gets the mean of its triangles'.
TEST(CheckedMesh, MendsNormalsWithoutLength) {
    TriangleMesh roof;
    roof.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, -1}, {1, 0, -1}};
    roof.triangles = {{0, 1, 2}, {1, 0, 3}};
    roof.normals = {{0, 0, 0}, {0, 0, 0}, {-3, 0, 3}, {0, 0, 0}};
    const auto mesh = checked_mesh(roof);
    ASSERT_TRUE(mesh);
    const Real half = std::sqrt(0.5);
    const std::vector<Vec3> expected{{0, 0, 1}, {0, 0, 1}, {-half, 0, half}, {half, 0, half}};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(length((*mesh)->normals[i] - expected[i]), 0, 1e-15) << i;
}

TEST(MeshFile, CutsConcavePolygonsOfBothFormats) {
    const std::string ell = "0.5 -0.5 0\n0.5 0 0\n0 0 0\n0 0.5 0\n-0.5 0.5 0\n-0.5 -0.5 0\n";
    std::string obj;
    for (std::size_t at = 0; at < ell.size();) {
        const std::size_t end = ell.find('\n', at);
        obj += "v " + ell.substr(at, end + 1 - at);
        at = end + 1;
    }
    const std::string ply_file =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
        ell + "6 0 1 2 3 4 5\n";
    for (const std::string& bytes : {obj + "f 1 2 3 4 5 6\n", ply_file}) {
        const Mesh mesh = read(bytes);
        Real area = 0;
        for (const auto& [a, b, c] : mesh->triangles) {
            const auto& p = mesh->positions;
            area += length(cross(p[b] - p[a], p[c] - p[a])) / 2;
        }
        EXPECT_NEAR(area, 0.75, 1e-15);
    }
}

TEST(MeshFile, CountsPolygonsThatCrossThemselves) {
    const Mesh mesh = read("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(mesh->notes.crossed_polygons, 1U);
}

// Equal corners; corners on a line; a triangle of height 1e-9, which has an area.
TEST(MeshFile, DropsTrianglesWithoutAreaAndCountsThem) {
    const Mesh mesh =
        read("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1e-9 0\nf 1 1 2\nf 1 2 3\nf 1 2 4\nf 1 2 4 1\n");
    EXPECT_EQ(mesh->triangles.size(), 2U);
    EXPECT_EQ(mesh->dropped_triangles, 3U);
}

TEST(MeshFile, KeepsTheSmallestAndTheLargestSizes) {
    for (const std::string size : {"1e-100", "1e100"}) {
        const Mesh mesh = read("v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
        EXPECT_EQ(mesh->triangles.size(), 1U);
    }
}

struct Malformed {
    std::string name, bytes, says;
};

std::string ply(const std::string& header, const std::string& body = {}) {
    return "ply\n" + header + "end_header\n" + body;
}

const std::string kVertex =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kAscii = "format ascii 1.0\n";
const std::string kBinary = "format binary_little_endian 1.0\n";
const std::string kCorner = "0 0 0\n1 0 0\n0 1 0\n";
const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::vector<Malformed> malformed_files() {
    return {
        {"nothing", "", "not a PLY file"},
        {"only the magic", "ply", "line 1"},
        {"prose", "a mesh, they said", "not a PLY file, nor an OBJ file"},
        {"binary rubbish",
         std::string("\x7f"
                     "ELF\0\1\2",
                     7),
         "not a PLY file, nor an OBJ file"},
        {"no end of the header", "ply\nformat ascii 1.0\n", "line 3: the header does not end"},
        {"no format", ply(kVertex + kFace, kCorner + "3 0 1 2"), "no format"},
        {"unknown format", ply("format ascii2 1.0\n"), "line 2: unknown format"},
        {"unknown version", ply("format ascii 2.0\n"), "line 2: unknown version"},
        {"two formats", ply(kAscii + kBinary), "line 3"},
        {"words after the format", ply("format ascii 1.0 or so\n"), "line 2"},
        {"unknown keyword", ply(kAscii + "elephant vertex 3\n"), "line 3"},
        {"count that is none", ply(kAscii + "element vertex many\n"), "line 3"},
        {"negative count", ply(kAscii + "element vertex -3\n"), "line 3"},
        {"count over 64 bits", ply(kAscii + "element vertex 99999999999999999999\n"), "line 3"},
        {"element twice", ply(kAscii + kVertex + kVertex), "line 7"},
        {"property before elements", ply(kAscii + "property float x\n"), "line 3"},
        {"property twice", ply(kAscii + kVertex + "property float x\n"), "line 7"},
        {"property without name", ply(kAscii + "element vertex 3\nproperty float\n"), "line 4"},
        {"unknown type", ply(kAscii + "element vertex 3\nproperty real x\n"), "line 4"},
        {"list with a float length",
         ply(kAscii + "element face 1\nproperty list float int vertex_indices\n"), "line 4"},
        {"element without properties", ply(kAscii + "element vertex 4000000000\n"),
         "has no properties"},
        {"no x",
         ply(kAscii + "element vertex 1\nproperty float y\nproperty float z\n" + kFace,
             "0 0 3 0 0 0"),
         "x, y or z"},
        {"x is a list",
         ply(kAscii +
                 "element vertex 1\nproperty list uchar float x\nproperty float y\n"
                 "property float z\n" +
                 kFace,
             "1 0 0 0 3 0 0 0"),
         "x, y or z"},
        {"no vertices", ply(kAscii + kFace, "3 0 1 2"), "no vertices"},
        {"no faces", ply(kAscii + kVertex, kCorner), "no faces"},
        {"float indices",
         ply(kAscii + kVertex + "element face 1\nproperty list uchar float vertex_indices\n",
             kCorner + "3 0 1 2"),
         "no faces"},
        {"4e9 vertices announced, ascii",
         ply(kAscii + "element vertex 4000000000\nproperty float x\n" + kFace, kCorner),
         "cut short"},
        {"4e9 vertices announced, binary",
         ply(kBinary + "element vertex 4000000000\nproperty float x\n" + kFace, kCorner),
         "cut short"},
        {"2^64-1 faces announced",
         ply(kAscii + kVertex +
                 "element face 18446744073709551615\n"
                 "property list uchar int vertex_indices\n",
             kCorner),
         "cut short"},
        {"vertex cut short", ply(kAscii + kVertex + kFace, "0 0 0 1 0 0 0 1"), "vertex"},
        {"vertex is a word", ply(kAscii + kVertex + kFace, "0 0 0\n1 0 zero\n0 1 0\n3 0 1 2"),
         "line 11, vertex 1: not a value"},
        {"vertex is nan", ply(kAscii + kVertex + kFace, "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2"),
         "vertex 1: not finite"},
        {"normal is nan",
         ply(kAscii + kVertex + "property float nx\nproperty float ny\nproperty float nz\n" + kFace,
             "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 nan 0 1\n3 0 1 2"),
         "vertex 2: not finite"},
        {"five coordinates for three corners",
         ply(kAscii + kVertex + kFace + "property list uchar float texcoord\n",
             kCorner + "3 0 1 2 5 0 0 1 0 1"),
         "face 0: texture coordinates are not two a corner"},
        {"vertex beyond double", ply(kAscii + kVertex + kFace, "0 0 1e999\n1 0 0\n0 1 0\n3 0 1 2"),
         "vertex 0"},
        {"face cut short", ply(kAscii + kVertex + kFace, kCorner + "3 0 1"), "face 0"},
        {"face of two corners", ply(kAscii + kVertex + kFace, kCorner + "2 0 1"),
         "no face of three corners"},
        {"face of minus three corners", ply(kAscii + kVertex + kFace, kCorner + "-3 0 1 2"),
         "face 0"},
        {"fractional index", ply(kAscii + kVertex + kFace, kCorner + "3 0 1 1.5"), "face 0"},
        {"index too large", ply(kAscii + kVertex + kFace, kCorner + "3 0 1 3"),
         "line 13, face 0: no such vertex"},
        {"negative index", ply(kAscii + kVertex + kFace, kCorner + "3 0 1 -1"), "no such vertex"},
        {"more than announced", ply(kAscii + kVertex + kFace, kCorner + "3 0 1 2\n3 0 1 2"),
         "more follows"},
        {"list without end",
         ply(kBinary + kVertex + "element face 1\nproperty list uint int vertex_indices\n",
             std::string(36, '\0') + "\xff\xff\xff\x7f" + std::string(12, '\0')),
         "face 0"},
        {"all triangles without area", ply(kAscii + kVertex + kFace, kCorner + "3 0 1 1"),
         "no triangle that has an area"},
        {"obj without faces", kObj, "faces"},
        {"obj of lines", kObj + "l 1 2 3\n", "an OBJ file without faces; it has lines"},
        {"obj face before its vertices", "f 1 2 3\n" + kObj, "line 1"},
        {"obj index 0", kObj + "f 0 1 2\n", "line 4: no such corner"},
        {"obj index too large", kObj + "f 1 2 4\n", "line 4: no such corner"},
        {"obj negative index too large", kObj + "f 1 2 -4\n", "line 4"},
        {"obj index over 64 bits", kObj + "f 1 2 99999999999999999999\n", "line 4"},
        {"obj unknown texture coordinate", kObj + "f 1/1 2/1 3/1\n", "line 4"},
        {"obj unknown normal", kObj + "f 1//1 2//1 3//1\n", "line 4"},
        {"obj four indices", kObj + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2/1/1 3/1/1\n", "line 6"},
        {"obj empty index", kObj + "f /1 2 3\n", "line 4"},
        {"obj nine coordinates", "v 0 0 0 1 1 1 1 1 1\n", "wrong count of numbers"},
        {"obj fractional index", kObj + "f 1 2 2.5\n", "line 4"},
        {"obj two corners", kObj + "f 1 2\n", "line 4: a face needs three corners"},
        {"obj two coordinates", "v 0 0\n", "line 1: wrong count of numbers"},
        {"obj vertex is a word", "v 0 0 x\n", "line 1: not a number: \"x\""},
        {"obj vertex is infinite", "v 0 0 inf\n", "line 1: not finite"},
        {"obj without area", kObj + "f 1 1 1\n", "no triangle"},
    };
}

TEST(MeshFile, RefusesMalformedFilesAndSaysWhere) {
    for (const Malformed& file : malformed_files()) {
        const auto mesh = read_mesh(file.bytes);
        ASSERT_FALSE(mesh) << file.name;
        EXPECT_EQ(mesh.error().kind, ErrorKind::InvalidInput) << file.name;
        EXPECT_NE(mesh.error().message.find(file.says), std::string::npos)
            << file.name << " says: " << mesh.error().message;
    }
}

TEST(MeshFile, HoldsItsLimits) {
    const std::string bytes = kAsciiHead + kSquare + "4 0 1 2 3\n";
    EXPECT_TRUE(read_mesh(bytes, {4, 2}));
    EXPECT_FALSE(read_mesh(bytes, {3, 2}));
    EXPECT_FALSE(read_mesh(bytes, {4, 1}));
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    EXPECT_TRUE(read_mesh(obj, {4, 2}));
    EXPECT_FALSE(read_mesh(obj, {3, 2}));
    EXPECT_FALSE(read_mesh(obj, {4, 1}));
}

TEST(CheckedMesh, AcceptsAndRefusesByTheSameRules) {
    TriangleMesh good;
    good.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    good.triangles = {{0, 1, 2}, {0, 0, 1}};
    const auto checked = checked_mesh(good);
    ASSERT_TRUE(checked);
    EXPECT_EQ((*checked)->triangles.size(), 1U);
    EXPECT_EQ((*checked)->dropped_triangles, 1U);
    const auto refused = [](const TriangleMesh& mesh) { return !checked_mesh(mesh); };
    EXPECT_TRUE(refused({}));
    auto bad = good;
    bad.triangles.push_back({0, 1, 3});
    EXPECT_TRUE(refused(bad));
    bad = good;
    bad.positions[2].y = std::numeric_limits<Real>::infinity();
    EXPECT_TRUE(refused(bad));
    bad = good;
    bad.normals.resize(2);
    EXPECT_TRUE(refused(bad));
    bad = good;
    bad.uvs = {{0, 0}, {0, std::nan("")}, {0, 0}};
    EXPECT_TRUE(refused(bad));
    EXPECT_FALSE(checked_mesh(good, {2, 10}));
    EXPECT_FALSE(checked_mesh(good, {3, 1}));
}

}  // namespace
}  // namespace bouguer::renderer
