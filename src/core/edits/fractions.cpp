// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pi.h"
#include "contours/plane_path.h"
#include "edits/steps.h"

#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

Side side_of(const Draft& draft, int edge, int chart) {
  const Contour_edge& e = draft.network.edges[edge];
  return draft.atlas().charts_of_edge[edge][0] == chart ? e.left : e.right;
}

// A saddle whose contour is a figure eight that belongs to it alone: chart `trunk` passes it twice, the
// `branches` once.
struct Simple_saddle {
  int node = -1, vertex = -1;
  std::array<int, 2> loops{{-1, -1}};
  int trunk = -1;
  std::array<int, 2> branches{{-1, -1}};
};

Result<Simple_saddle> simple_saddle_at(const Draft& draft, const Surface_point& at) {
  Simple_saddle s;
  s.node = draft.saddle_at(at.point);
  if (s.node < 0) return refuse("there is no saddle");
  s.vertex = draft.network.nodes[s.node].vertex;
  const std::vector<int> edges = draft.edges_at(s.node);
  const auto is_loop = [&](int e) { return draft.network.edges[e].from == draft.network.edges[e].to; };
  if (edges.size() != 4 || edges[0] != edges[1] || edges[2] != edges[3] || !is_loop(edges[0]) ||
      !is_loop(edges[2]))
    return refuse("the saddle is degenerate or shares its contour", {}, Element_kind::node, s.node);
  s.loops = {edges[0], edges[2]};
  const std::array<int, 2> first = draft.atlas().charts_of_edge[edges[0]],
                           second = draft.atlas().charts_of_edge[edges[2]];
  for (int side = 0; side < 2; ++side)
    if (first[side] == second[side] && first[1 - side] != second[1 - side]) {
      s.trunk = first[side];
      s.branches = {first[1 - side], second[1 - side]};
    }
  if (s.trunk < 0 || draft.chart(s.trunk).kind != Chart_kind::annulus ||
      draft.chart(s.branches[0]).kind != Chart_kind::annulus ||
      draft.chart(s.branches[1]).kind != Chart_kind::annulus)
    return refuse("the saddle's charts are not three annuli", {}, Element_kind::node, s.node);
  return s;
}

// Positions in an annulus, measured along and across it.
class Annulus_metric {
public:
  static Result<Annulus_metric> of(Draft& draft, int c) {
    Result<Chart_parameterization> map = draft.naturally_solved_map(c);
    if (!map) return map.error();
    return Annulus_metric(draft, draft.chart(c), std::move(*map));
  }

  // The interior vertex of the surface that is nearest to the point `size` away from a walk's vertex,
  // straight across.
  int vertex_across(Side side, int walk_index, double size) const {
    const Height_profile& profile = m_map.profile();
    const double height = profile.total(), v = m_map.natural(side)[walk_index];
    const double part = std::min(size / height, 0.4),
                 u = profile.level_at(side == Side::low ? part : 1 - part);
    const double length = side == Side::low ? profile.length.front() : profile.length.back();
    int best = -1;
    double least = 0;
    for (std::size_t i = 0; i < m_chart.vertex_origin.size(); ++i) {
      const int origin = m_chart.vertex_origin[i];
      if (origin < 0 || origin >= m_surface_vertices || m_map.u()[i] <= 0 || m_map.u()[i] >= 1) continue;
      double dv = m_map.v()[i] - v;
      dv -= std::round(dv);
      const double x = dv * length, y = (m_map.u()[i] - u) * height, d = x * x + y * y;
      if (best >= 0 && d >= least) continue;
      best = origin;
      least = d;
    }
    return best;
  }

private:
  Annulus_metric(const Draft& draft, const Chart& chart, Chart_parameterization map)
      : m_surface_vertices(draft.surface().number_of_vertices()), m_chart(chart), m_map(std::move(map)) {}
  int m_surface_vertices;
  const Chart& m_chart;
  Chart_parameterization m_map;
};

