// SPDX-License-Identifier: GPL-3.0-or-later
// The readers: good files of every kind give the mesh, hostile ones a sentence with a place.
#include "mesh_samples.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Result<Polygon_soup> parse(const std::string& bytes, Mesh_format format = Mesh_format::automatic) {
  return parse_polygon_soup(bytes.data(), bytes.size(), format);
}

void check_equal(const Result<Polygon_soup>& read, const Polygon_soup& expected) {
  if (!read) FAIL(read.error().message);
  CHECK(read->points == expected.points);
  CHECK(read->begin == expected.begin);
  CHECK(read->corner == expected.corner);
}

/// A folder of this process that vanishes with the test.
struct Scratch_folder {
  std::string path;
  Scratch_folder() : path("test_io_scratch_" + std::to_string(::getpid())) {
    REQUIRE(::mkdir(path.c_str(), 0777) == 0);
  }
  ~Scratch_folder() { (void)!std::system(("rm -r '" + path + "'").c_str()); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path + "/" + name, std::ios::binary) << bytes;
    return path + "/" + name;
  }
};

struct Bad_file {
  const char* what;
  std::string bytes;
  Mesh_format format;
  Error_code code;
  Element_kind element;
  std::int64_t index;
  const char* says;
};

const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

std::vector<Bad_file> bad_files() {
  const auto malformed = Error_code::malformed_file, unsupported = Error_code::unsupported_format;
  const auto none = Element_kind::none, line = Element_kind::line, byte = Element_kind::byte;
  const auto any = Mesh_format::automatic;
  std::vector<Bad_file> all = {
      {"nothing", "", any, malformed, none, -1, "empty"},
      {"text", "hello world\n", any, unsupported, none, -1, "not OFF, OBJ, PLY, STL or glTF"},
      {"text named obj", "hello world\n", Mesh_format::obj, malformed, line, 2, "no points"},
      {"gzip", std::string("\x1f\x8b\x08\0\0\0", 6), Mesh_format::off, unsupported, none, -1, "gzip"},
      {"zip", "PK\x03\x04 etc", Mesh_format::obj, unsupported, none, -1, "zip"},
      {"glTF", "glTF\x02", any, malformed, none, -1, "ends in its header"},
      {"UTF-16", "\xff\xfeO", Mesh_format::off, unsupported, none, -1, "UTF-16"},

      {"OFF header only", "OFF\n", any, malformed, line, 2, "number of points"},
      {"OFF counts only", "OFF\n4 4 0\n", any, malformed, line, 2, "only 1 bytes follow"},
      {"OFF huge counts", "OFF\n4000000000000 4 0\n0 0 0\n", any, malformed, line, 2, "2147483646"},
      {"OFF large counts", "OFF\n2000000000 2000000000 0\n0 0 0\n", any, malformed, line, 2, "announces"},
      {"OFF negative count", "OFF\n-1 4 0\n0 0 0\n", any, malformed, line, 2, "negative"},
      {"OFF count beyond 64 bits", "OFF\n99999999999999999999 1 0\n", any, malformed, line, 2,
       "number of points"},
      {"OFF index N", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", any, malformed, line, 6, "index 3"},
      {"OFF index -1", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", any, malformed, line, 6, "index -1"},
      {"OFF index 1.5", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", any, malformed, line, 6, "'1.5'"},
      {"OFF huge face", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", any, malformed, line, 6,
       "corners"},
      {"OFF word", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", any, malformed, line, 4, "'zero'"},
      {"OFF +-1", "OFF\n3 1 0\n0 0 0\n1 +-1 0\n0 1 0\n3 0 1 2\n", any, malformed, line, 4, "'+-1'"},
      {"OFF with colours it does not announce",
       "OFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n", any, malformed, line, 3,
       "more than three numbers"},
      {"OFF truncated", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0 #long enough\n3 0 1\n", any, malformed, line, 7,
       "ends at face 0"},
      {"OFF binary", "OFF BINARY\n123456789", any, unsupported, none, -1, "binary OFF"},
      {"4OFF", "4OFF\n1 0 0\n0 0 0 1\n", any, unsupported, none, -1, "four coordinates"},
      {"nOFF", "nOFF 2\n1 0 0\n0 0\n", any, unsupported, none, -1, "dimensions"},

      {"OBJ index N + 1", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", any, malformed, line, 4, "index 4"},
      {"OBJ index 0", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", any, malformed, line, 4, "index 0"},
      {"OBJ index -4", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", any, malformed, line, 4, "index -4"},
      {"OBJ huge index", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n", any, malformed, line, 4,
       "4000000000"},
      {"OBJ index beyond 64 bits", "v 0 0 0\nf 1 2 99999999999999999999\n", any, malformed, line, 2,
       "index of a point"},
      {"OBJ half a point", "v 0 0\nf 1 1 1\n", any, malformed, line, 1, "the end of the line"},
      {"OBJ without corners", "v 0 0 0\nf\n", any, malformed, line, 2, "without corners"},
      {"OBJ slashes", "v 0 0 0\nf 1/1/1/1 1 1\n", any, malformed, line, 2, "'1/1/1/1'"},
      {"OBJ NaN of an old compiler", "v 0 0 1.#QNAN\n", any, malformed, line, 1, "'1.#QNAN'"},
      {"OBJ binary rubbish", "v 0 0 0\n\x01\x02\x03\n", any, malformed, line, 2, "statement"},

      {"PLY header only", "ply\n", any, malformed, line, 2, "does not end"},
      {"PLY without format", "ply\nelement vertex 0\nend_header\n", any, malformed, line, 3, "no format"},
      {"PLY unknown format", "ply\nformat binary 1.0\nend_header\n", any, malformed, line, 2, "'binary'"},
      {"PLY without points", "ply\nformat ascii 1.0\nelement face 0\nend_header\n", any, malformed, line, 4,
       "vertex"},
      {"PLY huge counts",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000000\nproperty float x\nproperty float "
       "y\nproperty "
       "float z\nend_header\n0123",
       any, malformed, byte, 127, "only 4 bytes follow"},
      {"PLY points without properties",
       "ply\nformat ascii 1.0\nelement vertex 4000000000000000\nend_header\n", any, malformed, line, 5,
       "x, y and z"},
      {"PLY negative count", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", any, malformed, line,
       3, "negative"},
      {"PLY unknown type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", any,
       malformed, line, 4, "'quad'"},
      {"PLY property first", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", any, malformed, line, 3,
       "before any element"},
      {"PLY unknown statement", "ply\nformat ascii 1.0\nelments vertex 1\nend_header\n", any, malformed, line,
       3, "'elments'"},
      {"PLY two vertex elements", ply_head + "element vertex 1\nproperty float x\nend_header\n0 0 0\n", any,
       malformed, line, 9, "twice"},
      {"PLY index N",
       ply_head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                  "0\n3 0 1 3\n",
       any, malformed, line, 13, "not one of 3 points"},
      {"PLY index -1",
       ply_head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                  "0\n3 0 1 -1\n",
       any, malformed, line, 13, "not one of 3 points"},
      {"PLY index NaN",
       ply_head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                  "0\n3 0 1 nan\n",
       any, malformed, line, 13, "not one of 3 points"},
      {"PLY huge list",
       ply_head + "element face 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                  "0\n2000000000 0 1 2\n",
       any, malformed, line, 13, "impossible number"},
      {"PLY face without list",
       ply_head + "element face 1\nproperty int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3\n", any,
       malformed, line, 12, "no list"},
      {"PLY word", ply_head + "end_header\n0 0 0\n1 zero 0\n0 1 0\n", any, malformed, line, 9, "'zero'"},

      {"STL too short", "abc", Mesh_format::stl, malformed, byte, 3, "too short"},
      {"STL huge count", std::string(80, ' ') + "\xff\xff\xff\x7f" + std::string(50, '\0'), Mesh_format::stl,
       malformed, byte, 80, "2147483647 triangles"},
      {"STL without end", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", any, malformed, line, 5,
       "the end of the file"},
      {"STL word", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0\n", any, malformed, line, 4, "'x'"},
      {"STL square",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
       "0\nendloop\n",
       any, malformed, line, 7, "endloop"},
  };
  std::string cut = samples::rich_binary_ply(samples::cube(), true);
  cut.resize(cut.size() - 1);
  all.push_back(
      {"PLY truncated", cut, any, malformed, byte, std::int64_t(cut.size()) - 7, "impossible number"});
  cut = samples::binary_stl(samples::tetrahedron());
  cut.resize(cut.size() - 1);
  all.push_back({"STL truncated", cut, Mesh_format::stl, malformed, byte, 80, "bytes for 3"});
  return all;
}

long peak_memory_kilobytes() {
  struct rusage usage;
  REQUIRE(::getrusage(RUSAGE_SELF, &usage) == 0);
  return usage.ru_maxrss;
}

} // namespace

TEST_CASE("a tetrahedron is the same in every format and variant") {
  const Polygon_soup tetrahedron = samples::tetrahedron();
  check_equal(parse(samples::tetrahedron_off), tetrahedron);
  check_equal(parse(samples::tetrahedron_coff), tetrahedron);
  check_equal(parse(samples::tetrahedron_obj), tetrahedron);
  check_equal(parse(samples::tetrahedron_ply), tetrahedron);
  check_equal(parse(samples::rich_binary_ply(tetrahedron, false)), tetrahedron);
  check_equal(parse(samples::rich_binary_ply(tetrahedron, true)), tetrahedron);
}

TEST_CASE("polygons keep their corners") {
  check_equal(parse(samples::rich_binary_ply(samples::cube(), true)), samples::cube());
}

TEST_CASE("OFF without its keyword, glued to its counts, or without the number of edges is read") {
  const std::string rest = "1 1 1\n-1 -1 1\n-1 1 -1\n1 -1 -1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3";
  check_equal(parse("OFF4 4 6\n" + rest), samples::tetrahedron());
  check_equal(parse("OFF\n4 4\n" + rest), samples::tetrahedron());
  check_equal(parse("OFF 4 4 6\n" + rest), samples::tetrahedron());
  check_equal(parse("4 4 6\n" + rest, Mesh_format::off), samples::tetrahedron());
  check_equal(parse("\xef\xbb\xbfSTCNOFF\n4 4 6\n" + rest), samples::tetrahedron());
}

TEST_CASE("lines may end with LF, CR LF or CR") {
  for (const char* file : {samples::tetrahedron_off, samples::tetrahedron_obj, samples::tetrahedron_ply})
    for (const char* ending : {"\r\n", "\r"}) {
      std::string changed;
      for (const char* c = file; *c; ++c) changed += *c == '\n' ? std::string(ending) : std::string(1, *c);
      check_equal(parse(changed), samples::tetrahedron());
    }
}

TEST_CASE("a triangle strip turns every second triangle and restarts at -1") {
  const Result<Polygon_soup> read = parse(samples::strip_ply);
  REQUIRE(read);
  CHECK(read->corner == std::vector<int>{0, 2, 1, 1, 2, 3, 0, 3, 2});
}

TEST_CASE("equal points of an STL file are one point") {
  const Result<Polygon_soup> ascii = parse(samples::triangle_stl),
                             binary = parse(samples::binary_stl(samples::tetrahedron()));
  REQUIRE(ascii);
  CHECK(ascii->points == std::vector<Point>{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)});
  CHECK(ascii->corner == std::vector<int>{0, 1, 2, 1, 3, 2});
  REQUIRE(binary);
  CHECK(binary->number_of_points() == 4);
  CHECK(binary->number_of_polygons() == 4);
}

TEST_CASE("a binary STL file whose name begins with solid is binary") {
  const Result<Polygon_soup> read = parse(samples::binary_stl(samples::tetrahedron(), "solid tetrahedron"));
  REQUIRE(read);
  CHECK(read->number_of_polygons() == 4);
}

TEST_CASE("the content decides about the format, the extension where the content does not tell") {
  check_equal(parse(samples::tetrahedron_off, Mesh_format::obj), samples::tetrahedron());
  check_equal(parse(samples::tetrahedron_ply, Mesh_format::stl), samples::tetrahedron());
  CHECK(format_of_extension("a/b.c/mesh.OfF") == Mesh_format::off);
  CHECK(format_of_extension("a.obj/mesh") == Mesh_format::automatic);
  CHECK(format_of_extension("mesh.obj.gz") == Mesh_format::automatic);
}

TEST_CASE("coordinates that are not finite are read, for the check to list") {
  const Result<Polygon_soup> read = parse("v nan 0 0\nv -inf 0 0\nv 1e999 -1e999 1e-999\nv +1.5 .5 5.\n");
  REQUIRE(read);
  CHECK(std::isnan(read->points[0][0]));
  CHECK(read->points[1][0] == -INFINITY);
  CHECK(read->points[2] == Point(INFINITY, -INFINITY, 0));
  CHECK(read->points[3] == Point(1.5, 0.5, 5));
}

TEST_CASE("a face of an OBJ file may name points that come later") {
  const Result<Polygon_soup> read = parse("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", Mesh_format::obj);
  REQUIRE(read);
  CHECK(read->corner == std::vector<int>{0, 1, 2});
}

TEST_CASE("what does not matter for the surface is passed over with a note") {
  struct Case {
    const char* what;
    std::string bytes;
    Mesh_format format;
    int polygons;
    const char* says;
  };
  const std::string facet =
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  std::string uncounted(84, '\0');
  for (int facets = 0; facets < 2; ++facets) {
    for (int k = 0; k < 12; ++k) samples::put(uncounted, float(k == 6 || k == 10 ? 1 + facets : 0));
    uncounted += std::string(2, '\0');
  }
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                    obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
  const std::vector<Case> cases = {
      {"OFF with more faces than announced", off + "3 0 2 1\n", Mesh_format::off, 1, "line 7"},
      {"OFF with text behind it", off + "made by hand\n", Mesh_format::off, 1, "'made'"},
      {"OBJ with a texture index 0", obj + "f 1/0 2/1 3/1\n", Mesh_format::obj, 1,
       "1 corners are no indices, first in line 5"},
      {"OBJ with a texture index beyond 64 bits", obj + "f 1/1 2/99999999999999999999 3/1\n",
       Mesh_format::obj, 1, "line 5"},
      {"OBJ with texture indices out of range", obj + "f 1/1 2/2 3/1\n", Mesh_format::obj, 1, "do not exist"},
      {"OBJ with normals out of range", obj + "f 1//1 2//1 3//1\n", Mesh_format::obj, 1, "do not exist"},
      {"ascii STL without endsolid", "solid a\n" + facet + facet, Mesh_format::stl, 2, "without endsolid"},
      {"ascii STL with a second solid", "solid a\n" + facet + "solid b\n" + facet + "endsolid b\n",
       Mesh_format::stl, 2, "before line 9"},
      {"binary STL without its count", uncounted, Mesh_format::stl, 2, "announces no triangles"},
  };
  for (const Case& c : cases) {
    INFO(c.what);
    std::vector<std::string> notes;
    const Result<Polygon_soup> read = parse_polygon_soup(c.bytes.data(), c.bytes.size(), c.format, &notes);
    if (!read) FAIL(read.error().message);
    CHECK(read->number_of_polygons() == c.polygons);
    REQUIRE(notes.size() == 1);
    INFO(notes[0]);
    CHECK(notes[0].find(c.says) != std::string::npos);
    CHECK(parse(c.bytes, c.format)); // without somebody to tell
  }
  std::vector<std::string> none;
  CHECK(parse_polygon_soup(off.data(), off.size(), Mesh_format::off, &none));
  const std::string textured = obj + "f 1/1 2/-1 3/1\n";
  CHECK(parse_polygon_soup(textured.data(), textured.size(), Mesh_format::obj, &none));
  CHECK(none.empty());
  // A facet that is not whole is not passed over.
  CHECK_FALSE(parse("solid a\n" + facet + "facet normal 0 0 0\n", Mesh_format::stl));
  CHECK_FALSE(parse("solid a\n", Mesh_format::stl));
}

TEST_CASE("glTF is read with the places of its nodes, strips and mirrors") {
  std::vector<std::string> notes;
  const std::string file = samples::rich_gltf();
  const Result<Polygon_soup> read =
      parse_polygon_soup(file.data(), file.size(), Mesh_format::automatic, &notes);
  if (!read) FAIL(read.error().message);
  // Each node: four triangles of the tetrahedron and two of the strip.
  REQUIRE(read->number_of_polygons() == 12);
  REQUIRE(read->number_of_points() == 16);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("2 primitives of points or lines") != std::string::npos);
  const Polygon_soup s = samples::tetrahedron();
  for (int v = 0; v < 4; ++v) { // turned by 90 degrees about z, scaled or mirrored before, and moved
    const Point p = s.points[v];
    CHECK((read->points[v] - Point(10 - 2 * p[1], 2 * p[0], 2 * p[2])).norm() < 1e-12);
    CHECK((read->points[8 + v] - Point(10 - p[1], -p[0], p[2] + 5)).norm() < 1e-12);
  }
  const auto volume = [&](int first) {
    double sum = 0;
    for (int t = first; t < first + 4; ++t) {
      const Point &a = read->points[read->corner[3 * t]], &b = read->points[read->corner[3 * t + 1]],
                  &c = read->points[read->corner[3 * t + 2]];
      sum += a.dot(b.cross(c)) / 6;
    }
    return sum;
  };
  CHECK(volume(0) == Approx(8 * 8.0 / 3));
  CHECK(volume(6) == Approx(8.0 / 3)); // a mirror turns the faces back
  const auto normal = [&](int t) {
    const Point &a = read->points[read->corner[3 * t]], &b = read->points[read->corner[3 * t + 1]],
                &c = read->points[read->corner[3 * t + 2]];
    return Point((b - a).cross(c - a).normalized());
  };
  CHECK((normal(4) - normal(5)).norm() < 1e-12); // a strip turns every second triangle
}

TEST_CASE("glTF as JSON with its buffers inside is read, and with its buffers elsewhere says what to do") {
  // One triangle of three floats each, in base64.
  const std::string buffer = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const auto json = [](const std::string& uri, const std::string& more = "") {
    return R"({"asset":{"version":"2.0"},)" + more +
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
           uri + R"("}]})";
  };
  const Result<Polygon_soup> read = parse(json("data:application/octet-stream;base64," + buffer));
  if (!read) FAIL(read.error().message);
  CHECK(read->points == std::vector<Point>{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)});
  CHECK(read->corner == std::vector<int>{0, 1, 2});
  const Result<Polygon_soup> elsewhere = parse(json("scene.bin"));
  REQUIRE_FALSE(elsewhere);
  CHECK(elsewhere.error().code == Error_code::unsupported_format);
  CHECK(elsewhere.error().message.find("save it as .glb") != std::string::npos);
  const Result<Polygon_soup> squeezed =
      parse(json("data:;base64," + buffer, R"("extensionsRequired":["KHR_draco_mesh_compression"],)"));
  REQUIRE_FALSE(squeezed);
  CHECK(squeezed.error().message.find("KHR_draco_mesh_compression") != std::string::npos);
}

