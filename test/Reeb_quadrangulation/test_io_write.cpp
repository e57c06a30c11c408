// SPDX-License-Identifier: GPL-3.0-or-later
// The writers: what is written reads back, and files are written whole or not at all.
#include "mesh_samples.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace CGAL::Reeb_quadrangulation;
namespace fs = std::filesystem;

namespace {

/// A folder of this process that vanishes with the test.
struct Empty_folder {
  fs::path path = fs::absolute("test_io_write_scratch_" + std::to_string(::getpid()));
  Empty_folder() { fs::create_directory(path); }
  ~Empty_folder() { fs::remove_all(path); }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  std::size_t number_of_files() const {
    return std::size_t(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

Polygon_soup awkward_numbers() {
  Polygon_soup s = samples::cube();
  s.points[0] = Point(1.0 / 3, -0.0, 5e-324);
  s.points[1] = Point(0.1 + 0.2, 1e22, -1.7976931348623157e308);
  s.points[2] = Point(123456789.123456789, 2e-7, 1e15);
  return s;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    n |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return n;
}

} // namespace

TEST_CASE("what is written as OBJ, OFF and PLY reads back to the same bits") {
  const Polygon_soup mesh = awkward_numbers();
  for (const auto& [format, ascii] :
       {std::pair(Mesh_format::obj, false), std::pair(Mesh_format::off, false),
        std::pair(Mesh_format::ply, false), std::pair(Mesh_format::ply, true)}) {
    const Result<Encoded_mesh> encoded = encode_mesh(mesh, format, ascii);
    REQUIRE(encoded);
    CHECK(encoded->warnings.empty());
    const Result<Polygon_soup> read = parse_polygon_soup(encoded->bytes.data(), encoded->bytes.size());
    REQUIRE(read);
    CHECK(read->points == mesh.points);
    CHECK(std::signbit(read->points[0][1]));
    CHECK(read->begin == mesh.begin);
    CHECK(read->corner == mesh.corner);
  }
}

TEST_CASE("a VTK file holds the points and the quads") {
  const Result<Encoded_mesh> encoded = encode_mesh(samples::cube(), Mesh_format::vtk);
  REQUIRE(encoded);
  std::istringstream in(encoded->bytes);
  std::string line, word;
  for (int i = 0; i < 4; ++i) std::getline(in, line);
  CHECK(line == "DATASET POLYDATA");
  int points = 0, polygons = 0, size = 0, corners = 0;
  double coordinate = 0, sum = 0;
  in >> word >> points >> word;
  REQUIRE(points == 8);
  for (int i = 0; i < 24; ++i) in >> coordinate, sum += coordinate;
  CHECK(sum == 12);
  in >> word >> polygons >> size;
  CHECK(word == "POLYGONS");
  CHECK(polygons == 6);
  CHECK(size == 30);
  in >> corners;
  CHECK(corners == 4);
}

TEST_CASE("STL and glTF hold triangles, and say so when there were quads") {
  for (Mesh_format format : {Mesh_format::stl, Mesh_format::glb}) {
    const Result<Encoded_mesh> quads = encode_mesh(samples::cube(), format),
                               triangles = encode_mesh(samples::tetrahedron(), format);
    REQUIRE(quads);
    REQUIRE(triangles);
    REQUIRE(quads->warnings.size() == 1);
    CHECK(quads->warnings[0].find("6 faces") != std::string::npos);
    CHECK(triangles->warnings.empty());
  }
  for (bool ascii : {false, true}) {
    const Result<Encoded_mesh> encoded = encode_mesh(samples::cube(), Mesh_format::stl, ascii);
    REQUIRE(encoded);
    const Result<Polygon_soup> read = parse_polygon_soup(encoded->bytes.data(), encoded->bytes.size());
    REQUIRE(read);
    CHECK(read->number_of_points() == 8);
    CHECK(read->number_of_polygons() == 12);
  }
}

TEST_CASE("a quad is divided at its first diagonal, unless a half would be turned over") {
  // How many of the six corners of the two triangles lie at p.
  const auto corners_at = [](const Polygon_soup& quad, const Point& p) {
    const Result<Encoded_mesh> encoded = encode_mesh(quad, Mesh_format::stl);
    REQUIRE(encoded);
    const Result<Polygon_soup> read = parse_polygon_soup(encoded->bytes.data(), encoded->bytes.size());
    REQUIRE(read);
    REQUIRE(read->number_of_polygons() == 2);
    int number = 0;
    for (int c : read->corner) number += read->points[c] == p;
    return number;
  };
  const Point fold(0, 0, 0), far(2, 2, 0), low(2, 0, -2), high(0, 2, -2);
  // Folded along its first diagonal, which is the longer one.
  CHECK(corners_at(samples::soup({fold, low, far, high}, {{0, 1, 2, 3}}), fold) == 2);
  CHECK(corners_at(samples::soup({fold, low, far, high}, {{1, 2, 3, 0}}), fold) == 1);
  // An arrowhead, whose dent is its second corner.
  const Point dent(2, 1, 0);
  CHECK(corners_at(samples::soup({Point(0, 0, 0), dent, Point(4, 0, 0), Point(2, 4, 0)}, {{0, 1, 2, 3}}),
                   dent) == 2);
}

TEST_CASE("a glTF file has the chunks and accessors that its JSON describes") {
  const Result<Encoded_mesh> encoded = encode_mesh(samples::cube(), Mesh_format::glb);
  REQUIRE(encoded);
  const std::string& bytes = encoded->bytes;
  CHECK(bytes.substr(0, 4) == "glTF");
  CHECK(number_at(bytes, 4) == 2);
  CHECK(number_at(bytes, 8) == bytes.size());
  const std::size_t length = number_at(bytes, 12);
  CHECK(length % 4 == 0);
  CHECK(bytes.substr(16, 4) == "JSON");
  const auto json = nlohmann::json::parse(bytes.substr(20, length));
  const std::size_t binary = 20 + length;
  CHECK(number_at(bytes, binary) == 8 * 12 + 36 * 4);
  CHECK(bytes.substr(binary + 4, 4) == std::string("BIN\0", 4));
  CHECK(json["accessors"][0]["count"] == 8);
  CHECK(json["accessors"][0]["max"] == std::vector<double>{1, 1, 1});
  CHECK(json["accessors"][1]["count"] == 36);
  CHECK(json["bufferViews"][1]["byteOffset"] == 96);
  CHECK(json["buffers"][0]["byteLength"] == 240);
  CHECK(json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] == 0);
  CHECK(json["scenes"][0]["nodes"] == std::vector<int>{0});
  for (std::size_t i = 0; i < 36; ++i) CHECK(number_at(bytes, binary + 8 + 96 + 4 * i) < 8);
}

TEST_CASE("coordinates that a format cannot hold are refused, with the point") {
  Polygon_soup mesh = samples::cube();
  mesh.points[3][1] = 1e39;
  CHECK(encode_mesh(mesh, Mesh_format::off));
  CHECK(encode_mesh(mesh, Mesh_format::stl, true));
  for (Mesh_format format : {Mesh_format::stl, Mesh_format::glb}) {
    const Result<Encoded_mesh> refused = encode_mesh(mesh, format);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().index == 3);
  }
  mesh.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_FALSE(encode_mesh(mesh, Mesh_format::off));
}

TEST_CASE("meshes of every type are written under the format of the name or of the options") {
  const Empty_folder folder;
  const Quad_mesh quads{samples::cube().points,
                        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  REQUIRE(write_mesh(folder / "quads.obj", quads));
  Write_options as_ply;
  as_ply.format = Mesh_format::ply;
  as_ply.ascii = true;
  REQUIRE(write_mesh(folder / "quads.data", quads, as_ply));
  Triangle_surface surface;
  surface.points = samples::tetrahedron().points;
  surface.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  REQUIRE(write_mesh(folder / "surface.OFF", surface));
  CHECK(read_polygon_soup(folder / "quads.obj")->corner == samples::cube().corner);
  CHECK(content(folder / "quads.data").substr(0, 17) == "ply\nformat ascii ");
  CHECK(read_polygon_soup(folder / "quads.data")->corner == samples::cube().corner);
  CHECK(read_polygon_soup(folder / "surface.OFF")->corner == samples::tetrahedron().corner);
  const auto unknown = write_mesh(folder / "quads.xyz", quads);
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().code == Error_code::unsupported_format);
  CHECK(folder.number_of_files() == 3);
}

TEST_CASE("a file that cannot be written leaves the old one and nothing else") {
  const Empty_folder folder;
  const std::string path = folder / "a.off";
  REQUIRE(write_file_atomically(path, "old"));
  // The system refuses to let a file grow beyond 1000 bytes, as a full disk would.
  struct rlimit limit;
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &limit) == 0);
  struct rlimit small = limit;
  small.rlim_cur = 1000;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  const Result<void> refused = write_file_atomically(path, std::string(2000, 'x'));
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
  std::signal(SIGXFSZ, old_handler);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == Error_code::unwritable_file);
  CHECK(content(path) == "old");
  CHECK(folder.number_of_files() == 1);
}

