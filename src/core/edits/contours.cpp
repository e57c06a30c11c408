// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas/chart_lines.h"
#include "contours/plane_path.h"
#include "edits/steps.h"

#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>
#include <CGAL/Reeb_quadrangulation/plane_contour.h>
#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

Result<std::vector<double>> level_field(Draft& draft, int c) {
  const Chart& chart = draft.chart(c);
  if (chart.kind == Chart_kind::annulus) {
    Result<std::shared_ptr<const Chart_parameterization>> map = draft.map(c);
    if (!map) return map.error();
    return (*map)->u();
  }
  if (chart.extremum < 0) return refuse("a rectangle has no level lines");
  const bool is_maximum = chart.walks[0].side == Side::low;
  std::vector<char> is_fixed(chart.mesh.number_of_vertices(), 0);
  std::vector<double> values(is_fixed.size(), 0.0);
  is_fixed[chart.extremum] = 1;
  values[chart.extremum] = is_maximum ? 1 : 0;
  for (int v : chart.walks[0].vertices) {
    is_fixed[v] = 1;
    values[v] = is_maximum ? 0 : 1;
  }
  Result<Dirichlet_problem> problem =
      Dirichlet_problem::factorize(chart.mesh, clamped_cotangent_weights(chart.mesh), is_fixed,
                                   draft.order_of(chart), draft.field_solver());
  if (!problem) return problem.error();
  if (Result<void> solved = problem->solve(chart.mesh, values); !solved) return solved.error();
  return values;
}

std::array<double, 2> value_range(const Draft& draft, const Chart& chart) {
  const auto value = [&](const Walk& walk) { return draft.network.edges[walk.edges[0].edge].value; };
  if (chart.kind == Chart_kind::annulus) return {value(chart.walks[0]), value(chart.walks[1])};
  double pole = chart.walks[0].side == Side::low ? 1 : 0;
  for (const Design_extremum& e : draft.extrema)
    if (chart.extremum >= 0 && chart.vertex_origin[chart.extremum] == e.vertex) pole = e.value;
  const double around = value(chart.walks[0]);
  return chart.walks[0].side == Side::low ? std::array<double, 2>{around, pole}
                                          : std::array<double, 2>{pole, around};
}

Result<int> draw_level_line(Draft& draft, Chart_index c, Vertex_index vertex) {
  const Chart& chart = draft.chart(c);
  const auto found = std::find(chart.vertex_origin.begin(), chart.vertex_origin.end(), vertex);
  const int seed = int(found - chart.vertex_origin.begin());
  if (found == chart.vertex_origin.end() || seed == chart.extremum)
    return refuse("there is no level line through an extremum", {}, Element_kind::vertex, vertex);
  Result<std::vector<double>> field = level_field(draft, c);
  if (!field) return field.error();
  std::vector<signed char> level(chart.mesh.number_of_vertices(), 0);
  for (const Walk& walk : chart.walks)
    for (int v : walk.vertices) level[v] = walk.side == Side::low ? -1 : 1;
  const Vertex_order order = order_vertices(*field, level);
  const std::vector<Traced_contour> loops = trace_contour(chart.mesh, order, seed);
  if (loops.size() != 1)
    return refuse("the level line through the vertex is not one closed loop", {}, Element_kind::vertex,
                  vertex);
  const std::array<double, 2> range = value_range(draft, chart);
  Contour_network local = build_network(chart.mesh, order, *field, loops, {}, {});
  local.edges[0].value = range[0] + (*field)[seed] * (range[1] - range[0]);
  Result<std::vector<int>> added = transfer_contours(draft.surface(), chart, local, {0}, draft.network);
  if (!added) return added.error();
  return (*added)[0];
}

Result<void> apply_edit(Draft& draft, const Subdivide_chart& edit) {
  const int vertex = draft.vertex_at(edit.at),
            chart = draft.atlas().charts.empty() ? -1 : draft.chart_of_vertex(vertex);
  if (chart < 0) return refuse("the vertex lies on a contour", {}, Element_kind::vertex, vertex);
  Result<int> edge = draw_level_line(draft, Chart_index(chart), Vertex_index(vertex));
  if (!edge) return edge.error();
  return draft.cut();
}