TEST_CASE("glTF that contradicts itself is refused before anything is read outside it") {
  const std::string good = samples::rich_gltf();
  const auto changed = [&](const std::string& from, std::string to) {
    const std::size_t at = good.find(from);
    REQUIRE(at != std::string::npos);
    REQUIRE(to.size() <= from.size());
    to.append(from.size() - to.size(), ' '); // the lengths stay
    std::string file = good;
    return file.replace(at, from.size(), to);
  };
  struct Case {
    std::string bytes;
    const char* says;
  };
  const std::vector<Case> cases = {
      {changed("\"count\":4", "\"count\":9"), "do not fit into their view"},
      {changed("\"count\":12,", "\"count\":13,"), "do not fit into their view"},
      {changed("\"byteStride\":24", "\"byteStride\":4"), "do not fit into their view"},
      {changed("\"byteOffset\":120", "\"byteOffset\":999"), "does not fit into its buffer"},
      {changed("\"count\":12,", "\"count\":-1,"), "no index or size"},
      {changed("\"componentType\":5123", "\"componentType\":5124"), "component type 5124"},
      {changed("\"type\":\"SCALAR\"", "\"type\":\"VEC3\""), "is of type"},
      {changed("\"children\":[1,2]", "\"children\":[0]"), "two parents, or is its own"},
      {changed("\"children\":[1,2]", "\"children\":[9]"), "no node 9"},
      {changed("\"translation\":[10,0,0]", "\"translation\":[1,0]"), "3 numbers"},
      {changed("\"translation\":[10,0,0]", "\"translation\":[{},0,0]"), "not of the kind"},
      {changed("{\"asset\"", "[\"asset\""), "JSON is broken"},
      {good.substr(0, good.size() - 8), "shorter than it says"},
      {std::string("{\"asset\":") + std::string(100, '[') + std::string(100, ']') + "}", "too deep"},
  };
  for (const Case& c : cases) {
    const Result<Polygon_soup> read = parse(c.bytes);
    REQUIRE_FALSE(read);
    INFO(read.error().message);
    CHECK(read.error().message.find(c.says) != std::string::npos);
    CHECK(read.error().message.back() == '.');
  }
  // An index too large, in the bytes.
  std::string index = good;
  index[index.size() - 48 - 24] = 7;
  const Result<Polygon_soup> out = parse(index);
  REQUIRE_FALSE(out);
  CHECK(out.error().message.find("index 7 is not one of 4 points") != std::string::npos);
  // Whatever byte is changed, indices stay in range.
  for (std::size_t at = 0; at < good.size(); ++at)
    for (const char byte : {'\0', '\xff', '9', '[', '"'}) {
      std::string file = good;
      file[at] = byte;
      const std::vector<char> copy(file.begin(), file.end());
      const Result<Polygon_soup> read = parse_polygon_soup(copy.data(), copy.size(), Mesh_format::glb);
      if (!read) continue;
      for (int v : read->corner)
        if (v < 0 || v >= read->number_of_points()) FAIL("index " << v);
    }
}

