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

/// A binary PLY with what other programs add: an unknown element in front, a colour and a list at the points, a
/// quality at the faces; coordinates are doubles, indices unsigned shorts.
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
          binary_stl(tetrahedron())};
}

} // namespace samples

#endif // REEBQUAD_TEST_MESH_SAMPLES_H
