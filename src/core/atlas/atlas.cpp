// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Atlas.h>

#include "atlas/cut_part.h"
#include "atlas/region_curve.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Colours faces by the regions between walls; regions are numbered by their smallest face, and list their
// faces in order.
std::vector<std::vector<int>> flood_regions(const Embedding& embedding, std::vector<int>& region_of_face) {
  const Triangle_surface& s = embedding.surface;
  std::vector<int> sizes, stack;
  region_of_face.assign(s.number_of_faces(), -1);
  for (int first = 0; first < s.number_of_faces(); ++first) {
    if (region_of_face[first] >= 0) continue;
    const int region = int(sizes.size());
    sizes.push_back(1);
    stack.assign(1, first);
    region_of_face[first] = region;
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int o = s.opposite[h];
        if (o < 0 || embedding.is_wall(h) || region_of_face[o / 3] >= 0) continue;
        region_of_face[o / 3] = region;
        ++sizes[region];
        stack.push_back(o / 3);
      }
    }
  }
  std::vector<std::vector<int>> regions(sizes.size());
  for (std::size_t r = 0; r < regions.size(); ++r) regions[r].reserve(sizes[r]);
  for (int f = 0; f < s.number_of_faces(); ++f) regions[region_of_face[f]].push_back(f);
  return regions;
}