Result<int> free_loop_at(const Draft& draft, const Surface_point& at) {
  const int e = draft.contour_at(at.point);
  if (e < 0) return refuse("there is no contour");
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
  if (sides[0] < 0 || sides[1] < 0)
    return refuse("the contour is a boundary of the surface", {}, Element_kind::contour, e);
  if (!draft.is_free_loop(e))
    return refuse("the contour goes through a saddle or an anchor", {}, Element_kind::contour, e);
  return e;
}

namespace {

// Whether a disc has a contour of its own in parts between anchors, where its corners may be as well as
// between them.
bool is_anchored_cap(const Draft& draft, const Chart& disc) {
  return std::all_of(disc.walks[0].edges.begin(), disc.walks[0].edges.end(), [&](const Walk_edge& e) {
    const Contour_edge& edge = draft.network.edges[std::size_t(e.edge)];
    const std::array<int, 2>& sides = draft.atlas().charts_of_edge[std::size_t(e.edge)];
    const auto is_anchor = [&](int node) {
      return draft.network.nodes[std::size_t(node)].kind == Node_kind::anchor;
    };
    return sides[0] >= 0 && sides[1] >= 0 && sides[0] != sides[1] && is_anchor(edge.from) &&
           is_anchor(edge.to);
  });
}

} // namespace

Result<void> check_caps(const Draft& draft) {
  for (std::size_t c = 0; c < draft.atlas().charts.size(); ++c) {
    const Chart& chart = draft.chart(int(c));
    if (chart.kind != Chart_kind::disc || !rectangle_corners(draft.network, chart).empty()) continue;
    if (cap_contour(draft, int(c)) >= 0 || is_anchored_cap(draft, chart)) continue;
    const int pole = chart.extremum < 0 ? -1 : chart.vertex_origin[std::size_t(chart.extremum)];
    return refuse("an extremum needs a cap: a contour of its own", {},
                  pole < 0 ? Element_kind::none : Element_kind::vertex, pole);
  }
  return {};
}

Result<void> apply_edit(Draft& draft, const Remove_contour& edit) {
  const Result<int> e = free_loop_at(draft, edit.at);
  if (!e) return e.error();
  remove_edge(draft.network, *e);
  if (Result<void> cut = draft.cut(); !cut) return cut;
  return check_caps(draft);
}

Result<void> apply_edit(Draft& draft, const Drag_contour& edit) {
  const Result<int> e = free_loop_at(draft, edit.at);
  if (!e) return e.error();
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[*e];
  const int vertex = draft.vertex_at(edit.to), target = draft.chart_of_vertex(vertex);
  if (target != sides[0] && target != sides[1])
    return refuse("the contour would leave its charts", {}, Element_kind::vertex, vertex);
  remove_edge(draft.network, *e);
  if (Result<void> cut = draft.cut(); !cut) return cut;
  Result<int> line = draw_level_line(draft, Chart_index(draft.chart_of_vertex(vertex)), Vertex_index(vertex));
  if (!line) return line.error();
  if (Result<void> cut = draft.cut(); !cut) return cut;
  return check_caps(draft);
}

Chart_signature chart_beside(const Draft& draft, int edge, int side, const std::map<int, int>& names) {
  Chart_signature signature;
  const int c = draft.atlas().charts_of_edge[edge][side];
  if (c < 0) return signature;
  const Chart& chart = draft.chart(c);
  for (int e : contour_edges(chart)) signature.edges.push_back(names.count(e) ? names.at(e) : e);
  std::sort(signature.edges.begin(), signature.edges.end());
  if (chart.extremum >= 0) signature.extremum = chart.vertex_origin[chart.extremum];
  return signature;
}

Result<void> replace_edge(Draft& draft, int old, Contour_edge fresh) {
  const Chart_signature left = chart_beside(draft, old, 0, {});
  const Contour_edge before = draft.network.edges[old];
  fresh.value = before.value;
  fresh.left = before.left;
  fresh.right = before.right;
  remove_edge(draft.network, old);
  draft.network.edges.push_back(fresh);
  const int edge = int(draft.network.edges.size()) - 1;
  draft.replaced[edge] = draft.replaced.count(old) ? draft.replaced[old] : old;
  for (Design_extremum& e : draft.extrema)
    if (e.segment == old) e.segment = edge;
  const auto agrees = [&] { return chart_beside(draft, edge, 0, {{edge, old}}) == left; };
  Result<void> cut = draft.cut();
  if (cut && agrees()) return check_caps(draft);
  const bool is_loop = before.from == before.to;
  if (!is_loop) return cut ? refuse("the contour would change the topology of the field") : cut;
  reverse(draft.network.edges[edge]);
  Result<void> again = draft.cut();
  if (!again) return cut ? refuse("the contour would change the topology of the field") : cut;
  if (!agrees()) return refuse("the contour would change the topology of the field");
  return check_caps(draft);
}

