// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/draft.h"

#include "base/parallel_for.h"
#include "base/segments.h"

#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The density at a vertex of a network.
double density_at(const Contour_network& network, const Triangle_surface& surface,
                  const std::vector<double>& density, int vertex) {
  if (!network.is_crossing(vertex)) return density[std::size_t(vertex)];
  const Edge_crossing& c = network.crossing(vertex);
  if (c.halfedge < 0) return 1; // removed
  return (1 - c.t) * density[std::size_t(surface.source(c.halfedge))] +
         c.t * density[std::size_t(surface.target(c.halfedge))];
}

} // namespace

Surface_solver::Surface_solver(const Triangle_surface& surface, const Editor_options& options)
    : m_surface(surface), m_options(options) {}

Harmonic_field Surface_solver::new_field() const {
  Harmonic_field field(m_surface, {m_options.solver, m_options.constraints});
  field.set_weights(m_options.weights);
  field.set_threads(internal::number_of_threads(m_options.threads));
  return field;
}

Result<void> Surface_solver::solve(Designed_field& field) {
  const bool first = m_order.empty();
  std::optional<Harmonic_field> for_once;
  if (first && !m_options.keep_factorization) {
    for_once.emplace(new_field());
  } else if (!m_field) {
    m_field.emplace(new_field());
    m_field->set_incremental(true);
  }
  Harmonic_field& solver = for_once ? *for_once : *m_field;
  Result<void> solved = solve_field(m_surface, solver, field);
  if (first) {
    m_order = solver.elimination_order();
    m_places = places_in(m_order);
  }
  return solved;
}

Draft::Draft(const Triangle_surface& surface, const internal::Lazy_projector& projector,
             Surface_solver& solver, const Design& design, const Editor_options& options, Observer* observer)
    : network(design.network), extrema(design.extrema), target_quads(design.target_quads),
      edge_length(design.edge_length), field(design.field), guides(design.guides), m_surface(surface),
      m_projector(projector), m_solver(solver), m_before(design), m_options(options), m_observer(observer),
      m_atlas(design.atlas) {
  remember_contours();
  for (std::size_t c = 0; c < design.charts.size(); ++c) {
    settings[design.charts[c]->id] = design.charts[c]->settings;
    m_maps.push_back(design.charts[c]->map);
    m_origin.push_back(int(c));
  }
}

void Draft::remember_contours() {
  m_was_cut.clear();
  for (const Contour_edge& e : network.edges) m_was_cut.push_back(!network.is_removed(e));
}

std::vector<int> Draft::extremal_vertices() const {
  std::vector<int> vertices;
  for (const Design_extremum& e : extrema)
    if (e.segment < 0) vertices.push_back(e.vertex);
  return vertices;
}

// The charts beside contours that are gone, and those that new contours go through.
std::vector<int> Draft::changed_charts() const {
  std::vector<char> changed(m_atlas.charts.size(), 0), crossed(m_surface.number_of_faces(), 0);
  const auto cross = [&](int h) {
    crossed[h / 3] = 1;
    if (m_surface.opposite[h] >= 0) crossed[m_surface.opposite[h] / 3] = 1;
  };
  bool any = false;
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const bool was = e < m_was_cut.size() && m_was_cut[e], is = !network.is_removed(network.edges[e]);
    if (was && !is)
      for (int c : m_atlas.charts_of_edge[e])
        if (c >= 0) changed[c] = 1;
    if (was || !is) continue;
    any = true;
    for (int f : network.edges[e].faces)
      if (f >= 0) crossed[f] = 1;
    for (int v : network.edges[e].vertices) {
      if (network.is_crossing(v)) {
        cross(network.crossing(v).halfedge);
        continue;
      }
      const int first = m_surface.outgoing[v];
      int h = first;
      do {
        cross(h);
        h = m_surface.rotate_ccw(h);
      } while (h >= 0 && h != first);
    }
  }
  std::vector<int> list;
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const std::vector<int>& faces = m_atlas.charts[c]->face_origin;
    if (changed[c] || (any && std::any_of(faces.begin(), faces.end(), [&](int f) { return crossed[f]; })))
      list.push_back(int(c));
  }
  return list;
}

