// SPDX-License-Identifier: GPL-3.0-or-later
// Splits saddles of any multiplicity, also where several share a contour, by the combinatorics of the
// contours around one node.
//
// 2k contours ("prongs") end at a saddle of multiplicity k - 1; between them lie 2k sectors, in turn below
// and above it. Each sector is one visit of a chart's walk. Half-saddles: in every sector of one kind the
// contour retreats across the sector to a new vertex with three prongs, which a spoke joins to the old one;
// that keeps k prongs, and is regular if k = 2. Quarter-saddles: a rectangle whose corners lie on the four
// prongs of a simple saddle cuts off the four sectors. A degenerate saddle is unfolded first: a new saddle on
// one of its prongs takes over the two prongs beside it, again and again, until all are simple.
#include "edits/steps.h"

#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

Error no_room(int node) {
  return refuse("there is no room around the saddle for its parts", {}, Element_kind::node, node);
}

// An end of a contour edge at the saddle.
struct Prong {
  int edge = -1;
  bool at_start = true;
  bool operator<(const Prong& o) const { return edge != o.edge ? edge < o.edge : at_start < o.at_start; }
  bool operator==(const Prong& o) const { return edge == o.edge && at_start == o.at_start; }
};

// A visit of the saddle by a chart's walk, which comes along one prong and leaves along another.
struct Sector {
  int chart = -1, walk = 0, index = 0;
  Side side = Side::low;
  Prong before, after;
};

std::vector<Sector> sectors_at(const Draft& draft, int node) {
  std::vector<Sector> sectors;
  for (std::size_t c = 0; c < draft.atlas().charts.size(); ++c) {
    const Chart& chart = draft.chart(int(c));
    for (std::size_t w = 0; w < chart.walks.size(); ++w) {
      const std::vector<Walk_edge>& edges = chart.walks[w].edges;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const Walk_edge &in = edges[(i + edges.size() - 1) % edges.size()], &out = edges[i];
        const Contour_edge& edge = draft.network.edges[out.edge];
        if ((out.forward ? edge.from : edge.to) != node) continue;
        sectors.push_back({int(c),
                           int(w),
                           out.begin,
                           chart.walks[w].side,
                           {in.edge, !in.forward},
                           {out.edge, out.forward}});
      }
    }
  }
  return sectors;
}

// What becomes of a prong: the edge begins at its vertex number `index`, or at the end of a path that leads
// there.
struct Trim {
  int index = -1;
  int node = -1;
  Contour_edge path;           // from the node to the vertex, or empty if the node is there
  bool keeps_the_rest = false; // another edge uses what is cut off
};

class Saddle_surgery {
public:
  Saddle_surgery(Draft& draft, int node, double size) : m_draft(draft), m_node(node), m_size(size) {}

  Result<void> begin() {
    m_sectors = sectors_at(m_draft, m_node);
    if (m_sectors.size() != m_draft.edges_at(m_node).size() || m_sectors.size() % 2 != 0)
      return refuse("the saddle lies on a boundary of the surface", {}, Element_kind::node, m_node);
    for (const Sector& s : m_sectors)
      if (m_draft.chart(s.chart).kind != Chart_kind::annulus)
        return refuse("the saddle's charts are not all annuli", {}, Element_kind::node, m_node);
    return {};
  }

  int number_of_prongs() const { return int(m_sectors.size()); }

  // The kind of sector of which more lie in charts of their own.
  Side better_side() const {
    std::array<std::set<int>, 2> charts;
    for (const Sector& s : m_sectors) charts[s.side == Side::high ? 1 : 0].insert(s.chart);
    return charts[1].size() > charts[0].size() ? Side::high : Side::low;
  }