TEST_CASE("nodes that place a mesh again and again end at a limit") {
  std::string nodes = "{\"mesh\":0}";
  for (int i = 1; i < 2000; ++i) nodes += ",{\"mesh\":0}";
  const std::string file = samples::binary_gltf(
      R"({"asset":{"version":"2.0"},"nodes":[)" + nodes +
          R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
          R"("accessors":[{"bufferView":0,"componentType":5126,"count":100000,"type":"VEC3"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":1200000}],"buffers":[{"byteLength":1200000}]})",
      std::string(1200000, '\0'));
  const Result<Polygon_soup> read = parse(file);
  REQUIRE_FALSE(read);
  CHECK(read.error().message.find("more than 30000000 points") != std::string::npos);
}

TEST_CASE("3MF is read where Assimp is there, and says why where it is not") {
  const Scratch_folder folder;
  const bool with = (" " + other_mesh_formats() + " ").find(" 3mf ") != std::string::npos;
  const Result<Polygon_soup> broken = read_polygon_soup(folder.write("broken.3mf", "PK\x03\x04 and nothing"));
  REQUIRE_FALSE(broken);
  CHECK(broken.error().code == (with ? Error_code::malformed_file : Error_code::unsupported_format));
  if (!with) {
    WARN("built without Assimp: its formats are not tested");
    CHECK(broken.error().message.find("Assimp") != std::string::npos);
    return;
  }
  const Result<Polygon_soup> dae =
      read_polygon_soup(folder.write("tetrahedron.dae", samples::collada_tetrahedron()));
  if (!dae) FAIL(dae.error().message);
  CHECK(dae->number_of_polygons() == 4);
}

