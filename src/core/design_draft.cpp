// SPDX-License-Identifier: GPL-3.0-or-later
#include "design_draft.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

Error refuse(const std::string& reason, const std::string& details, Element_kind element, int index) {
  return make_error(Error_code::refused_edit, details.empty() ? reason : reason + ": " + details, element,
                    index);
}

Draft::Draft(const Triangle_surface& surface, const Surface_projector& projector, const Design& design,
             const Editor_options& options, Observer* observer)
    : network(design.network), extrema(design.extrema), target_quads(design.target_quads),
      edge_length(design.edge_length), m_surface(surface), m_projector(projector), m_before(design),
      m_options(options), m_observer(observer), m_atlas(design.atlas), m_embedding(design.embedding) {
  for (std::size_t c = 0; c < design.charts.size(); ++c) {
    settings[design.charts[c]->id] = design.charts[c]->settings;
    m_maps.push_back(design.charts[c]->map);
    m_origin.push_back(int(c));
  }
}

std::vector<int> Draft::extremal_vertices() const {
  std::vector<int> vertices;
  for (const Design_extremum& e : extrema)
    if (e.segment < 0) vertices.push_back(e.vertex);
  return vertices;
}

Result<void> Draft::cut() {
  Result<Embedding> embedding = embed(m_surface, network);
  if (!embedding)
    return refuse("the contour would touch another contour", {}, Element_kind::face,
                  int(embedding.error().index));
  std::vector<int> reused;
  Result<Atlas> atlas = build_atlas(*embedding, network, extremal_vertices(), &m_atlas, &reused);
  if (!atlas)
    return refuse("the regions between the contours would not all be charts", atlas.error().message);
  std::vector<std::shared_ptr<const Chart_parameterization>> maps(reused.size());
  std::vector<int> origin(reused.size(), -1);
  for (std::size_t c = 0; c < reused.size(); ++c)
    if (reused[c] >= 0) {
      maps[c] = m_maps[reused[c]];
      origin[c] = m_origin[reused[c]];
    }
  m_maps = std::move(maps);
  m_origin = std::move(origin);
  m_atlas = std::move(*atlas);
  m_embedding = std::make_shared<const Embedding>(std::move(*embedding));
  return {};
}

void Draft::take(Draft&& other) {
  network = std::move(other.network);
  extrema = std::move(other.extrema);
  settings = std::move(other.settings);
  target_quads = other.target_quads;
  edge_length = other.edge_length;
  resample = other.resample;
  m_atlas = std::move(other.m_atlas);
  m_embedding = std::move(other.m_embedding);
  m_maps = std::move(other.m_maps);
  m_origin = std::move(other.m_origin);
}

void Draft::adopt(Reeb_layout layout) {
  network = std::move(layout.network);
  m_atlas = std::move(layout.atlas);
  m_embedding = std::make_shared<const Embedding>(std::move(layout.embedding));
  m_maps.assign(m_atlas.charts.size(), nullptr);
  m_origin.assign(m_atlas.charts.size(), -1);
}

Result<std::shared_ptr<const Chart_parameterization>> Draft::map(int c) {
  if (!m_maps[c]) {
    Result<Chart_parameterization> map = Chart_parameterization::prepare(chart(c));
    if (!map) return map.error();
    m_maps[c] = std::make_shared<const Chart_parameterization>(std::move(*map));
  }
  return m_maps[c];
}

Result<Chart_parameterization> Draft::naturally_solved_map(int c) {
  Result<std::shared_ptr<const Chart_parameterization>> prepared = map(c);
  if (!prepared) return prepared.error();
  Chart_parameterization copy = **prepared;
  if (Result<void> solved = copy.solve_columns(chart(c), copy.natural(Side::low), copy.natural(Side::high));
      !solved)
    return solved.error();
  return copy;
}

int Draft::vertex_at(const Surface_point& at) const {
  if (at.vertex >= 0 && at.vertex < m_surface.number_of_vertices() && m_surface.points[at.vertex] == at.point)
    return at.vertex;
  const int face = m_projector.closest(at.point).face;
  const Triangle& t = m_surface.triangles[face];
  return *std::min_element(t.begin(), t.end(), [&](int a, int b) {
    const double da = (m_surface.points[a] - at.point).squaredNorm(),
                 db = (m_surface.points[b] - at.point).squaredNorm();
    return da != db ? da < db : a < b;
  });
}