// The vertices of a face, the smallest first.
Triangle rotated(const Triangle& t) {
  const int i = int(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
}

// Orders a region's faces by their original faces, and the pieces of one by their vertices: an order that
// does not depend on how many pieces there are elsewhere.
void sort_faces(const Embedding& embedding, std::vector<int>& faces) {
  const auto base = [&](int f) { return embedding.base_face[f]; };
  const auto by_base = [&](int f, int g) { return base(f) < base(g); };
  // Faces of the surface come first, then further pieces: both are in order.
  std::inplace_merge(faces.begin(), std::is_sorted_until(faces.begin(), faces.end(), by_base), faces.end(),
                     by_base);
  for (auto first = faces.begin(), last = first; first != faces.end(); first = last) {
    while (last != faces.end() && base(*last) == base(*first)) ++last;
    if (last - first > 1)
      std::sort(first, last, [&](int f, int g) {
        return rotated(embedding.surface.triangles[f]) < rotated(embedding.surface.triangles[g]);
      });
  }
}

// The edges of a walk that begin at a half- or quarter-saddle, or at a corner.
std::vector<int> corners_of(const Contour_network& network, const Walk& walk) {
  std::vector<int> visits;
  for (std::size_t i = 0; i < walk.edges.size(); ++i) {
    const Contour_edge& edge = network.edges[walk.edges[i].edge];
    const Node_kind kind = network.nodes[walk.edges[i].forward ? edge.from : edge.to].kind;
    if (kind == Node_kind::half_saddle || kind == Node_kind::quarter_saddle || kind == Node_kind::corner)
      visits.push_back(int(i));
  }
  return visits;
}

// Cuts one region out of the embedded surface. The scratch arrays are shared by all regions, since they are
// disjoint.
class Chart_builder {
public:
  Chart_builder(const Embedding& embedding, const Contour_network& network, const std::vector<int>& extrema)
      : m_embedding(embedding), m_network(network), m_local_face(embedding.surface.number_of_faces(), -1),
        m_local_vertex(embedding.surface.number_of_vertices(), -1),
        m_on_wall(embedding.surface.number_of_vertices(), 0), m_is_extremum(m_on_wall.size(), 0) {
    const Triangle_surface& s = embedding.surface;
    for (int h = 0; h < s.number_of_halfedges(); ++h)
      if (is_border(h)) m_on_wall[s.source(h)] = m_on_wall[s.target(h)] = 1;
    for (int v : extrema) m_is_extremum[v] = 1;
  }

  // Takes regions of any topology from now on; with `mixed` also borders that are upper and lower in turn.
  void accept_regions(bool mixed = false) {
    m_any_topology = true;
    m_mixed = mixed;
  }

  // A field will have one value on all walks of a side.
  void split_between_walks() { m_one_value_a_side = true; }

  // Of the region that was built last: per vertex on its border the wall that begins there.
  std::vector<Region_wall> take_walls() { return std::move(m_walls); }

  Result<Chart> build(const std::vector<int>& faces, int index) {
    m_index = index;
    m_chart = Chart();
    m_walls.clear();
    if (m_any_topology) m_chart.kind = Chart_kind::region;
    m_extrema.clear();
    copy_faces(faces);
    if (Result<void> walked = trace_walks(faces); !walked) return walked.error();
    number_interior_vertices(faces);
    if (!m_any_topology)
      if (Result<void> valid = classify(); !valid) return valid.error();
    split_chords();
    renew_outgoing();
    return std::move(m_chart);
  }

private:
  bool is_border(int h) const { return m_embedding.surface.opposite[h] < 0 || m_embedding.is_wall(h); }
  Error bad(const std::string& what) const {
    return make_error(Error_code::internal_error, "a region between contours " + what, Element_kind::chart,
                      m_index);
  }

  void copy_faces(const std::vector<int>& faces) {
    const Triangle_surface& s = m_embedding.surface;
    for (int i = 0; i < int(faces.size()); ++i) m_local_face[faces[i]] = i;
    Triangle_surface& mesh = m_chart.mesh;
    mesh.triangles.assign(faces.size(), {-1, -1, -1});
    mesh.opposite.assign(3 * faces.size(), -1);
    m_chart.face_origin.resize(faces.size());
    for (int i = 0; i < int(faces.size()); ++i) {
      m_chart.face_origin[i] = m_embedding.base_face[faces[i]];
      for (int k = 0; k < 3; ++k) {
        const int h = 3 * faces[i] + k;
        if (is_border(h)) continue;
        const int o = s.opposite[h];
        mesh.opposite[3 * i + k] = 3 * m_local_face[o / 3] + o % 3;
      }
    }
  }

  int add_vertex(int origin, const Point& point) {
    m_chart.vertex_origin.push_back(origin);
    m_chart.mesh.points.push_back(point);
    return m_chart.mesh.number_of_vertices() - 1;
  }

  // Follows the border with the region on the left. Turning around the target of a border halfedge inside the
  // region until the next border halfedge enumerates exactly the corners of one visit: they share one local
  // vertex.
  Result<void> trace_walks(const std::vector<int>& faces) {
    const Triangle_surface& s = m_embedding.surface;
    std::vector<char> seen(3 * faces.size(), 0);
    for (int f : faces)
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        if (!is_border(h) || seen[local(h)]) continue;
        std::vector<int> halfedges;
        for (int g = h; !seen[local(g)];) {
          seen[local(g)] = 1;
          halfedges.push_back(g);
          const int vertex = add_vertex(s.target(g), s.points[s.target(g)]);
          for (g = Triangle_surface::next(g);; g = Triangle_surface::next(s.opposite[g])) {
            corner(g) = vertex;
            if (is_border(g)) break;
          }
        }
        if (Result<void> walked = add_walk(halfedges); !walked) return walked;
      }
    return {};
  }
  int local(int h) const { return 3 * m_local_face[h / 3] + h % 3; }
  int& corner(int h) { return m_chart.mesh.triangles[m_local_face[h / 3]][h % 3]; }

  struct Step {
    int vertex; // local, where the step begins
    Wall wall;
  };

  Result<void> add_walk(const std::vector<int>& halfedges) {
    std::vector<Step> steps;
    for (int h : halfedges) {
      const int wall = m_embedding.wall_of[h];
      if (wall < 0) return bad("ends at a boundary that is not a contour");
      steps.push_back({corner(h), m_embedding.walls[wall]});
    }
    if (m_mixed) {
      for (const Step& step : steps) {
        m_walls.resize(std::max(m_walls.size(), std::size_t(step.vertex) + 1));
        m_walls[step.vertex] = {step.wall.edge, step.wall.forward ? 0 : 1};
      }
      return {};
    }
    Walk walk;
    const auto side = [&](const Wall& w) {
      const Contour_edge& e = m_network.edges[w.edge];
      return w.forward ? e.left : e.right;
    };
    walk.side = side(steps[0].wall);
    for (const Step& step : steps)
      if (side(step.wall) != walk.side) return bad("has a boundary that is both upper and lower");
    if (walk.side == Side::high) reverse(steps);
    if (!rotate_to_node(steps)) return bad("has a boundary without a node");
    for (int i = 0; i < int(steps.size()); ++i) {
      walk.vertices.push_back(steps[i].vertex);
      const Wall& w = steps[i].wall;
      const int last = int(m_network.edges[w.edge].faces.size()) - 1;
      if (w.segment == (w.forward ? 0 : last)) walk.edges.push_back({w.edge, w.forward, i});
    }
    m_chart.walks.push_back(std::move(walk));
    return {};
  }

  // A step begins at its vertex, so in the reverse order each step takes the vertex where it ended.
  static void reverse(std::vector<Step>& steps) {
    const int n = int(steps.size());
    std::vector<Step> reversed;
    for (int i = n - 1; i >= 0; --i) {
      reversed.push_back({steps[(i + 1) % n].vertex, steps[i].wall});
      reversed.back().wall.forward = !reversed.back().wall.forward;
    }
    steps = std::move(reversed);
  }

  // Begins at the node whose contour edge has the smallest index.
  bool rotate_to_node(std::vector<Step>& steps) const {
    int best = -1;
    for (int i = 0; i < int(steps.size()); ++i) {
      const Wall& w = steps[i].wall;
      const int last = int(m_network.edges[w.edge].faces.size()) - 1;
      if (w.segment == (w.forward ? 0 : last) && (best < 0 || w.edge < steps[best].wall.edge)) best = i;
    }
    if (best < 0) return false;
    std::rotate(steps.begin(), steps.begin() + best, steps.end());
    return true;
  }

  void number_interior_vertices(const std::vector<int>& faces) {
    const Triangle_surface& s = m_embedding.surface;
    for (int f : faces)
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int v = s.source(h);
        if (m_on_wall[v]) continue;
        if (m_local_vertex[v] < 0) {
          m_local_vertex[v] = add_vertex(v, s.points[v]);
          if (m_is_extremum[v]) m_extrema.push_back(m_local_vertex[v]);
        }
        corner(h) = m_local_vertex[v];
      }
  }

  Result<void> classify() {
    const Triangle_surface& mesh = m_chart.mesh;
    int edges = 0;
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      edges += mesh.opposite[h] < 0 || h < mesh.opposite[h];
    const int chi = mesh.number_of_vertices() - edges + mesh.number_of_faces();
    std::vector<Walk>& walks = m_chart.walks;
    const std::vector<int> extrema = std::move(m_extrema);
    m_extrema.clear();
    if (chi == 0 && walks.size() == 2) {
      if (!extrema.empty()) return bad("with two boundaries has an extremum");
      if (walks[0].side == walks[1].side) return bad("has two boundaries on the same side");
      if (walks[0].side == Side::high) std::swap(walks[0], walks[1]);
      m_chart.kind = Chart_kind::annulus;
      return {};
    }
    if (chi == 1 && walks.size() == 1 &&
        (extrema.size() == 1 || (extrema.empty() && corners_of(m_network, walks[0]).size() == 4))) {
      m_chart.kind = Chart_kind::disc;
      m_chart.extremum = extrema.empty() ? -1 : extrema[0];
      return {};
    }
    return bad("is neither an annulus nor a disc with one extremum: Euler characteristic " +
               std::to_string(chi) + ", " + std::to_string(walks.size()) + " boundaries, " +
               std::to_string(extrema.size()) + " extrema");
  }

  // An edge inside the chart that joins two vertices of one walk would be mapped to the walk's line, or fold
  // there: it is split in the middle; if asked for, so is one between two walks of one side. Splitting adds
  // no new such edge, since the new vertex is inside.
  void split_chords() {
    Triangle_surface& mesh = m_chart.mesh;
    std::vector<int> walk_of(mesh.number_of_vertices(), -1);
    for (std::size_t w = 0; w < m_chart.walks.size(); ++w)
      for (int v : m_chart.walks[w].vertices)
        walk_of[v] = m_one_value_a_side ? int(m_chart.walks[w].side) : int(w);
    std::fill_n(walk_of.begin(), m_walls.size(), 0);
    // Also over the new halfedges: two splits may have moved both sides of an edge to the end.
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      if (mesh.opposite[h] < h) continue; // the border, or seen from the other side
      const int a = mesh.source(h), b = mesh.target(h);
      if (walk_of[a] < 0 || walk_of[a] != walk_of[b]) continue;
      split_edge(h);
      walk_of.push_back(-1);
    }
  }

  void split_edge(int h) {
    Triangle_surface& mesh = m_chart.mesh;
    const int g = mesh.opposite[h], a = mesh.source(h), b = mesh.target(h);
    const int m = add_vertex(-1, 0.5 * (mesh.points[a] + mesh.points[b]));
    m_chart.split_chords.push_back({a, b});
    const int h_far = cut_face(h, m), g_far = cut_face(g, m); // the new halfedges m -> b and m -> a
    pair(h, g_far);
    pair(g, h_far);
  }

  // Shortens halfedge h = a -> b of face (a, b, c) to a -> m and adds the face (m, b, c); returns its
  // halfedge m -> b.
  int cut_face(int h, int m) {
    Triangle_surface& mesh = m_chart.mesh;
    const int next = Triangle_surface::next(h), b = mesh.source(next), c = mesh.target(next);
    const int far = mesh.number_of_halfedges();
    mesh.triangles.push_back({m, b, c});
    m_chart.face_origin.push_back(m_chart.face_origin[h / 3]);
    mesh.opposite.insert(mesh.opposite.end(), {-1, -1, -1});
    if (mesh.opposite[next] >= 0) pair(far + 1, mesh.opposite[next]);
    mesh.triangles[h / 3][next % 3] = m;
    pair(next, far + 2);
    return far;
  }
  void pair(int h, int g) {
    m_chart.mesh.opposite[h] = g;
    m_chart.mesh.opposite[g] = h;
  }

  void renew_outgoing() {
    Triangle_surface& mesh = m_chart.mesh;
    mesh.outgoing.assign(mesh.number_of_vertices(), -1);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      int& out = mesh.outgoing[mesh.source(h)];
      if (out < 0 || mesh.opposite[h] < 0) out = h;
    }
  }

  const Embedding& m_embedding;
  const Contour_network& m_network;
  std::vector<int> m_local_face, m_local_vertex;
  std::vector<char> m_on_wall, m_is_extremum;
  std::vector<int> m_extrema;
  Chart m_chart;
  int m_index = -1;
  bool m_any_topology = false, m_mixed = false, m_one_value_a_side = false;
  std::vector<Region_wall> m_walls;
};

