// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/redraw.h"

#include "base/segments.h"
#include "edits/rubber_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

double height_of(Draft& draft, int c) {
  const Chart& chart = draft.chart(c);
  if (chart.kind == Chart_kind::annulus)
    if (const auto map = draft.map(c)) return (*map)->profile().total();
  return std::sqrt(area(chart.mesh));
}

// Vertices without a side get that of the nearest ones that have one.
void spread_sides(const Triangle_surface& mesh, std::vector<signed char>& home) {
  std::vector<int> queue;
  for (std::size_t v = 0; v < home.size(); ++v)
    if (home[v] != 0) queue.push_back(int(v));
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int v = queue[i], first = mesh.outgoing[v];
    const auto reach = [&](int w) {
      if (home[w] != 0) return;
      home[w] = home[v];
      queue.push_back(w);
    };
    int h = first;
    do {
      reach(mesh.target(h));
      reach(mesh.source(Triangle_surface::previous(h)));
      h = mesh.rotate_ccw(h);
    } while (h >= 0 && h != first);
  }
}

// Turns a closed contour so that it begins at the vertex that is nearest to a point.
void begin_near(const Draft& draft, const Point& point, Contour_edge& edge) {
  edge.vertices.pop_back();
  const auto nearer = [&](int a, int b) {
    return (draft.position(a) - point).squaredNorm() < (draft.position(b) - point).squaredNorm();
  };
  const auto first = std::min_element(edge.vertices.begin(), edge.vertices.end(), nearer);
  const auto shift = first - edge.vertices.begin();
  std::rotate(edge.vertices.begin(), first, edge.vertices.end());
  std::rotate(edge.faces.begin(), edge.faces.begin() + shift, edge.faces.end());
  edge.vertices.push_back(edge.vertices.front());
}

// The share of a curve that lies where its course is zero, and not where contours or order hold it.
double share_followed(const Triangle_surface& mesh, const Region_curve& curve,
                      const std::vector<double>& raw) {
  std::vector<Point> points;
  std::vector<char> follows;
  for (std::size_t i = 0; i < curve.exits.size(); ++i) {
    const int a = mesh.source(curve.exits[i]), b = mesh.target(curve.exits[i]);
    points.push_back(mesh.points[a] + curve.t[i] * (mesh.points[b] - mesh.points[a]));
    follows.push_back(raw[a] <= 0 && raw[b] >= 0);
  }
  double good = 0, all = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    all += length;
    good += 0.5 * length * (follows[i] + follows[i - 1]);
  }
  return all > 0 ? good / all : follows.empty() || follows[0] ? 1 : 0;
}

} // namespace

Course plane_course(const Point& point, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d n = normal.normalized();
  return [point, n](const Point& p, int) { return n.dot(p - point); };
}

Course old_course(const Draft& draft, int edge) {
  std::vector<Point> points;
  for (int v : draft.network.edges[edge].vertices) points.push_back(draft.position(v));
  return [points](const Point& p, int home) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i)
      least = std::min(least, squared_distance_to_segment(p, points[i - 1], points[i]));
    return home * std::sqrt(least);
  };
}

Result<Redrawing> Redrawing::of(Draft& draft, const std::vector<int>& edges) {
  Redrawing made(draft);
  made.m_edges = edges;
  std::set<int> charts;
  for (int e : edges) {
    const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
    if (sides[0] < 0 || sides[1] < 0)
      return refuse("the contour is a boundary of the surface", {}, Element_kind::contour, e);
    made.m_sides[e] = sides;
    made.m_old[e] = draft.network.edges[e];
    if (draft.is_free_loop(e)) made.m_free.insert(e);
    charts.insert(sides.begin(), sides.end());
    for (int side : {0, 1}) made.m_before.push_back(chart_beside(draft, e, side, {}));
  }
  made.m_charts.assign(charts.begin(), charts.end());
  if (Result<void> prepared = made.prepare_levels(); !prepared) return prepared.error();
  for (int e : edges) {
    made.m_homes[e] = made.homes_of_charts(e);
    if (made.m_homes[e].empty())
      return refuse("the contour has the same chart on both sides", {}, Element_kind::contour, e);
  }
  for (int e : edges) remove_edge(draft.network, e);
  return made;
}

int Redrawing::side_of(int edge, int vertex) const {
  const int c = m_chart_of_vertex[std::size_t(vertex)];
  return c < 0 ? 0 : m_homes.at(edge)[std::size_t(c)];
}

