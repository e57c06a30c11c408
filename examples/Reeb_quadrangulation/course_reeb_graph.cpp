// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph of a height function on a surface of genus 2, and the parts of the surface that are its
// arcs: course_reeb_graph [FOLDER OF THE PICTURE].
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/Reeb_quadrangulation/render.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <string>

namespace RQ = CGAL::Reeb_quadrangulation;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

int fail(const RQ::Error& error) {
  std::cerr << error.message << '\n';
  return 1;
}

int main(int argc, char** argv) {
  const auto surface = RQ::make_shape("bitorus", 6000);
  if (!surface) return fail(surface.error());
  Mesh mesh;
  if (const auto added = RQ::to_face_graph(*surface, mesh); !added) return fail(added.error());

  // The function may be anything that has a value at each vertex; here it is a coordinate.
  auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for (const Mesh::Vertex_index v : mesh.vertices()) height[v] = mesh.point(v).x();
  auto arc = mesh.add_property_map<Mesh::Face_index, int>("f:arc", -1).first;
  const auto graph = RQ::reeb_graph(mesh, height, RQ::parameters::face_arc_map(arc));
  if (!graph) return fail(graph.error());

  for (const auto& node : graph->nodes)
    std::cout << (node.lower.empty()   ? "a minimum"
                  : node.upper.empty() ? "a maximum"
                                       : "a saddle")
              << " at height " << height[node.vertex] << ": " << node.lower.size() << " arcs from below, "
              << node.upper.size() << " above\n";
  std::cout << "loops of the graph, as many as the surface has handles: " << graph->loops() << '\n';

  std::vector<int> region;
  for (const Mesh::Face_index f : mesh.faces()) region.push_back(arc[f]);
  const RQ::Camera camera = RQ::camera(RQ::View::three_quarter, RQ::Up_axis::z);
  const std::string file = std::string(argc > 1 ? argv[1] : ".") + "/course_reeb_graph.png";
  const auto written =
      RQ::write_png(RQ::render(RQ::face_colour_scene(*surface, region), camera, 600, 480), file);
  if (!written) return fail(written.error());
  return graph->loops() == 2 ? 0 : 1;
}
