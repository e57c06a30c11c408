// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_SHAPES_H
#define CGAL_REEB_QUADRANGULATION_SHAPES_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A built-in shape.
struct Shape_info {
  std::string name;        ///< what `make_shape()` takes
  std::string description; ///< one line for people
  int genus = 0;
  int boundaries = 0; ///< number of boundary loops
};

/// The built-in shapes in a fixed order. "genus-N" stands for "genus-1" to "genus-12"; its `genus` entry is
/// 0.
std::vector<Shape_info> shape_names();

/// The description of one shape; "genus-5" has its own. Fails with `impossible_request` if there is none.
Result<Shape_info> shape_info(const std::string& name);

/// A triangulation of a built-in shape with about `triangles` triangles (within 15 %), connected, oriented
/// outwards. It is irregular, as meshes from scans are, has nearly equilateral triangles, has its vertices on
/// the exact surface up to rounding, and keeps sharp edges and corners. The same call gives the same bytes.
///
/// The shapes are about one to ten units large:
/// sphere (radius 1), ellipsoid (semi-axes 1, 0.7, 2 along x, y, z), torus (radii 1 and 0.4), bitorus =
/// genus-2, genus-N (N tori of radii 1 and 0.35 in a chain, smoothly joined), hand (a palm with five
/// fingers), cube
/// ([0, 1]^3), l-shape (three unit cubes), twisted-bar (1 x 1 x 4, turned by half a turn), cylinder (radius
/// 1, height 3, both ends open). "tetrahedron" and "octahedron" are the solids themselves, whatever
/// `triangles` says.
///
/// A draft (a marching-tetrahedra mesh of an implicit function, or a box lattice) is shaken by a fixed
/// pseudo-random sequence and remeshed with CGAL's isotropic remeshing under projection on the exact surface.
/// Beyond 50,000 triangles the result is refined by midpoints, again projected. Errors: `impossible_request`
/// if there is no such shape, or `triangles` is not within [400, 4,000,000] (of genus N: from 100 N).
Result<Triangle_surface> make_shape(const std::string& name, int triangles);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_SHAPES_H
