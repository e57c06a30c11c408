// SPDX-License-Identifier: GPL-3.0-or-later
// A torus with exact points, turned by a rational rotation, and a plane through many of its vertices: sides
// and points are exact.
#include "torus.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Reeb_quadrangulation/plane_curves.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;

int main() {
  Exact_mesh mesh;
  CGAL::copy_face_graph(torus(), mesh);
  const CGAL::Aff_transformation_3<Exact> turn(2, -2, 1, 1, 2, 2, -2, -1, 2, 3); // all over 3
  CGAL::Polygon_mesh_processing::transform(turn, mesh);
  const Exact::Plane_3 plane(mesh.point(Exact_mesh::Vertex_index(0)), turn(Exact::Vector_3(0, 0, 1)));
  std::vector<RQ::Face_graph_curve<Exact_mesh, Exact::Point_3>> curves;
  const auto number = RQ::plane_curves(mesh, plane, std::back_inserter(curves));
  if (!number) return std::cerr << number.error().message << '\n', 1;
  bool right = !curves.empty();
  std::size_t crossed = 0, expected = 0;
  for (const auto& curve : curves)
    for (const auto& p : curve.points) right = right && plane.has_on(p), ++crossed;
  for (const auto e : mesh.edges())
    expected += plane.has_on_negative_side(mesh.point(mesh.vertex(e, 0))) !=
                plane.has_on_negative_side(mesh.point(mesh.vertex(e, 1)));
  std::cout << *number << " curves, " << crossed << " of " << expected << " crossings\n";
  return right && crossed == expected ? 0 : 1;
}