Result<void> Redrawing::prepare_levels() {
  const int n = m_draft.surface().number_of_vertices();
  m_chart_of_vertex.assign(std::size_t(n), -1);
  m_level.assign(std::size_t(n), 0.5);
  for (int c : m_charts) {
    const std::shared_ptr<const Chart> chart = m_draft.atlas().charts[c];
    const Result<std::vector<double>> level = level_field(m_draft, c); // rectangles have none
    m_height[c] = height_of(m_draft, c);
    std::vector<char> on_walk(chart->vertex_origin.size(), 0);
    for (const Walk& walk : chart->walks)
      for (int v : walk.vertices) on_walk[v] = 1;
    for (std::size_t v = 0; v < on_walk.size(); ++v) {
      const int o = chart->vertex_origin[v];
      if (on_walk[v] || o < 0 || o >= n) continue;
      m_chart_of_vertex[o] = c;
      if (level) m_level[o] = (*level)[v];
    }
  }
  return {};
}

// Per chart of the draft 1 on the left of an edge, -1 on its right, 0 elsewhere; nothing if the edge parts
// nothing.
std::vector<signed char> Redrawing::homes_of_charts(int edge) const {
  std::vector<signed char> home(m_draft.atlas().charts.size(), 0);
  for (int side : {0, 1}) {
    std::vector<int> stack{m_sides.at(edge)[side]};
    const auto sign = static_cast<signed char>(side == 0 ? 1 : -1);
    if (home[stack[0]] != 0) return {};
    home[stack[0]] = sign;
    while (!stack.empty()) {
      const int c = stack.back();
      stack.pop_back();
      for (const auto& [e, sides] : m_sides) {
        if (e == edge || (sides[0] != c && sides[1] != c)) continue;
        const int other = sides[0] == c ? sides[1] : sides[0];
        if (home[other] == -sign) return {};
        if (home[other] == 0) stack.push_back(other);
        home[other] = sign;
      }
    }
  }
  return home;
}

// A face of the region that an edge is drawn in: at an extremum, or at a contour that stays.
Result<int> Redrawing::face_beside(const Embedding& embedding, int edge) const {
  std::vector<int> charts{m_sides.at(edge)[0], m_sides.at(edge)[1]};
  for (std::size_t i = 0; i < charts.size(); ++i) { // and those beyond edges that are not drawn yet
    for (const auto& [e, sides] : m_sides)
      for (int side : {0, 1})
        if (!m_drawn.count(e) && sides[side] == charts[i] &&
            std::find(charts.begin(), charts.end(), sides[1 - side]) == charts.end())
          charts.push_back(sides[1 - side]);
    const Chart& chart = m_draft.chart(charts[i]);
    if (chart.extremum >= 0) {
      const int pole = chart.vertex_origin[chart.extremum];
      for (int f = 0; f < embedding.surface.number_of_faces(); ++f)
        for (int v : embedding.surface.triangles[f])
          if (v == pole) return f;
    }
    for (int h = 0; h < embedding.surface.number_of_halfedges(); ++h) {
      if (!embedding.is_wall(h)) continue;
      const Wall& wall = embedding.walls[embedding.wall_of[h]];
      if (m_origin.count(wall.edge) || wall.edge >= int(m_draft.atlas().charts_of_edge.size())) continue;
      if (m_draft.atlas().charts_of_edge[wall.edge][wall.forward ? 0 : 1] == charts[i]) return h / 3;
    }
  }
  return refuse("there is no room between the contours for another course");
}

std::vector<signed char> Redrawing::homes(const Open_region& region,
                                          const std::vector<signed char>& of_chart) const {
  std::vector<signed char> home(region.chart.vertex_origin.size(), 0);
  for (std::size_t v = 0; v < home.size(); ++v) {
    int chart = -1;
    if (region.is_on_border(int(v))) {
      const Region_wall& wall = region.walls[v];
      const auto drawn = m_origin.find(wall.edge);
      chart = drawn != m_origin.end() ? m_sides.at(drawn->second)[wall.side]
                                      : m_draft.atlas().charts_of_edge[wall.edge][wall.side];
    } else if (const int o = region.chart.vertex_origin[v]; o >= 0 && o < int(m_chart_of_vertex.size())) {
      chart = m_chart_of_vertex[o];
    }
    if (chart >= 0) home[v] = of_chart[chart];
  }
  spread_sides(region.chart.mesh, home);
  return home;
}

// The contour keeps off extrema and their neighbours.
void Redrawing::hold_extrema(Asked& asked) const {
  const std::vector<int>& origin = asked.region.chart.vertex_origin;
  const Triangle_surface& mesh = asked.region.chart.mesh;
  for (int c : m_charts) {
    const Chart& chart = m_draft.chart(c);
    if (chart.extremum < 0) continue;
    const auto found = std::find(origin.begin(), origin.end(), chart.vertex_origin[chart.extremum]);
    if (found == origin.end()) continue;
    const int pole = int(found - origin.begin()), first = mesh.outgoing[pole];
    asked.sides.held.push_back(pole);
    int h = first;
    do {
      const int v = mesh.target(h);
      if (!asked.region.is_on_border(v) && asked.sides.home[v] == asked.sides.home[pole])
        asked.sides.held.push_back(v);
      h = mesh.rotate_ccw(h);
    } while (h >= 0 && h != first);
  }
}

