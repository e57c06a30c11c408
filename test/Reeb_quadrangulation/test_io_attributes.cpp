// SPDX-License-Identifier: GPL-3.0-or-later
// What files tell beside the surface: read, written, carried over, and named where it is dropped.
#include "mesh_samples.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/transfer_mesh_attributes.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Read {
  Polygon_soup soup;
  Mesh_attributes attributes;
};

Read read(const std::string& bytes, Mesh_format format = Mesh_format::automatic) {
  Read result;
  Result<Polygon_soup> soup =
      parse_polygon_soup(bytes.data(), bytes.size(), format, nullptr, &result.attributes);
  REQUIRE(soup);
  result.soup = std::move(*soup);
  return result;
}

std::string written(const Polygon_soup& mesh, const Mesh_attributes& attributes, Mesh_format format,
                    bool ascii = false) {
  const Result<Encoded_mesh> encoded = encode_mesh(mesh, attributes, format, ascii);
  REQUIRE(encoded);
  return encoded->bytes;
}

/// Of the cube: coordinates that differ at each corner, colours, materials of which one side has none, two
/// groups.
Mesh_attributes of_cube(const Polygon_soup& cube) {
  Mesh_attributes attributes;
  for (std::size_t c = 0; c < cube.corner.size(); ++c) attributes.uv.push_back({c / 32.0, 1 - c / 64.0});
  for (const Point& p : cube.points) attributes.colours.push_back(p);
  attributes.labels = {{"group", {"low", "high"}, {0, 0, 0, 1, 1, 1}},
                       {"material", {"brick", "glass"}, {0, 1, 0, 1, 0, -1}}};
  return attributes;
}

/// Squares [i, i + 1] x [j, j + 1] in the plane.
Polygon_soup grid(int columns, int rows) {
  Polygon_soup soup;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) soup.points.push_back(Point(i, j, 0));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int v = j * (columns + 1) + i;
      for (const int corner : {v, v + 1, v + columns + 2, v + columns + 1}) soup.corner.push_back(corner);
      soup.close_polygon();
    }
  return soup;
}

/// The number of lines of the text that begin so.
int lines_with(const std::string& text, const std::string& begin) {
  int n = text.rfind(begin, 0) == 0;
  for (std::size_t at = 0; (at = text.find('\n' + begin, at)) != std::string::npos; ++at) ++n;
  return n;
}

} // namespace

TEST_CASE("attributes that are written as OBJ and PLY read back") {
  const Polygon_soup cube = samples::cube();
  const Mesh_attributes attributes = of_cube(cube);
  for (const auto& [format, ascii] : {std::pair(Mesh_format::obj, false), std::pair(Mesh_format::ply, false),
                                      std::pair(Mesh_format::ply, true)}) {
    const Read back = read(written(cube, attributes, format, ascii));
    CHECK(back.soup.points == cube.points);
    CHECK(back.soup.corner == cube.corner);
    CHECK(back.attributes.uv == attributes.uv); // sums of powers of two, exact in single precision
    CHECK(back.attributes.colours == attributes.colours);
    CHECK(back.attributes.others.empty());
    REQUIRE(back.attributes.labels.size() == 2);
    for (std::size_t l = 0; l < 2; ++l) {
      const Face_labels &now = back.attributes.labels[l], &before = attributes.labels[l];
      CHECK(now.kind == before.kind);
      for (std::size_t p = 0; p < 6; ++p) {
        const int label = now.label[p];
        const std::string name = label < 0 ? "none" : now.names[std::size_t(label)];
        CHECK(name == (before.label[p] < 0 ? "none" : before.names[std::size_t(before.label[p])]));
      }
    }
  }
}

