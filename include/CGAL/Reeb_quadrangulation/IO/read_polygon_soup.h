// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_READ_POLYGON_SOUP_H
#define CGAL_REEB_QUADRANGULATION_IO_READ_POLYGON_SOUP_H

#include <CGAL/Reeb_quadrangulation/IO/mesh_format.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Reads a mesh file: OFF (also with colours, normals or texture coordinates, which are skipped; ascii), OBJ,
/// PLY (ascii and both binaries; polygons and triangle strips) or STL (ascii and binary).
///
/// The content decides about the format; the extension is asked only where the content does not tell. Errors
/// name the line (text) or the byte (binary) where the file contradicts its format: `unreadable_file`
/// (missing, a folder, not a regular file, larger than `maximum_bytes`), `unsupported_format` (compressed, or
/// a variant we do not read), `malformed_file`.
///
/// The readers are made for files from strangers: every announced count is compared with the bytes that are
/// left before memory is taken, and every index with the number of points. Memory is at most about ten times
/// the file and time is linear in it. Coordinates that are NaN or infinite (also by overflow, as 1e999) are
/// kept, so that `check_surface()` can list them. Equal points of an STL file, which has no indices, become
/// one point.
Result<Polygon_soup> read_polygon_soup(const std::string& path, std::uint64_t maximum_bytes = std::uint64_t(4)
                                                                                              << 30);

/// The same for `size` bytes at `data`; `format` is what is tried where the content does not tell.
Result<Polygon_soup> parse_polygon_soup(const char* data, std::size_t size,
                                        Mesh_format format = Mesh_format::automatic);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_READ_POLYGON_SOUP_H
