// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quad_connectivity.h"
#include "surface/size_at.h"

#include <CGAL/Reeb_quadrangulation/adapt_quads.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Numbers of quads at each vertex, negative at boundary vertices.
std::vector<int> inner_valences(const std::vector<Quad>& quads, const std::vector<int>& opposite,
                                int vertices) {
  std::vector<int> valence(vertices, 0);
  for (const Quad& q : quads)
    for (int v : q) ++valence[v];
  for (int h = 0; h < int(opposite.size()); ++h)
    if (opposite[h] < 0)
      for (int v : {internal::source(quads, h), internal::target(quads, h)}) valence[v] = -1;
  return valence;
}

class Refinement {
public:
  Refinement(const Quad_mesh& mesh, const std::vector<char>& marked) : m_mesh(mesh), m_marked(marked) {}

  Result<Refined_quads> run(const T_junction_options& options) {
    if (const int bad = internal::connect_quads(m_mesh.quads, int(m_mesh.points.size()), m_opposite);
        bad >= 0)
      return make_error(Error_code::not_a_surface, "the quads are not an oriented manifold mesh",
                        Element_kind::face, bad);
    m_fine.points = m_mesh.points;
    m_middle.assign(m_opposite.size(), -1);
    for (int h = 0; h < int(m_opposite.size()); ++h)
      if (m_marked[h / 4] && m_middle[h] < 0) split(h);
    for (int q = 0; q < int(m_mesh.quads.size()); ++q) add(q);
    return resolve(options);
  }

private:
  void split(int h) {
    m_middle[h] = int(m_fine.points.size());
    if (m_opposite[h] >= 0) m_middle[m_opposite[h]] = m_middle[h];
    m_fine.points.push_back(0.5 * (m_mesh.points[internal::source(m_mesh.quads, h)] +
                                   m_mesh.points[internal::target(m_mesh.quads, h)]));
  }

  void add(int q) {
    const Quad& quad = m_mesh.quads[q];
    if (!m_marked[q]) {
      for (int i = 0; i < 4; ++i)
        if (m_middle[4 * q + i] >= 0)
          m_hanging.push_back({int(m_fine.quads.size()), i, {m_middle[4 * q + i]}});
      m_fine.quads.push_back(quad);
      m_parent.push_back(q);
      return;
    }
    const int centre = int(m_fine.points.size());
    m_fine.points.push_back(0.25 * (m_mesh.points[quad[0]] + m_mesh.points[quad[1]] + m_mesh.points[quad[2]] +
                                    m_mesh.points[quad[3]]));
    for (int i = 0; i < 4; ++i) {
      m_fine.quads.push_back({quad[i], m_middle[4 * q + i], centre, m_middle[4 * q + (i + 3) % 4]});
      m_parent.push_back(q);
    }
  }

  Result<Refined_quads> resolve(const T_junction_options& options) {
    Refined_quads out;
    out.t_junctions = int(m_hanging.size());
    std::vector<int> before = inner_valences(m_mesh.quads, m_opposite, int(m_mesh.points.size()));
    Result<Resolved_mesh> resolved = resolve_t_junctions(m_fine, m_hanging, options);
    if (!resolved) return resolved.error();
    out.mesh = std::move(resolved->mesh);
    for (int parent : resolved->parent) out.parent.push_back(m_parent[parent]);
    // New vertices: middles of quads and of edges between two that were split have four edges, T-junctions
    // three, before the lines.
    const int old = int(before.size());
    before.resize(m_fine.points.size(), 4);
    for (const Hanging_edge& e : m_hanging) before[e.vertices[0]] = 3;
    for (int h = 0; h < int(m_opposite.size()); ++h)
      if (m_opposite[h] < 0 && m_middle[h] >= 0) before[m_middle[h]] = -1;
    before.resize(out.mesh.points.size(), 0);
    for (int v : resolved->boundary_vertices) before[v] = -1;
    for (int v = 0; v < int(before.size()); ++v) {
      if (before[v] < 0) continue;
      if (v < old) --out.valence_changes[before[v]];
      ++out.valence_changes[before[v] + resolved->added_edges[v]];
    }
    return out;
  }