int index_of(const Chart& chart, const Walk& walk, int network_vertex) {
  for (std::size_t i = 0; i < walk.vertices.size(); ++i)
    if (chart.vertex_origin[walk.vertices[i]] == network_vertex) return int(i);
  return -1;
}

// Straight lines across a strip between two walks.
class Strip {
public:
  static Result<Strip> of(Draft& draft, int c) {
    if (c < 0 || draft.chart(c).kind != Chart_kind::annulus)
      return refuse("there is no strip beside the contour to draw a line in");
    Result<Chart_parameterization> map = draft.naturally_solved_map(c);
    if (!map) return map.error();
    return Strip(draft, draft.atlas().charts[c], std::move(*map));
  }

  const Chart& chart() const { return *m_chart; }

  // From a vertex of the walk on `side` to one of the other walk, both by their indices.
  Result<Contour_edge> line(Side side, int from, int to) {
    const bool upward = side == Side::low;
    const int low = upward ? from : to, high = upward ? to : from;
    const double v_low = m_map.v()[m_chart->walks[0].vertices[low]],
                 v_high = m_map.v()[m_chart->walks[1].vertices[high]];
    Result<Contour_edge> line = trace_line(m_draft.surface(), *m_chart, m_map, low, high,
                                           std::round(v_low - v_high), !upward, m_draft.network);
    if (!line) return refuse("a line through a chart could not be followed");
    return line;
  }

private:
  Strip(Draft& draft, std::shared_ptr<const Chart> chart, Chart_parameterization map)
      : m_draft(draft), m_chart(std::move(chart)), m_map(std::move(map)) {}
  Draft& m_draft;
  std::shared_ptr<const Chart> m_chart;
  Chart_parameterization m_map;
};

double usual_size(const Draft& draft, double asked) {
  return asked > 0 ? asked : draft.edge_length;
}

Result<void> check_branch_vertex(const Draft& draft, int vertex, int branch) {
  if (vertex < 0 || draft.chart_of_vertex(vertex) != branch)
    return refuse("a point is not inside the chart that it is for", {}, Element_kind::vertex, vertex);
  return {};
}

// The two new vertices: as given (in any order), or straight across from the saddle.
Result<std::array<int, 2>> half_saddle_vertices(Draft& draft, const Simple_saddle& s,
                                                const Split_saddle& edit) {
  std::array<int, 2> vertices{{-1, -1}};
  if (!edit.points.empty()) {
    if (edit.points.size() != 2)
      return make_error(Error_code::impossible_request, "half-saddles need two points, or none");
    for (int i = 0; i < 2; ++i) vertices[i] = draft.vertex_at(edit.points[i]);
    if (draft.chart_of_vertex(vertices[0]) == s.branches[1]) std::swap(vertices[0], vertices[1]);
  } else {
    for (int i = 0; i < 2; ++i) {
      Result<Annulus_metric> metric = Annulus_metric::of(draft, s.branches[i]);
      if (!metric) return metric.error();
      vertices[i] =
          metric->vertex_across(side_of(draft, s.loops[i], s.branches[i]), 0, usual_size(draft, edit.size));
    }
  }
  for (int i = 0; i < 2; ++i)
    if (Result<void> good = check_branch_vertex(draft, vertices[i], s.branches[i]); !good)
      return good.error();
  return vertices;
}

