// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SURFACE_SHAPES_DRAFT_H
#define REEBQUAD_SURFACE_SHAPES_DRAFT_H

#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace shapes {

/// Moves a point near the surface onto it.
using Projection = std::function<Point(const Point&)>;

/// A first triangulation of a shape: right topology, any quality. Creases are edges that remeshing must keep.
struct Draft {
  Triangle_surface surface;
  std::vector<std::pair<int, int>> creases;
};

/// A closed surface as the zero set of a function that is negative inside.
struct Implicit_surface {
  std::function<double(const Point&, Point& gradient)> value;
  Point low, high;     ///< a box that holds the surface
  double feature_size; ///< a length below the thickness of every part
};

/// A fixed pseudo-random sequence (Vigna's SplitMix64), the same on every machine.
class Random_sequence {
public:
  /// Uniform in [-1, 1).
  double next() {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
  }

private:
  std::uint64_t m_state = 20111;
};

/// Newton's iteration along the gradient.
Projection projection(const Implicit_surface& shape);

/// Marching tetrahedra on a shaken cubic grid of the given spacing.
Draft polygonize(const Implicit_surface& shape, double spacing);

/// The boundary of a union of unit cubes (given by their lowest corners), every square cut into m x m cells
/// of two triangles; the cells are shaken inside their planes, and the edges between different planes are
/// creases.
Draft cube_complex(const std::vector<std::array<int, 3>>& cubes, int m);

/// An open cylinder of radius 1 about the z-axis with m segments around, `rings` segments along its height;
/// its two boundary loops are creases.
Draft open_cylinder(double height, int m, int rings);

/// Four triangles for each, new vertices at midpoints, then projected.
Triangle_surface quadrisect(const Triangle_surface& surface, const Projection& project);

/// Remeshes a draft towards the edge length under projection; keeps creases. The result is connected.
Triangle_surface remesh(const Draft& draft, double edge_length, const Projection& project);

} // namespace shapes
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_SHAPES_DRAFT_H
