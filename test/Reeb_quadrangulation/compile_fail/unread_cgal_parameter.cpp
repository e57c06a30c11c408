// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: a named parameter that this function does not read
// A parameter of CGAL's own that a function does not read.
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace RQ = CGAL::Reeb_quadrangulation;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

bool is_surface(const Mesh& mesh) {
#ifdef REEBQUAD_LEAVE_OUT
  const auto chain = CGAL::parameters::vertex_point_map(mesh.points()).number_of_iterations(3);
#else
  const auto chain = CGAL::parameters::vertex_point_map(mesh.points());
#endif
  return bool(RQ::to_triangle_surface(mesh, chain));
}
