// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph of a user's own function.
#include "Python_observer.h"
#include "arrays.h"
#include "bind.h"

#include <CGAL/Reeb_quadrangulation/reeb_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

using Graph = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Graph_vertex = Graph::Vertex_index;
using Graph_face = Graph::Face_index;

struct Named_graph {
  Face_graph_reeb_graph<Graph> graph;
  std::vector<int> arc_of_vertex, arc_of_face;
};

/// With the numbers of the points and triangles as indices.
Result<Graph> face_graph(Triangle_surface surface) {
  if (const Result<void> connected = surface.connect(); !connected) return connected.error();
  Graph graph;
  for (const Point& p : surface.points) graph.add_vertex({p.x(), p.y(), p.z()});
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    if (graph.add_face(Graph_vertex(t[0]), Graph_vertex(t[1]), Graph_vertex(t[2])) == Graph::null_face())
      return make_error(Error_code::not_a_surface, "a face does not join the others as a surface",
                        Element_kind::face, std::int64_t(f));
  }
  return graph;
}

Result<Named_graph> graph_of(const Triangle_surface& surface, const std::vector<double>& values) {
  Result<Graph> mesh = face_graph(surface);
  if (!mesh) return mesh.error();
  const auto field = mesh->add_property_map<Graph_vertex, double>("v:value").first;
  for (std::size_t v = 0; v < values.size(); ++v) field[Graph_vertex(int(v))] = values[v];
  const auto of_vertex = mesh->add_property_map<Graph_vertex, int>("v:arc", -1).first;
  const auto of_face = mesh->add_property_map<Graph_face, int>("f:arc", -1).first;
  auto graph = reeb_graph(*mesh, field, parameters::vertex_arc_map(of_vertex).face_arc_map(of_face));
  if (!graph) return graph.error();
  Named_graph named{std::move(*graph), {}, {}};
  for (const Graph_vertex v : mesh->vertices()) named.arc_of_vertex.push_back(of_vertex[v]);
  for (const Graph_face f : mesh->faces()) named.arc_of_face.push_back(of_face[f]);
  return named;
}

const char* kind_name(Critical_kind kind) {
  switch (kind) {
  case Critical_kind::minimum: return "minimum";
  case Critical_kind::maximum: return "maximum";
  case Critical_kind::saddle: return "saddle";
  case Critical_kind::touch: break;
  }
  return "touch";
}

py::dict reeb_graph_of(const py::object& vertices, const py::object& faces, const py::object& function) {
  const Polygon_soup soup = soup_from(vertices, faces);
  Triangle_surface surface;
  surface.points = soup.points;
  surface.triangles = triangles_of(soup);
  const std::vector<double> values = numbers_from(function, "the function");
  if (values.size() != surface.points.size())
    refuse("the function has one value a vertex; got " + std::to_string(values.size()) + " for " +
           std::to_string(surface.points.size()) + " vertices");
  Python_observer observer{py::none()};
  const Named_graph named = without_lock(observer, [&] { return graph_of(surface, values); });
  std::vector<int> nodes;
  std::vector<double> persistence;
  py::list kinds;
  for (const auto& node : named.graph.nodes) {
    nodes.push_back(int(node.vertex));
    persistence.push_back(node.persistence);
    kinds.append(kind_name(node.kind));
  }
  std::vector<std::array<int, 2>> arcs;
  for (const Order_graph::Arc& arc : named.graph.arcs) arcs.push_back({arc.low, arc.high});
  py::dict out;
  out["vertices"] = to_array(nodes);
  out["kinds"] = kinds;
  out["persistence"] = to_array(persistence);
  out["arcs"] = to_array(arcs);
  out["pairs"] = to_array(named.graph.pairs);
  out["arc_of_vertex"] = to_array(named.arc_of_vertex);
  out["arc_of_face"] = to_array(named.arc_of_face);
  out["components"] = named.graph.components;
  out["loops"] = named.graph.loops();
  return out;
}

} // namespace

void bind_reeb_graph(py::module_& module) {
  module.def("reeb_graph", &reeb_graph_of, py::arg("vertices"), py::arg("faces"), py::arg("function"));
}

} // namespace python
} // namespace reebquad
