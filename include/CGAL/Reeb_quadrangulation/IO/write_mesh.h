// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_WRITE_MESH_H
#define CGAL_REEB_QUADRANGULATION_IO_WRITE_MESH_H

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/mesh_format.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

struct Write_options {
  Mesh_format format = Mesh_format::automatic; ///< `automatic`: by the extension of the file
  bool ascii = false;  ///< PLY and STL as text; they are binary (little endian) otherwise
  std::string comment; ///< one line for people; OBJ, OFF and PLY hold it
  const Mesh_attributes* attributes = nullptr; ///< what else is written, as far as the format holds it
  std::vector<std::string>* dropped = nullptr; ///< gets what the format does not hold of these
};

/// The bytes of a mesh file, and what its format could not hold.
struct Encoded_mesh {
  std::string bytes;
  std::vector<std::string> warnings; ///< sentences for people
  std::vector<std::string>
      dropped; ///< attributes that the format does not hold, as words for people: "colours"
};

/// Encodes a mesh as OBJ, OFF, PLY, VTK legacy, VTK XML (.vtu), Abaqus' input (.inp), Gmsh's format 4.1
/// (.msh), STL or binary glTF
/// (.glb); text has coordinates with the fewest digits that read back to the same double. STL and glTF hold
/// triangles only, and coordinates of single precision (ascii STL: double); .inp and .msh hold no polygons of
/// more than four corners. Larger faces are divided, quads at their first diagonal, or if a half would be
/// turned over at the other one, and a warning says so.
///
/// Errors: `unsupported_format` for `Mesh_format::automatic`; `impossible_request` if a coordinate is not
/// finite or beyond what the format holds. OBJ, OFF and PLY hold the comment. \pre every corner is an index
/// of a point; the comment is one line. O(size).
Result<Encoded_mesh> encode_mesh(const Polygon_soup& mesh, Mesh_format format, bool ascii = false,
                                 const std::string& comment = {});

/// The same with attributes:
///
/// | format | texture coordinates | colours | names of faces |
/// |--|--|--|--|
/// | OBJ | `vt` | behind the point | `o`; groups and charts as `g`; `usemtl` |
/// | PLY | list `texcoord` of the face | `red green blue` | numbers of the face, explained by comments |
/// | glTF | `TEXCOORD_0`; points at seams are doubled | `COLOR_0` | materials, a primitive each |
/// | VTU | no | an array of the points | an array of numbers of the cells for each kind |
/// | INP | no | no | a set of elements for each name |
/// | MSH | no | no | a physical group for each name |
/// | OFF, VTK, STL | no | no | no |
///
/// What is not held is named in `dropped`. \pre the arrays that are given have the sizes that
/// `Mesh_attributes` tells.
Result<Encoded_mesh> encode_mesh(const Polygon_soup& mesh, const Mesh_attributes& attributes,
                                 Mesh_format format, bool ascii = false, const std::string& comment = {});

/// Encodes a mesh and writes it whole or not at all, see `write_file_atomically()`; the warnings of
/// `encode_mesh()`.
Result<std::vector<std::string>> write_mesh(const std::string& path, const Polygon_soup& mesh,
                                            const Write_options& options = {});
Result<std::vector<std::string>> write_mesh(const std::string& path, const Quad_mesh& mesh,
                                            const Write_options& options = {});
Result<std::vector<std::string>> write_mesh(const std::string& path, const Triangle_surface& surface,
                                            const Write_options& options = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_WRITE_MESH_H
