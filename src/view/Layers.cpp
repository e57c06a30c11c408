// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Layers.h"

#include "view/Skeleton.h"

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <algorithm>
#include <limits>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

Frame surface_frame(const Triangle_surface& surface, const Point& origin) {
  Frame frame("surface");
  frame.add_points("position", surface.points, origin);
  frame.add_indices("triangle", surface.triangles);
  return frame;
}

std::int32_t chart_id(const Layer_source& source, int chart) {
  return chart < 0 ? -1 : source.chart_ids[chart];
}

/// The faces that contours cross, in pieces: what of the embedded surface is not the surface's own, with all
/// that is known there.
Frame cuts_frame(const Layer_source& source) {
  const Charted_surface& charted = *source.charted;
  const Triangle_surface &base = charted.base, &cut = charted.embedding.surface;
  const auto first = std::ptrdiff_t(base.points.size());
  std::vector<int> pieces;
  for (int f = 0; f < cut.number_of_faces(); ++f)
    if (f >= base.number_of_faces() || cut.triangles[f] != base.triangles[f]) pieces.push_back(f);
  // By the face that they lie in: so an edit leaves most of the order as it is.
  std::stable_sort(pieces.begin(), pieces.end(), [&](int a, int b) {
    return charted.embedding.base_face[a] < charted.embedding.base_face[b];
  });
  std::vector<std::uint32_t> base_face, triangle;
  std::vector<std::int32_t> charts;
  for (const int f : pieces) {
    base_face.push_back(std::uint32_t(charted.embedding.base_face[f]));
    for (const int v : cut.triangles[f]) triangle.push_back(std::uint32_t(v));
    charts.push_back(chart_id(source, charted.chart_of_face[f]));
  }
  Frame frame("cuts");
  frame.add_points("position", {cut.points.begin() + first, cut.points.end()}, source.origin);
  frame.add("value", std::vector<float>(charted.values.begin() + first, charted.values.end()));
  frame.add("base", base_face);
  frame.add("triangle", triangle);
  frame.add("chart", charts);
  return frame;
}

Frame field_frame(const Charted_surface& charted) {
  Frame frame("field");
  const auto begin = charted.values.begin();
  frame.add("value", std::vector<float>(begin, begin + std::ptrdiff_t(charted.base.points.size())));
  return frame;
}

/// A face that contours cross has the chart of its first piece here.
Frame charts_frame(const Layer_source& source) {
  Frame frame("charts");
  std::vector<std::int32_t> charts;
  charts.reserve(source.charted->base.triangles.size());
  for (std::size_t f = 0; f < source.charted->base.triangles.size(); ++f)
    charts.push_back(chart_id(source, source.charted->chart_of_face[f]));
  frame.add("chart", charts);
  return frame;
}

const char* kind_of(const Contour_network& network, const Contour_edge& edge) {
  const Node_kind a = network.nodes[edge.from].kind, b = network.nodes[edge.to].kind;
  const auto either = [&](Node_kind kind) { return a == kind || b == kind; };
  if (either(Node_kind::saddle)) return "saddle";
  if (either(Node_kind::half_saddle)) return "half_saddle";
  if (either(Node_kind::quarter_saddle)) return "quarter_saddle";
  if (either(Node_kind::half_pole)) return "half_pole";
  return either(Node_kind::boundary) ? "boundary" : "regular";
}

Frame contours_frame(const Layer_source& source) {
  Frame frame("contours");
  const Contour_network& network = source.charted->network;
  std::vector<Point> points;
  std::vector<std::uint32_t> begin{0};
  std::vector<std::int32_t> edges, counts;
  std::vector<float> values;
  Json kinds = Json::array();
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const Contour_edge& edge = network.edges[e];
    if (network.is_removed(edge)) continue;
    for (const int v : edge.vertices) points.push_back(source.charted->embedding.surface.points[v]);
    begin.push_back(std::uint32_t(points.size()));
    edges.push_back(int(e));
    counts.push_back(e < source.counts.size() ? source.counts[e] : 0);
    values.push_back(float(edge.value));
    kinds.push_back(kind_of(network, edge));
  }
  frame.add_points("position", points, source.origin);
  frame.add("begin", begin);
  frame.add("edge", edges);
  frame.add("count", counts);
  frame.add("value", values);
  frame.data["kind"] = std::move(kinds);
  return frame;
}