int find_root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

} // namespace

namespace {

using Border_set = std::vector<std::pair<int, bool>>; // contour edges with the side of the chart, sorted

// The contour edges around each region, with true where the region is on their left.
std::vector<Border_set> borders_of_regions(const Embedding& embedding, const std::vector<int>& region_of_face,
                                           std::size_t regions) {
  std::vector<Border_set> borders(regions);
  for (int h = 0; h < embedding.surface.number_of_halfedges(); ++h) {
    const int wall = embedding.wall_of[h];
    if (wall < 0 || embedding.walls[wall].segment != 0) continue;
    borders[region_of_face[h / 3]].push_back({embedding.walls[wall].edge, embedding.walls[wall].forward});
  }
  for (Border_set& border : borders) std::sort(border.begin(), border.end());
  return borders;
}

std::vector<Border_set> borders_of_charts(const Atlas& atlas) {
  std::vector<Border_set> borders(atlas.charts.size());
  for (std::size_t e = 0; e < atlas.charts_of_edge.size(); ++e)
    for (int side = 0; side < 2; ++side)
      if (const int c = atlas.charts_of_edge[e][side]; c >= 0) borders[c].push_back({int(e), side == 0});
  for (Border_set& border : borders) std::sort(border.begin(), border.end());
  return borders;
}

std::map<Border_set, int> charts_by_border(const Atlas& atlas) {
  const std::vector<Border_set> borders = borders_of_charts(atlas);
  std::map<Border_set, int> result;
  for (std::size_t c = 0; c < borders.size(); ++c) result[borders[c]] = int(c);
  return result;
}

} // namespace

