// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SURFACE_GEODESIC_H
#define REEBQUAD_SURFACE_GEODESIC_H

#include <CGAL/Reeb_quadrangulation/decimate.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Shortest path lengths in a metric graph, from many sources one after the other.
///
/// A label-correcting search with buckets of one mean arc length (delta-stepping without the parallelism;
/// Meyer and Sanders 2003): the lengths are the least fixed point of the relaxations, so they do not depend
/// on the order in which nodes leave a bucket.
class Graph_distances {
public:
  explicit Graph_distances(const Metric_graph& graph);

  /// Distances from the nearest of `sources` to all nodes.
  const std::vector<double>& from(const std::vector<int>& sources);
  const std::vector<double>& from(int source);

private:
  const Metric_graph& m_graph;
  double m_width;
  std::vector<double> m_distance;
  std::vector<std::vector<int>> m_buckets; // a ring
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_GEODESIC_H
