// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int profile_bins = 64;

// The boundary halfedge that leaves a walk vertex, the chart on its left.
int border_halfedge(const Chart& chart, int vertex) {
  return chart.mesh.outgoing[vertex];
}

Result<void> check_weights(const Triangle_surface& mesh, const Edge_weights& weights) {
  if (int(weights.of_halfedge.size()) != mesh.number_of_halfedges())
    return make_error(Error_code::impossible_request, "a chart's weights are not one for each halfedge");
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    const double w = weights.of_halfedge[h],
                 other = mesh.is_boundary(h) ? w : weights.of_halfedge[mesh.opposite[h]];
    if (!(w > 0) || !std::isfinite(w) || w != other)
      return make_error(Error_code::impossible_request,
                        "a chart's weights must be positive, finite and alike on both sides of an edge",
                        Element_kind::edge, h);
  }
  return {};
}

} // namespace

double Height_profile::level_at(double fraction) const {
  const double wanted = fraction * total();
  const auto above = std::lower_bound(height.begin(), height.end(), wanted);
  if (above == height.begin()) return 0;
  if (above == height.end()) return 1;
  const std::size_t i = above - height.begin();
  const double step = height[i] - height[i - 1];
  const double part = step > 0 ? (wanted - height[i - 1]) / step : 0.5;
  return (double(i - 1) + part) / double(height.size() - 1);
}

Result<Chart_parameterization> Chart_parameterization::prepare(const Chart& chart,
                                                               const Field_solver_options& options) {
  return prepare(chart, clamped_cotangent_weights(chart.mesh), {}, options);
}

std::vector<int> elimination_order(const Chart& chart, const std::vector<int>& place) {
  std::vector<char> is_known(chart.vertex_origin.size(), 0); // and in several charts
  for (const Walk& walk : chart.walks)
    for (int v : walk.vertices) is_known[v] = 1;
  std::vector<std::pair<int, int>> placed;
  placed.reserve(chart.vertex_origin.size());
  for (std::size_t v = 0; v < chart.vertex_origin.size(); ++v)
    if (const int origin = chart.vertex_origin[v]; !is_known[v] && origin >= 0 && origin < int(place.size()))
      placed.push_back({place[origin], int(v)});
  std::sort(placed.begin(), placed.end());
  std::vector<int> order;
  order.reserve(placed.size());
  for (const auto& entry : placed) order.push_back(entry.second);
  return order;
}

std::vector<int> places_in(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = int(i);
  return place;
}

Result<Chart_parameterization> Chart_parameterization::prepare(const Chart& chart, Edge_weights weights,
                                                               const std::vector<int>& elimination_order,
                                                               const Field_solver_options& options) {
  const Triangle_surface& mesh = chart.mesh;
  if (Result<void> checked = check_weights(mesh, weights); !checked) return checked.error();
  Chart_parameterization p;
  std::vector<char> is_fixed(mesh.number_of_vertices(), 0);
  for (const Walk& walk : chart.walks)
    for (int v : walk.vertices) is_fixed[v] = 1;
  Result<Dirichlet_problem> problem =
      Dirichlet_problem::factorize(mesh, std::move(weights), is_fixed, elimination_order, options);
  if (!problem) return problem.error();
  p.m_problem = std::move(*problem);
  if (chart.kind == Chart_kind::annulus) {
    if (Result<void> solved = p.solve_u(chart); !solved) return solved.error();
    p.choose_seam(chart);
    p.integrate_flux(chart);
    p.measure_profile(chart, nullptr);
  }
  return p;
}

Result<void> Chart_parameterization::solve_u(const Chart& chart) {
  m_u.assign(chart.mesh.number_of_vertices(), 0.0);
  for (int v : chart.walks[1].vertices) m_u[v] = 1;
  return m_problem.solve(chart.mesh, m_u);
}