TEST_CASE("a mesh without attributes has the bytes it always had") {
  const Polygon_soup cube = samples::cube();
  CHECK(written(samples::tetrahedron(), {}, Mesh_format::obj) ==
        encode_mesh(samples::tetrahedron(), Mesh_format::obj)->bytes);
  CHECK(lines_with(written(cube, {}, Mesh_format::obj), "f ") == 6);
  CHECK(written(cube, {}, Mesh_format::obj).find_first_of("/gou") == std::string::npos);
}

TEST_CASE("what an OBJ tells is kept as it is meant") {
  const std::string obj =
      "mtllib a b.mtl\no body\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 0 1\nv 1 1 0\nvt 0 0\nvt 1 0\n"
      "vn 0 0 1\ns 1\nf 1/1//1 2/2 3/-1\n";
  const Read a = read(obj.substr(0, obj.find("f 1")) + "f 1/1/1 2/2/1 3/-1/1\nusemtl x y\nf 2/9 4 3/1\n");
  CHECK(a.attributes.material_library == "a b.mtl");
  CHECK(a.attributes.others == std::vector<std::string>{"normals", "smoothing groups"});
  CHECK(a.attributes.colours[1] == Eigen::Vector3d(1, 1, 1)); // without a colour among points with one: white
  CHECK(a.attributes.colours[2] == Eigen::Vector3d(0, 0, 1));
  REQUIRE(a.attributes.uv.size() == 6);
  CHECK(a.attributes.uv[2] == Eigen::Vector2d(1, 0));
  CHECK_FALSE(a.attributes.uv[3].allFinite()); // does not exist
  CHECK_FALSE(a.attributes.uv[4].allFinite());
  REQUIRE(a.attributes.labels.size() == 2);
  CHECK(a.attributes.labels[0].label == std::vector<int>{0, 0});
  CHECK(a.attributes.labels[1].label == std::vector<int>{-1, 0});
  CHECK(a.attributes.labels[1].names == std::vector<std::string>{"x y"});
}

TEST_CASE("what a reader does not keep is named") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float quality\nelement face 1\nproperty list uchar int "
      "vertex_indices\nproperty float weight\nelement range 1\nproperty int a\nend_header\n"
      "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n3 0 1 2 7\n5\n";
  CHECK(read(ply).attributes.others == std::vector<std::string>{"normals", "the property quality of points",
                                                                "the property weight of faces",
                                                                "elements range"});
  CHECK(read("CNOFF\n3 1 0\n0 0 0 1 1 1 1 0 0 1\n1 0 0 1 1 1 1 0 0 1\n0 1 0 1 1 1 1 0 0 1\n3 0 1 2\n")
            .attributes.others == std::vector<std::string>{"colours", "normals"});
}

TEST_CASE("what a format does not hold is named, and nothing else") {
  const Polygon_soup cube = samples::cube();
  Mesh_attributes attributes = of_cube(cube);
  attributes.others = {"normals"};
  const std::vector<std::pair<Mesh_format, std::vector<std::string>>> expected{
      {Mesh_format::obj, {"normals"}},
      {Mesh_format::ply, {"normals"}},
      {Mesh_format::glb, {"groups", "normals"}},
      {Mesh_format::vtu, {"texture coordinates", "normals"}},
      {Mesh_format::inp, {"texture coordinates", "colours", "normals"}},
      {Mesh_format::msh, {"texture coordinates", "colours", "normals"}},
      {Mesh_format::off, {"texture coordinates", "colours", "groups", "materials", "normals"}},
      {Mesh_format::stl, {"texture coordinates", "colours", "groups", "materials", "normals"}}};
  for (const auto& [format, words] : expected) {
    const Result<Encoded_mesh> encoded = encode_mesh(cube, attributes, format);
    REQUIRE(encoded);
    INFO(name(format));
    CHECK(encoded->dropped == words);
  }
}

