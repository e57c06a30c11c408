// SPDX-License-Identifier: GPL-3.0-or-later
// What the writers of the single formats share; the doors to them are in IO/write_mesh.h.
#ifndef REEBQUAD_IO_WRITERS_H
#define REEBQUAD_IO_WRITERS_H

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Appends the bytes of a number, the lowest first, on every machine.
template <class T> void append_little_endian(std::string& out, T value) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(T) == sizeof(Bits));
  Bits bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (std::size_t i = 0; i < sizeof bits; ++i) out += char(static_cast<unsigned char>(bits >> (8 * i)));
}

/// Appends a number with the fewest digits that read back to the same.
template <class T> void append_number(std::string& out, T x) {
  static_assert(std::is_arithmetic_v<T>);
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, x).ptr);
}

/// Appends three numbers with spaces between.
void append_point(std::string& out, const Point& p);

/// The polygons divided into triangles: quads by `first_corner_of_cut()`, others as fans from their first
/// corner. The triangles are of indices into `mesh.corner`; `polygon`, unless it is null, gets the polygon
/// of each.
std::vector<Triangle> corner_triangles_of(const Polygon_soup& mesh, std::vector<int>* polygon = nullptr);

/// The same triangles, of points.
std::vector<Triangle> triangles_of(const Polygon_soup& mesh);

/// The names of kind `kind`; null if polygons have none.
const Face_labels* labels_of(const Mesh_attributes& attributes, const std::string& kind);

/// A name without what ends lines or words: other characters than letters, digits and ._- become '_'. Not
/// empty.
std::string word_of(const std::string& name);

/// \name Formats
/// What a format cannot hold of the attributes is left out.
/// @{
std::string encode_obj(const Polygon_soup& mesh, const Mesh_attributes& attributes);
std::string encode_ply(const Polygon_soup& mesh, const Mesh_attributes& attributes, bool ascii);
/// Binary glTF 2.0 with one mesh, one primitive for each material; coordinates fit into single precision.
std::string encode_glb(const Polygon_soup& mesh, const Mesh_attributes& attributes);
/// VTK's XML, an unstructured grid.
std::string encode_vtu(const Polygon_soup& mesh, const Mesh_attributes& attributes);
/// Abaqus' input: elements S4 and S3, a set of elements for each name. \pre no polygon has more than four
/// corners
std::string encode_inp(const Polygon_soup& mesh, const Mesh_attributes& attributes);
/// Gmsh's format 4.1 as text: a physical group for each name. \pre no polygon has more than four corners
std::string encode_msh(const Polygon_soup& mesh, const Mesh_attributes& attributes);
/// @}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_IO_WRITERS_H
