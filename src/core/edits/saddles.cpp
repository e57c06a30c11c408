// SPDX-License-Identifier: GPL-3.0-or-later
// A saddle that moves with all its contours.
#include "contours/plane_path.h"
#include "edits/steps.h"

#include <algorithm>
#include <iterator>

namespace CGAL {
namespace Reeb_quadrangulation {

Eigen::Vector3d normal_at(const Triangle_surface& surface, int vertex) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const int first = surface.outgoing[vertex];
  int h = first;
  do {
    const Triangle& t = surface.triangles[h / 3];
    normal +=
        (surface.points[t[1]] - surface.points[t[0]]).cross(surface.points[t[2]] - surface.points[t[0]]);
    h = surface.rotate_ccw(h);
  } while (h >= 0 && h != first);
  return normal;
}

std::vector<int> vertices_around(const Triangle_surface& s, int vertex, double distance) {
  std::vector<std::pair<double, int>> found{{0.0, vertex}};
  std::set<int> seen{vertex};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const int first = s.outgoing[found[i].second];
    int h = first;
    do {
      const double d = (s.points[s.target(h)] - s.points[vertex]).norm();
      if (d <= distance && seen.insert(s.target(h)).second) found.push_back({d, s.target(h)});
      h = s.rotate_ccw(h);
    } while (h >= 0 && h != first);
  }
  std::sort(found.begin(), found.end());
  std::vector<int> vertices;
  for (const auto& entry : found) vertices.push_back(entry.second);
  return vertices;
}

