// SPDX-License-Identifier: GPL-3.0-or-later
// Contours and saddles that move where a plane alone does not take them: others give way.
#include "base/segments.h"
#include "edits/redraw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The other loops at a loop's saddle, if there are only loops.
std::vector<int> siblings(const Draft& draft, int e) {
  const Contour_edge& edge = draft.network.edges[e];
  std::vector<int> others;
  if (edge.from != edge.to || draft.network.nodes[edge.from].kind != Node_kind::saddle) return others;
  for (int other : draft.edges_at(edge.from)) {
    if (draft.network.edges[other].from != draft.network.edges[other].to) return {};
    if (other != e && (others.empty() || others.back() != other)) others.push_back(other);
  }
  return others;
}

// The loops around the charts beside some edges: free ones, or also those at saddles.
std::vector<int> neighbours(const Draft& draft, const std::vector<int>& edges, bool at_saddles) {
  std::set<int> found;
  for (int e : edges)
    for (int c : draft.atlas().charts_of_edge[e])
      for (const Walk& walk : draft.chart(c).walks)
        for (const Walk_edge& passed : walk.edges) {
          const std::array<int, 2>& sides = draft.atlas().charts_of_edge[passed.edge];
          const bool is_inner = sides[0] >= 0 && sides[1] >= 0 && sides[0] != sides[1];
          const Contour_edge& edge = draft.network.edges[passed.edge];
          const bool is_loop =
              edge.from == edge.to && draft.network.nodes[edge.from].kind == Node_kind::saddle;
          if (is_inner && (draft.is_free_loop(passed.edge) || (at_saddles && is_loop)))
            found.insert(passed.edge);
        }
  for (int e : edges) found.erase(e);
  return {found.begin(), found.end()};
}

// How the area of a chart is distributed over its level lines: its vertices with their share of the area,
// from the low side up.
struct Level_area {
  std::vector<int> vertices; // of the chart
  std::vector<double> below; // the area below each, as a share
};

Result<Level_area> level_area(Draft& draft, int c) {
  const Result<std::vector<double>> level = level_field(draft, c);
  if (!level) return level.error();
  const Triangle_surface& mesh = draft.chart(c).mesh;
  std::vector<double> weight(level->size(), 0);
  for (int f = 0; f < mesh.number_of_faces(); ++f)
    for (int v : mesh.triangles[f]) weight[v] += area(mesh, f) / 3;
  Level_area result;
  result.vertices.resize(level->size());
  std::iota(result.vertices.begin(), result.vertices.end(), 0);
  std::sort(result.vertices.begin(), result.vertices.end(),
            [&](int a, int b) { return (*level)[a] != (*level)[b] ? (*level)[a] < (*level)[b] : a < b; });
  const double all = std::accumulate(weight.begin(), weight.end(), 0.0);
  double sum = 0;
  for (int v : result.vertices) {
    sum += weight[v];
    result.below.push_back(sum / all);
  }
  return result;
}

double share_below(const Draft& draft, int e) { // of the area of the two charts beside a contour
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
  const double above = area(draft.chart(sides[0]).mesh), below = area(draft.chart(sides[1]).mesh);
  return below / (above + below);
}

// A free loop becomes the level line of its two charts below which they have a share of their area.
Result<void> level_again(Draft& draft, int e, double below) {
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
  int inside = -1; // a vertex of the surface in one of the charts
  for (int c : sides)
    for (int v : draft.chart(c).vertex_origin)
      if (inside < 0 && v >= 0 && v < draft.surface().number_of_vertices() && draft.chart_of_vertex(v) == c)
        inside = v;
  if (inside < 0) return refuse("there is no room between the contours for another course");
  const int old = draft.replaced.count(e) ? draft.replaced[e] : e;
  remove_edge(draft.network, e);
  if (Result<void> cut = draft.cut(); !cut) return cut;
  const int c = draft.chart_of_vertex(inside);
  const Result<Level_area> areas = level_area(draft, c);
  if (!areas) return areas.error();
  int seed = -1;
  double least = 2;
  const Chart& chart = draft.chart(c);
  for (std::size_t i = 0; i < areas->vertices.size(); ++i) {
    const int v = areas->vertices[i], o = chart.vertex_origin[v];
    if (o < 0 || o >= draft.surface().number_of_vertices() || v == chart.extremum) continue;
    const double off = std::abs(areas->below[i] - below);
    if (off < least && draft.chart_of_vertex(o) == c) {
      least = off;
      seed = o;
    }
  }
  if (seed < 0) return refuse("there is no room between the contours for another course");
  const Result<int> line = draw_level_line(draft, Chart_index(c), Vertex_index(seed));
  if (!line) return line.error();
  draft.replaced[*line] = old;
  return draft.cut();
}