// The seam is a shortest strip of faces from the LOW walk to the HIGH walk. The edges it crosses carry the
// jump: -1 from its east side to its west side.
void Chart_parameterization::choose_seam(const Chart& chart) {
  const Triangle_surface& mesh = chart.mesh;
  const Walk &low = chart.walks[0], &high = chart.walks[1];
  std::vector<char> is_high(mesh.number_of_vertices(), 0);
  for (int v : high.vertices) is_high[v] = 1;

  std::vector<int> entry(mesh.number_of_faces(), -1),
      queue; // entry: the halfedge of the previous face, or own border
  for (int v : low.vertices) {
    const int h = border_halfedge(chart, v);
    if (entry[h / 3] >= 0) continue;
    entry[h / 3] = h;
    queue.push_back(h / 3);
  }
  int exit = -1;
  for (std::size_t i = 0; exit < 0; ++i) {
    CGAL_assertion(i < queue.size());
    for (int h = 3 * queue[i]; h < 3 * queue[i] + 3 && exit < 0; ++h) {
      const int o = mesh.opposite[h];
      if (o < 0) {
        if (is_high[mesh.source(h)]) exit = h;
      } else if (entry[o / 3] < 0) {
        entry[o / 3] = h;
        queue.push_back(o / 3);
      }
    }
  }
  m_jump.assign(mesh.number_of_halfedges(), 0);
  int h = entry[exit / 3];
  while (mesh.opposite[h] >= 0) { // h leaves the previous face: its source is east of the strip
    m_jump[h] = -1;
    m_jump[mesh.opposite[h]] = 1;
    h = entry[h / 3];
  }
  m_jump[h] = 1; // the strip begins and ends by crossing a border edge, which runs east on the LOW walk
  m_jump[exit] = -1;
  const auto index = [](const Walk& walk, int v) {
    return int(std::find(walk.vertices.begin(), walk.vertices.end(), v) - walk.vertices.begin());
  };
  m_seam_vertex = {index(low, mesh.target(h)), index(high, mesh.source(exit))};

  // The flux across the seam links the two walks' natural V.
  double flux = 0;
  for (int g = 0; g < mesh.number_of_halfedges(); ++g)
    if (m_jump[g] < 0)
      flux += m_problem.weights().of_halfedge[g] * (m_u[mesh.target(g)] - m_u[mesh.source(g)]);
  m_natural[1].assign(1, flux);
}

// The dual of a harmonic function is a flow: the flux out of the LOW walk, summed eastward, is V.
void Chart_parameterization::integrate_flux(const Chart& chart) {
  const Triangle_surface& mesh = chart.mesh;
  std::vector<double> out(mesh.number_of_vertices(), 0.0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (const int v = mesh.source(h); m_problem.is_fixed(v))
      out[v] += m_problem.weights().of_halfedge[h] * std::abs(m_u[mesh.target(h)] - m_u[v]);
  const double seam_flux = m_natural[1].front();
  for (int w = 0; w < 2; ++w) {
    const std::vector<int>& vertices = chart.walks[w].vertices;
    const int n = int(vertices.size());
    double total = 0;
    for (int v : vertices) total += out[v];
    if (!(total > 0)) total = 1;
    // From the seam eastward once around; then the list is turned to begin at the walk's first vertex.
    std::vector<double> from_seam(n);
    double sum = w == 0 ? 0 : seam_flux;
    for (int i = 0; i < n; ++i) {
      const double flux = out[vertices[(m_seam_vertex[w] + i) % n]];
      from_seam[i] = (sum + 0.5 * flux) / total;
      sum += flux;
    }
    std::vector<double>& natural = m_natural[w];
    natural.resize(n + 1);
    for (int i = 0; i < n; ++i) {
      const int k = (i - m_seam_vertex[w] + n) % n;
      natural[i] = from_seam[k] - (i < m_seam_vertex[w] ? 1 : 0);
    }
    natural[n] = natural[0] + 1;
  }
}

// Area and level length in each band of U; the height of a band is their quotient.
void Chart_parameterization::weigh_profile(const Chart& chart, const std::vector<double>& density) {
  CGAL_precondition(int(density.size()) == chart.mesh.number_of_vertices());
  measure_profile(chart, &density);
}

void Chart_parameterization::measure_profile(const Chart& chart, const std::vector<double>* density) {
  const Triangle_surface& mesh = chart.mesh;
  std::vector<double> area(profile_bins, 0.0), length(profile_bins + 1, 0.0);
  for (const Triangle& t : mesh.triangles) {
    std::array<int, 3> s = {t[0], t[1], t[2]};
    std::sort(s.begin(), s.end(), [&](int a, int b) { return m_u[a] != m_u[b] ? m_u[a] < m_u[b] : a < b; });
    const double u0 = m_u[s[0]], u1 = m_u[s[1]], u2 = m_u[s[2]];
    const Point &p0 = mesh.points[s[0]], &p1 = mesh.points[s[1]], &p2 = mesh.points[s[2]];
    const double times = density ? ((*density)[t[0]] + (*density)[t[1]] + (*density)[t[2]]) / 3 : 1;
    const double whole = 0.5 * times * times * (p1 - p0).cross(p2 - p0).norm();
    const auto below = [&](double u) { // area of the part below level u
      if (u <= u0) return 0.0;
      if (u >= u2) return whole;
      if (u < u1) return whole * (u - u0) * (u - u0) / ((u1 - u0) * (u2 - u0));
      return whole * (1 - (u2 - u) * (u2 - u) / ((u2 - u1) * (u2 - u0)));
    };
    const int first = std::min(profile_bins - 1, std::max(0, int(u0 * profile_bins)));
    const int last = std::min(profile_bins - 1, std::max(0, int(u2 * profile_bins)));
    for (int b = first; b <= last; ++b)
      area[b] += below(double(b + 1) / profile_bins) - below(double(b) / profile_bins);
    for (int i = first; i <= last + 1; ++i) {
      const double u = double(i) / profile_bins;
      if (!(u0 < u && u < u2)) continue;
      const Point a = p0 + (u - u0) / (u2 - u0) * (p2 - p0);
      const Point b = u < u1 ? Point(p0 + (u - u0) / (u1 - u0) * (p1 - p0))
                             : Point(p1 + (u2 > u1 ? (u - u1) / (u2 - u1) : 0.0) * (p2 - p1));
      length[i] += times * (b - a).norm();
    }
  }
  for (int w = 0; w < 2; ++w) {
    const std::vector<int>& v = chart.walks[w].vertices;
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const int a = v[i], b = v[(i + 1) % v.size()];
      sum += (density ? 0.5 * ((*density)[a] + (*density)[b]) : 1) * (mesh.points[b] - mesh.points[a]).norm();
    }
    length[w == 0 ? 0 : profile_bins] = sum;
  }
  m_profile.height.assign(1, 0.0);
  m_profile.length = length;
  for (int b = 0; b < profile_bins; ++b) {
    const double mean = 0.5 * (length[b] + length[b + 1]);
    m_profile.height.push_back(m_profile.height.back() + (mean > 0 ? area[b] / mean : 0.0));
  }
}

