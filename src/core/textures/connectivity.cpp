// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quad_connectivity.h"

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

int connect_quads(const std::vector<Quad>& quads, int number_of_vertices, std::vector<int>& opposite) {
  // The halfedges that leave each vertex, in the order of their quads.
  std::vector<int> begin(number_of_vertices + 1, 0), leaving(4 * quads.size());
  for (const Quad& q : quads)
    for (int v : q) ++begin[v + 1];
  for (int v = 0; v < number_of_vertices; ++v) begin[v + 1] += begin[v];
  std::vector<int> end(begin.begin(), begin.end() - 1);
  for (int h = 0; h < int(leaving.size()); ++h) leaving[end[source(quads, h)]++] = h;

  opposite.assign(leaving.size(), -1);
  for (int h = 0; h < int(leaving.size()); ++h) {
    const int a = source(quads, h), b = target(quads, h);
    if (a == b) return quad_of(h);
    for (int k = begin[a]; k < begin[a + 1]; ++k)
      if (leaving[k] != h && target(quads, leaving[k]) == b) return quad_of(h);
    for (int k = begin[b]; k < begin[b + 1]; ++k)
      if (target(quads, leaving[k]) == a) opposite[h] = leaving[k];
  }
  return -1;
}

int find_fault(const std::vector<Quad>& quads, int number_of_vertices) {
  for (int q = 0; q < int(quads.size()); ++q)
    if (quads[q][0] == quads[q][2] || quads[q][1] == quads[q][3]) return q;
  std::vector<int> opposite, at(std::size_t(number_of_vertices), 0);
  if (const int q = connect_quads(quads, number_of_vertices, opposite); q >= 0) return q;
  for (const Quad& q : quads)
    for (int v : q) ++at[std::size_t(v)];
  // The fan of each vertex from its boundary, or from any quad, has all quads at the vertex.
  for (int h = 0; h < int(opposite.size()); ++h) {
    int& left = at[std::size_t(source(quads, h))];
    if (left <= 0) continue;
    int first = h;
    while (opposite[first] >= 0 && next(opposite[first]) != h) first = next(opposite[first]);
    int number = 1;
    for (int k = opposite[previous(first)]; k >= 0 && k != first; k = opposite[previous(k)]) ++number;
    if (number != left) return quad_of(h);
    left = 0;
  }
  return -1;
}

std::vector<std::pair<int, int>> quad_components(const std::vector<Quad>& quads, int number_of_vertices) {
  std::vector<int> opposite, component(quads.size(), -1);
  connect_quads(quads, number_of_vertices, opposite);
  std::vector<std::pair<int, int>> result;
  for (int q = 0; q < int(quads.size()); ++q) {
    if (component[q] >= 0) continue;
    component[q] = int(result.size());
    std::vector<int> reached{q};
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (int h = 4 * reached[i]; h < 4 * reached[i] + 4; ++h)
        if (opposite[h] >= 0 && component[quad_of(opposite[h])] < 0) {
          component[quad_of(opposite[h])] = int(result.size());
          reached.push_back(quad_of(opposite[h]));
        }
    result.emplace_back(0, 0);
  }
  std::vector<char> counted(std::size_t(number_of_vertices), 0), passed(opposite.size(), 0);
  for (int h = 0; h < int(opposite.size()); ++h) {
    auto& [euler, loops] = result[component[quad_of(h)]];
    euler += (h & 3) == 0;                            // a quad
    euler -= opposite[h] < h;                         // an edge
    euler += !counted[std::size_t(source(quads, h))]; // a vertex
    counted[std::size_t(source(quads, h))] = 1;
    if (opposite[h] >= 0 || passed[h]) continue;
    ++loops;
    for (int b = h; !passed[b];) {
      passed[b] = 1;
      for (b = next(b); opposite[b] >= 0;) b = next(opposite[b]);
    }
  }
  return result;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