TEST_CASE("a new file replaces the old one, keeps its permissions and goes through a link") {
  const Empty_folder folder;
  const std::string path = folder / "a.off", link = folder / "link.off";
  REQUIRE(write_file_atomically(path, "old"));
  REQUIRE(::chmod(path.c_str(), 0640) == 0);
  fs::create_symlink("a.off", link);
  REQUIRE(write_file_atomically(link, "new"));
  CHECK(content(path) == "new");
  CHECK(fs::is_symlink(link));
  struct stat status;
  REQUIRE(::stat(path.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777) == 0640);
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("folders, devices and missing folders cannot be written") {
  const Empty_folder folder;
  for (const auto& [path, says] :
       {std::pair(folder.path.string(), "folder"), std::pair(std::string("/dev/null"), "regular"),
        std::pair(folder / "missing/a.off", "No such file"), std::pair(std::string(), "No such file")}) {
    const Result<void> refused = write_file_atomically(path, "x");
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == Error_code::unwritable_file);
    CHECK(refused.error().message.find(says) != std::string::npos);
  }
  CHECK(folder.number_of_files() == 0);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a name as long as names can be, and one in the current folder, are written") {
  const Empty_folder folder;
  REQUIRE(write_file_atomically(folder / std::string(255, 'n'), "x"));
  const fs::path before = fs::current_path();
  fs::current_path(folder.path);
  CHECK(write_file_atomically("here.off", "x"));
  fs::current_path(before);
  CHECK(content(folder / "here.off") == "x");
  CHECK(folder.number_of_files() == 2);
}
