// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: a named parameter that this function does not read
// A named parameter that a function does not read, in a chain that begins with one of CGAL's.
#include <CGAL/Reeb_quadrangulation/combine_parameters.h>
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace RQ = CGAL::Reeb_quadrangulation;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

bool is_surface(const Mesh& mesh) {
  const auto chain = RQ::parameters::combine(CGAL::parameters::vertex_point_map(mesh.points()))
#ifdef REEBQUAD_LEAVE_OUT
                         .number_of_quads(7)
#endif
                         .geom_traits(Kernel());
  return bool(RQ::to_triangle_surface(mesh, chain));
}
