// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs of the samples with their points in a map beside them, so that each kind of graph is asked alike.
#ifndef REEBQUAD_TEST_POINTED_GRAPH_H
#define REEBQUAD_TEST_POINTED_GRAPH_H

#include "concepts/face_graph_archetype.h"
#include "tiny_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>
#include <CGAL/Surface_mesh.h>

#include <map>

using namespace CGAL::Reeb_quadrangulation;
namespace params = CGAL::Reeb_quadrangulation::parameters;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Inexact::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Inexact>;
using Bare = archetype::Face_graph;

template <class Graph> using Vertex_of = typename boost::graph_traits<Graph>::vertex_descriptor;

// A graph of a surface with its points in a map beside it.
template <class Graph> struct Pointed {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  std::map<Vertex, Inexact::Point_3> points;
  Graph graph;
  auto map() const { return boost::associative_property_map<std::map<Vertex, Inexact::Point_3>>(mine()); }

private:
  std::map<Vertex, Inexact::Point_3>& mine() const {
    return const_cast<std::map<Vertex, Inexact::Point_3>&>(points);
  }
};

template <class Graph> Pointed<Graph> pointed(const Triangle_surface& s) {
  Pointed<Graph> result;
  const auto added = to_face_graph(s, result.graph, params::vertex_point_map(result.map()));
  REQUIRE(bool(added));
  REQUIRE(added->faces.size() == s.triangles.size());
  return result;
}

template <class Graph> Point at(const Pointed<Graph>& mesh, Vertex_of<Graph> v) {
  const auto& p = mesh.points.at(v);
  return {p.x(), p.y(), p.z()};
}

// The torus of the samples as quads of the same points and others between: its triangles lie in pairs.
inline Quad_mesh quads_of_torus(int m, int n) {
  Quad_mesh quads;
  quads.points = tiny::torus(m, n).points;
  const auto at = [&](int i, int j) { return i % m * n + j % n; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      quads.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return quads;
}

template <class Graph> Pointed<Graph> pointed_quads(const Quad_mesh& quads) {
  Pointed<Graph> result;
  REQUIRE(bool(to_face_graph(quads, result.graph, params::vertex_point_map(result.map()))));
  return result;
}

#endif // REEBQUAD_TEST_POINTED_GRAPH_H