namespace {

// A closed plane curve as a free loop that begins near `node`.
Contour_edge loop_of_curve(Draft& draft, const Plane_curve& curve, const Point& node) {
  const std::vector<Point> points = curve_points(draft.surface(), curve);
  const int n = int(points.size());
  int first = 0;
  for (int i = 1; i < n; ++i)
    if ((points[i] - node).squaredNorm() < (points[first] - node).squaredNorm()) first = i;
  Contour_edge edge;
  for (int i = 0; i < n; ++i) {
    edge.vertices.push_back(add_crossing(draft.network, curve.crossings[(first + i) % n]));
    edge.faces.push_back(curve.faces[(first + i) % n]);
  }
  edge.vertices.push_back(edge.vertices.front());
  edge.from = edge.to = add_node(draft.network, edge.vertices.front());
  return edge;
}

Result<void> move_free_loop(Draft& draft, int e, const Move_contour& edit) {
  const Contour_edge old = draft.network.edges[e];
  Result<Plane_curves> cut =
      plane_curves(draft.surface(), Cutting_plane::at(edit.plane_point, edit.plane_normal));
  if (!cut) return cut.error();
  place_crossings(draft.surface(), Cutting_plane::at(edit.plane_point, edit.plane_normal), 0.03, cut->curves);
  const int nearest = nearest_curve(draft.surface(), cut->curves, edit.at.point);
  if (nearest < 0) return refuse("the plane does not meet the surface", {}, Element_kind::contour, e);
  if (!cut->curves[nearest].is_closed)
    return refuse("the plane's curve is not a closed loop", {}, Element_kind::contour, e);
  // Only then are the old crossings out of the way of the new ones.
  Contour_edge fresh = loop_of_curve(draft, cut->curves[nearest], draft.position(old.vertices.front()));
  return replace_edge(draft, e, std::move(fresh));
}

// The part of contour `e` between two of its vertices that is nearest to a point, as an edge of its own.
Result<int> part_between(Draft& draft, int e, const std::vector<Surface_point>& anchors, const Point& at) {
  const int i = draft.vertex_of_contour_at(e, anchors[0].point);
  const Point first = draft.position(draft.network.edges[e].vertices[i]);
  const bool at_end = i == 0 || i + 1 == int(draft.network.edges[e].vertices.size());
  if (at_end && draft.is_free_loop(e))
    draft.network.nodes[draft.network.edges[e].from].kind = Node_kind::anchor;
  std::vector<int> parts = split_edge(draft.network, Contour_id(e), i, Node_kind::anchor);
  const auto nearest = [&](const Point& p) {
    int best = parts[0];
    double least = -1;
    for (int part : parts)
      for (int v : draft.network.edges[part].vertices)
        if (const double d = (draft.position(v) - p).squaredNorm(); least < 0 || d < least) {
          least = d;
          best = part;
        }
    return best;
  };
  const int second = nearest(anchors[1].point);
  const int j = draft.vertex_of_contour_at(second, anchors[1].point);
  if (draft.position(draft.network.edges[second].vertices[j]) == first)
    return refuse("the anchors are the same vertex of the contour");
  const std::vector<int> more = split_edge(draft.network, Contour_id(second), j, Node_kind::anchor);
  parts.erase(std::find(parts.begin(), parts.end(), second));
  parts.insert(parts.end(), more.begin(), more.end());
  return nearest(at);
}

Result<void> move_part(Draft& draft, int e, const Move_contour& edit) {
  const Contour_edge old = draft.network.edges[e];
  Result<Contour_edge> path = plane_path(draft.surface(), draft.network, old.vertices.front(),
                                         old.vertices.back(), edit.plane_normal, edit.at.point);
  if (!path) return path.error();
  path->from = old.from;
  path->to = old.to;
  return replace_edge(draft, e, std::move(*path));
}

bool meets_surface(const Draft& draft, const Cutting_plane& plane) {
  const Result<std::vector<char>> above = classify_vertices(draft.surface(), plane);
  return above && std::count(above->begin(), above->end(), char(1)) % std::ptrdiff_t(above->size()) != 0;
}

// The plane itself, or what comes near it.
Result<void> move_edge(Draft& draft, int e, const Move_contour& edit) {
  Draft trial = draft;
  const bool is_free = draft.is_free_loop(e);
  const Result<void> exact = is_free ? move_free_loop(trial, e, edit) : move_part(trial, e, edit);
  if (!exact && exact.error().code != Error_code::refused_edit) return exact;
  if (exact) {
    draft.take(std::move(trial));
    return {};
  }
  Point point = edit.plane_point;
  Eigen::Vector3d normal = edit.plane_normal;
  if (is_free && !meets_surface(draft, Cutting_plane::at(point, normal))) return exact;
  if (!is_free) { // through both ends
    const Contour_edge& old = draft.network.edges[e];
    point = draft.position(old.vertices.front());
    const Eigen::Vector3d along = draft.position(old.vertices.back()) - point;
    if (along.squaredNorm() > 0) normal -= normal.dot(along) / along.squaredNorm() * along;
    if (!(normal.norm() > 1e-9 * edit.plane_normal.norm())) return exact;
  }
  return move_towards_plane(draft, e, point, normal);
}

} // namespace

