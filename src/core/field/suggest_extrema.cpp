// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include "surface/geodesic.h"
#include "surface/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

Result<void> check_request(const Triangle_surface& surface, const Suggestion_options& options) {
  const auto refuse = [](const char* why) { return make_error(Error_code::impossible_request, why); };
  if (!(options.persistence > 0 && options.persistence <= 1))
    return refuse("the persistence must be in (0, 1]");
  if (!(options.relative_area > 0 && options.relative_area <= 1))
    return refuse("the relative area of a neighbourhood must be in (0, 1]");
  if (options.working_faces < 200) return refuse("the working copy must have at least 200 faces");
  if (!options.axis.allFinite() || !(options.axis.cwiseAbs().maxCoeff() > 0))
    return refuse("the height axis must be a finite vector other than zero");
  if (surface.triangles.empty()) return make_error(Error_code::not_a_surface, "the surface has no face");
  return {};
}

// Needles are so much longer than the radius, which is taken from the area, that they would get a source
// every few edges.
constexpr int most_sources = 1000;

// Sources that cover the graph with a radius, each as far as possible from those before it, and for every
// node the sum of its distances to them, weighted by the areas of their Voronoi cells. Empty if cancelled.
std::vector<double> integral_geodesic_function(const Metric_graph& graph, Graph_distances& distances,
                                               double radius, Observer* observer) {
  const int n = graph.size();
  const auto farthest = [&](const std::vector<double>& d) {
    return int(std::max_element(d.begin(), d.end()) - d.begin());
  };
  std::vector<double> to_nearest(n, std::numeric_limits<double>::infinity());
  std::vector<int> nearest(n, -1);
  std::vector<std::vector<double>> rows;
  for (int source = farthest(distances.from(0));;) {
    if (observer && observer->cancelled()) return {};
    rows.push_back(distances.from(source));
    const std::vector<double>& row = rows.back();
    for (int i = 0; i < n; ++i)
      if (row[i] < to_nearest[i]) {
        to_nearest[i] = row[i];
        nearest[i] = int(rows.size()) - 1;
      }
    source = farthest(to_nearest);
    if (to_nearest[source] <= radius || int(rows.size()) >= most_sources) break;
  }
  std::vector<double> weight(rows.size(), 0), mu(n, 0);
  for (int i = 0; i < n; ++i) weight[nearest[i]] += graph.area[i];
  for (std::size_t s = 0; s < rows.size(); ++s)
    for (int i = 0; i < n; ++i) mu[i] += weight[s] * rows[s][i];
  return mu;
}

struct Peak {
  int node;
  double persistence;
};

// The maxima of a function on a graph with the persistence of their superlevel components (the highest one
// lives as long as the function's range), by decreasing persistence, then by node.
std::vector<Peak> persistent_peaks(const Metric_graph& graph, const std::vector<double>& value) {
  const int n = graph.size();
  std::vector<int> order(n), parent(n, -1), peak(n); // `peak` of a root: the highest node of its component
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return value[a] != value[b] ? value[a] > value[b] : a < b; });
  std::vector<int> rank(n);
  for (int i = 0; i < n; ++i) rank[order[i]] = i;
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<Peak> peaks{{order.front(), value[order.front()] - value[order.back()]}};
  for (int v : order) {
    parent[v] = peak[v] = v;
    for (int k = graph.begin[v]; k < graph.begin[v + 1]; ++k) {
      if (parent[graph.neighbor[k]] < 0) continue;
      int older = root(graph.neighbor[k]), younger = root(v);
      if (older == younger) continue;
      if (rank[peak[older]] > rank[peak[younger]]) std::swap(older, younger);
      if (peak[younger] != v) peaks.push_back({peak[younger], value[peak[younger]] - value[v]});
      parent[younger] = older;
    }
  }
  std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) {
    return a.persistence != b.persistence ? a.persistence > b.persistence : a.node < b.node;
  });
  return peaks;
}

// Turns nodes into vertices that may carry an extremum: interior, not adjacent to each other or to the
// boundary where the mesh has room for it.
class Vertex_picker {
public:
  Vertex_picker(const Triangle_surface& surface, const Metric_graph& graph)
      : m_surface(surface), m_graph(graph), m_state(surface.number_of_vertices(), free) {
    for (int v = 0; v < surface.number_of_vertices(); ++v)
      if (surface.outgoing[v] < 0 || surface.is_boundary(surface.outgoing[v])) m_state[v] = taken;
    for (int v = 0; v < surface.number_of_vertices(); ++v)
      if (m_state[v] == taken && surface.outgoing[v] >= 0) discourage_neighbors(v);
  }