namespace {

// A saddle, its contour edges, and where it goes.
struct Saddle_move {
  int node = -1;
  std::vector<int> edges;
  int vertex = -1;
  Eigen::Vector3d normal;
};

Eigen::Vector3d plane_normal(const Draft& draft, const Move_saddle& edit, int vertex) {
  return edit.plane_normal.isZero(0) ? normal_at(draft.surface(), vertex) : edit.plane_normal;
}

// How often the ring around a vertex crosses the plane through it.
int crossings_around(const Triangle_surface& s, int vertex, const Eigen::Vector3d& normal) {
  std::vector<bool> above;
  const int first = s.outgoing[vertex];
  int h = first;
  do {
    above.push_back((s.points[s.target(h)] - s.points[vertex]).dot(normal) > 0);
    h = s.rotate_ccw(h);
  } while (h >= 0 && h != first);
  int count = 0;
  for (std::size_t i = 0; i < above.size(); ++i) count += above[i] != above[(i + 1) % above.size()];
  return count;
}

// Whether a vertex lies on the saddle's contours or in the charts beside them.
bool is_beside(const Draft& draft, const std::vector<int>& edges, int vertex) {
  const int chart = draft.chart_of_vertex(vertex);
  return std::any_of(edges.begin(), edges.end(), [&](int e) {
    const std::vector<int>& passed = draft.network.edges[e].vertices;
    const std::array<int, 2>& sides = draft.atlas().charts_of_edge[e];
    return chart >= 0 ? chart == sides[0] || chart == sides[1]
                      : std::find(passed.begin(), passed.end(), vertex) != passed.end();
  });
}

// The saddle and its contours.
Result<Saddle_move> read(const Draft& draft, const Move_saddle& edit) {
  Saddle_move move;
  move.node = draft.saddle_at(edit.at.point);
  if (move.node < 0) return refuse("there is no saddle");
  const std::vector<int> ends = draft.edges_at(move.node);
  std::unique_copy(ends.begin(), ends.end(), std::back_inserter(move.edges));
  for (int e : move.edges)
    for (int c : draft.atlas().charts_of_edge[e])
      if (c < 0) return refuse("the contour is a boundary of the surface", {}, Element_kind::contour, e);
  return move;
}

// On flat triangles, and beside the ridge of a saddle, another vertex near it may be one where the plane
// meets the surface so.
Result<Saddle_move> with_one_plane(const Draft& draft, const Move_saddle& edit, Saddle_move move,
                                   const std::vector<int>& vertices) {
  const std::size_t ends = draft.edges_at(move.node).size();
  for (int v : vertices) {
    move.vertex = v;
    move.normal = plane_normal(draft, edit, v);
    if (crossings_around(draft.surface(), v, move.normal) >= int(ends)) return move;
  }
  return refuse("the plane meets the surface in fewer curves than the saddle has contours", {},
                Element_kind::vertex, vertices[0]);
}

// The contour that takes the place of edge `e`, whose ends at the saddle are at node `node` now.
Result<Contour_edge> moved_edge(Draft& draft, const Saddle_move& move, int node, int e, Loop_sense sense) {
  const Contour_edge old = draft.network.edges[e];
  const int from = old.from == move.node ? node : old.from, to = old.to == move.node ? node : old.to;
  const Point middle = draft.position(old.vertices[old.vertices.size() / 2]);
  Result<Contour_edge> fresh = plane_path(draft.surface(), draft.network, draft.network.nodes[from].vertex,
                                          draft.network.nodes[to].vertex, move.normal, middle, sense);
  if (!fresh) return fresh;
  fresh->from = from;
  fresh->to = to;
  fresh->value = old.value;
  fresh->left = old.left;
  fresh->right = old.right;
  return fresh;
}

// The saddle moves, and all its contours with it; the charts beside them are bounded as before.
Result<void> move_saddle(Draft& draft, const Saddle_move& move, Loop_sense sense) {
  std::vector<Chart_signature> before;
  for (int e : move.edges)
    for (int side : {0, 1}) before.push_back(chart_beside(draft, e, side, {}));
  int node = move.node;
  if (const Contour_node old = draft.network.nodes[node]; old.vertex != move.vertex) {
    node = add_node(draft.network, move.vertex, old.kind);
    draft.network.nodes[node].multiplicity = old.multiplicity;
  }
  std::map<int, int> names; // of the new contour edges
  std::vector<Contour_edge> all;
  for (int e : move.edges) {
    Result<Contour_edge> fresh = moved_edge(draft, move, node, e, sense);
    if (!fresh) return fresh.error();
    const bool is_loop = fresh->from == fresh->to;
    for (const Contour_edge& other : all)
      if (is_loop && other.from == other.to && other.faces.front() == fresh->faces.front())
        return refuse("the plane meets the surface in fewer curves than the saddle has contours", {},
                      Element_kind::vertex, move.vertex);
    all.push_back(std::move(*fresh));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int old = move.edges[i], edge = int(draft.network.edges.size());
    remove_edge(draft.network, old);
    draft.network.edges.push_back(std::move(all[i]));
    names[edge] = old;
    draft.replaced[edge] = draft.replaced.count(old) ? draft.replaced[old] : old;
    for (Design_extremum& e : draft.extrema)
      if (e.segment == old) e.segment = edge;
  }
  if (Result<void> cut = draft.cut(); !cut) return cut;
  std::vector<Chart_signature> after;
  for (const auto& [edge, old] : names)
    for (int side : {0, 1}) after.push_back(chart_beside(draft, edge, side, names));
  if (before != after) return refuse("the contour would change the topology of the field");
  return check_caps(draft);
}

// All contours in one plane; its upper side is that of the field, or the lower one.
Result<void> move_to_plane(Draft& draft, const Saddle_move& move) {
  Result<void> done;
  for (Loop_sense sense : {Loop_sense::above_on_left, Loop_sense::above_on_right}) {
    Draft trial = draft;
    done = move_saddle(trial, move, sense);
    if (!done) continue;
    draft.take(std::move(trial));
    return {};
  }
  return done;
}

} // namespace

Result<void> apply_edit(Draft& draft, const Move_saddle& edit) {
  const Result<Saddle_move> saddle = read(draft, edit);
  if (!saddle) return saddle.error();
  const int wanted = draft.vertex_at(edit.to);
  std::vector<int> vertices;
  for (int v : vertices_around(draft.surface(), wanted, draft.edge_length))
    if (is_beside(draft, saddle->edges, v)) vertices.push_back(v);
  if (vertices.empty() || !is_beside(draft, saddle->edges, wanted))
    return refuse("the saddle would leave its charts", {}, Element_kind::vertex, wanted);
  const Result<Saddle_move> move = with_one_plane(draft, edit, *saddle, vertices);
  if (move && move_to_plane(draft, *move)) return {};
  constexpr std::size_t most = 6;
  Result<void> done;
  for (std::size_t i = 0; i < std::min(most, vertices.size()); ++i) {
    Draft trial = draft;
    done = move_saddle_with_loops(trial, Node_id(saddle->node), Vertex_index(vertices[i]), edit.plane_normal);
    if (!done) continue;
    draft.take(std::move(trial));
    return {};
  }
  return done;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