namespace {

// A chart's place in the atlas: its smallest original face, then the first contour edge around it, then its
// side.
struct Chart_key {
  int face, edge;
  bool on_right;
  bool operator<(const Chart_key& o) const {
    if (face != o.face) return face < o.face;
    return edge != o.edge ? edge < o.edge : on_right < o.on_right;
  }
};

// Finds or builds the charts of regions.
class Atlas_builder {
public:
  Atlas_builder(const Embedding& embedding, const Contour_network& network, const std::vector<int>& extrema,
                const Atlas* previous)
      : m_embedding(embedding), m_network(network), m_extrema(extrema), m_previous(previous) {
    if (previous) m_known = charts_by_border(*previous);
  }

  void keep(int chart, const Border_set& border) { add(m_previous->charts[chart], chart, border); }

  // `partial`: leave out the regions that end where the embedding ends, and those that are kept already.
  Result<void> add_regions(bool partial) {
    std::vector<std::vector<int>> regions = flood_regions(m_embedding, m_region_of_face);
    const std::vector<Border_set> borders = borders_of_regions(m_embedding, m_region_of_face, regions.size());
    m_chart_of_region.assign(regions.size(), -1);
    std::vector<char> is_open(regions.size(), 0);
    const Triangle_surface& s = m_embedding.surface;
    for (int h = 0; partial && h < s.number_of_halfedges(); ++h)
      if (s.opposite[h] < 0 && !m_embedding.is_wall(h)) is_open[m_region_of_face[h / 3]] = 1;
    Chart_builder builder(m_embedding, m_network, m_extrema);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (is_open[r] || m_kept.count(borders[r])) continue;
      m_chart_of_region[r] = int(m_charts.size());
      if (const auto found = m_known.find(borders[r]); found != m_known.end()) {
        keep(found->second, borders[r]);
        continue;
      }
      sort_faces(m_embedding, regions[r]);
      Result<Chart> chart = builder.build(regions[r], int(r));
      if (!chart) return chart.error();
      add(std::make_shared<const Chart>(std::move(*chart)), -1, borders[r]);
    }
    return {};
  }