  const Quad_mesh& m_mesh;
  const std::vector<char>& m_marked;
  std::vector<int> m_opposite;
  std::vector<int> m_middle; ///< per halfedge: the vertex in its middle, or -1
  Quad_mesh m_fine;
  std::vector<int> m_parent;
  std::vector<Hanging_edge> m_hanging;
};

Point inside(const Quad_mesh& mesh, const Quad& q, double s, double t) {
  return (1 - t) * ((1 - s) * mesh.points[q[0]] + s * mesh.points[q[1]]) +
         t * ((1 - s) * mesh.points[q[3]] + s * mesh.points[q[2]]);
}

// The greatest angle between the surface's normals at nine points of the quad, which do not include the
// corners: so that the faces of a sharp edge are seen by the quads that it crosses or bounds alike.
double turn(const Quad_mesh& mesh, const Quad& q, const Surface_projector& projector, int& hint) {
  std::array<Point, 9> normals;
  for (int i = 0; i < 9; ++i) {
    const Closest_point found =
        projector.closest(inside(mesh, q, 0.1 + 0.4 * (i % 3), 0.1 + 0.4 * (i / 3)), hint);
    hint = found.face;
    normals[i] = projector.normal(found.face);
  }
  double least = 1; // cosine
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < i; ++j) least = std::min(least, normals[i].dot(normals[j]));
  return std::acos(std::max(-1.0, least));
}

std::vector<char> large_quads(const Quad_mesh& mesh, const std::function<double(const Point&)>& size) {
  std::vector<char> marked;
  for (const Quad& q : mesh.quads) {
    double length = 0;
    for (int i = 0; i < 4; ++i) length += 0.25 * (mesh.points[q[(i + 1) % 4]] - mesh.points[q[i]]).norm();
    marked.push_back(length > std::sqrt(2.0) * size(inside(mesh, q, 0.5, 0.5)));
  }
  return marked;
}

// Which quads are subdivided together.
class Regions {
public:
  explicit Regions(const Quad_mesh& mesh) : m_quads(mesh.quads) {
    internal::connect_quads(mesh.quads, int(mesh.points.size()), m_opposite);
  }

  // Means over neighbours, so that regions of large values are few and compact.
  std::vector<double> averaged(std::vector<double> values) const {
    for (int round = 0; round < 3; ++round) {
      const std::vector<double> before = values;
      for (int q = 0; q < int(m_quads.size()); ++q) {
        double sum = 2 * before[q], weight = 2;
        for (int h = 4 * q; h < 4 * q + 4; ++h)
          if (m_opposite[h] >= 0) {
            sum += before[m_opposite[h] / 4];
            ++weight;
          }
        values[q] = sum / weight;
      }
    }
    return values;
  }

  // Fills the corners and gaps of regions and takes off what sticks out of them: each corner of a border
  // costs extraordinary vertices.
  std::vector<char> smoothed(std::vector<char> marked) const {
    for (const int enough : {2, 2, 3}) {
      const std::vector<char> before = marked;
      for (int q = 0; q < int(m_quads.size()); ++q)
        if (neighbours(before, q) >= enough) marked[q] = 1;
    }
    for (int round = 0; round < 2; ++round) {
      const std::vector<char> before = marked;
      for (int q = 0; q < int(m_quads.size()); ++q)
        if (neighbours(before, q) < 2) marked[q] = 0;
    }
    return marked;
  }

private:
  int neighbours(const std::vector<char>& marked, int q) const {
    int n = 0;
    for (int h = 4 * q; h < 4 * q + 4; ++h) n += m_opposite[h] >= 0 && marked[m_opposite[h] / 4];
    return n;
  }

  const std::vector<Quad>& m_quads;
  std::vector<int> m_opposite;
};

// The quads that bend most, most of all first, without those that are nearly flat.
std::vector<int> bent_quads(const Quad_mesh& mesh, const Surface_projector& projector, double flat,
                            const std::vector<char>& candidates, const Regions& regions) {
  std::vector<double> angles;
  int hint = -1;
  for (const Quad& q : mesh.quads) angles.push_back(turn(mesh, q, projector, hint));
  angles = regions.averaged(std::move(angles));
  std::vector<std::pair<double, int>> order;
  for (int q = 0; q < int(mesh.quads.size()); ++q)
    if (candidates[q] && angles[q] >= flat * std::acos(-1.0) / 180) order.push_back({-angles[q], q});
  std::sort(order.begin(), order.end());
  std::vector<int> quads;
  for (const auto& [angle, q] : order) quads.push_back(q);
  return quads;
}