// The dumbbell: the loops retreat into the branches, and a middle segment through the old saddle joins them.
Result<void> split_in_halves(Draft& draft, const Simple_saddle& s, const Split_saddle& edit) {
  Result<std::array<int, 2>> vertices = half_saddle_vertices(draft, s, edit);
  if (!vertices) return vertices.error();
  const Side trunk_side = side_of(draft, s.loops[0], s.trunk);
  std::array<Side, 2> branch_side{};
  std::array<int, 2> lines{};
  for (int i = 0; i < 2; ++i) {
    branch_side[i] = side_of(draft, s.loops[i], s.branches[i]);
    Result<int> line = draw_level_line(draft, Chart_index(s.branches[i]), Vertex_index((*vertices)[i]));
    if (!line) return line.error();
    lines[i] = *line;
  }
  if (Result<void> cut = draft.cut(); !cut) return cut;
  std::array<Contour_edge, 2> spokes; // from the saddle to the new vertices
  for (int i = 0; i < 2; ++i) {
    const std::array<int, 2> around = draft.atlas().charts_of_edge[s.loops[i]];
    const int strip_chart = around[0] == draft.atlas().charts_of_edge[lines[i]][0] ||
                                    around[0] == draft.atlas().charts_of_edge[lines[i]][1]
                                ? around[0]
                                : around[1];
    Result<Strip> strip = Strip::of(draft, strip_chart);
    if (!strip) return strip.error();
    Result<Contour_edge> spoke = strip->line(branch_side[i], 0, 0);
    if (!spoke) return spoke.error();
    spokes[i] = std::move(*spoke);
  }
  const double value = draft.network.edges[s.loops[0]].value;
  reverse(spokes[0]);
  Contour_edge middle = joined(std::move(spokes[0]), spokes[1]);
  middle.from = draft.network.edges[lines[0]].from;
  middle.to = draft.network.edges[lines[1]].from;
  middle.left = middle.right = trunk_side;
  middle.value = value;
  for (int i = 0; i < 2; ++i) {
    draft.network.edges[lines[i]].value = value;
    draft.network.nodes[draft.network.edges[lines[i]].from].kind = Node_kind::half_saddle;
    remove_edge(draft.network, s.loops[i]);
  }
  draft.network.edges.push_back(std::move(middle));
  return draft.cut();
}

// Where the corners of the quarter-saddles lie on a loop: the numbers of two of its vertices.
Result<std::array<int, 2>> corners_on_loop(const Draft& draft, int loop,
                                           const std::vector<Surface_point>& points, double size) {
  const std::vector<int>& v = draft.network.edges[loop].vertices;
  std::vector<double> along(1, 0.0);
  for (std::size_t i = 1; i < v.size(); ++i)
    along.push_back(along.back() + (draft.position(v[i]) - draft.position(v[i - 1])).norm());
  std::array<int, 2> at{{-1, -1}};
  if (points.empty()) {
    const double distance = std::min(size, 0.25 * along.back());
    for (int i = 1; i + 1 < int(v.size()); ++i) {
      if (at[0] < 0 && along[i] >= distance) at[0] = i;
      if (along.back() - along[i] >= distance) at[1] = i;
    }
  } else {
    std::vector<int> nearest;
    for (const Surface_point& p : points)
      if (draft.contour_at(p.point) == loop) nearest.push_back(draft.vertex_of_contour_at(loop, p.point));
    std::sort(nearest.begin(), nearest.end());
    if (nearest.size() != 2)
      return refuse("each loop of the saddle needs two of the four points", {}, Element_kind::contour, loop);
    at = {nearest[0], nearest[1]};
  }
  if (at[0] < 1 || at[0] >= at[1] || at[1] + 1 >= int(v.size()))
    return refuse("there is no room for the corners on the saddle's contour", {}, Element_kind::contour,
                  loop);
  return at;
}

// A path around a visit of the saddle inside chart `c`, from contour vertex `from` to contour vertex `to` by
// way of a vertex straight across from number `visit` of the walk on `side`.
Result<Contour_edge> path_around(Draft& draft, int c, Side side, int visit, double size, int from, int to) {
  Result<Annulus_metric> metric = Annulus_metric::of(draft, c);
  if (!metric) return metric.error();
  const int apex = metric->vertex_across(side, visit, size);
  if (Result<void> good = check_branch_vertex(draft, apex, c); !good) return good.error();
  const int witness = draft.chart(c).walk(side).edges[0].edge;
  Result<int> line = draw_level_line(draft, Chart_index(c), Vertex_index(apex));
  if (!line) return line.error();
  if (Result<void> cut = draft.cut(); !cut) return cut.error();
  int strip_chart = -1;
  for (int around : draft.atlas().charts_of_edge[*line])
    for (const Walk& walk : draft.chart(around).walks)
      for (const Walk_edge& e : walk.edges)
        if (e.edge == witness && walk.side == side) strip_chart = around;
  Result<Strip> strip = Strip::of(draft, strip_chart);
  if (!strip) return strip.error();
  const Walk& walk = strip->chart().walk(side);
  std::array<Contour_edge, 2> halves;
  for (int i = 0; i < 2; ++i) {
    const int index = index_of(strip->chart(), walk, i == 0 ? from : to);
    if (index < 0) return refuse("there is no strip beside the contour to draw a line in");
    Result<Contour_edge> half = strip->line(side, index, 0);
    if (!half) return half.error();
    halves[i] = std::move(*half);
  }
  remove_edge(draft.network, *line);
  reverse(halves[1]);
  return joined(std::move(halves[0]), halves[1]);
}