  // Half-saddles in all sectors of a side; `points` are where they go, one for each, or none.
  Result<void> split_in_halves(Side side, const std::vector<int>& points) {
    std::vector<Contour_edge> spokes;
    std::vector<int> unused = points;
    const Side other = side == Side::low ? Side::high : Side::low;
    for (const Sector& s : m_sectors) {
      if (s.side != side) continue;
      Result<Place> place = place_of(s, m_size, m_size, points.empty() ? nullptr : &unused);
      if (!place) return place.error();
      const int node = add_node(m_draft.network, m_draft.chart(s.chart).vertex_origin[place->apex],
                                Node_kind::half_saddle);
      for (bool before : {true, false}) {
        Result<Contour_edge> path = line_from_apex(*place, before ? place->before : place->after);
        if (!path) return path.error();
        m_trims[before ? s.before : s.after] = {place->at(before).index, node, std::move(*path)};
      }
      Result<Contour_edge> spoke = line_from_apex(*place, place->saddle);
      if (!spoke) return spoke.error();
      spoke->from = node;
      spoke->to = m_node;
      spoke->left = spoke->right = other;
      spokes.push_back(std::move(*spoke));
    }
    const double value = m_draft.network.edges[m_sectors[0].before.edge].value;
    if (Result<void> trimmed = apply_trims(); !trimmed) return trimmed;
    if (spokes.size() == 2) { // the saddle itself is regular
      reverse(spokes[1]);
      const int to = spokes[1].to;
      spokes[0] = joined(std::move(spokes[0]), spokes[1]);
      spokes[0].to = to;
      spokes.pop_back();
    } else {
      m_draft.network.nodes[m_node].kind = Node_kind::half_saddle;
    }
    for (Contour_edge& spoke : spokes) {
      spoke.value = value;
      m_draft.network.edges.push_back(std::move(spoke));
    }
    return m_draft.cut();
  }

  // A rectangle of the given side around a simple saddle.
  Result<void> split_in_quarters(Side side) {
    if (m_sectors.size() != 4) return refuse("the saddle is degenerate", {}, Element_kind::node, m_node);
    std::vector<Contour_edge> sides;
    for (const Sector& s : m_sectors) {
      const Result<Place> place = place_of(s, m_size, 0.7 * m_size);
      if (!place) return place.error();
      Result<Contour_edge> path = around(*place);
      if (!path) return path.error();
      for (bool before : {true, false}) {
        const Prong& prong = before ? s.before : s.after;
        if (!m_trims.count(prong))
          m_trims[prong] = {
              place->at(before).index,
              add_node(m_draft.network, vertex_of(prong, place->at(before).index), Node_kind::quarter_saddle),
              {}};
      }
      path->from = m_trims[s.before].node;
      path->to = m_trims[s.after].node;
      // The chart is on the left of its LOW walk, and the rectangle on the other side.
      path->left = s.side == Side::low ? Side::low : side;
      path->right = s.side == Side::high ? Side::high : side;
      path->value = m_draft.network.edges[s.before.edge].value;
      sides.push_back(std::move(*path));
    }
    if (Result<void> trimmed = apply_trims(); !trimmed) return trimmed;
    for (Contour_edge& path : sides) m_draft.network.edges.push_back(std::move(path));
    return m_draft.cut();
  }

  // A simple saddle on one of the prongs takes over the two prongs beside it; returns its node.
  Result<int> unfold() {
    Prong middle = m_sectors[0].after;
    for (const Sector& s : m_sectors)
      if (length_of(s.after.edge) > length_of(middle.edge)) middle = s.after;
    int node = -1;
    for (const Sector& s : m_sectors) {
      if (!(s.before == middle) && !(s.after == middle)) continue;
      const bool comes =
          s.before == middle; // the walk comes along the middle prong and leaves along one beside it
      const Prong beside = comes ? s.after : s.before;
      const Result<Place> place = place_of(s, 2.5 * m_size, 0.8 * m_size);
      if (!place) return place.error();
      Result<Contour_edge> path = around(*place);
      if (!path) return path.error();
      if (!comes) reverse(*path);
      const int index = place->at(comes).index;
      if (node < 0) {
        node = add_node(m_draft.network, vertex_of(middle, index), Node_kind::saddle);
        m_draft.network.nodes[node].multiplicity = 1;
        m_trims[middle] = {index, node, {}, true};
      }
      m_trims[beside] = {place->at(!comes).index, node, std::move(*path)};
    }
    if (m_trims.size() != 3) return no_room(m_node);
    const Contour_edge whole = m_draft.network.edges[middle.edge];
    if (Result<void> trimmed = apply_trims(); !trimmed) return trimmed.error();
    Contour_edge link = whole;
    const int index = m_trims[middle].index;
    if (middle.at_start) {
      link.vertices.resize(std::size_t(index) + 1);
      link.faces.resize(std::size_t(index));
      link.to = node;
    } else {
      link.vertices.erase(link.vertices.begin(), link.vertices.begin() + index);
      link.faces.erase(link.faces.begin(), link.faces.begin() + index);
      link.from = node;
    }
    reverse(link); // the sectors beyond the prongs beside it meet on it now, each on the other side
    m_draft.network.edges.push_back(std::move(link));
    --m_draft.network.nodes[m_node].multiplicity;
    if (Result<void> cut = m_draft.cut(); !cut) return cut.error();
    return node;
  }

private:
  // A vertex on the border of a sector's chart, by its number on its edge, and its V as seen from the saddle.
  struct Border_point {
    int index = -1, local = -1;
    double v = 0;
  };
  // Where a sector is cut off.
  struct Place {
    Sector sector;
    const Chart_parameterization* map = nullptr;
    Border_point before, after, saddle;
    int apex = -1; // a vertex of the surface inside the chart
    double apex_v = 0;
    const Border_point& at(bool is_before) const { return is_before ? before : after; }
  };

