// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files made in memory, good ones and hostile ones: shared by the tests and the fuzz drivers.
#ifndef REEBQUAD_TEST_MESH_SAMPLES_H
#define REEBQUAD_TEST_MESH_SAMPLES_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace samples {

using CGAL::Reeb_quadrangulation::Point;
using CGAL::Reeb_quadrangulation::Polygon_soup;

inline Polygon_soup soup(std::vector<Point> points, const std::vector<std::vector<int>>& polygons) {
  Polygon_soup s;
  s.points = std::move(points);
  for (const std::vector<int>& p : polygons) {
    s.corner.insert(s.corner.end(), p.begin(), p.end());
    s.close_polygon();
  }
  return s;
}

/// The unit cube with six quads, oriented outward.
inline Polygon_soup cube() {
  return soup({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 0, 1), Point(1, 0, 1),
               Point(1, 1, 1), Point(0, 1, 1)},
              {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

inline Polygon_soup tetrahedron() {
  return soup({Point(1, 1, 1), Point(-1, -1, 1), Point(-1, 1, -1), Point(1, -1, -1)},
              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// Appends the bytes of a number in the order of the file, whatever the order of the machine.
template <class T> void put(std::string& out, T value, bool big_endian = false) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof value);
  const std::uint16_t probe = 1;
  const bool machine_is_big = *reinterpret_cast<const unsigned char*>(&probe) == 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    out += char(bytes[machine_is_big == big_endian ? i : sizeof(T) - 1 - i]);
}

/// A binary glTF file: its header, a chunk of JSON and a chunk of bytes.
inline std::string binary_gltf(std::string json, std::string bytes) {
  json.append((4 - json.size() % 4) % 4, ' ');
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  std::string out = "glTF";
  put(out, std::uint32_t(2));
  put(out, std::uint32_t(28 + json.size() + bytes.size()));
  put(out, std::uint32_t(json.size()));
  out += "JSON" + json;
  put(out, std::uint32_t(bytes.size()));
  return out + std::string("BIN\0", 4) + bytes;
}

/// The tetrahedron as glTF that exporters write: two nodes under a turned and moved one place the same mesh,
/// one of them mirrored; one primitive of shorts with stride, one strip without indices.
inline std::string rich_gltf() {
  const Polygon_soup s = tetrahedron();
  std::string bytes;
  for (const Point& p : s.points) { // position and a normal, interleaved
    for (int k = 0; k < 3; ++k) put(bytes, float(p[k]));
    for (int k = 0; k < 3; ++k) put(bytes, float(0));
  }
  for (int v : s.corner) put(bytes, std::uint16_t(v));
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)})
    for (int k = 0; k < 3; ++k) put(bytes, float(p[k]));
  return binary_gltf(
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"translation":[10,0,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476],"children":[1,2]},)"
      R"({"mesh":0,"scale":[2,2,2]},{"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":3},"indices":1,"material":0},)"
      R"({"attributes":{"POSITION":2},"mode":5},{"attributes":{"POSITION":2},"mode":1}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
      R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"},)"
      R"({"bufferView":2,"componentType":5126,"count":4,"type":"VEC3"},)"
      R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":4,"type":"VEC3"}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96,"byteStride":24},)"
      R"({"buffer":0,"byteOffset":96,"byteLength":24},{"buffer":0,"byteOffset":120,"byteLength":48}],)"
      R"("buffers":[{"byteLength":168}],"materials":[{"name":"glass"}]})",
      bytes);
}

/// The tetrahedron as COLLADA.
inline std::string collada_tetrahedron() {
  std::string points, corners;
  const Polygon_soup s = tetrahedron();
  for (const Point& p : s.points)
    for (int k = 0; k < 3; ++k) points += std::to_string(p[k]) + ' ';
  for (int v : s.corner) corners += std::to_string(v) + ' ';
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">)" +
         points +
         R"(</float_array><technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>)"
         R"(<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>)"
         R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)"
         R"(<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         corners +
         R"(</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s">)"
         R"(<node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>)"
         R"(<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// A binary PLY with what other programs add: an unknown element in front, a colour and a list at the points,