Result<void> apply_edit(Draft& draft, const Move_contour& edit) {
  int e = draft.contour_at(edit.at.point);
  if (e < 0) return refuse("there is no contour");
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
  if (sides[0] < 0 || sides[1] < 0)
    return refuse("the contour is a boundary of the surface", {}, Element_kind::contour, e);
  if (!edit.anchors.empty() && edit.anchors.size() != 2)
    return make_error(Error_code::impossible_request, "a contour has no anchors, or two");
  if (edit.enforcement == Enforcement::field) {
    if (!edit.anchors.empty())
      return refuse("the field alone moves no part of a contour", {}, Element_kind::contour, e);
    Draft trial = draft; // what cannot be cut in is no contour for a field to follow
    if (Result<void> possible = move_edge(trial, e, edit); !possible) return possible;
    return enforce_by_field(draft, e, trial);
  }
  if (edit.anchors.empty()) return move_edge(draft, e, edit);
  if (sides[0] == sides[1])
    return refuse("a segment has no anchors but its ends", {}, Element_kind::contour, e);
  Result<int> part = part_between(draft, e, edit.anchors, edit.at.point);
  if (!part) return part.error();
  // The parts are edges of their own now; the atlas has to know them before one of them moves.
  if (Result<void> cut = draft.cut(); !cut) return cut;
  return move_edge(draft, *part, edit);
}

namespace {

int chart_between(const Draft& draft, int first, int second) {
  const auto touches = [&](const Walk& walk, int node) {
    return std::any_of(walk.edges.begin(), walk.edges.end(), [&](const Walk_edge& e) {
      return draft.network.edges[e.edge].from == node || draft.network.edges[e.edge].to == node;
    });
  };
  for (std::size_t c = 0; c < draft.atlas().charts.size(); ++c) {
    const Chart& chart = draft.chart(int(c));
    if (chart.kind != Chart_kind::annulus) continue;
    for (int w = 0; w < 2; ++w)
      if (touches(chart.walks[w], first) && touches(chart.walks[1 - w], second)) return int(c);
  }
  return -1;
}

} // namespace

Result<void> apply_edit(Draft& draft, const Collapse_chart& edit) {
  const int c = draft.chart_at(edit.at);
  if (c < 0) return refuse("there is no chart");
  return collapse_chart(draft, c);
}

Result<void> apply_edit(Draft& draft, const Align_saddles& edit) {
  const int first = draft.saddle_at(edit.first.point), second = draft.saddle_at(edit.second.point);
  if (first < 0 || first == second) return refuse("two saddles are needed");
  const int c = chart_between(draft, first, second);
  if (c < 0) return refuse("no chart lies between the saddles");
  return collapse_chart(draft, c);
}

Result<void> apply_edit(Draft& draft, const Collapse_thin_charts&) {
  if (Result<void> done = collapse_thin_charts(draft); !done) return done;
  if (draft.collapsed_charts == 0) return refuse("no chart is thinner than half a quad and can be collapsed");
  return {};
}