// Free loops that were pushed out of their place take a level line of what is left to them, if they can.
void level_pushed(Draft& draft, const std::vector<std::pair<int, double>>& pushed) {
  for (const auto& [e, below] : pushed)
    for (std::size_t fresh = 0; fresh < draft.network.edges.size(); ++fresh) {
      const auto found = draft.replaced.find(int(fresh));
      if (found == draft.replaced.end() || found->second != e ||
          draft.network.is_removed(draft.network.edges[fresh]))
        continue;
      Draft trial = draft;
      if (level_again(trial, int(fresh), below) && check_caps(trial)) draft.take(std::move(trial));
      break;
    }
}

// Fails where a chart has become so thin that it cannot be mapped, with the contour that is in the way of
// those that moved: one around that chart that has not.
Result<void> check_room(Draft& draft) {
  const int c = unmappable_chart(draft);
  if (c < 0) return {};
  int obstacle = -1;
  for (const Walk& walk : draft.chart(c).walks)
    for (const Walk_edge& e : walk.edges) {
      const auto old = draft.replaced.find(e.edge);
      if (obstacle < 0 || old == draft.replaced.end())
        obstacle = old == draft.replaced.end() ? e.edge : old->second;
    }
  return refuse("the contours would come too near to each other", {}, Element_kind::contour, obstacle);
}

// A contour that follows less of its plane than this is not what was asked for.
constexpr double least_share = 0.2;

struct Way {
  Draft draft;
  double share = 0;
  int obstacle = -1;
};

// How the other loops of a saddle make room.
enum class Style { pushed, short_ones };

// Draws `e` to a course, then the others where they were, as far as that is left to them; or loops of saddles
// as short as they can be.
Result<Way> redrawn(const Draft& draft, int e, const std::vector<int>& others, const Course& course,
                    Style style) {
  Way way{draft};
  std::vector<int> all{e};
  all.insert(all.end(), others.begin(), others.end());
  std::map<int, Course> old;
  std::map<int, double> below;
  for (int other : others) {
    old[other] = old_course(draft, other);
    if (draft.is_free_loop(other)) below[other] = share_below(draft, other);
  }
  Result<Redrawing> redrawing = Redrawing::of(way.draft, all);
  if (!redrawing) return redrawing.error();
  const Result<double> share = redrawing->draw(e, course, true);
  if (!share) return share.error();
  way.share = *share;
  way.obstacle = redrawing->obstacle();
  std::vector<std::pair<int, double>> pushed;
  for (int other : others) {
    if (style == Style::short_ones && !below.count(other)) {
      if (const Result<void> drawn = redrawing->draw_short(other); !drawn) return drawn.error();
      continue;
    }
    const Result<double> kept = redrawing->draw(other, old[other]);
    if (!kept) return kept.error();
    const int origin = draft.replaced.count(other) ? draft.replaced.at(other) : other;
    if (below.count(other) && *kept < 0.98) pushed.push_back({origin, below[other]});
  }
  if (Result<void> done = redrawing->finish(); !done) return done.error();
  level_pushed(way.draft, pushed);
  if (Result<void> room = check_room(way.draft); !room) return room.error();
  return way;
}

// The course of an edge that is dragged along when a point moves; what is far from it stays.
Course dragged_course(const Draft& draft, const Redrawing& redrawing, int edge,
                      const std::vector<Point>& points, const Point& from, const Point& to) {
  const Eigen::Vector3d way = to - from;
  const double reach = 3 * way.norm();
  return [&draft, &redrawing, edge, points, to, way, reach](const Point& p, int home) {
    const double r = reach > 0 ? (p - to).norm() / reach : 1;
    const Point q = r < 1 ? Point(p - (1 - r * r) * (1 - r * r) * way) : p;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i)
      least = std::min(least, squared_distance_to_segment(q, points[i - 1], points[i]));
    const int side = r < 1 ? redrawing.side_of(edge, draft.vertex_at({q, -1})) : home;
    return (side != 0 ? side : home) * std::sqrt(least);
  };
}

} // namespace