  Atlas finish(std::vector<int>* reused) {
    std::vector<int> order(m_charts.size()), place(m_charts.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return m_keys[a] < m_keys[b]; });
    Atlas atlas;
    atlas.charts_of_edge.assign(m_network.edges.size(), {-1, -1});
    if (reused) reused->clear();
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = int(i);
      atlas.charts.push_back(m_charts[order[i]]);
      if (reused) reused->push_back(m_source[order[i]]);
      for (const auto& [edge, on_left] : m_borders[order[i]])
        atlas.charts_of_edge[edge][on_left ? 0 : 1] = int(i);
    }
    for (int r : m_region_of_face)
      atlas.chart_of_face.push_back(m_chart_of_region[r] < 0 ? -1 : place[m_chart_of_region[r]]);
    return atlas;
  }

private:
  void add(std::shared_ptr<const Chart> chart, int source, const Border_set& border) {
    const std::pair<int, bool> first = border.empty() ? std::pair<int, bool>(-1, true) : border.front();
    m_keys.push_back({chart->face_origin.front(), first.first, !first.second});
    m_charts.push_back(std::move(chart));
    m_source.push_back(source);
    m_borders.push_back(border);
    m_kept.insert(border);
  }

  const Embedding& m_embedding;
  const Contour_network& m_network;
  const std::vector<int>& m_extrema;
  const Atlas* m_previous;
  std::map<Border_set, int> m_known;
  std::set<Border_set> m_kept;
  std::vector<int> m_region_of_face, m_chart_of_region;
  std::vector<std::shared_ptr<const Chart>> m_charts;
  std::vector<int> m_source;
  std::vector<Border_set> m_borders;
  std::vector<Chart_key> m_keys;
};

} // namespace

Result<Atlas> build_atlas(const Embedding& embedding, const Contour_network& network,
                          const std::vector<int>& extrema, const Atlas* previous, std::vector<int>* reused) {
  Atlas_builder builder(embedding, network, extrema, previous);
  if (Result<void> added = builder.add_regions(false); !added) return added.error();
  return builder.finish(reused);
}

int chart_across(const Atlas& atlas, Contour_id edge, Chart_index chart) {
  const std::array<int, 2> sides = atlas.charts_of_edge[edge];
  return sides[0] == chart ? sides[1] : sides[0];
}

