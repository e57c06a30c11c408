// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_MESH_ATTRIBUTES_H
#define CGAL_REEB_QUADRANGULATION_IO_MESH_ATTRIBUTES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Names that polygons have.
struct Face_labels {
  std::string kind; ///< "object", "group", "material" or "chart"
  std::vector<std::string> names;
  std::vector<int> label; ///< of each polygon an index into `names`, or -1
};

/// What a mesh file tells beside points and polygons. What is empty is not given.
struct Mesh_attributes {
  /// Texture coordinates of each corner, v upwards; not finite where a corner has none.
  std::vector<Eigen::Vector2d> uv;
  std::vector<Eigen::Vector3d> colours; ///< red, green, blue of each point, 0 to 1
  std::vector<Face_labels> labels;      ///< at most one of each kind
  /// The property `size` of each point, else `quality` (PLY); for who asks for it, carried over to nothing.
  std::vector<double> sizes;
  std::string material_library; ///< the file that describes the materials (OBJ)
  /// What the file has and what has no place here, as words for people: "normals".
  std::vector<std::string> others;

  /// Whether there is something to carry over.
  bool empty() const { return uv.empty() && colours.empty() && labels.empty(); }
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_MESH_ATTRIBUTES_H