Result<void> Draft::cut() {
  std::vector<int> reused;
  Result<Atlas> atlas =
      update_atlas(m_surface, network, extremal_vertices(), m_atlas, changed_charts(), &reused);
  if (!atlas && atlas.error().element == Element_kind::face)
    return refuse("the contour would touch another contour", {}, Element_kind::face,
                  int(atlas.error().index));
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
  remember_contours();
  return {};
}

void Draft::take(Draft&& other) {
  network = std::move(other.network);
  extrema = std::move(other.extrema);
  settings = std::move(other.settings);
  target_quads = other.target_quads;
  edge_length = other.edge_length;
  resample = other.resample;
  reset_textures = std::move(other.reset_textures);
  replaced = std::move(other.replaced);
  field = std::move(other.field);
  collapsed_charts = other.collapsed_charts;
  followed = other.followed;
  guides = std::move(other.guides);
  remark = std::move(other.remark);
  has_pushed_contours = other.has_pushed_contours;
  m_atlas = std::move(other.m_atlas);
  m_was_cut = std::move(other.m_was_cut);
  m_maps = std::move(other.m_maps);
  m_origin = std::move(other.m_origin);
}

void Draft::adopt(Reeb_layout layout) {
  network = std::move(layout.network);
  auto traced = std::make_shared<Surface_field>();
  traced->values = std::move(layout.values);
  traced->cleanup_rounds = layout.cleanup_rounds;
  traced->lost_extrema = std::move(layout.lost_extrema);
  field = std::move(traced);
  m_atlas = std::move(layout.atlas);
  m_atlas.chart_of_face.clear();
  remember_contours();
  m_maps.assign(m_atlas.charts.size(), nullptr);
  m_origin.assign(m_atlas.charts.size(), -1);
  settings.clear();
  for (Design_guide& guide : guides) guide.contour = -1;
  resample = true;
}

Result<void> Draft::begin(const char* stage) const {
  if (!m_observer) return {};
  m_observer->progress(stage, 0);
  if (m_observer->cancelled()) return make_error(Error_code::cancelled, "cancelled by the user");
  return {};
}

Result<void> Draft::for_each_chart(const std::vector<int>& charts,
                                   const std::function<Result<void>(int)>& work) const {
  std::vector<int> order(charts.size()); // places in the list
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(i);
  const auto faces = [&](int i) { return chart(charts[std::size_t(i)]).mesh.number_of_faces(); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return faces(a) > faces(b); });
  std::vector<Result<void>> done(charts.size());
  internal::parallel_for(int(order.size()), internal::number_of_threads(m_options.threads), [&](int i) {
    const std::size_t place = std::size_t(order[std::size_t(i)]);
    if (m_observer && m_observer->cancelled())
      done[place] = make_error(Error_code::cancelled, "cancelled by the user");
    else
      done[place] = work(charts[place]);
  });
  for (Result<void>& result : done)
    if (!result) return result;
  return {};
}

Result<void> Draft::prepare_maps() {
  std::vector<int> missing;
  for (int c = 0; c < int(m_maps.size()); ++c)
    if (!has_map(c)) missing.push_back(c);
  return for_each_chart(missing, [&](int c) -> Result<void> {
    if (const auto prepared = map(c); !prepared) return prepared.error();
    return {};
  });
}

std::vector<double> Draft::network_density() const {
  if (!density) return {};
  std::vector<double> all = *density;
  for (std::size_t i = 0; i < network.crossings.size(); ++i)
    all.push_back(density_at(network, m_surface, *density, network.surface_vertices + int(i)));
  return all;
}

std::vector<double> Draft::chart_density(const Chart& chart) const {
  const std::size_t known = chart.vertex_origin.size() - chart.split_chords.size();
  std::vector<double> all;
  for (std::size_t v = 0; v < chart.vertex_origin.size(); ++v)
    all.push_back(v < known ? density_at(network, m_surface, *density, chart.vertex_origin[v])
                            : 0.5 * (all[std::size_t(chart.split_chords[v - known][0])] +
                                     all[std::size_t(chart.split_chords[v - known][1])]));
  return all;
}

