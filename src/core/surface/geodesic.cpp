// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

Graph_distances::Graph_distances(const Metric_graph& graph) : m_graph(graph), m_width(1) {
  double sum = 0, longest = 0;
  for (double l : graph.length) {
    sum += l;
    longest = std::max(longest, l);
  }
  if (sum > 0) m_width = sum / double(graph.length.size());
  m_buckets.resize(std::size_t(longest / m_width) + 3);
}

const std::vector<double>& Graph_distances::from(int source) {
  return from(std::vector<int>(1, source));
}

const std::vector<double>& Graph_distances::from(const std::vector<int>& sources) {
  const int ring = int(m_buckets.size());
  m_distance.assign(m_graph.size(), std::numeric_limits<double>::infinity());
  for (int s : sources) m_distance[s] = 0;
  m_buckets[0].assign(sources.begin(), sources.end());
  std::size_t waiting = sources.size();
  for (long long level = 0; waiting > 0; ++level) {
    std::vector<int>& bucket = m_buckets[level % ring];
    // The bucket grows while it is read: an arc shorter than its width leads back into it.
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const int u = bucket[i];
      const double d = m_distance[u];
      if ((long long)(d / m_width) < level) continue; // settled in an earlier bucket
      for (int k = m_graph.begin[u]; k < m_graph.begin[u + 1]; ++k) {
        const int w = m_graph.neighbor[k];
        const double candidate = d + m_graph.length[k];
        if (!(candidate < m_distance[w])) continue;
        m_distance[w] = candidate;
        m_buckets[(long long)(candidate / m_width) % ring].push_back(w);
        ++waiting;
      }
    }
    waiting -= bucket.size();
    bucket.clear();
  }
  return m_distance;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