int Draft::chart_of_vertex(int vertex) const {
  const Triangle_surface& s = m_embedding->surface;
  int h = s.outgoing[vertex];
  const int first = h;
  do {
    if (m_embedding->is_wall(h) || m_embedding->is_wall(Triangle_surface::previous(h))) return -1;
    h = s.rotate_ccw(h);
  } while (h >= 0 && h != first);
  return m_atlas.chart_of_face[first / 3];
}

namespace {

double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double length = d.squaredNorm(), t = length > 0 ? (p - a).dot(d) / length : 0;
  return (a + std::min(1.0, std::max(0.0, t)) * d - p).squaredNorm();
}

// How far a point in the plane of a triangle lies outside, negative inside.
double outside(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point n = (b - a).cross(c - a);
  const double area = n.squaredNorm();
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  const double u = (b - p).cross(c - p).dot(n), v = (c - p).cross(a - p).dot(n),
               w = (a - p).cross(b - p).dot(n);
  return -std::min({u, v, w}) / area;
}

} // namespace

int Draft::chart_at(const Surface_point& at) const {
  if (m_atlas.charts.empty()) return -1;
  if (at.vertex >= 0 && at.vertex < m_surface.number_of_vertices() && m_surface.points[at.vertex] == at.point)
    if (const int c = chart_of_vertex(at.vertex); c >= 0) return c;
  const Closest_point closest = m_projector.closest(at.point);
  const Triangle_surface& s = m_embedding->surface;
  int best = closest.face;
  const auto measure = [&](int f) {
    const Triangle& t = s.triangles[f];
    return outside(closest.point, s.points[t[0]], s.points[t[1]], s.points[t[2]]);
  };
  double least = measure(best);
  const std::vector<int>& base = m_embedding->base_face;
  const auto extra = base.begin() + m_surface.number_of_faces(); // the further pieces, ordered by their faces
  for (auto piece = std::lower_bound(extra, base.end(), closest.face);
       piece != base.end() && *piece == closest.face; ++piece) {
    const int f = int(piece - base.begin());
    if (const double m = measure(f); m < least) {
      least = m;
      best = f;
    }
  }
  return m_atlas.chart_of_face[best];
}

int Draft::contour_at(const Point& point) const {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const std::vector<int>& v = network.edges[e].vertices;
    for (std::size_t i = 1; i < v.size(); ++i) {
      const double d = squared_distance_to_segment(point, position(v[i - 1]), position(v[i]));
      if (d < least) {
        least = d;
        best = int(e);
      }
    }
  }
  return best;
}

int Draft::extremum_at(const Point& point) const {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < extrema.size(); ++i)
    if (const double d = (m_surface.points[extrema[i].vertex] - point).squaredNorm(); d < least) {
      least = d;
      best = int(i);
    }
  return best;
}

int Draft::saddle_at(const Point& point) const {
  std::vector<char> used(network.nodes.size(), 0);
  for (const Contour_edge& e : network.edges)
    if (!network.is_removed(e)) used[e.from] = used[e.to] = 1;
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i] || network.nodes[i].kind != Node_kind::saddle) continue;
    if (const double d = (position(network.nodes[i].vertex) - point).squaredNorm(); d < least) {
      least = d;
      best = int(i);
    }
  }
  return best;
}

int Draft::vertex_of_contour_at(int edge, const Point& point) const {
  const std::vector<int>& v = network.edges[edge].vertices;
  int best = 0;
  for (int i = 1; i < int(v.size()); ++i)
    if ((position(v[i]) - point).squaredNorm() < (position(v[best]) - point).squaredNorm()) best = i;
  return best;
}

std::vector<int> Draft::edges_at(int node) const {
  std::vector<int> edges;
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    if (network.is_removed(network.edges[e])) continue;
    if (network.edges[e].from == node) edges.push_back(int(e));
    if (network.edges[e].to == node) edges.push_back(int(e));
  }
  return edges;
}

bool Draft::is_free_loop(int edge) const {
  const Contour_edge& e = network.edges[edge];
  return e.from == e.to && network.nodes[e.from].kind == Node_kind::regular && edges_at(e.from).size() == 2;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