TEST_CASE("hostile files get a code, a sentence and a place, and neither time nor memory") {
  const long before = peak_memory_kilobytes();
  const auto start = std::chrono::steady_clock::now();
  for (const Bad_file& bad : bad_files()) {
    INFO(bad.what);
    const Result<Polygon_soup> read = parse(bad.bytes, bad.format);
    REQUIRE_FALSE(read);
    INFO(read.error().message);
    CHECK(read.error().code == bad.code);
    CHECK(read.error().element == bad.element);
    CHECK(read.error().index == bad.index);
    CHECK(read.error().message.find(bad.says) != std::string::npos);
    CHECK(read.error().message.back() == '.');
  }
  CHECK(peak_memory_kilobytes() - before < 50'000);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("no beginning of a good file is mistaken for the whole, or reads outside it") {
  for (const std::string& file : samples::good_files()) {
    const Result<Polygon_soup> whole = parse(file);
    REQUIRE(whole);
    for (std::size_t size = 0; size < file.size(); ++size) {
      // A copy of exactly that size, so that the sanitizer sees the first byte too many.
      const std::vector<char> part(file.begin(), file.begin() + std::ptrdiff_t(size));
      const Result<Polygon_soup> read = parse_polygon_soup(part.data(), part.size());
      if (!read)
        CHECK_FALSE(read.error().message.empty());
      else
        CHECK(read->corner.size() <= whole->corner.size());
    }
    // Binary files tell their size: no beginning is accepted.
    if (file.find('\0') == std::string::npos) continue;
    for (std::size_t size = 0; size < file.size(); ++size)
      CHECK_FALSE(parse(file.substr(0, size), Mesh_format::stl));
  }
}

TEST_CASE("a changed byte gives another mesh or an error, whose indices are in range") {
  for (const std::string& file : samples::good_files())
    for (std::size_t at = 0; at < file.size(); ++at)
      for (const char byte : {'\0', '\xff', '-', '9', ' ', '\n'}) {
        std::string changed = file;
        changed[at] = byte;
        const Result<Polygon_soup> read = parse(changed, Mesh_format::obj);
        if (!read) continue;
        for (int v : read->corner)
          if (v < 0 || v >= read->number_of_points()) FAIL("index " << v);
        if (read->begin.back() != int(read->corner.size())) FAIL("polygons do not cover the corners");
      }
}

TEST_CASE("what is not a regular file is unreadable, and says why") {
  const Scratch_folder folder;
  const std::string pipe = folder.path + "/pipe.off";
  REQUIRE(::mkfifo(pipe.c_str(), 0666) == 0);
  for (const auto& [path, says] : {std::pair(folder.path, "folder"), std::pair(pipe, "regular file"),
                                   std::pair(folder.path + "/missing.off", "No such file"),
                                   std::pair(std::string("/dev/zero"), "regular file")}) {
    const Result<Polygon_soup> read = read_polygon_soup(path);
    REQUIRE_FALSE(read);
    CHECK(read.error().code == Error_code::unreadable_file);
    CHECK(read.error().message.find(says) != std::string::npos);
    CHECK(read.error().message.find(path) != std::string::npos);
  }
  const std::string large = folder.write("large.off", samples::tetrahedron_off);
  CHECK(read_polygon_soup(large));
  const Result<Polygon_soup> refused = read_polygon_soup(large, 20);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("limit of 20") != std::string::npos);
}