// A path between two contour vertices in the plane through them that stands upright on the surface at
// `vertex` of it.
Result<Contour_edge> upright_path(Draft& draft, int vertex, int from, int to) {
  const Triangle_surface& surface = draft.surface();
  const Point a = draft.position(from), b = draft.position(to);
  const Eigen::Vector3d normal = (b - a).cross(normal_at(surface, vertex));
  if (!(normal.norm() > 0)) return refuse("there is no room for the corners on the saddle's contour");
  return plane_path(surface, draft.network, from, to, Cutting_plane::at(a, normal), 0.5 * (a + b));
}

// A loop of which the part between the network vertices `corner` is left, an edge between the nodes `ends`.
void keep_middle(Contour_network& network, int e, const std::array<int, 2>& corner,
                 const std::array<int, 2>& ends) {
  const Contour_edge loop = network.edges[e];
  Contour_edge rest = loop;
  const auto place = [&](int vertex) {
    return std::find(loop.vertices.begin(), loop.vertices.end(), vertex) - loop.vertices.begin();
  };
  const auto first = place(corner[0]), last = place(corner[1]);
  rest.vertices.assign(loop.vertices.begin() + first, loop.vertices.begin() + last + 1);
  rest.faces.assign(loop.faces.begin() + first, loop.faces.begin() + last);
  rest.from = ends[0];
  rest.to = ends[1];
  for (std::size_t k = 1; k + 1 < loop.vertices.size(); ++k) // the ends of the loop go
    if (network.is_crossing(loop.vertices[k]) && (int(k) < first || int(k) > last))
      network.crossings[loop.vertices[k] - network.surface_vertices].halfedge = -1;
  network.edges[e].vertices.clear();
  network.edges[e].faces.clear();
  network.edges.push_back(std::move(rest));
}