// A mesh in which quads are refined, and which ones.
struct Refinement_step {
  std::vector<char> marked;
  Refined_quads refined;
};

Result<Refinement_step> refine(const Quad_mesh& mesh, std::vector<char> marked,
                               const T_junction_options& lines) {
  Result<Refined_quads> refined = refine_quads(mesh, marked, lines);
  if (!refined) return refined.error();
  return Refinement_step{std::move(marked), std::move(*refined)};
}

// Refines as many of the first quads as give a number of quads in the end, but for a few of them.
Result<Refinement_step> refine_first(const Quad_mesh& mesh, const std::vector<int>& order,
                                     const Regions& regions, double quads, const T_junction_options& lines) {
  Result<Refinement_step> best = refine(mesh, std::vector<char>(mesh.quads.size(), 0), lines);
  std::size_t low = 0, high = order.size();
  while (best && high - low > order.size() / 500) {
    const std::size_t middle = (low + high + 1) / 2;
    std::vector<char> marked(mesh.quads.size(), 0);
    for (std::size_t i = 0; i < middle; ++i) marked[std::size_t(order[i])] = 1;
    Result<Refinement_step> step = refine(mesh, regions.smoothed(std::move(marked)), lines);
    if (!step) return step;
    if (double(step->refined.mesh.quads.size()) <= quads) {
      low = middle;
      best = std::move(step);
    } else
      high = middle - 1;
  }
  return best;
}

} // namespace

Result<Refined_quads> refine_quads(const Quad_mesh& mesh, const std::vector<char>& marked,
                                   const T_junction_options& options) {
  CGAL_precondition(marked.size() == mesh.quads.size());
  return Refinement(mesh, marked).run(options);
}

Result<Adapted_quads> adapt_quads(const Quad_mesh& mesh, const Surface_projector& projector,
                                  const Adaptive_options& options) {
  if (options.ratio != 1 && options.ratio != 2 && options.ratio != 4 && options.ratio != 8)
    return make_error(Error_code::impossible_request, "the ratio of an adaptive mesh is 1, 2, 4 or 8");
  if (options.quads < 0 || !(options.flat >= 0))
    return make_error(Error_code::impossible_request, "a number of quads or an angle is negative");
  std::function<double(const Point&)> size = options.size;
  if (!size && !options.sizes.empty()) {
    if (Result<void> fine = internal::check_sizes(projector.surface(), options.sizes); !fine)
      return fine.error();
    size = internal::Size_at(projector, options.sizes);
  }
  double quads = double(mesh.quads.size());
  const double factor = options.quads == 0 ? 2
                                           : std::pow(options.quads / std::max(1.0, quads),
                                                      1 / std::log2(double(options.ratio)));
  Adapted_quads out{mesh, std::vector<int>(mesh.quads.size()), {}, 0, 0};
  for (std::size_t q = 0; q < out.parent.size(); ++q) out.parent[q] = int(q);
  std::vector<char> candidates(mesh.quads.size(), 1);
  for (int step = 2; step <= options.ratio; step *= 2) {
    const Regions regions(out.mesh);
    quads *= factor;
    Result<Refinement_step> done =
        size ? refine(out.mesh, regions.smoothed(large_quads(out.mesh, size)), options.lines)
             : refine_first(out.mesh, bent_quads(out.mesh, projector, options.flat, candidates, regions),
                            regions, quads, options.lines);
    if (!done) return done.error();
    const std::vector<char>& marked = done->marked;
    Refined_quads* const refined = &done->refined;
    for (std::size_t v = out.mesh.points.size(); v < refined->mesh.points.size(); ++v)
      refined->mesh.points[v] = projector.closest(refined->mesh.points[v]).point;
    std::vector<int> parent;
    candidates.clear();
    for (int p : refined->parent) {
      parent.push_back(out.parent[p]);
      candidates.push_back(marked[p]);
    }
    out.parent = std::move(parent);
    out.mesh = std::move(refined->mesh);
    out.t_junctions += refined->t_junctions;
    out.subdivided += int(std::count(marked.begin(), marked.end(), 1));
    for (const auto& [valence, number] : refined->valence_changes) out.valence_changes[valence] += number;
  }
  return out;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