/// Minima, saddles and maxima: kinds 0, 1 and 2. Fractional saddles are 3 (half) and 4 (quarter).
Frame critical_frame(const Layer_source& source) {
  Frame frame("critical");
  const std::vector<Point>& all = source.charted->embedding.surface.points;
  const Contour_network& network = source.charted->network;
  std::vector<Point> points;
  std::vector<std::int32_t> vertices;
  std::vector<std::uint8_t> kinds, multiplicities;
  const auto add = [&](int vertex, int kind, int multiplicity) {
    points.push_back(all[vertex]);
    vertices.push_back(vertex);
    kinds.push_back(std::uint8_t(kind));
    multiplicities.push_back(std::uint8_t(std::min(multiplicity, 255)));
  };
  for (const Design_extremum& e : source.extrema) add(e.vertex, e.is_maximum ? 2 : 0, 0);
  const std::vector<char> used = nodes_in_use(network);
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    const Contour_node& node = network.nodes[i];
    if (!used[i]) continue;
    if (node.kind == Node_kind::saddle) add(node.vertex, 1, node.multiplicity);
    if (node.kind == Node_kind::half_saddle) add(node.vertex, 3, 0);
    if (node.kind == Node_kind::quarter_saddle) add(node.vertex, 4, 0);
  }
  frame.add_points("position", points, source.origin);
  frame.add("vertex", vertices);
  frame.add("kind", kinds);
  frame.add("multiplicity", multiplicities);
  return frame;
}

Frame reeb_frame(const Layer_source& source) {
  const Skeleton drawn = skeleton(*source.charted);
  Frame frame("reeb");
  std::vector<Point> points;
  std::vector<std::uint32_t> begin{0};
  for (const std::vector<Point>& arc : drawn.arcs) {
    points.insert(points.end(), arc.begin(), arc.end());
    begin.push_back(std::uint32_t(points.size()));
  }
  std::vector<std::uint8_t> is_extremum;
  for (const int vertex : source.charted->graph.extremum) is_extremum.push_back(vertex >= 0);
  frame.add_points("position", points, source.origin);
  frame.add("begin", begin);
  frame.add_points("node", drawn.nodes, source.origin);
  frame.add("extremum", is_extremum);
  return frame;
}

/// The number of edges of each vertex, and whether it is on the boundary.
struct Valences {
  std::vector<int> valence;
  std::vector<char> is_boundary;
};

Valences valences(const Quad_mesh& mesh) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(4 * mesh.quads.size());
  for (const Quad& q : mesh.quads)
    for (int i = 0; i < 4; ++i)
      if (q[i] != q[(i + 1) % 4])
        edges.push_back({std::min(q[i], q[(i + 1) % 4]), std::max(q[i], q[(i + 1) % 4])});
  std::sort(edges.begin(), edges.end());
  Valences result{std::vector<int>(mesh.points.size(), 0), std::vector<char>(mesh.points.size(), false)};
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    for (const int v : edges[i]) {
      ++result.valence[v];
      if (j == i + 1) result.is_boundary[v] = true;
    }
  }
  return result;
}

Frame textures_frame(const Layer_source& source) {
  Frame frame("textures");
  frame.add_points("position", source.textures->points, source.origin);
  frame.add_indices("quad", source.textures->quads);
  return frame;
}

Frame quads_frame(const Layer_source& source) {
  const Quad_mesh& mesh = *source.quads;
  Frame frame("quads");
  std::vector<float> quality;
  quality.reserve(mesh.quads.size());
  for (const Quad& q : mesh.quads)
    quality.push_back(q[2] == q[3] ? std::numeric_limits<float>::quiet_NaN()
                                   : float(scaled_jacobian(mesh.points[q[0]], mesh.points[q[1]],
                                                           mesh.points[q[2]], mesh.points[q[3]])));
  const Valences all = valences(mesh);
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint8_t> numbers, boundary;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (all.valence[v] == 0 || all.valence[v] == (all.is_boundary[v] ? 3 : 4)) continue;
    vertices.push_back(std::uint32_t(v));
    numbers.push_back(std::uint8_t(std::min(all.valence[v], 255)));
    boundary.push_back(std::uint8_t(all.is_boundary[v]));
  }
  frame.add_points("position", mesh.points, source.origin);
  frame.add_indices("quad", mesh.quads);
  frame.add("quality", quality);
  std::vector<std::int32_t> charts;
  for (const int chart : source.chart_of_quad) charts.push_back(chart_id(source, chart));
  frame.add("chart", charts);
  frame.add("irregular_vertex", vertices);
  frame.add("irregular_valence", numbers);
  frame.add("irregular_on_boundary", boundary);
  return frame;
}

} // namespace

Layers make_layers(const Layer_source& source) {
  Layers layers;
  if (source.surface) layers["surface"] = surface_frame(*source.surface, source.origin).encode();
  if (source.charted) {
    layers["cuts"] = cuts_frame(source).encode();
    layers["field"] = field_frame(*source.charted).encode();
    layers["charts"] = charts_frame(source).encode();
    layers["contours"] = contours_frame(source).encode();
    layers["critical"] = critical_frame(source).encode();
    layers["reeb"] = reeb_frame(source).encode();
  }
  if (source.textures) layers["textures"] = textures_frame(source).encode();
  if (source.quads) layers["quads"] = quads_frame(source).encode();
  return layers;
}

} // namespace studio
} // namespace reebquad
