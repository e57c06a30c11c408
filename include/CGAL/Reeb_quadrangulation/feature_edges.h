// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_FEATURE_EDGES_H
#define CGAL_REEB_QUADRANGULATION_FEATURE_EDGES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A run of feature edges between two corners, or a closed run without a corner.
struct Feature_chain {
  std::vector<int> halfedges; ///< in order: the target of each is the source of the next
  bool closed = false;
  bool boundary = false; ///< of boundary halfedges (the face on the left); otherwise of sharp edges
};

/// Sharp edges and boundary edges of a surface, cut into chains at the corners.
struct Feature_edges {
  std::vector<Feature_chain> chains; ///< ordered by their smallest halfedge
  std::vector<int> corners;          ///< vertices, ascending
};

/// Finds the interior edges whose two faces meet at an angle of more than `dihedral_angle` degrees between
/// their normals (0 is flat), and all boundary edges. With `dihedral_angle <= 0` only boundary edges are
/// features. A corner is a vertex where other than two features end, where a sharp edge meets the boundary,
/// or where the feature turns by more than `corner_angle` degrees. Linear time. \pre `surface` is connected
/// by `connect()`.
Feature_edges feature_edges(const Triangle_surface& surface, double dihedral_angle, double corner_angle = 50);

/// The same with the sharp edges at hand: `sharp` has an entry a halfedge, the same for both of an edge.
Feature_edges feature_edges(const Triangle_surface& surface, std::vector<char> sharp,
                            double corner_angle = 50);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_FEATURE_EDGES_H
