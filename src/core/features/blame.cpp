// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/blame.h"

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <algorithm>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// As far as relaxation carries what a vertex on a sharp edge does to the quads around it, nearly.
constexpr int rings_around = 4;

double shape_of(const Quad_mesh& mesh, const Quad& q) {
  return scaled_jacobian(mesh.points[std::size_t(q[0])], mesh.points[std::size_t(q[1])],
                         mesh.points[std::size_t(q[2])], mesh.points[std::size_t(q[3])]);
}

// The chain of a curve that ends at the point, or -1.
int chain_ending_at(const Point& p, const Vertex_constraints& onto, const std::vector<int>& chain_of_curve) {
  for (std::size_t c = 0; c < chain_of_curve.size(); ++c)
    if (onto.curves[c].points.front() == p || onto.curves[c].points.back() == p) return chain_of_curve[c];
  return -1;
}

} // namespace

std::vector<int> chains_around(const Quad_mesh& mesh, const Vertex_constraints& onto,
                               const std::vector<int>& chain_of_curve) {
  std::vector<int> chain(mesh.points.size(), -1);
  for (const Vertex_constraints::Place& place : onto.places)
    chain[std::size_t(place.vertex)] = chain_of_curve[std::size_t(place.curve)];
  for (std::size_t v = 0; v < onto.fixed.size(); ++v)
    if (onto.fixed[v] && chain[v] < 0) chain[v] = chain_ending_at(mesh.points[v], onto, chain_of_curve);
  for (int ring = 0; ring < rings_around; ++ring) {
    const std::vector<int> before = chain;
    for (const Quad& q : mesh.quads) {
      int nearest = -1;
      for (int v : q) nearest = std::max(nearest, before[std::size_t(v)]);
      for (int v : q)
        if (before[std::size_t(v)] < 0) chain[std::size_t(v)] = std::max(chain[std::size_t(v)], nearest);
    }
  }
  return chain;
}

std::vector<int> chains_at(const Quad_mesh& mesh, const std::vector<int>& quads,
                           const std::vector<int>& chain_of_vertex) {
  std::vector<int> chains;
  for (int q : quads)
    for (int v : mesh.quads[std::size_t(q)])
      if (chain_of_vertex[std::size_t(v)] >= 0) chains.push_back(chain_of_vertex[std::size_t(v)]);
  std::sort(chains.begin(), chains.end());
  chains.erase(std::unique(chains.begin(), chains.end()), chains.end());
  return chains;
}

std::vector<int> costliest_chains(const Quad_mesh& before, const Quad_mesh& after,
                                  const std::vector<int>& chain_of_vertex, double sum) {
  std::map<int, double> cost;
  for (std::size_t q = 0; q < after.quads.size(); ++q) {
    int chain = -1;
    for (int v : after.quads[q]) chain = std::max(chain, chain_of_vertex[std::size_t(v)]);
    if (chain >= 0) cost[chain] += shape_of(before, before.quads[q]) - shape_of(after, after.quads[q]);
  }
  std::vector<std::pair<double, int>> order;
  for (const auto& [chain, loss] : cost) order.push_back({-loss, chain});
  std::sort(order.begin(), order.end());
  std::vector<int> chains;
  for (const auto& [loss, chain] : order) {
    if (!(sum > 0) || !(loss < 0)) break;
    chains.push_back(chain);
    sum += loss;
  }
  std::sort(chains.begin(), chains.end());
  return chains;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
