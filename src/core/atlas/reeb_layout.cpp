// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas/given_field.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The vertices between an extremum and the first critical point that its level sets meet, in the order of
// their levels.
struct Extremal_disc {
  std::vector<int> vertices; // the extremum first
  bool ends_at_extremum = false;
};

Extremal_disc grow_disc(const Closed_surface& closed, const Vertex_order& order,
                        const std::vector<char>& is_critical, int extremum, bool is_maximum) {
  const Triangle_surface& s = closed.surface;
  const int n = s.number_of_vertices();
  const auto key = [&](int v) { return is_maximum ? n - 1 - order.rank[v] : order.rank[v]; };
  std::priority_queue<int, std::vector<int>, std::greater<int>> queue;
  std::unordered_map<int, bool> queued; // looked up only: its order is never used
  Extremal_disc disc;
  queue.push(key(extremum));
  queued[extremum] = true;
  while (!queue.empty()) {
    const int v = order.by_rank[is_maximum ? n - 1 - queue.top() : queue.top()];
    queue.pop();
    if (v != extremum && is_critical[v]) {
      disc.ends_at_extremum = is_critical[v] == 2;
      break;
    }
    disc.vertices.push_back(v);
    int h = s.outgoing[v];
    do {
      const int w = s.target(h);
      if (queued.emplace(w, true).second) queue.push(key(w));
      h = s.rotate_ccw(h);
    } while (h != s.outgoing[v]);
  }
  return disc;
}

struct Level_line {
  int inside = 0;                                     // number of disc vertices on the extremum's side
  double value = 0, length = 0, moment = 0, area = 0; // area between the line and the extremum
  double radius() const { return length > 0 ? moment / length : 0; }
};

// Some levels between the vertices of a disc, denser near the extremum.
std::vector<Level_line> choose_levels(const std::vector<double>& values, const std::vector<int>& disc) {
  constexpr int count = 48;
  const int m = int(disc.size());
  std::vector<Level_line> lines;
  for (int i = 1; i <= count; ++i) {
    const int inside = 1 + int((m - 1) * (double(i) / count) * (double(i) / count));
    if (inside >= m || (!lines.empty() && lines.back().inside == inside)) continue;
    Level_line line;
    line.inside = inside;
    line.value = 0.5 * (values[disc[inside - 1]] + values[disc[inside]]);
    lines.push_back(line);
  }
  return lines;
}