// A rectangle around the old saddle: its corners lie on the loops, its sides cut off the corners of the four
// sectors; straight ones lie in planes, the others go around by way of a point across from the saddle.
Result<void> split_in_quarters(Draft& draft, const Simple_saddle& s, const Split_saddle& edit,
                               bool straight) {
  if (!edit.points.empty() && edit.points.size() != 4)
    return make_error(Error_code::impossible_request, "quarter-saddles need four points, or none");
  const double size = usual_size(draft, edit.size), value = draft.network.edges[s.loops[0]].value;
  const std::array<int, 2> loops = s.loops;
  std::array<std::array<int, 2>, 2> corner; // per loop: the network vertices where its side begins and ends
  for (int i = 0; i < 2; ++i) {
    Result<std::array<int, 2>> at = corners_on_loop(draft, loops[i], edit.points, size);
    if (!at) return at.error();
    for (int k = 0; k < 2; ++k) corner[i][k] = draft.network.edges[loops[i]].vertices[(*at)[k]];
  }
  const std::array<Side, 2> branch_side{side_of(draft, loops[0], s.branches[0]),
                                        side_of(draft, loops[1], s.branches[1])};
  const Side trunk_side = side_of(draft, loops[0], s.trunk);
  const bool branch_on_left = draft.atlas().charts_of_edge[loops[0]][0] == s.branches[0];
  const auto chart_beside = [&](int loop, bool branch) {
    return draft.atlas().charts_of_edge[loop][branch == branch_on_left ? 0 : 1];
  };
  struct Rectangle_side {
    Contour_edge path;
    std::array<int, 2> ends; // network vertices
    bool faces_branch;
  };
  std::vector<Rectangle_side> sides;
  const auto add = [&](int loop, bool branch, int from, int to) -> Result<void> {
    const int c = chart_beside(loop, branch);
    const Side side = branch ? branch_side[loop == loops[0] ? 0 : 1] : trunk_side;
    // In a branch the saddle is visited at the beginning of the loop; in the trunk, before each of the loops.
    int visit = 0;
    for (const Walk_edge& e : draft.chart(c).walk(side).edges)
      if (e.edge == loop) visit = e.begin;
    Result<Contour_edge> path = straight ? upright_path(draft, s.vertex, from, to)
                                         : path_around(draft, c, side, visit, 0.7 * size, from, to);
    if (!path) return path.error();
    sides.push_back({std::move(*path), {from, to}, branch});
    return draft.cut();
  };
  for (int i = 0; i < 2; ++i)
    if (Result<void> added = add(loops[i], true, corner[i][1], corner[i][0]); !added) return added;
  for (int i = 0; i < 2; ++i) // the visit before loop i: after the other loop's end, before its own beginning
    if (Result<void> added = add(loops[i], false, corner[1 - i][1], corner[i][0]); !added) return added;
  std::map<int, int> node;
  for (const std::array<int, 2>& ends : corner)
    for (int end : ends)
      if (node.emplace(end, -1).second) node[end] = add_node(draft.network, end, Node_kind::quarter_saddle);
  for (int i = 0; i < 2; ++i)
    keep_middle(draft.network, loops[i], corner[i], {node.at(corner[i][0]), node.at(corner[i][1])});
  for (Rectangle_side& side : sides) {
    side.path.from = node.at(side.ends[0]);
    side.path.to = node.at(side.ends[1]);
    side.path.value = value;
    // The rectangle takes the place of the branches beside the trunk, and is on the same side as the branches
    // themselves.
    side.path.left = branch_on_left || side.faces_branch ? branch_side[0] : trunk_side;
    side.path.right = !branch_on_left || side.faces_branch ? branch_side[0] : trunk_side;
    draft.network.edges.push_back(std::move(side.path));
  }
  return draft.cut();
}

} // namespace

Result<void> apply_edit(Draft& draft, const Split_saddle& edit) {
  if (!(edit.size >= 0)) return make_error(Error_code::impossible_request, "a size is not negative");
  const int node = draft.saddle_at(edit.at.point);
  if (node < 0) return refuse("there is no saddle");
  Result<void> done;
  if (const Result<Simple_saddle> saddle = simple_saddle_at(draft, edit.at)) {
    for (bool straight : {true, false}) {
      Draft trial = draft;
      done = edit.kind == Saddle_kind::half ? split_in_halves(trial, *saddle, edit)
                                            : split_in_quarters(trial, *saddle, edit, straight);
      if (done) {
        draft.take(std::move(trial));
        return {};
      }
      if (edit.kind == Saddle_kind::half || done.error().code != Error_code::refused_edit) break;
    }
    if (!edit.points.empty() || done.error().code != Error_code::refused_edit) return done;
  }
  return split_saddle_by_sectors(draft, node, edit);
}

namespace {

int capped_disc_at(const Draft& draft, const Surface_point& at) {
  const int c = draft.chart_at(at);
  if (c < 0) return -1;
  if (draft.chart(c).kind == Chart_kind::disc) return c;
  for (const Walk& walk : draft.chart(c).walks) // the annulus beside a cap stands for the whole disc
    if (walk.edges.size() == 1) {
      const int beyond = chart_across(draft.atlas(), Contour_id(walk.edges[0].edge), Chart_index(c));
      if (beyond >= 0 && cap_contour(draft, beyond) == walk.edges[0].edge) return beyond;
    }
  return -1;
}

// Forgets an extremum that lies in a disc.
void forget_extremum(Draft& draft, const Chart& disc) {
  if (disc.extremum < 0) return;
  const int vertex = disc.vertex_origin[disc.extremum];
  draft.extrema.erase(std::remove_if(draft.extrema.begin(), draft.extrema.end(),
                                     [&](const Design_extremum& e) { return e.vertex == vertex; }),
                      draft.extrema.end());
}

} // namespace

