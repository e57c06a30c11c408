// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_MESH_FORMAT_H
#define CGAL_REEB_QUADRANGULATION_IO_MESH_FORMAT_H

#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The file formats that are read (OFF, OBJ, PLY, STL) and written (those, VTK, binary glTF, Abaqus and
/// Gmsh).
enum class Mesh_format {
  automatic, ///< when reading: by the content, then by the name; when writing: by the name
  off,
  obj,
  ply,
  stl,
  vtk,
  glb,
  vtu, ///< VTK's XML, an unstructured grid
  inp, ///< Abaqus' input
  msh  ///< Gmsh's format 4.1
};

/// The name of a format as people write it ("OFF", "OBJ", ...).
const char* name(Mesh_format format);

/// The format that the last extension of `path` stands for, upper or lower case; `automatic` if it is none we
/// know.
Mesh_format format_of_extension(const std::string& path);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_MESH_FORMAT_H
