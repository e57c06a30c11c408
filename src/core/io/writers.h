// SPDX-License-Identifier: GPL-3.0-or-later
// What the writers of the single formats share; the doors to them are in IO/write_mesh.h.
#ifndef REEBQUAD_IO_WRITERS_H
#define REEBQUAD_IO_WRITERS_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

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

/// The polygons divided into triangles: quads by `first_corner_of_cut()`, others as fans from their first corner.
std::vector<Triangle> triangles_of(const Polygon_soup& mesh);

/// Binary glTF 2.0 with one mesh; coordinates fit into single precision.
std::string encode_glb(const Polygon_soup& mesh);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_IO_WRITERS_H