  double length_of(int edge) const {
    const std::vector<int>& v = m_draft.network.edges[edge].vertices;
    double sum = 0;
    for (std::size_t i = 1; i < v.size(); ++i)
      sum += (m_draft.position(v[i]) - m_draft.position(v[i - 1])).norm();
    return sum;
  }
  int vertex_of(const Prong& prong, int index) const {
    return m_draft.network.edges[prong.edge].vertices[std::size_t(index)];
  }

  // The first vertex of a prong that is so far from the saddle, but none of its other half unless it is the
  // first; -1 if there is none.
  int index_at(const Prong& prong, double distance) const {
    const std::vector<int>& v = m_draft.network.edges[prong.edge].vertices;
    const double all = length_of(prong.edge);
    const int n = int(v.size());
    double along = 0;
    int best = -1;
    for (int k = 1; k + 1 < n; ++k) {
      const int i = prong.at_start ? k : n - 1 - k, previous = prong.at_start ? i - 1 : i + 1;
      along += (m_draft.position(v[std::size_t(i)]) - m_draft.position(v[std::size_t(previous)])).norm();
      if (best >= 0 && along >= 0.48 * all) break;
      best = i;
      if (along >= std::min(distance, 0.4 * all)) break;
    }
    return best;
  }

  Result<const Chart_parameterization*> map_of(int chart) {
    const auto known = m_maps.find(chart);
    if (known != m_maps.end()) return &known->second;
    Result<Chart_parameterization> map = m_draft.naturally_solved_map(chart);
    if (!map) return map.error();
    return &m_maps.emplace(chart, std::move(*map)).first->second;
  }

  // The place of a prong's vertex on the walk, from the visit on forwards or backwards.
  bool find_on_walk(const Sector& s, bool is_before, Border_point& point,
                    const Chart_parameterization& map) const {
    const Chart& chart = m_draft.chart(s.chart);
    const std::vector<int>& walk = chart.walks[std::size_t(s.walk)].vertices;
    const int n = int(walk.size()), vertex = vertex_of(is_before ? s.before : s.after, point.index);
    for (int k = 1; k < n; ++k) {
      const int i = ((s.index + (is_before ? -k : k)) % n + n) % n;
      if (chart.vertex_origin[walk[std::size_t(i)]] != vertex) continue;
      point.local = walk[std::size_t(i)];
      const double dv = map.v()[point.local] - map.v()[walk[std::size_t(s.index)]];
      point.v = dv - (is_before ? std::ceil(dv) : std::floor(dv));
      return true;
    }
    return false;
  }

  Result<Place> place_of(const Sector& s, double along, double across, std::vector<int>* points = nullptr) {
    Place place;
    place.sector = s;
    Result<const Chart_parameterization*> map = map_of(s.chart);
    if (!map) return map.error();
    place.map = *map;
    place.saddle.local = m_draft.chart(s.chart).walks[std::size_t(s.walk)].vertices[std::size_t(s.index)];
    for (bool before : {true, false}) {
      Border_point& point = before ? place.before : place.after;
      point.index = index_at(before ? s.before : s.after, along);
      if (point.index < 0 || !find_on_walk(s, before, point, **map)) return no_room(m_node);
    }
    if (!find_apex(across, points, place))
      return points ? refuse("a point is not inside the chart that it is for", {}, Element_kind::node, m_node)
                    : no_room(m_node);
    return place;
  }