// The course leaves some room before contours that stay and around extrema.
void Redrawing::keep_off(int edge, Asked& asked) const {
  const std::vector<signed char>& of_chart = m_homes.at(edge);
  const std::vector<int>& origin = asked.region.chart.vertex_origin;
  std::map<int, int> far_side; // of a chart: where nothing is drawn
  for (int c : m_charts) {
    std::array<bool, 2> is_drawn{{false, false}};
    for (const Walk& walk : m_draft.chart(c).walks)
      for (const Walk_edge& e : walk.edges)
        if (m_sides.count(e.edge)) is_drawn[walk.side == Side::high ? 1 : 0] = true;
    if (is_drawn[0] != is_drawn[1]) far_side[c] = is_drawn[0] ? 1 : 0;
  }
  asked.sides.wish = asked.raw;
  for (std::size_t v = asked.region.walls.size(); v < origin.size(); ++v) {
    const int o = origin[v], c = o >= 0 && o < int(m_chart_of_vertex.size()) ? m_chart_of_vertex[o] : -1;
    if (c < 0 || of_chart[c] == 0 || !far_side.count(c)) continue;
    const bool is_disc = m_draft.chart(c).kind == Chart_kind::disc;
    const double room = is_disc ? 0.35 : std::clamp(m_draft.edge_length / m_height.at(c), 0.08, 0.25);
    const double level = far_side[c] == 1 ? m_level[o] : 1 - m_level[o];
    const double beyond = (level - (1 - room)) * m_height.at(c);
    double& wish = asked.sides.wish[v];
    wish = of_chart[c] > 0 ? std::max(wish, beyond) : std::min(wish, -beyond);
  }
}

// The visits of the edge's nodes where it lay before, or where its course goes if a node has moved: its right
// side comes before its left one where it begins, after it where it ends.
bool Redrawing::find_ends(int edge, Asked& asked) const {
  if (m_free.count(edge)) return true;
  const Triangle_surface& mesh = asked.region.chart.mesh;
  const std::vector<int>& origin = asked.region.chart.vertex_origin;
  const auto visit_of = [&](int node, bool begins) {
    const int vertex = m_draft.network.nodes[node].vertex;
    int best = -1, most = -1;
    for (std::size_t v = 0; v < origin.size(); ++v) {
      if (origin[v] != vertex) continue;
      int turns = 0, before = 0, around = 0;
      const int first = mesh.outgoing[v];
      int h = first;
      const auto pass = [&](int w) {
        const int side =
            !m_moved_nodes.empty() && asked.raw[w] != 0 ? (asked.raw[w] > 0 ? 1 : -1) : asked.sides.home[w];
        if (before != 0 && before != side && (before < 0) == begins) ++turns;
        before = side;
        ++around;
      };
      do {
        pass(mesh.target(h));
        const int last = Triangle_surface::previous(h);
        h = mesh.opposite[last];
        if (h < 0) pass(mesh.source(last));
      } while (h >= 0 && h != first);
      const int rank = 1000 * turns + around;
      if (rank <= most) continue;
      most = rank;
      best = int(v);
    }
    return best;
  };
  const Contour_edge& old = m_old.at(edge);
  asked.sides.from = visit_of(node_of(old.from), true);
  asked.sides.to = visit_of(node_of(old.to), false);
  // A saddle inside the region is one vertex, and so is the only visit of a loop that has moved.
  return asked.sides.from >= 0 && asked.sides.to >= 0;
}

Result<Redrawing::Asked> Redrawing::ask(int edge, const Course& course) {
  const std::vector<int> faces = faces_of_charts(m_draft.surface(), m_draft.atlas(), m_charts);
  const Result<Embedding> embedding = embed(m_draft.surface(), m_draft.network, faces);
  if (!embedding) return refuse("the contour would touch another contour");
  const Result<int> face = face_beside(*embedding, edge);
  if (!face) return face.error();
  Result<Open_region> region = open_region(*embedding, m_draft.network, *face);
  if (!region)
    return refuse("the regions between the contours would not all be charts", region.error().message);
  Asked asked{std::move(*region), {}, {}};
  asked.sides.home = homes(asked.region, m_homes.at(edge));
  const std::vector<Point>& points = asked.region.chart.mesh.points;
  for (std::size_t v = 0; v < points.size(); ++v) asked.raw.push_back(course(points[v], asked.sides.home[v]));
  hold_extrema(asked);
  if (!find_ends(edge, asked))
    return refuse("there is no room between the contours for another course", {}, Element_kind::contour,
                  edge);
  return asked;
}