TEST_CASE("a sparse file of terabytes is refused before memory is taken") {
  const Scratch_folder folder;
  const std::string path = folder.write("sparse.stl", "solid");
  if (::truncate(path.c_str(), off_t(1) << 40) != 0) return; // the file system has smaller files only
  const Result<Polygon_soup> read = read_polygon_soup(path);
  REQUIRE_FALSE(read);
  CHECK(read.error().code == Error_code::unreadable_file);
}

TEST_CASE("400,000 triangles are read fast") {
  std::string off = "OFF\n200000 400000 0\n", ply;
  ply = "ply\nformat binary_little_endian 1.0\nelement vertex 200000\nproperty double x\nproperty double "
        "y\nproperty double "
        "z\nelement face 400000\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 200'000; ++i) {
    const double x = std::sin(i), y = std::cos(i * 0.7), z = std::sqrt(i);
    char text[96];
    off.append(text, std::size_t(std::snprintf(text, sizeof text, "%.17g %.17g %.17g\n", x, y, z)));
    for (double c : {x, y, z}) samples::put(ply, c);
  }
  for (int i = 0; i < 400'000; ++i) {
    const int a = i % 200'000, b = (i + 1) % 200'000, c = (i * 7 + 3) % 200'000;
    off += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    samples::put(ply, std::uint8_t(3));
    for (int v : {a, b, c}) samples::put(ply, std::int32_t(v));
  }
  const std::clock_t start = std::clock();
  const Result<Polygon_soup> from_off = parse(off);
  const std::clock_t middle = std::clock();
  const Result<Polygon_soup> from_ply = parse(ply);
  const std::clock_t end = std::clock();
  REQUIRE(from_off);
  REQUIRE(from_ply);
  CHECK(from_off->points == from_ply->points);
  CHECK(from_off->corner == from_ply->corner);
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && defined(NDEBUG)
  CHECK(double(middle - start) / CLOCKS_PER_SEC <
        0.5); // measured: 0.04; the bound leaves room for slow machines
  CHECK(double(end - middle) / CLOCKS_PER_SEC < 0.5); // measured: 0.04
#else
  (void)start, (void)middle, (void)end;
#endif
}