Result<std::shared_ptr<const Chart_parameterization>> Draft::map(int c) {
  if (!m_maps[c]) {
    Edge_weights weights = m_options.chart_weights ? m_options.chart_weights(chart(c))
                                                   : clamped_cotangent_weights(chart(c).mesh);
    Result<Chart_parameterization> map =
        Chart_parameterization::prepare(chart(c), std::move(weights), order_of(chart(c)), field_solver());
    if (!map) return map.error();
    if (density && chart(c).kind == Chart_kind::annulus)
      map->weigh_profile(chart(c), chart_density(chart(c)));
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
  const int face = m_projector->closest(at.point).face;
  const Triangle& t = m_surface.triangles[face];
  return *std::min_element(t.begin(), t.end(), [&](int a, int b) {
    const double da = (m_surface.points[a] - at.point).squaredNorm(),
                 db = (m_surface.points[b] - at.point).squaredNorm();
    return da != db ? da < db : a < b;
  });
}

int Draft::face_at(const Point& point) const {
  return m_projector->closest(point).face;
}

int Draft::inner_vertex_at(const Surface_point& at) const {
  const auto is_inner = [&](int v) {
    return m_surface.outgoing[v] >= 0 && !m_surface.is_boundary(m_surface.outgoing[v]);
  };
  int best = vertex_at(at);
  if (at.vertex >= 0 || is_inner(best)) return best;
  double least = std::numeric_limits<double>::infinity();
  for (int v = 0; v < m_surface.number_of_vertices(); ++v)
    if (const double d = (m_surface.points[v] - at.point).squaredNorm(); d < least && is_inner(v)) {
      least = d;
      best = v;
    }
  return best;
}

int Draft::chart_of_vertex(int vertex) const {
  for (const Contour_edge& e : network.edges)
    if (std::find(e.vertices.begin(), e.vertices.end(), vertex) != e.vertices.end()) return -1;
  for (std::size_t c = 0; c < m_atlas.charts.size(); ++c) {
    const std::vector<int>& origin = m_atlas.charts[c]->vertex_origin;
    if (std::find(origin.begin(), origin.end(), vertex) != origin.end()) return int(c);
  }
  return -1;
}

namespace {

// The barycentric coordinates of a point in the plane of a triangle; minus infinity if that has no area.
std::array<double, 3> weights_in(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point n = (b - a).cross(c - a);
  const double area = n.squaredNorm(), nowhere = -std::numeric_limits<double>::infinity();
  if (!(area > 0)) return {nowhere, nowhere, nowhere};
  return {(b - p).cross(c - p).dot(n) / area, (c - p).cross(a - p).dot(n) / area,
          (a - p).cross(b - p).dot(n) / area};
}

} // namespace

int Draft::chart_at(const Surface_point& at) const {
  if (m_atlas.charts.empty()) return -1;
  if (at.vertex >= 0 && at.vertex < m_surface.number_of_vertices() && m_surface.points[at.vertex] == at.point)
    if (const int c = chart_of_vertex(at.vertex); c >= 0) return c;
  return chart_point_at(at.point).chart;
}

Chart_point Draft::chart_point_at(const Point& point, int only) const {
  const Closest_point closest = m_projector->closest(point);
  Chart_point best;
  double inside = -std::numeric_limits<double>::infinity();
  for (int c = only < 0 ? 0 : only; c < (only < 0 ? int(m_atlas.charts.size()) : only + 1); ++c) {
    const Chart& chart = *m_atlas.charts[c];
    for (std::size_t f = 0; f < chart.face_origin.size(); ++f) {
      if (chart.face_origin[f] != closest.face) continue;
      const Triangle& t = chart.mesh.triangles[f];
      const std::array<double, 3> weights = weights_in(closest.point, chart.mesh.points[t[0]],
                                                       chart.mesh.points[t[1]], chart.mesh.points[t[2]]);
      const double least = *std::min_element(weights.begin(), weights.end());
      if (best.chart >= 0 && !(least > inside)) continue;
      inside = least;
      best = {c, closest.point, {int(f), weights}};
    }
  }
  return best;
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
  const std::vector<char> used = nodes_in_use(network);
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