std::vector<int> contour_edges(const Chart& chart) {
  std::vector<int> edges;
  for (const Walk& walk : chart.walks)
    for (const Walk_edge& e : walk.edges) edges.push_back(e.edge);
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<int> faces_of_charts(const Triangle_surface& surface, const Atlas& atlas,
                                 const std::vector<int>& charts) {
  std::vector<char> inside(surface.number_of_faces(), 0);
  for (int c : charts)
    for (int f : atlas.charts[c]->face_origin) inside[f] = 1;
  std::vector<int> faces;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    if (inside[f]) faces.push_back(f);
  return faces;
}

Result<Atlas> update_atlas(const Triangle_surface& surface, const Contour_network& network,
                           const std::vector<int>& extrema, const Atlas& previous,
                           const std::vector<int>& changed, std::vector<int>* reused) {
  const Result<Embedding> embedding = embed(surface, network, faces_of_charts(surface, previous, changed));
  if (!embedding) return embedding.error();
  Atlas_builder builder(*embedding, network, extrema, &previous);
  std::vector<char> is_changed(previous.charts.size(), 0);
  for (int c : changed) is_changed[c] = 1;
  const std::vector<Border_set> borders = borders_of_charts(previous);
  for (std::size_t c = 0; c < borders.size(); ++c)
    if (!is_changed[c]) builder.keep(int(c), borders[c]);
  if (Result<void> added = builder.add_regions(true); !added) return added.error();
  Atlas atlas = builder.finish(reused);
  atlas.chart_of_face.clear();
  return atlas;
}

namespace {

// The region of a face.
Result<Chart> build_region(const Embedding& embedding, int face, Chart_builder& builder) {
  std::vector<int> region_of_face;
  std::vector<std::vector<int>> regions = flood_regions(embedding, region_of_face);
  std::vector<int>& faces = regions[region_of_face[face]];
  sort_faces(embedding, faces);
  return builder.build(faces, region_of_face[face]);
}

} // namespace

Result<Chart> cut_region(const Embedding& embedding, const Contour_network& network,
                         const std::vector<int>& extrema, int face) {
  Chart_builder builder(embedding, network, extrema);
  builder.accept_regions();
  return build_region(embedding, face, builder);
}

Result<Chart> cut_part(const Embedding& embedding, const Contour_network& network, int face) {
  Chart_builder builder(embedding, network, {});
  builder.accept_regions();
  builder.split_between_walks();
  return build_region(embedding, face, builder);
}

Result<Open_region> open_region(const Embedding& embedding, const Contour_network& network, int face) {
  Chart_builder builder(embedding, network, {});
  builder.accept_regions(true);
  Result<Chart> chart = build_region(embedding, face, builder);
  if (!chart) return chart.error();
  return Open_region{std::move(*chart), builder.take_walls()};
}

std::vector<int> rectangle_corners(const Contour_network& network, const Chart& chart) {
  if (chart.kind != Chart_kind::disc) return {};
  std::vector<int> corners = corners_of(network, chart.walks[0]);
  return corners.size() == 4 ? corners : std::vector<int>();
}

int Reeb_graph::loops() const {
  std::vector<int> parent(number_of_nodes());
  std::iota(parent.begin(), parent.end(), 0);
  int cycles = 0;
  for (const Arc& arc : arcs) {
    const int a = find_root(parent, arc.low), b = find_root(parent, arc.high);
    if (a == b) ++cycles;
    parent[a] = b;
  }
  return cycles;
}

Reeb_graph reeb_graph(const Atlas& atlas, const Contour_network& network) {
  std::vector<int> parent(network.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const Contour_edge& e : network.edges)
    if (!network.is_removed(e)) parent[find_root(parent, e.from)] = find_root(parent, e.to);
  Reeb_graph graph;
  std::vector<int> contour_of_node(network.nodes.size(), -1);
  for (const Contour_edge& e : network.edges) {
    if (network.is_removed(e)) {
      graph.contour_of_edge.push_back(-1);
      continue;
    }
    int& contour = contour_of_node[find_root(parent, e.from)];
    if (contour < 0) {
      contour = graph.number_of_nodes();
      graph.extremum.push_back(-1);
    }
    graph.contour_of_edge.push_back(contour);
  }
  for (const std::shared_ptr<const Chart>& shared : atlas.charts) {
    const Chart& chart = *shared;
    const int first = graph.contour_of_edge[chart.walks[0].edges[0].edge];
    if (chart.kind == Chart_kind::annulus) {
      graph.arcs.push_back({first, graph.contour_of_edge[chart.walks[1].edges[0].edge]});
      continue;
    }
    const int pole = graph.number_of_nodes();
    graph.extremum.push_back(chart.extremum >= 0 ? chart.vertex_origin[chart.extremum] : -1);
    if (chart.walks[0].side == Side::low)
      graph.arcs.push_back({first, pole});
    else
      graph.arcs.push_back({pole, first});
  }
  return graph;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