/// a quality at the faces; coordinates are doubles, indices unsigned shorts.
inline std::string rich_binary_ply(const Polygon_soup& s, bool big) {
  std::string out =
      std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
      "_endian 1.0\r\ncomment made for a test\r\nelement camera 2\r\nproperty list ushort double view\r\n"
      "property char kind\r\nelement vertex " +
      std::to_string(s.points.size()) +
      "\r\nproperty uchar red\r\nproperty double x\r\nproperty list uchar int friends\r\n"
      "property double z\r\nproperty double y\r\nelement face " +
      std::to_string(s.number_of_polygons()) +
      "\r\nproperty float quality\r\nproperty list uint ushort vertex_index\r\nend_header\r\n";
  for (std::uint16_t i = 0; i < 2; ++i) {
    put(out, i, big);
    for (std::uint16_t k = 0; k < i; ++k) put(out, 0.5, big);
    put(out, 'c', big);
  }
  for (const Point& p : s.points) {
    put(out, std::uint8_t(200), big);
    put(out, p[0], big);
    put(out, std::uint8_t(2), big);
    put(out, std::int32_t(-7), big);
    put(out, std::int32_t(9), big);
    put(out, p[2], big);
    put(out, p[1], big);
  }
  for (int f = 0; f < s.number_of_polygons(); ++f) {
    put(out, 0.25f, big);
    put(out, std::uint32_t(s.size_of_polygon(f)), big);
    for (int c = s.begin[f]; c < s.begin[f + 1]; ++c) put(out, std::uint16_t(s.corner[c]), big);
  }
  return out;
}

/// A binary STL of the triangles of `s`.
inline std::string binary_stl(const Polygon_soup& s, const std::string& name = "a test") {
  std::string out = name;
  out.resize(80, '\0');
  put(out, std::uint32_t(s.number_of_polygons()));
  for (int f = 0; f < s.number_of_polygons(); ++f) {
    for (int k = 0; k < 3; ++k) put(out, 0.0f);
    for (int c = s.begin[f]; c < s.begin[f] + 3; ++c)
      for (int k = 0; k < 3; ++k) put(out, float(s.points[s.corner[c]][k]));
    put(out, std::uint16_t(0));
  }
  return out;
}

inline const char* const tetrahedron_off =
    "OFF\n# four points\n4 4 6\n1 1 1\n-1 -1 1\n-1 1 -1 # third\n1 -1 -1\n\n"
    "3 0 2 1\n3 0 1 3 255 0 0\n3 0 3 2\n3 1 2 3\n";
inline const char* const tetrahedron_coff =
    "COFF\n4 4 0\n1 1 1 255 0 0 255\n-1 -1 1 0 0 0 1\n-1 1 -1 0 0 0 1\n"
    "1 -1 -1 0 0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
inline const char* const tetrahedron_obj =
    "# a test\nmtllib a.mtl\no tet\nv 1 1 1 0.5 0.5 0.5\nv -1 -1 1\nvt 0 0\nvn 0 0 1\n"
    "f 1//1 3//1 2//1\nv -1 1 -1\nv 1 -1 \\\n -1\nusemtl m\nf -4/1/1 -3/1/1 \\\n-1/1/1\n"
    "f 1/1 4/1 3/1\ns off\nf 2 3 4\nl 1 2\n";
inline const char* const tetrahedron_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n1 1 1\n-1 -1 1\n-1 1 -1\n1 -1 -1\n"
    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
inline const char* const strip_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n1 1 1\n-1 -1 1\n-1 1 -1\n1 -1 "
    "-1\n"
    "10 0 2 1 3 -1 0 3 2 2 -1\n";
inline const char* const triangle_stl =
    "solid a name with facet in it\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n"
    "   vertex 1 0 0\n   vertex 0 1e0 0\n  endloop\n endfacet\n"
    "FACET NORMAL 0 0 1 OUTER LOOP VERTEX 1 0 0 VERTEX 1 1 0 VERTEX 0 1 0 ENDLOOP ENDFACET\n"
    "endsolid a name\n";

/// Good files, one of each kind: the seeds of mutations.
inline std::vector<std::string> good_files() {
  return {tetrahedron_off,
          tetrahedron_coff,
          tetrahedron_obj,
          tetrahedron_ply,
          strip_ply,
          triangle_stl,
          rich_binary_ply(cube(), false),
          rich_binary_ply(cube(), true),
          binary_stl(tetrahedron()),
          rich_gltf()};
}

} // namespace samples

#endif // REEBQUAD_TEST_MESH_SAMPLES_H