Result<void> move_towards_plane(Draft& draft, int e, const Point& point, const Eigen::Vector3d& normal) {
  constexpr double follows = 0.95; // of its length
  const Course course = plane_course(point, normal);
  const std::vector<int> loops = siblings(draft, e);
  std::vector<int> with_loops{e}, both = loops;
  with_loops.insert(with_loops.end(), loops.begin(), loops.end());
  for (int f : neighbours(draft, with_loops, false)) both.push_back(f);
  std::set<std::vector<int>> tried;
  std::optional<Way> best;
  Result<void> failure;
  const std::vector<std::vector<int>> ways{
      {}, neighbours(draft, {e}, false), loops, both, neighbours(draft, {e}, true)};
  for (Style style : {Style::pushed, Style::short_ones}) {
    if (best && best->share >= 2 * least_share) break;
    for (const std::vector<int>& others : ways) {
      if (style == Style::pushed ? !tried.insert(others).second : others.empty()) continue;
      Result<Way> way = redrawn(draft, e, others, course, style);
      if (!way) {
        if (failure) failure = way.error();
        continue;
      }
      if (best && way->share < best->share + 0.05) continue;
      best.emplace(std::move(*way));
      if (best->share >= follows) break;
    }
  }
  if (!best) return failure;
  if (best->share < least_share)
    return refuse("the plane leaves the charts beside the contour", "another contour is in the way",
                  Element_kind::contour, best->obstacle);
  draft.take(std::move(best->draft));
  draft.followed = best->share;
  return {};
}

namespace {

// Moves a saddle whose contours are the loops `edges` to a vertex; by planes of a normal, or dragged along
// with it.
Result<void> move_loops(Draft& draft, int node, int vertex, const std::vector<int>& edges,
                        const std::optional<Eigen::Vector3d>& normal) {
  std::map<int, std::vector<Point>> places; // of the loops as they are
  for (int e : edges)
    for (int v : draft.network.edges[e].vertices) places[e].push_back(draft.position(v));
  Result<Redrawing> redrawing = Redrawing::of(draft, edges);
  if (!redrawing) return redrawing.error();
  const Contour_node old = draft.network.nodes[node];
  const Point from = draft.position(old.vertex), to = draft.surface().points[vertex];
  const int fresh = old.vertex == vertex ? node : add_node(draft.network, vertex, old.kind);
  draft.network.nodes[fresh].multiplicity = old.multiplicity;
  redrawing->move_node(node, fresh);
  double followed = 0;
  for (int e : edges) {
    const Course course =
        normal ? plane_course(to, *normal) : dragged_course(draft, *redrawing, e, places[e], from, to);
    const Result<double> drawn = redrawing->draw(e, course, bool(normal));
    if (!drawn) return drawn.error();
    followed += *drawn / double(edges.size());
  }
  if (normal && followed < least_share)
    return refuse("the plane leaves the charts beside the contour", "another contour is in the way",
                  Element_kind::contour, redrawing->obstacle());
  draft.followed = normal ? followed : 1;
  if (Result<void> done = redrawing->finish(); !done) return done;
  return check_room(draft);
}

} // namespace

Result<void> move_saddle_with_loops(Draft& draft, Node_id node, Vertex_index vertex,
                                    const Eigen::Vector3d& normal) {
  std::vector<int> edges;
  for (int e : draft.edges_at(node)) {
    if (draft.network.edges[e].from != draft.network.edges[e].to)
      return refuse("the saddle shares its contour", {}, Element_kind::node, node);
    if (edges.empty() || edges.back() != e) edges.push_back(e);
  }
  std::optional<Eigen::Vector3d> plane;
  if (!normal.isZero(0)) plane = normal;
  return move_loops(draft, node, vertex, edges, plane);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