  // The vertex of the surface inside the chart that is nearest to a point straight across, above the part
  // that is cut off; or one of the points given, which is then taken from them.
  bool find_apex(double across, std::vector<int>* points, Place& place) const {
    const Chart& chart = m_draft.chart(place.sector.chart);
    const Chart_parameterization& map = *place.map;
    const Height_profile& profile = map.profile();
    const bool is_low = place.sector.side == Side::low;
    const double part = std::min(across / profile.total(), 0.4),
                 u = profile.level_at(is_low ? part : 1 - part),
                 length = is_low ? profile.length.front() : profile.length.back();
    double least = 0;
    for (std::size_t i = 0; i < chart.vertex_origin.size(); ++i) {
      const int origin = chart.vertex_origin[i];
      if (origin < 0 || origin >= m_draft.surface().number_of_vertices() || map.u()[i] <= 0 ||
          map.u()[i] >= 1)
        continue;
      if (points && std::find(points->begin(), points->end(), origin) == points->end()) continue;
      double dv = map.v()[i] - map.v()[place.saddle.local];
      dv -= std::round(dv);
      if (!points && (dv <= 0.9 * place.before.v || dv >= 0.9 * place.after.v)) continue;
      const double x = dv * length, y = (map.u()[i] - u) * profile.total(), d = x * x + y * y;
      if (place.apex >= 0 && d >= least) continue;
      place.apex = int(i);
      place.apex_v = dv;
      least = d;
    }
    if (points && place.apex >= 0)
      points->erase(std::find(points->begin(), points->end(), chart.vertex_origin[place.apex]));
    return place.apex >= 0;
  }

  Result<Contour_edge> line_from_apex(const Place& place, const Border_point& to) {
    const double from_v = place.map->v()[place.apex];
    Result<Contour_edge> line =
        trace_line(m_draft.surface(), m_draft.chart(place.sector.chart), *place.map, place.apex, to.local,
                   from_v + to.v - place.apex_v, m_draft.network);
    if (!line) return refuse("a line through a chart could not be followed");
    return line;
  }

  // From the prong before the sector by way of the apex to the prong after it.
  Result<Contour_edge> around(const Place& place) {
    Result<Contour_edge> first = line_from_apex(place, place.before);
    if (!first) return first;
    const Result<Contour_edge> second = line_from_apex(place, place.after);
    if (!second) return second;
    reverse(*first);
    return joined(std::move(*first), *second);
  }

  Result<void> apply_trims() {
    std::set<int> edges;
    for (const auto& [prong, trim] : m_trims) edges.insert(prong.edge);
    for (int e : edges) {
      const Contour_edge old = m_draft.network.edges[e];
      const int last = int(old.vertices.size()) - 1;
      const auto start = m_trims.find({e, true}), end = m_trims.find({e, false});
      const bool has_start = start != m_trims.end(), has_end = end != m_trims.end();
      const int first = has_start ? start->second.index : 0, until = has_end ? end->second.index : last;
      if (first >= until) return no_room(m_node);
      Contour_edge rest = old;
      rest.vertices.assign(old.vertices.begin() + first, old.vertices.begin() + until + 1);
      rest.faces.assign(old.faces.begin() + first, old.faces.begin() + until);
      if (has_start) {
        rest.from = start->second.node;
        if (!start->second.path.vertices.empty()) rest = with_start(start->second.path, rest);
      }
      if (has_end) {
        rest.to = end->second.node;
        if (!end->second.path.vertices.empty()) rest = with_end(rest, end->second.path);
      }
      if (has_start && !start->second.keeps_the_rest) remove_crossings(old, 1, first);
      if (has_end && !end->second.keeps_the_rest) remove_crossings(old, until + 1, last);
      m_draft.network.edges[e].vertices.clear();
      m_draft.network.edges[e].faces.clear();
      m_draft.network.edges.push_back(std::move(rest));
    }
    return {};
  }