Result<void> Redrawing::insert(int edge, const Asked& asked, const Region_curve& curve) {
  const Contour_edge& old = m_old.at(edge);
  const bool is_free = m_free.count(edge) > 0;
  const int from = node_of(old.from), to = node_of(old.to);
  const auto vertex = [&](int node) { return is_free ? -1 : m_draft.network.nodes[node].vertex; };
  Result<Contour_edge> made =
      contour_of_curve(m_draft.surface(), asked.region, curve, vertex(from), vertex(to), m_draft.network);
  if (!made) return made.error();
  if (is_free) begin_near(m_draft, m_draft.position(m_draft.network.nodes[from].vertex), *made);
  made->from = is_free ? add_node(m_draft.network, made->vertices.front()) : from;
  made->to = is_free ? made->from : to;
  made->value = old.value;
  made->left = old.left;
  made->right = old.right;
  const int fresh = int(m_draft.network.edges.size());
  m_draft.network.edges.push_back(std::move(*made));
  m_drawn[edge] = fresh;
  m_origin[fresh] = edge;
  m_draft.replaced[fresh] = m_draft.replaced.count(edge) ? m_draft.replaced[edge] : edge;
  for (Design_extremum& e : m_draft.extrema)
    if (e.segment == edge) e.segment = fresh;
  return {};
}

struct Redrawing::Drawing {
  Region_curve curve;
  double share = 0;
};

Result<Redrawing::Drawing> Redrawing::drawing(int edge, Asked asked) const {
  keep_off(edge, asked);
  const Result<std::vector<signed char>> sides = part_region(asked.region, asked.sides);
  if (!sides) return sides.error();
  Result<Region_curve> curve = curve_between(asked.region, *sides, asked.sides);
  if (!curve) return curve.error();
  const double share = share_followed(asked.region.chart.mesh, *curve, asked.raw);
  return Drawing{std::move(*curve), share};
}

// The contour most of whose vertices lie on the wrong side of the course.
int Redrawing::wall_against(const Asked& asked) const {
  std::map<int, int> against;
  for (std::size_t v = 0; v < asked.region.walls.size(); ++v)
    if (asked.raw[v] * asked.sides.home[v] < 0) ++against[asked.region.walls[v].edge];
  int most = -1;
  for (const auto& [e, number] : against)
    if (most < 0 || number > against[most]) most = e;
  return most;
}

Result<double> Redrawing::draw(int edge, const Course& course, bool either_sense) {
  Result<Asked> asked = ask(edge, course);
  if (!asked) return asked.error();
  Result<Drawing> best = drawing(edge, *asked);
  m_obstacle = wall_against(*asked);
  if (either_sense && (!best || best->share < 0.95)) {
    for (double& x : asked->raw) x = -x;
    Result<Drawing> other = drawing(edge, *asked);
    if (other && (!best || other->share > best->share)) {
      best = std::move(other);
      m_obstacle = wall_against(*asked);
    }
  }
  if (!best) return best.error();
  if (Result<void> inserted = insert(edge, *asked, best->curve); !inserted) return inserted.error();
  return best->share;
}

Result<void> Redrawing::draw_short(int edge) {
  const Course stay = [](const Point&, int home) { return double(home); };
  Result<Asked> asked = ask(edge, stay);
  if (!asked) return asked.error();
  asked->sides.wish = asked->raw;
  const Result<std::vector<signed char>> sides = part_region(asked->region, asked->sides);
  if (!sides) return sides.error();
  Result<Region_curve> curve = curve_between(asked->region, *sides, asked->sides);
  if (!curve) return curve.error();
  std::vector<char> is_wall(asked->region.chart.mesh.points.size(), 0);
  std::fill_n(is_wall.begin(), asked->region.walls.size(), char(1));
  for (int v : asked->sides.held) is_wall[std::size_t(v)] = 1;
  Band band{std::move(curve->exits), std::move(curve->t), asked->sides.from, asked->sides.to};
  band = tightened(asked->region.chart.mesh, std::move(band), 200, is_wall);
  if (band.exit.empty() || (asked->sides.from < 0 && band.exit.size() < 3))
    return refuse("the contour would shrink to a point");
  return insert(edge, *asked, {std::move(band.exit), std::move(band.t)});
}

Result<void> Redrawing::finish() {
  m_draft.has_pushed_contours = true;
  if (Result<void> cut = m_draft.cut(); !cut) return cut;
  std::vector<Chart_signature> after;
  for (int e : m_edges)
    for (int side : {0, 1}) after.push_back(chart_beside(m_draft, m_drawn.at(e), side, m_origin));
  if (after != m_before) return refuse("the contour would change the topology of the field");
  return check_caps(m_draft);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