TEST_CASE("Abaqus' input has each node and element once, and a set of elements for each name") {
  const std::string inp = written(samples::cube(), of_cube(samples::cube()), Mesh_format::inp);
  CHECK(inp.find("*ELEMENT, TYPE=S4") != std::string::npos);
  CHECK(inp.find("TYPE=S3") == std::string::npos);
  CHECK(inp.find("*ELSET, ELSET=MATERIAL_BRICK\n1, 3, 5\n") != std::string::npos);
  CHECK(inp.find("*ELSET, ELSET=GROUP_HIGH\n4, 5, 6\n") != std::string::npos);
  CHECK(lines_with(inp, "*ELSET") == 4);
  Polygon_soup pentagon; // no element of Abaqus has five corners
  for (int i = 0; i < 5; ++i) pentagon.points.push_back(Point(std::cos(i * 1.2566), std::sin(i * 1.2566), 0));
  pentagon.corner = {0, 1, 2, 3, 4};
  pentagon.close_polygon();
  const Result<Encoded_mesh> divided = encode_mesh(pentagon, Mesh_format::inp);
  REQUIRE(divided);
  CHECK(divided->warnings.size() == 1);
  CHECK(divided->bytes.find("TYPE=S3, ELSET=S3_ALL\n1, 1, 2, 3\n2, 1, 3, 4\n3, 1, 4, 5\n") !=
        std::string::npos);
}

TEST_CASE("a file of Gmsh has a surface for each set of names, with a physical group for each name") {
  const std::string msh = written(samples::cube(), of_cube(samples::cube()), Mesh_format::msh);
  CHECK(msh.rfind("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n2 1 \"group_low\"\n", 0) == 0);
  // {low, brick}, {low, glass}, {high, brick}, {high, glass}, {high}
  CHECK(msh.find("$Entities\n0 0 5 0\n") != std::string::npos);
  CHECK(msh.find("$Elements\n5 6 1 6\n") != std::string::npos);
  CHECK(lines_with(msh, "2 1 3 2") == 1); // two quads of the first surface
}

TEST_CASE("VTK's XML has cells of the kinds that the polygons are") {
  Polygon_soup mesh = samples::cube();
  for (const int v : {0, 1, 2}) mesh.corner.push_back(v);
  mesh.close_polygon();
  const std::string vtu = written(mesh, {}, Mesh_format::vtu);
  CHECK(vtu.find("NumberOfPoints=\"8\" NumberOfCells=\"7\"") != std::string::npos);
  CHECK(vtu.find("\n9 9 9 9 9 9 5 \n") != std::string::npos);
  CHECK(vtu.find("\n4 8 12 16 20 24 27 \n") != std::string::npos);
}

TEST_CASE("glTF doubles points at seams, and has a primitive for each material") {
  const Polygon_soup cube = samples::cube();
  const std::string glb = written(cube, of_cube(cube), Mesh_format::glb);
  std::uint32_t size = 0;
  for (std::size_t i = 0; i < 4; ++i)
    size |= std::uint32_t(static_cast<unsigned char>(glb[12 + i])) << (8 * i);
  const nlohmann::json json = nlohmann::json::parse(glb.substr(20, size));
  const nlohmann::json primitives = json.at("meshes").at(0).at("primitives");
  REQUIRE(primitives.size() == 3); // without material, brick, glass
  CHECK(json.at("materials").size() == 2);
  int corners = 0;
  for (const nlohmann::json& primitive : primitives) {
    corners += json.at("accessors").at(primitive.at("indices").get<std::size_t>()).at("count").get<int>();
    for (const char* attribute : {"POSITION", "TEXCOORD_0", "COLOR_0"})
      CHECK(
          json.at("accessors").at(primitive.at("attributes").at(attribute).get<std::size_t>()).at("count") ==
          24);
  }
  CHECK(corners == 36);
  CHECK(read(glb).soup.number_of_polygons() == 12);
}