  // A free vertex at the tip of the node's patch, or else the nearest vertex (in edges) that is free, or else
  // that is not taken; -1 if all are taken.
  int pick(int node, const Point& behind) {
    int v = tip(node, behind);
    if (v < 0) v = search(m_graph.vertex[node], free);
    if (v < 0) v = search(m_graph.vertex[node], discouraged);
    if (v < 0) return -1;
    m_state[v] = taken;
    discourage_neighbors(v);
    return v;
  }

private:
  enum State : char { free, discouraged, taken };

  void discourage_neighbors(int v) {
    for_each_neighbor(m_surface, v, [&](int w) {
      if (m_state[w] == free) m_state[w] = discouraged;
    });
  }

  // The free vertex of the node's patch that lies farthest in the direction from `behind` to the node's
  // centre.
  int tip(int node, const Point& behind) const {
    const Point center = m_graph.position[node], direction = center - behind;
    int best = -1;
    double most = -std::numeric_limits<double>::infinity();
    std::vector<int> queue{m_graph.vertex[node]};
    if (m_graph.node_of_vertex[queue[0]] != node) return -1; // a node inside an edge has no patch of vertices
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int v = queue[i];
      const double ahead = direction.dot(m_surface.points[v] - center);
      if (m_state[v] == free && ahead > most) {
        most = ahead;
        best = v;
      }
      for_each_neighbor(m_surface, v, [&](int w) {
        if (m_graph.node_of_vertex[w] != node || std::find(queue.begin(), queue.end(), w) != queue.end())
          return;
        queue.push_back(w);
      });
    }
    return best;
  }

  int search(int start, State worst) const {
    std::vector<char> seen(m_surface.number_of_vertices(), 0);
    std::vector<int> queue{start};
    seen[start] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (m_state[queue[i]] <= worst) return queue[i];
      for_each_neighbor(m_surface, queue[i], [&](int w) {
        if (seen[w]) return;
        seen[w] = 1;
        queue.push_back(w);
      });
    }
    return -1;
  }

  const Triangle_surface& m_surface;
  const Metric_graph& m_graph;
  std::vector<char> m_state;
};

// A constraint on its way to a constant: an extremum or a boundary loop.
struct Item {
  double height; // as `relative_height` gives it
  bool is_maximum = false;
};

// 0 at the bottom of the surface, 2^30 at its top; rounded, so that equal heights of a symmetric shape stay
// equal wherever the shape lies in space.
double relative_height(double height, double low, double high) {
  return high > low ? std::nearbyint(std::ldexp((height - low) / (high - low), 30)) : 0;
}

// The lower half of the surface is for minima; if that leaves one kind empty, the lower half of the items is.
void split_by_height(std::vector<Item>& items) {
  const double middle = std::ldexp(0.5, 30);
  int maxima = 0;
  for (Item& item : items) maxima += item.is_maximum = !(item.height < middle);
  const int n = int(items.size());
  if (maxima > 0 && maxima < n) return;
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return items[a].height < items[b].height; });
  for (int i = 0; i < n; ++i) items[order[i]].is_maximum = i >= n / 2;
}

// Mean height of a boundary loop, weighted by length.
double loop_height(const Triangle_surface& surface, const std::vector<int>& loop,
                   const Eigen::Vector3d& axis) {
  double sum = 0, length = 0, plain = 0;
  for (int h : loop) {
    const Point p = surface.points[surface.source(h)], q = surface.points[surface.target(h)];
    const double l = (q - p).norm();
    sum += l * axis.dot(p + q) / 2;
    plain += axis.dot(p);
    length += l;
  }
  return length > 0 ? sum / length : plain / double(loop.size());
}

// The features that become extrema, chosen on the graph.
class Feature_selection {
public:
  Feature_selection(const Triangle_surface& surface, const Metric_graph& graph, Graph_distances& distances,
                    double radius, const std::vector<std::vector<int>>& loops)
      : m_graph(graph), m_distances(distances), m_radius(radius), m_picker(surface, graph) {
    std::vector<int> boundary;
    for (const std::vector<int>& loop : loops)
      for (int h : loop) boundary.push_back(graph.node_of_vertex[surface.source(h)]);
    m_to_nearest.assign(graph.size(), std::numeric_limits<double>::infinity());
    if (!boundary.empty()) m_to_nearest = distances.from(boundary);
  }

  // Adds the node's tip as an extremum unless it is too near to what there is.
  void offer(int node, double prominence) {
    if (m_to_nearest[node] > m_radius) add(node, prominence);
  }