std::vector<int> faces_around(const Triangle_surface& s, const std::vector<int>& vertices) {
  std::vector<int> faces;
  for (int v : vertices) {
    int h = s.outgoing[v];
    do {
      faces.push_back(h / 3);
      h = s.rotate_ccw(h);
    } while (h != s.outgoing[v]);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// Adds the pieces of the lines in face `f`.
void add_pieces(const Triangle_surface& s, const std::vector<double>& values, int f, const Point& centre,
                bool is_maximum, std::vector<Level_line>& lines) {
  const auto before = [&](const Level_line& line, double value) {
    return is_maximum ? line.value > value : line.value < value;
  };
  Triangle t = s.triangles[f];
  std::sort(t.begin(), t.end(),
            [&](int a, int b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  const double u0 = values[t[0]], u1 = values[t[1]], u2 = values[t[2]];
  auto line = std::lower_bound(lines.begin(), lines.end(), is_maximum ? u2 : u0, before);
  for (; line != lines.end() && u0 < line->value && line->value < u2; ++line) {
    const double u = line->value;
    const Point &p0 = s.points[t[0]], &p1 = s.points[t[1]], &p2 = s.points[t[2]];
    const Point a = p0 + (u - u0) / (u2 - u0) * (p2 - p0);
    const Point b = u < u1 ? Point(p0 + (u - u0) / (u1 - u0) * (p1 - p0))
                           : Point(p1 + (u2 > u1 ? (u - u1) / (u2 - u1) : 0.0) * (p2 - p1));
    const double length = (b - a).norm();
    line->length += length;
    line->moment += length * (0.5 * (a + b) - centre).norm();
  }
}

// A face counts for the first line that has its last vertex inside; the lines' areas are sums of these.
void add_areas(const Triangle_surface& s, const std::vector<int>& disc, const std::vector<int>& faces,
               std::vector<Level_line>& lines) {
  const int m = int(disc.size());
  std::unordered_map<int, int> place; // looked up only
  for (int i = 0; i < m; ++i) place[disc[i]] = i;
  for (int f : faces) {
    int last = 0;
    for (int v : s.triangles[f]) {
      const auto found = place.find(v);
      last = std::max(last, found == place.end() ? m : found->second);
    }
    const auto line =
        std::upper_bound(lines.begin(), lines.end(), last,
                         [](int place_of_last, const Level_line& l) { return place_of_last < l.inside; });
    const Triangle& t = s.triangles[f];
    if (line != lines.end())
      line->area += 0.5 * (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]).norm();
  }
  for (std::size_t i = 1; i < lines.size(); ++i) lines[i].area += lines[i - 1].area;
}

// Lengths and mean distances from the extremum of some level lines of a disc, by summing over its triangles.
std::vector<Level_line> measure_levels(const Triangle_surface& s, const std::vector<double>& values,
                                       const std::vector<int>& disc, bool is_maximum) {
  std::vector<Level_line> lines = choose_levels(values, disc);
  const std::vector<int> faces = faces_around(s, disc);
  for (int f : faces) add_pieces(s, values, f, s.points[disc[0]], is_maximum, lines);
  add_areas(s, disc, faces, lines);
  return lines;
}

// How much larger the quads of a cap are than those around it: a square grid on a loop of length L has (L /
// 4)^2 of them in units of their edges there. A flat disc has 1.27, a cube's top with half of its sides 3.
double cap_stretch(const Level_line& line) {
  return 16 * line.area / (line.length * line.length);
}

int choose_cap_size(const std::vector<Level_line>& lines, bool ends_at_extremum) {
  double end = 0, longest = 0;
  for (const Level_line& line : lines) {
    end = std::max(end, line.radius());
    longest = std::max(longest, line.length);
  }
  // Two extrema that share a disc get a third each, so that their caps cannot meet.
  const double farthest = (ends_at_extremum ? 0.35 : 0.6) * end;
  const Level_line* best = nullptr;
  for (const Level_line& line : lines)
    if (line.length > 0 && cap_stretch(line) <= 2 && line.radius() <= farthest) best = &line;
  // A thin tip is stretched wherever it is cut: where it is a quarter as thick as at its root.
  for (std::size_t i = 0; !best && i < lines.size(); ++i)
    if (lines[i].length >= 0.25 * longest && lines[i].radius() <= farthest) best = &lines[i];
  return best ? best->inside : lines.empty() ? 1 : lines.front().inside;
}

struct Cap_site {
  int extremum;
  bool is_maximum;
  std::vector<int> disc;
  int inside;
};

Cap_site choose_cap(const Closed_surface& closed, const Vertex_order& order,
                    const std::vector<double>& values, const std::vector<char>& is_critical, int extremum,
                    bool is_maximum) {
  Extremal_disc disc = grow_disc(closed, order, is_critical, extremum, is_maximum);
  const std::vector<Level_line> lines = measure_levels(closed.surface, values, disc.vertices, is_maximum);
  int inside = choose_cap_size(lines, disc.ends_at_extremum);
  if (disc.ends_at_extremum) inside = std::min(inside, std::max(1, int(disc.vertices.size()) / 2));
  return {extremum, is_maximum, std::move(disc.vertices), inside};
}

Traced_contour trace_site(const Closed_surface& closed, const Vertex_order& order, const Cap_site& site) {
  const Triangle_surface& s = closed.surface;
  const int v = site.disc[site.inside - 1], rank = order.rank[v];
  int h = s.outgoing[v];
  while ((order.rank[s.target(h)] > rank) == site.is_maximum) h = s.rotate_ccw(h);
  return site.is_maximum ? trace_threshold(s, order, Rank(rank - 1), Halfedge_index(s.opposite[h]))
                         : trace_threshold(s, order, Rank(rank), Halfedge_index(h));
}

std::vector<char> critical_marks(const Closed_surface& closed, const Critical_points& critical) {
  std::vector<char> mark(closed.surface.number_of_vertices(), 0);
  for (int v : critical.saddles) mark[v] = 1;
  for (int v : critical.minima) mark[v] = 2;
  for (int v : critical.maxima) mark[v] = 2;
  // A boundary loop ends a disc as its apex does, before the flood climbs onto the loop.
  for (int h = 3 * closed.original_faces; h < closed.surface.number_of_halfedges(); ++h)
    if (const int v = closed.surface.source(h); mark[v] == 0) mark[v] = 1;
  return mark;
}

void erase_apexes(std::vector<int>& vertices, int original_vertices) {
  vertices.erase(
      std::remove_if(vertices.begin(), vertices.end(), [&](int v) { return v >= original_vertices; }),
      vertices.end());
}

} // namespace

Traced_contour trace_cap(const Closed_surface& closed, const Vertex_order& order,
                         const std::vector<double>& values, const Critical_points& critical, int extremum,
                         bool is_maximum) {
  return trace_site(
      closed, order,
      choose_cap(closed, order, values, critical_marks(closed, critical), extremum, is_maximum));
}

void close_field(const Closed_surface& closed, const std::vector<std::vector<int>>& loops,
                 const Designed_field& field, std::vector<double>& values, std::vector<signed char>& level) {
  values = field.values;
  if (loops.empty()) return;
  level.assign(closed.surface.number_of_vertices(), 0);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const signed char side = field.boundary_is_maximum[i] ? 1 : -1;
    for (int h : loops[i]) level[closed.surface.source(h)] = side;
    // The apex of a minimum must rank below its loop: values of a loop are made one, and the apex lies
    // beyond.
    const double value = field.values[closed.surface.source(loops[i][0])];
    for (int h : loops[i]) values[closed.surface.source(h)] = value;
    values.push_back(value + side * (1 + std::abs(value)));
    level[closed.original_vertices + i] = side;
  }
}

namespace {

// The contours through the saddles, and one around each extremum, whose cap it bounds.
std::vector<Traced_contour> trace_contours(const Closed_surface& closed, const Vertex_order& order,
                                           Reeb_layout& layout) {
  std::vector<Traced_contour> contours;
  for (int s : layout.critical.saddles)
    for (Traced_contour& loop : trace_contour(closed.surface, order, s)) contours.push_back(std::move(loop));
  const std::vector<char> is_critical = critical_marks(closed, layout.critical);
  erase_apexes(layout.critical.minima, closed.original_vertices);
  erase_apexes(layout.critical.maxima, closed.original_vertices);
  for (const bool is_maximum : {false, true})
    for (int v : is_maximum ? layout.critical.maxima : layout.critical.minima)
      contours.push_back(
          trace_site(closed, order, choose_cap(closed, order, layout.values, is_critical, v, is_maximum)));
  return contours;
}

} // namespace

Result<Reeb_layout> make_layout(const Triangle_surface& surface, const Designed_field& field,
                                int first_edge) {
  const std::vector<std::vector<int>> loops = boundary_loops(surface);
  CGAL_precondition(field.boundary_is_maximum.size() == loops.size());
  CGAL_precondition(int(field.values.size()) == surface.number_of_vertices());
  const Closed_surface closed = close_boundaries(surface);
  std::vector<int> minima = field.minima, maxima = field.maxima;
  for (std::size_t i = 0; i < loops.size(); ++i)
    (field.boundary_is_maximum[i] ? maxima : minima).push_back(closed.original_vertices + int(i));
  if (minima.empty() || maxima.empty())
    return make_error(Error_code::impossible_request, minima.empty()
                                                          ? "the field needs at least one minimum"
                                                          : "the field needs at least one maximum");

  Reeb_layout layout;
  std::vector<signed char> level;
  close_field(closed, loops, field, layout.values, level);
  Vertex_order order = order_vertices(layout.values, level);
  layout.cleanup_rounds = remove_extrema(closed.surface, minima, maxima, layout.values, order);
  layout.critical = critical_points(closed.surface, order);
  for (int v : layout.critical.saddles)
    if (v >= closed.original_vertices || surface.is_boundary(surface.outgoing[v]))
      return make_error(Error_code::impossible_request,
                        "a boundary vertex is a saddle: edges that join boundary vertices must be split",
                        Element_kind::vertex, v);
  for (const auto* wanted : {&minima, &maxima})
    for (int v : *wanted) {
      const std::vector<int>& found = wanted == &minima ? layout.critical.minima : layout.critical.maxima;
      if (!std::binary_search(found.begin(), found.end(), v)) layout.lost_extrema.push_back(v);
    }

  const std::vector<Traced_contour> contours = trace_contours(closed, order, layout);
  layout.network = build_network(surface, order, layout.values, contours, layout.critical.saddles,
                                 layout.critical.multiplicity);
  layout.network.edges.insert(layout.network.edges.begin(), first_edge, Contour_edge());
  for (std::size_t i = 0; i < loops.size(); ++i)
    add_boundary_contour(surface, loops[i], field.boundary_is_maximum[i],
                         layout.values[surface.source(loops[i][0])], layout.network);
  layout.values.resize(surface.number_of_vertices());

  Result<Embedding> embedding = embed(surface, layout.network);
  if (!embedding) return embedding.error();
  layout.embedding = std::move(*embedding);
  std::vector<int> extrema = layout.critical.minima;
  extrema.insert(extrema.end(), layout.critical.maxima.begin(), layout.critical.maxima.end());
  Result<Atlas> atlas = build_atlas(layout.embedding, layout.network, extrema);
  if (!atlas) return atlas.error();
  layout.atlas = std::move(*atlas);
  layout.graph = reeb_graph(layout.atlas, layout.network);
  return layout;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
