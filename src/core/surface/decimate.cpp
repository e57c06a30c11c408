// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/decimate.h>

#include "surface/surface_walk.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Takes the first vertex that is not yet within `radius` of a centre as the next centre and floods the ball
// around it, stopping at vertices that are nearer to an earlier centre.
void grow_patches(const Triangle_surface& s, double radius, Metric_graph& graph) {
  const double limit = radius * radius;
  std::vector<double> nearest(s.number_of_vertices(), 2 * limit);
  std::vector<int> queue;
  graph.node_of_vertex.assign(s.number_of_vertices(), -1);
  for (int center = 0; center < s.number_of_vertices(); ++center) {
    if (s.outgoing[center] < 0 || graph.node_of_vertex[center] >= 0) continue;
    const int node = graph.size();
    graph.vertex.push_back(center);
    graph.position.push_back(s.points[center]);
    graph.node_of_vertex[center] = node;
    nearest[center] = 0;
    queue.assign(1, center);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for_each_neighbor(s, queue[i], [&](int w) {
        const double squared = (s.points[w] - s.points[center]).squaredNorm();
        if (squared > limit || squared >= nearest[w]) return;
        nearest[w] = squared;
        graph.node_of_vertex[w] = node;
        queue.push_back(w);
      });
  }
}

// Nodes inside edges that are longer than `spacing`, in equal distances; returns the first node of each edge
// (by its halfedge `edge(h)`), and their number.
struct Edge_nodes {
  std::vector<int> first, count;
  bool is_any = false;
};

Edge_nodes subdivide_long_edges(const Triangle_surface& s, double spacing, Metric_graph& graph) {
  // A cap keeps the number of arcs across a face, quadratic in this, harmless on needles.
  const int most = 8;
  Edge_nodes nodes{std::vector<int>(s.number_of_halfedges(), -1),
                   std::vector<int>(s.number_of_halfedges(), 0), false};
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    if (s.edge(h) != h) continue;
    const Point p = s.points[s.source(h)], q = s.points[s.target(h)];
    const double squared = (q - p).squaredNorm();
    if (squared <= spacing * spacing) continue;
    const double ratio = std::sqrt(squared) / spacing;
    const int pieces = ratio < most + 1 ? int(std::ceil(ratio)) : most + 1;
    nodes.is_any = true;
    nodes.first[h] = graph.size();
    nodes.count[h] = pieces - 1;
    for (int i = 1; i < pieces; ++i) {
      graph.vertex.push_back(2 * i <= pieces ? s.source(h) : s.target(h));
      graph.position.push_back(p + (q - p) * (double(i) / pieces));
    }
  }
  return nodes;
}

// Patches, and nodes inside edges that are longer than two radii. Needles have much length for their area,
// and would get a node for every vertex and eight for every edge: then the radius grows.
Edge_nodes sample(const Triangle_surface& s, double radius, int nodes, Metric_graph& graph) {
  const int most = 10 * nodes;
  for (;; radius *= 2) {
    graph = Metric_graph();
    grow_patches(s, radius, graph);
    Edge_nodes inside = subdivide_long_edges(s, 2 * radius, graph);
    if (graph.size() <= most || !std::isfinite(radius) || graph.size() == 1) return inside;
  }
}

// The nodes of side i of a face in order, its corners excluded.
void side_nodes(const Triangle_surface& s, const Edge_nodes& nodes, int h, std::vector<int>& out) {
  const int e = s.edge(h);
  out.clear();
  for (int i = 0; i < nodes.count[e]; ++i) out.push_back(nodes.first[e] + i);
  if (e != h) std::reverse(out.begin(), out.end());
}

using Arc = std::pair<int, int>;

// Joins the nodes of a subdivided face: neighbours along a side, and every two nodes that are not on one
// side.
void join_across_face(const Triangle_surface& s, const Edge_nodes& nodes, int f, double area,
                      Metric_graph& graph, std::vector<Arc>& arcs) {
  std::vector<int> inner[3], all;
  int corner[3];
  for (int i = 0; i < 3; ++i) {
    side_nodes(s, nodes, 3 * f + i, inner[i]);
    corner[i] = graph.node_of_vertex[s.triangles[f][i]];
  }
  for (int i = 0; i < 3; ++i) {
    int last = corner[i];
    for (int n : inner[i]) {
      arcs.emplace_back(last, n);
      last = n;
      arcs.emplace_back(n, corner[(i + 2) % 3]);
      for (int m : inner[(i + 1) % 3]) arcs.emplace_back(n, m);
    }
    arcs.emplace_back(last, corner[(i + 1) % 3]);
    all.push_back(corner[i]);
    all.insert(all.end(), inner[i].begin(), inner[i].end());
  }
  for (int n : all) graph.area[n] += area / double(all.size());
}

// Sorts arcs into rows by counting, drops repetitions and measures lengths.
void store_arcs(const std::vector<Arc>& arcs, Metric_graph& graph) {
  const int n = graph.size();
  std::vector<int> end(n + 1, 0), mark(n, -1);
  for (const Arc& a : arcs) {
    ++end[a.first];
    ++end[a.second];
  }
  int total = 0;
  for (int i = 0; i <= n; ++i) {
    const int count = end[i];
    end[i] = total;
    total += count;
  }
  const std::vector<int> start = end;
  std::vector<int> row(total);
  for (const Arc& a : arcs) {
    row[end[a.first]++] = a.second;
    row[end[a.second]++] = a.first;
  }
  graph.begin.assign(1, 0);
  for (int i = 0; i < n; ++i) {
    const std::size_t first = graph.neighbor.size();
    for (int k = start[i]; k < end[i]; ++k) {
      if (row[k] == i || mark[row[k]] == i) continue;
      mark[row[k]] = i;
      graph.neighbor.push_back(row[k]);
    }
    std::sort(graph.neighbor.begin() + first, graph.neighbor.end());
    for (std::size_t k = first; k < graph.neighbor.size(); ++k)
      graph.length.push_back((graph.position[graph.neighbor[k]] - graph.position[i]).norm());
    graph.begin.push_back(int(graph.neighbor.size()));
  }
}

} // namespace

Metric_graph decimate(const Triangle_surface& surface, int nodes) {
  CGAL_precondition(nodes > 0);
  Metric_graph graph;
  // On fine meshes this sampling leaves one centre for about 1.5 squared radii (measured).
  std::vector<double> areas(surface.number_of_faces());
  for (int f = 0; f < surface.number_of_faces(); ++f) areas[f] = area(surface, f);
  const double radius = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.0) / (1.5 * nodes));
  const Edge_nodes inside = sample(surface, radius, nodes, graph);
  graph.area.assign(graph.size(), 0.0);
  std::vector<Arc> arcs;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    int subdivided = 0;
    for (int i = 0; i < 3 && inside.is_any; ++i) subdivided += inside.count[surface.edge(3 * f + i)];
    if (subdivided > 0) {
      join_across_face(surface, inside, f, areas[f], graph, arcs);
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const int h = 3 * f + i;
      const int a = graph.node_of_vertex[surface.source(h)], b = graph.node_of_vertex[surface.target(h)];
      graph.area[a] += areas[f] / 3;
      if (a != b && surface.edge(h) == h) arcs.emplace_back(a, b);
    }
  }
  store_arcs(arcs, graph);
  return graph;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