TEST_CASE("a mesh that is carried over to itself keeps its attributes") {
  const Polygon_soup mesh = grid(4, 3);
  Mesh_attributes attributes;
  for (const int v : mesh.corner) attributes.uv.push_back(mesh.points[std::size_t(v)].head<2>() / 4);
  for (const Point& p : mesh.points) attributes.colours.push_back(p / 4);
  attributes.labels = {{"material", {"a", "b"}, {0, 0, 1, 1, 0, 0, 1, 1, -1, -1, -1, -1}}};
  const Mesh_attributes carried = transfer_mesh_attributes(mesh, attributes, mesh);
  REQUIRE(carried.uv.size() == attributes.uv.size());
  for (std::size_t c = 0; c < carried.uv.size(); ++c)
    CHECK((carried.uv[c] - attributes.uv[c]).norm() < 1e-12);
  for (std::size_t v = 0; v < carried.colours.size(); ++v)
    CHECK((carried.colours[v] - attributes.colours[v]).norm() < 1e-12);
  CHECK(carried.labels[0].label == attributes.labels[0].label);
}

TEST_CASE("a linear map is carried over exactly to any other polygons, also with its own resolution") {
  const Polygon_soup from = grid(8, 8);
  Mesh_attributes attributes;
  const auto map = [](const Point& p) { return Eigen::Vector2d(p.x() + 2 * p.y(), 3 * p.y() - p.x()); };
  for (const int v : from.corner) attributes.uv.push_back(map(from.points[std::size_t(v)]));
  Polygon_soup to = grid(3, 3);
  for (Point& p : to.points) p *= 8.0 / 3;
  const Mesh_attributes carried = transfer_mesh_attributes(from, attributes, to);
  for (std::size_t c = 0; c < to.corner.size(); ++c)
    CHECK((carried.uv[c] - map(to.points[std::size_t(to.corner[c])])).norm() < 1e-12);
}

TEST_CASE("texture coordinates are not torn where a seam lies in a polygon") {
  // Two halves of a strip with islands far from each other, and polygons of which the middle ones step over
  // the seam.
  const Polygon_soup from = grid(6, 1);
  Mesh_attributes attributes;
  for (int p = 0; p < from.number_of_polygons(); ++p)
    for (int c = from.begin[p]; c < from.begin[p + 1]; ++c)
      attributes.uv.push_back(from.points[std::size_t(from.corner[std::size_t(c)])].head<2>() / 10 +
                              Eigen::Vector2d(p < 3 ? 0 : 50, 0));
  Polygon_soup to = grid(4, 1);
  for (Point& p : to.points) p.x() *= 1.4;
  const Mesh_attributes carried = transfer_mesh_attributes(from, attributes, to);
  for (int p = 0; p < to.number_of_polygons(); ++p) {
    const Eigen::Vector2d& first = carried.uv[std::size_t(to.begin[p])];
    for (int c = to.begin[p]; c < to.begin[p + 1]; ++c)
      CHECK((carried.uv[std::size_t(c)] - first).norm() < 0.2);
  }
}

TEST_CASE("a polygon gets the name that most of it lies on") {
  const Polygon_soup from = grid(10, 1);
  Mesh_attributes attributes;
  attributes.labels = {{"group", {"left", "right"}, {0, 0, 0, 0, 1, 1, 1, 1, 1, 1}}};
  Polygon_soup to = grid(2, 1);
  for (Point& p : to.points) p.x() *= 5;
  CHECK(transfer_mesh_attributes(from, attributes, to).labels[0].label == std::vector<int>{0, 1});
}

TEST_CASE("points that are not finite carry nothing over, and do no harm") {
  Polygon_soup from = grid(2, 1);
  from.points[0] = Point(std::nan(""), 0, 0);
  Mesh_attributes attributes;
  attributes.labels = {{"group", {"left", "right"}, {0, 1}}};
  CHECK(transfer_mesh_attributes(from, attributes, grid(2, 1)).labels[0].label == std::vector<int>{1, 1});
  for (Point& p : from.points) p = Point(std::nan(""), 0, 0);
  CHECK(transfer_mesh_attributes(from, attributes, grid(2, 1)).empty());
}