Result<void> apply_edit(Draft& draft, const Pin_corners& edit) {
  const int c = capped_disc_at(draft, edit.at);
  const int cap = c >= 0 ? cap_contour(draft, c) : -1;
  if (cap < 0) return refuse("there is no cap whose corners could be pinned");
  const std::shared_ptr<const Chart> disc = draft.atlas().charts[c];
  const int annulus = chart_across(draft.atlas(), Contour_id(cap), Chart_index(c));
  const Walk& outer = draft.chart(annulus).walk(disc->walks[0].side);
  int visits = 0;
  for (const Walk_edge& e : outer.edges) {
    const Contour_edge& edge = draft.network.edges[e.edge];
    visits += draft.network.nodes[e.forward ? edge.from : edge.to].kind == Node_kind::half_saddle;
  }
  if (draft.chart(annulus).kind != Chart_kind::annulus || visits != 4)
    return refuse("the contour around the cap does not pass half-saddles four times", {}, Element_kind::chart,
                  draft.identity(c));
  remove_edge(draft.network, cap);
  forget_extremum(draft, *disc);
  return draft.cut();
}

namespace {

// The ends of a half-pole: as given, or across the cap in its longest direction.
Result<std::array<int, 2>> pole_ends(const Draft& draft, int disc, const std::vector<Surface_point>& ends) {
  if (!ends.empty()) {
    if (ends.size() != 2)
      return make_error(Error_code::impossible_request, "a half-pole needs two ends, or none");
    return std::array<int, 2>{draft.vertex_at(ends[0]), draft.vertex_at(ends[1])};
  }
  const Chart& chart = draft.chart(disc);
  Point mean = Point::Zero();
  const std::vector<int>& walk = chart.walks[0].vertices;
  for (int v : walk) mean += chart.mesh.points[v] / double(walk.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (int v : walk)
    spread += (chart.mesh.points[v] - mean) * (chart.mesh.points[v] - mean).transpose() / double(walk.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Eigen::Vector3d axis =
      axes.eigenvectors().col(2) * std::sqrt(std::max(0.0, axes.eigenvalues()[2])) * 0.7;
  const Point pole = chart.mesh.points[chart.extremum];
  std::array<int, 2> vertices{{-1, -1}};
  for (int side = 0; side < 2; ++side) {
    const Point wish = pole + (side == 0 ? axis : Eigen::Vector3d(-axis));
    double least = 0;
    for (std::size_t i = 0; i < chart.vertex_origin.size(); ++i) {
      const int origin = chart.vertex_origin[i];
      if (origin < 0 || origin >= draft.surface().number_of_vertices() || int(i) < int(walk.size())) continue;
      const double d = (chart.mesh.points[i] - wish).squaredNorm();
      if (vertices[side] >= 0 && d >= least) continue;
      vertices[side] = origin;
      least = d;
    }
  }
  return vertices;
}

// A disc spread on the unit circle, its walk by arc length.
Result<Chart_parameterization> round_map(const Draft& draft, const Chart& disc) {
  Result<Chart_parameterization> map = Chart_parameterization::prepare(
      disc, clamped_cotangent_weights(disc.mesh), draft.order_of(disc), draft.field_solver());
  if (!map) return map;
  const std::vector<int>& walk = disc.walks[0].vertices;
  std::vector<double> along(1, 0.0), x, y;
  for (std::size_t i = 0; i < walk.size(); ++i)
    along.push_back(along.back() +
                    (disc.mesh.points[walk[(i + 1) % walk.size()]] - disc.mesh.points[walk[i]]).norm());
  const bool clockwise = disc.walks[0].side == Side::high;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const double angle = 2 * pi * along[i] / along.back();
    x.push_back(std::cos(angle));
    y.push_back(clockwise ? -std::sin(angle) : std::sin(angle));
  }
  if (Result<void> solved = map->solve_rectangle(disc, x, y); !solved) return solved.error();
  return map;
}

Result<void> split_in_half_poles(Draft& draft, Design_extremum& extremum, const Split_pole& edit) {
  const int disc = draft.chart_of_vertex(extremum.vertex), cap = cap_contour(draft, disc);
  if (cap < 0) return refuse("the extremum has no cap");
  Result<std::array<int, 2>> ends = pole_ends(draft, disc, edit.ends);
  if (!ends) return ends.error();
  remove_edge(draft.network, cap);
  if (Result<void> cut = draft.cut(); !cut) return cut;
  const int whole = draft.chart_of_vertex(extremum.vertex);
  const std::shared_ptr<const Chart> chart = draft.atlas().charts[whole];
  Result<Chart_parameterization> map = round_map(draft, *chart);
  if (!map) return map.error();
  std::array<int, 2> local{{-1, -1}};
  for (int i = 0; i < 2; ++i) {
    if (draft.chart_of_vertex((*ends)[i]) != whole)
      return refuse("a point is not inside the chart that it is for", {}, Element_kind::vertex, (*ends)[i]);
    local[i] = int(std::find(chart->vertex_origin.begin(), chart->vertex_origin.end(), (*ends)[i]) -
                   chart->vertex_origin.begin());
  }
  if (local[0] == local[1]) return refuse("the ends of the half-pole are the same vertex");
  Result<Contour_edge> segment =
      trace_line(draft.surface(), *chart, *map, local[0], local[1], map->v()[local[1]], draft.network);
  if (!segment) return refuse("a line through a chart could not be followed");
  segment->left = segment->right = extremum.is_maximum ? Side::high : Side::low;
  segment->value = extremum.value;
  segment->from = add_node(draft.network, (*ends)[0], Node_kind::half_pole);
  segment->to = add_node(draft.network, (*ends)[1], Node_kind::half_pole);
  draft.network.edges.push_back(std::move(*segment));
  extremum.segment = int(draft.network.edges.size()) - 1;
  extremum.pole = Pole_kind::half;
  return draft.cut();
}

} // namespace

Result<void> apply_edit(Draft& draft, const Split_pole& edit) {
  const int i = draft.extremum_at(edit.at.point);
  if (i < 0) return refuse("there is no extremum");
  Design_extremum& extremum = draft.extrema[i];
  if (extremum.pole == edit.kind) return refuse("the pole is of this kind already");
  if (edit.kind == Pole_kind::half) return split_in_half_poles(draft, extremum, edit);
  if (extremum.segment < 0) { // the cap stays, with another texture
    const Design_chart& disc = *draft.before().charts[draft.origin(draft.chart_of_vertex(extremum.vertex))];
    if (disc.settings.locked)
      return refuse("the edit would change a locked chart", {}, Element_kind::chart, disc.id);
    draft.reset_textures.insert(disc.id);
    extremum.pole = edit.kind;
    return {};
  }
  const int annulus = draft.atlas().charts_of_edge[extremum.segment][0];
  const Contour_edge& segment = draft.network.edges[extremum.segment];
  const bool on_segment =
      std::find(segment.vertices.begin(), segment.vertices.end(), extremum.vertex) != segment.vertices.end();
  // The extremum returns to its vertex, unless a contour has come between that and the segment.
  const int vertex = on_segment || draft.chart_of_vertex(extremum.vertex) == annulus
                         ? extremum.vertex
                         : draft.network.nodes[segment.from].vertex;
  remove_edge(draft.network, extremum.segment);
  extremum = {vertex, extremum.is_maximum, extremum.value, edit.kind, -1};
  sort_by_vertex(draft.extrema);
  return redesign_region(draft, {annulus}, vertex, -1, 0);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
