// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/shapes_draft.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace shapes {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// What CGAL's remeshing calls for every vertex it has made or moved.
struct Vertex_projection {
  const Mesh* mesh;
  const Projection* project;

  Kernel::Point_3 operator()(Mesh::Vertex_index v) const {
    const Kernel::Point_3& p = mesh->point(v);
    const Point q = (*project)(Point(p.x(), p.y(), p.z()));
    return Kernel::Point_3(q.x(), q.y(), q.z());
  }
};

} // namespace

Triangle_surface remesh(const Draft& draft, double edge_length, const Projection& project) {
  Mesh mesh;
  for (const Point& p : draft.surface.points) mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  using Index = Mesh::Vertex_index;
  for (const Triangle& t : draft.surface.triangles) mesh.add_face(Index(t[0]), Index(t[1]), Index(t[2]));
  auto crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
  for (const auto& [a, b] : draft.creases) crease[mesh.edge(mesh.halfedge(Index(a), Index(b)))] = true;
  // With a projection of our own, CGAL finds the patches between creases by itself only where its
  // preconditions are compiled in; given explicitly, every build remeshes alike.
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  namespace Pmp = CGAL::Polygon_mesh_processing;
  Pmp::connected_components(mesh, patch, CGAL::parameters::edge_is_constrained_map(crease));

  Pmp::isotropic_remeshing(faces(mesh), edge_length, mesh,
                           CGAL::parameters::number_of_iterations(6)
                               .number_of_relaxation_steps(2)
                               .edge_is_constrained_map(crease)
                               .face_patch_map(patch)
                               .protect_constraints(true)
                               .projection_functor(Vertex_projection{&mesh, &project}));

  mesh.collect_garbage();
  Triangle_surface result;
  for (Index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    result.points.push_back(project(Point(p.x(), p.y(), p.z())));
  }
  for (auto f : mesh.faces()) {
    Triangle t{};
    int i = 0;
    for (Index v : vertices_around_face(mesh.halfedge(f), mesh)) t[i++] = int(v);
    result.triangles.push_back(t);
  }
  return result;
}

} // namespace shapes
} // namespace Reeb_quadrangulation
} // namespace CGAL