// A walk's values as the cut domain has them: from the first vertex east of the seam, once around.
std::vector<double> Chart_parameterization::lifted(const Chart& chart, int walk,
                                                   const std::vector<double>& values) const {
  const int n = int(chart.walks[walk].vertices.size());
  std::vector<double> result(values.begin(), values.begin() + n);
  for (int i = 0; i < m_seam_vertex[walk]; ++i) result[i] += 1;
  return result;
}

Result<void> Chart_parameterization::solve_columns(const Chart& chart, const std::vector<double>& low,
                                                   const std::vector<double>& high) {
  CGAL_precondition(chart.kind == Chart_kind::annulus);
  m_v.assign(chart.mesh.number_of_vertices(), 0.0);
  for (int w = 0; w < 2; ++w) {
    const std::vector<double> values = lifted(chart, w, w == 0 ? low : high);
    for (std::size_t i = 0; i < values.size(); ++i) m_v[chart.walks[w].vertices[i]] = values[i];
  }
  return m_problem.solve(chart.mesh, m_v, m_jump);
}

Result<void> Chart_parameterization::solve_rectangle(const Chart& chart, const std::vector<double>& x,
                                                     const std::vector<double>& y) {
  CGAL_precondition(chart.kind == Chart_kind::disc);
  const std::vector<int>& vertices = chart.walks[0].vertices;
  m_v.assign(chart.mesh.number_of_vertices(), 0.0);
  m_u = m_v;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    m_v[vertices[i]] = x[i];
    m_u[vertices[i]] = y[i];
  }
  if (Result<void> solved = m_problem.solve(chart.mesh, m_v); !solved) return solved;
  return m_problem.solve(chart.mesh, m_u);
}

int Chart_parameterization::flipped(const Chart& chart) const {
  int count = 0;
  for (int f = 0; f < chart.mesh.number_of_faces(); ++f) {
    const Triangle& t = chart.mesh.triangles[f];
    const double v1 = m_v[t[1]] + jump(3 * f) - m_v[t[0]], v2 = m_v[t[2]] - jump(3 * f + 2) - m_v[t[0]];
    const double u1 = m_u[t[1]] - m_u[t[0]], u2 = m_u[t[2]] - m_u[t[0]];
    count += !(v1 * u2 - v2 * u1 > 0);
  }
  return count;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