  static Contour_edge with_start(const Contour_edge& path, const Contour_edge& rest) {
    const Contour_edge whole = joined(path, rest);
    Contour_edge result = rest;
    result.vertices = whole.vertices;
    result.faces = whole.faces;
    return result;
  }
  static Contour_edge with_end(const Contour_edge& rest, Contour_edge path) {
    std::reverse(path.vertices.begin(), path.vertices.end());
    std::reverse(path.faces.begin(), path.faces.end());
    return joined(rest, path);
  }
  void remove_crossings(const Contour_edge& edge, int first, int end) {
    for (int k = first; k < end; ++k)
      if (const int v = edge.vertices[std::size_t(k)]; m_draft.network.is_crossing(v))
        m_draft.network.crossings[std::size_t(v - m_draft.network.surface_vertices)].halfedge = -1;
  }

  Draft& m_draft;
  int m_node;
  double m_size;
  std::vector<Sector> m_sectors;
  std::map<Prong, Trim> m_trims;
  std::map<int, Chart_parameterization> m_maps;
};

// One saddle, by the better kind of its sectors, or by the other.
Result<void> split_node(Draft& draft, int node, Saddle_kind kind, double size,
                        const std::vector<int>& points) {
  Result<void> done;
  for (const bool better : {true, false}) {
    Draft trial = draft;
    Saddle_surgery surgery(trial, node, size);
    if (Result<void> begun = surgery.begin(); !begun) return begun;
    const Side best = surgery.better_side(), other = best == Side::low ? Side::high : Side::low,
               side = better ? best : other;
    const Result<void> split =
        kind == Saddle_kind::half ? surgery.split_in_halves(side, points) : surgery.split_in_quarters(side);
    if (split) {
      draft.take(std::move(trial));
      return {};
    }
    if (better) done = split;
  }
  return done;
}

// Until all are simple; the nodes of all of them.
Result<std::vector<int>> unfold(Draft& draft, int node, double size) {
  std::vector<int> nodes{node};
  for (;;) {
    Saddle_surgery surgery(draft, node, size);
    if (Result<void> begun = surgery.begin(); !begun) return begun.error();
    if (surgery.number_of_prongs() <= 4) return nodes;
    const Result<int> fresh = surgery.unfold();
    if (!fresh) return fresh.error();
    nodes.push_back(*fresh);
  }
}

Result<void> split_all(Draft& draft, int node, Saddle_kind kind, double size,
                       const std::vector<int>& points) {
  const int prongs = int(draft.edges_at(node).size());
  if (prongs <= 4 || (kind == Saddle_kind::half && prongs == 6))
    return split_node(draft, node, kind, size, points);
  const Result<std::vector<int>> nodes = unfold(draft, node, size);
  if (!nodes) return nodes.error();
  for (int n : *nodes)
    if (Result<void> split = split_node(draft, n, kind, size, {}); !split) return split;
  return {};
}

} // namespace

Contour_edge joined(Contour_edge a, const Contour_edge& b) {
  a.vertices.insert(a.vertices.end(), b.vertices.begin() + 1, b.vertices.end());
  a.faces.insert(a.faces.end(), b.faces.begin(), b.faces.end());
  return a;
}

Result<void> split_saddle_by_sectors(Draft& draft, int node, const Split_saddle& edit) {
  draft.has_pushed_contours = true;
  std::vector<int> points;
  for (const Surface_point& p : edit.points) points.push_back(draft.vertex_at(p));
  if (edit.kind == Saddle_kind::quarter && !points.empty())
    return refuse("corners are chosen on a simple saddle's own contour only", {}, Element_kind::node, node);
  if (!points.empty() && 2 * points.size() != draft.edges_at(node).size())
    return make_error(Error_code::impossible_request, "half-saddles need a point for each, or none");
  const double size = edit.size > 0 ? edit.size : draft.edge_length;
  Result<void> done;
  for (double factor :
       {1.0, 0.5, 0.25, 2.0, 4.0}) { // smaller in narrow charts, larger where triangles are large
    Draft trial = draft;
    const Result<void> split = split_all(trial, node, edit.kind, factor * size, points);
    if (split) {
      draft.take(std::move(trial));
      return {};
    }
    if (done) done = split;
    if (!points.empty()) break;
  }
  return done;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
