// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_READ_POLYGON_SOUP_H
#define CGAL_REEB_QUADRANGULATION_IO_READ_POLYGON_SOUP_H

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/mesh_format.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The largest file that `read_polygon_soup()` reads if it is not told otherwise.
constexpr std::uint64_t largest_mesh_file = std::uint64_t(4) << 30;

/// Reads a mesh file: OFF (also with colours, normals or texture coordinates, which are skipped; ascii), OBJ,
/// PLY (ascii and both binaries; polygons and triangle strips), STL (ascii and binary) or glTF 2.0 (binary,
/// and JSON with embedded buffers: meshes placed by their nodes; triangles, strips and fans). If the
/// library was built with Assimp, also 3MF, COLLADA, FBX and what else that reads; see
/// `other_mesh_formats()`.
///
/// The content decides about the format; the extension is asked only where the content does not tell. Errors
/// name the line (text) or the byte (binary) where the file contradicts its format: `unreadable_file`
/// (missing, a folder, not a regular file, larger than `maximum_bytes`), `unsupported_format` (compressed, or
/// a variant we do not read), `malformed_file`.
///
/// What does not matter for the surface is passed over and told in a sentence that is appended to `notes`,
/// unless that is null: data behind the end of an OFF, indices of texture coordinates or normals that do
/// not exist in an OBJ, a missing `endsolid`, a binary STL that announces no triangles but has some,
/// materials and animations of glTF.
///
/// `attributes`, unless it is null, gets what the file tells beside the surface: of OBJ texture coordinates,
/// colours, objects, groups and materials; of PLY colours (`red green blue`), texture coordinates (`texcoord`
/// of faces; `s t`, `u v` or `texture_u texture_v` of vertices), sizes (`size`, else `quality` of
/// vertices) and the numbers `object`, `group`, `material`
/// and `chart` of faces. What else is there, and what other formats have, is named in
/// `Mesh_attributes::others`.
///
/// The readers are made for files from strangers: every announced count is compared with the bytes that are
/// left before memory is taken, and every index with the number of points. Memory is at most about ten times
/// the file (what several nodes of a glTF share counts for each of them, to a limit) and time is linear in
/// it. Coordinates that are NaN or infinite (also by overflow, as 1e999) are kept, so that
/// `check_surface()` can list them. Equal points of an STL file, which has no indices, become one point.
Result<Polygon_soup> read_polygon_soup(const std::string& path,
                                       std::uint64_t maximum_bytes = largest_mesh_file,
                                       std::vector<std::string>* notes = nullptr,
                                       Mesh_attributes* attributes = nullptr);

/// The same for `size` bytes at `data`; `format` is what is tried where the content does not tell.
Result<Polygon_soup> parse_polygon_soup(const char* data, std::size_t size,
                                        Mesh_format format = Mesh_format::automatic,
                                        std::vector<std::string>* notes = nullptr,
                                        Mesh_attributes* attributes = nullptr);

/// The extensions that are read by Assimp ("3mf dae fbx ..."), in order; empty if the library was built
/// without it.
std::string other_mesh_formats();

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_READ_POLYGON_SOUP_H
