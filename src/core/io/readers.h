// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the single formats; the doors to them are in IO/read_polygon_soup.h.
#ifndef REEBQUAD_IO_READERS_H
#define REEBQUAD_IO_READERS_H

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The largest number of points, polygons or corners: indices are of type `int`.
constexpr std::int64_t largest_count = std::numeric_limits<int>::max() - 1;

/// What a reader passed over, as sentences.
using Notes = std::vector<std::string>;

/// Adds a word to `attributes->others`, once.
inline void note_other(Mesh_attributes* attributes, const std::string& word) {
  if (!attributes) return;
  for (const std::string& known : attributes->others)
    if (known == word) return;
  attributes->others.push_back(word);
}

/// `attributes` may be null: then they are not kept.
Result<Polygon_soup> parse_off(const char* data, std::size_t size, Notes& notes, Mesh_attributes* attributes);
Result<Polygon_soup> parse_obj(const char* data, std::size_t size, Notes& notes, Mesh_attributes* attributes);
Result<Polygon_soup> parse_ply(const char* data, std::size_t size, Mesh_attributes* attributes);
Result<Polygon_soup> parse_stl(const char* data, std::size_t size, Notes& notes);
Result<Polygon_soup> parse_gltf(const char* data, std::size_t size, Notes& notes,
                                Mesh_attributes* attributes);

/// What Assimp makes of a file of one of `other_mesh_formats()`; `extension` without the dot, in small
/// letters.
Result<Polygon_soup> parse_by_assimp(const char* data, std::size_t size, const std::string& extension,
                                     Notes& notes);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_IO_READERS_H