namespace {

// The borders of the smooth pieces between sharp edges, as closed lists of vertices, those that lie in some
// charts.
std::vector<std::vector<int>> feature_loops(const Draft& draft, const std::set<int>& charts, int moved,
                                            double angle) {
  const Triangle_surface& s = draft.surface();
  std::vector<char> sharp(s.number_of_halfedges(), 0);
  for (const Feature_chain& chain : feature_edges(s, angle).chains)
    for (int h : chain.halfedges) {
      sharp[h] = 1;
      if (s.opposite[h] >= 0) sharp[s.opposite[h]] = 1;
    }
  // Inside the charts, or on the contour itself.
  std::vector<char> inside(s.number_of_vertices(), 0);
  for (int c : charts)
    for (int v : draft.chart(c).vertex_origin)
      if (v >= 0 && v < s.number_of_vertices()) inside[v] = 1;
  for (const Contour_edge& e : draft.network.edges)
    for (int v : e.vertices)
      if (!draft.network.is_crossing(v)) inside[v] = 0;
  for (int v : draft.network.edges[moved].vertices)
    if (!draft.network.is_crossing(v)) inside[v] = 1;
  std::vector<std::vector<int>> loops;
  std::vector<char> seen(s.number_of_halfedges(), 0);
  for (int first = 0; first < s.number_of_halfedges(); ++first) {
    if (!sharp[first] || seen[first]) continue;
    std::vector<int> loop;
    bool good = true;
    for (int h = first; !seen[h];) {
      seen[h] = 1;
      loop.push_back(s.source(h));
      good = good && inside[loop.back()];
      for (h = Triangle_surface::next(h); !sharp[h]; h = Triangle_surface::next(s.opposite[h])) {
      }
    }
    std::vector<int> sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    good = good && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (good && loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

// Turns a closed list of vertices so that it begins where it bends most: there the contour has a sample for
// certain.
void begin_at_corner(const Triangle_surface& s, std::vector<int>& loop) {
  const int n = int(loop.size());
  int corner = 0;
  double least = 2;
  for (int i = 0; i < n; ++i) {
    const Point& p = s.points[loop[i]];
    const double straightness = (p - s.points[loop[(i + n - 1) % n]])
                                    .normalized()
                                    .dot((s.points[loop[(i + 1) % n]] - p).normalized());
    if (straightness < least) {
      least = straightness;
      corner = i;
    }
  }
  std::rotate(loop.begin(), loop.begin() + corner, loop.end());
}

} // namespace

Result<void> apply_edit(Draft& draft, const Snap_contour& edit) {
  const Result<int> e = free_loop_at(draft, edit.at);
  if (!e) return e.error();
  if (!(edit.feature_angle > 0 && edit.feature_angle < 180))
    return make_error(Error_code::impossible_request, "the feature angle is between 0 and 180 degrees");
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[*e];
  std::vector<std::vector<int>> loops = feature_loops(draft, {sides[0], sides[1]}, *e, edit.feature_angle);
  for (std::vector<int>& loop : loops) begin_at_corner(draft.surface(), loop);
  const std::vector<int> old = draft.network.edges[*e].vertices;
  const auto distance = [&](const std::vector<int>& loop) { // mean, from the contour to the loop's vertices
    double sum = 0;
    for (int v : old) {
      double least = -1;
      for (int w : loop)
        if (const double d = (draft.position(v) - draft.surface().points[w]).norm(); least < 0 || d < least)
          least = d;
      sum += least;
    }
    return sum;
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < loops.size(); ++i) order.push_back({distance(loops[i]), i});
  std::sort(order.begin(), order.end());
  for (const auto& [d, i] : order) {
    Draft trial = draft;
    Contour_edge fresh;
    fresh.vertices = loops[i];
    fresh.vertices.push_back(loops[i].front());
    fresh.faces.assign(loops[i].size(), -1);
    fresh.from = fresh.to = add_node(trial.network, loops[i].front());
    if (!replace_edge(trial, *e, std::move(fresh))) continue;
    draft.take(std::move(trial));
    return {};
  }
  return refuse("no closed chain of sharp edges lies beside the contour", {}, Element_kind::contour, *e);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