  // Adds the point that is farthest from everything so far.
  void add_farthest() {
    add(int(std::max_element(m_to_nearest.begin(), m_to_nearest.end()) - m_to_nearest.begin()), 0);
  }

  std::vector<Suggested_extremum> extrema;

private:
  void add(int node, double prominence) {
    const std::vector<double>& d = m_distances.from(node);
    Point behind(0, 0, 0);
    double weight = 0;
    for (int i = 0; i < m_graph.size(); ++i) {
      m_to_nearest[i] = std::min(m_to_nearest[i], d[i]);
      if (d[i] > 2 * m_radius) continue;
      behind += m_graph.area[i] * (m_graph.position[i] - m_graph.position[node]);
      weight += m_graph.area[i];
    }
    if (weight > 0) behind /= weight;
    const int vertex = m_picker.pick(node, m_graph.position[node] + behind);
    if (vertex >= 0) extrema.push_back({vertex, false, prominence});
  }

  const Metric_graph& m_graph;
  Graph_distances& m_distances;
  double m_radius;
  Vertex_picker m_picker;
  std::vector<double> m_to_nearest;
};

void label_by_height(const Triangle_surface& surface, const std::vector<std::vector<int>>& loops,
                     const Eigen::Vector3d& axis, Suggestion& suggestion) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (surface.outgoing[v] < 0) continue;
    low = std::min(low, axis.dot(surface.points[v]));
    high = std::max(high, axis.dot(surface.points[v]));
  }
  std::vector<Item> items;
  for (const Suggested_extremum& e : suggestion.extrema)
    items.push_back({relative_height(axis.dot(surface.points[e.vertex]), low, high)});
  for (const std::vector<int>& loop : loops)
    items.push_back({relative_height(loop_height(surface, loop, axis), low, high)});
  split_by_height(items);
  const std::size_t n = suggestion.extrema.size();
  for (std::size_t i = 0; i < n; ++i) suggestion.extrema[i].is_maximum = items[i].is_maximum;
  for (std::size_t i = n; i < items.size(); ++i)
    suggestion.boundary_is_maximum.push_back(items[i].is_maximum);
}

// On round shapes the integral geodesic function is nearly constant, and its range is discretization error: a
// protrusion must also rise by this fraction of the largest value.
const double noise = 0.02;

} // namespace

Result<Suggestion> suggest_extrema(const Triangle_surface& surface, const Suggestion_options& options,
                                   Observer* observer) {
  if (Result<void> checked = check_request(surface, options); !checked) return checked.error();
  const double total = area(surface);
  if (!(total > 0) || !std::isfinite(total))
    return make_error(Error_code::not_a_surface, "the surface has no area, or an infinite one");
  if (observer) observer->progress("suggest extrema", 0);

  const Metric_graph graph = decimate(surface, options.working_faces / 2);
  Graph_distances distances(graph);
  if (const std::vector<double>& d = distances.from(0); std::isinf(*std::max_element(d.begin(), d.end())))
    return make_error(Error_code::not_a_surface,
                      "extrema are suggested for one component at a time; the surface has " +
                          std::to_string(connected_components(surface).second),
                      Element_kind::component, 1);
  const double radius = std::sqrt(options.relative_area * total);
  const std::vector<double> mu = integral_geodesic_function(graph, distances, radius, observer);
  if (mu.empty()) return make_error(Error_code::cancelled, "the suggestion of extrema was cancelled");

  const std::vector<Peak> peaks = persistent_peaks(graph, mu);
  const double range = peaks.front().persistence, largest = *std::max_element(mu.begin(), mu.end());
  const std::vector<std::vector<int>> loops = boundary_loops(surface);
  Feature_selection selection(surface, graph, distances, radius, loops);
  Suggestion suggestion;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    // The highest peak is one even where the function is constant.
    const double prominence = i == 0 ? 1 : peaks[i].persistence / range;
    suggestion.spectrum.push_back(prominence);
    if (i == 0 || (prominence >= options.persistence && peaks[i].persistence >= noise * largest))
      selection.offer(peaks[i].node, prominence);
  }
  if (selection.extrema.size() + loops.size() < 2) selection.add_farthest();
  if (selection.extrema.size() + loops.size() < 2)
    return make_error(Error_code::not_a_surface,
                      "the surface has no interior vertex that could be an extremum");
  suggestion.extrema = std::move(selection.extrema);
  label_by_height(surface, loops, options.axis / options.axis.cwiseAbs().maxCoeff(), suggestion);
  if (observer) observer->progress("suggest extrema", 1);
  return suggestion;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
