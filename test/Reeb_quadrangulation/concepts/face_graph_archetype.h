// SPDX-License-Identifier: GPL-3.0-or-later
// A face graph that has what a model of CGAL's MutableFaceGraph and FaceListGraph has to have, and no points
// of its own.
#ifndef REEBQUAD_TEST_FACE_GRAPH_ARCHETYPE_H
#define REEBQUAD_TEST_FACE_GRAPH_ARCHETYPE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <map>
#include <utility>

namespace archetype {

class Face_graph {
public:
  using Connectivity = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Traits = boost::graph_traits<Connectivity>;
  using Vertex = Traits::vertex_descriptor;
  using Halfedge = Traits::halfedge_descriptor;
  using Edge = Traits::edge_descriptor;
  using Face = Traits::face_descriptor;

  const Connectivity& connectivity() const { return m_connectivity; }
  Connectivity& connectivity() { return m_connectivity; }

private:
  Connectivity m_connectivity; // its points are never touched
};

inline auto vertices(const Face_graph& g) {
  return vertices(g.connectivity());
}
inline auto halfedges(const Face_graph& g) {
  return halfedges(g.connectivity());
}
inline auto edges(const Face_graph& g) {
  return edges(g.connectivity());
}
inline auto faces(const Face_graph& g) {
  return faces(g.connectivity());
}
inline auto num_vertices(const Face_graph& g) {
  return num_vertices(g.connectivity());
}
inline auto num_faces(const Face_graph& g) {
  return num_faces(g.connectivity());
}
inline Face_graph::Halfedge next(Face_graph::Halfedge h, const Face_graph& g) {
  return next(h, g.connectivity());
}
inline Face_graph::Halfedge prev(Face_graph::Halfedge h, const Face_graph& g) {
  return prev(h, g.connectivity());
}
inline Face_graph::Halfedge opposite(Face_graph::Halfedge h, const Face_graph& g) {
  return opposite(h, g.connectivity());
}
inline Face_graph::Vertex source(Face_graph::Halfedge h, const Face_graph& g) {
  return source(h, g.connectivity());
}
inline Face_graph::Vertex target(Face_graph::Halfedge h, const Face_graph& g) {
  return target(h, g.connectivity());
}
inline Face_graph::Face face(Face_graph::Halfedge h, const Face_graph& g) {
  return face(h, g.connectivity());
}
inline Face_graph::Edge edge(Face_graph::Halfedge h, const Face_graph& g) {
  return edge(h, g.connectivity());
}
inline Face_graph::Halfedge halfedge(Face_graph::Vertex v, const Face_graph& g) {
  return halfedge(v, g.connectivity());
}
inline Face_graph::Halfedge halfedge(Face_graph::Edge e, const Face_graph& g) {
  return halfedge(e, g.connectivity());
}
inline Face_graph::Halfedge halfedge(Face_graph::Face f, const Face_graph& g) {
  return halfedge(f, g.connectivity());
}
inline std::pair<Face_graph::Halfedge, bool> halfedge(Face_graph::Vertex u, Face_graph::Vertex v,
                                                      const Face_graph& g) {
  return halfedge(u, v, g.connectivity());
}
inline Face_graph::Vertex add_vertex(Face_graph& g) {
  return g.connectivity().add_vertex();
}
inline Face_graph::Edge add_edge(Face_graph& g) {
  return add_edge(g.connectivity());
}
inline Face_graph::Face add_face(Face_graph& g) {
  return add_face(g.connectivity());
}
inline void set_target(Face_graph::Halfedge h, Face_graph::Vertex v, Face_graph& g) {
  set_target(h, v, g.connectivity());
}
inline void set_next(Face_graph::Halfedge h, Face_graph::Halfedge next, Face_graph& g) {
  set_next(h, next, g.connectivity());
}
inline void set_face(Face_graph::Halfedge h, Face_graph::Face f, Face_graph& g) {
  set_face(h, f, g.connectivity());
}
inline void set_halfedge(Face_graph::Face f, Face_graph::Halfedge h, Face_graph& g) {
  set_halfedge(f, h, g.connectivity());
}
inline void set_halfedge(Face_graph::Vertex v, Face_graph::Halfedge h, Face_graph& g) {
  set_halfedge(v, h, g.connectivity());
}

} // namespace archetype

namespace boost {
template <> struct graph_traits<archetype::Face_graph> : graph_traits<archetype::Face_graph::Connectivity> {};
} // namespace boost

#endif // REEBQUAD_TEST_FACE_GRAPH_ARCHETYPE_H
