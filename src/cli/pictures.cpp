// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a run: field with contours, Reeb graph, charts, quads, quality.
#include "Interruption.h"
#include "Run.h"

#include <CGAL/Reeb_quadrangulation/render.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr int width = 1000, height = 800;

/// The embedded surfaces of all components as one, with the field and the chart of each face.
struct Joined_layout {
  Triangle_surface surface;
  std::vector<double> values;
  std::vector<int> chart_of_face;
};

/// The field on the embedded surface: vertices that contours added have their contour's value.
std::vector<double> embedded_values(const Reeb_layout& layout) {
  std::vector<double> values = layout.values;
  values.resize(layout.embedding.surface.points.size(), 0);
  for (const Contour_edge& edge : layout.network.edges)
    for (const int v : edge.vertices)
      if (layout.network.is_crossing(v)) values[v] = edge.value;
  return values;
}

Joined_layout joined_layout(const Run& run) {
  Joined_layout all;
  int charts = 0;
  for (const Component_run& component : run.components) {
    const Reeb_layout& layout = component.result->layout;
    const Triangle_surface& surface = layout.embedding.surface;
    const int first = all.surface.number_of_vertices();
    all.surface.points.insert(all.surface.points.end(), surface.points.begin(), surface.points.end());
    for (const Triangle& t : surface.triangles)
      all.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const std::vector<double> values = embedded_values(layout);
    all.values.insert(all.values.end(), values.begin(), values.end());
    for (const int chart : layout.atlas.chart_of_face) all.chart_of_face.push_back(charts + chart);
    charts += int(layout.atlas.charts.size());
  }
  return all;
}

void add_contours(Scene& scene, const Run& run, double pixels) {
  for (const Component_run& component : run.components) {
    const Reeb_layout& layout = component.result->layout;
    for (const Contour_edge& edge : layout.network.edges) {
      std::vector<Point> line;
      for (const int v : edge.vertices) line.push_back(layout.embedding.surface.points[v]);
      add_polyline(scene, line, {30, 28, 34}, pixels);
    }
  }
}

/// The centroids of a chart's level bands, from its low end to its high end: a line through its middle.
std::vector<Point> middle_line(const Chart& chart, const std::vector<double>& values) {
  constexpr int bands = 12;
  const Triangle_surface& mesh = chart.mesh;
  std::vector<double> value(mesh.points.size());
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t v = 0; v < value.size(); ++v) {
    const int origin = chart.vertex_origin[v];
    value[v] = origin >= 0 ? values[origin] : std::numeric_limits<double>::quiet_NaN();
    if (origin < 0) continue;
    low = std::min(low, value[v]);
    high = std::max(high, value[v]);
  }
  std::vector<Point> sum(bands, Point::Zero());
  std::vector<double> area(bands, 0);
  for (const Triangle& t : mesh.triangles) {
    const double mean = (value[t[0]] + value[t[1]] + value[t[2]]) / 3;
    if (!(mean >= low && mean <= high && low < high)) continue;
    const Point &p = mesh.points[t[0]], &q = mesh.points[t[1]], &r = mesh.points[t[2]];
    const int band = std::min(bands - 1, int(bands * (mean - low) / (high - low)));
    const double weight = (q - p).cross(r - p).norm();
    sum[band] += weight * (p + q + r) / 3;
    area[band] += weight;
  }
  std::vector<Point> line;
  for (int band = 0; band < bands; ++band)
    if (area[band] > 0) line.push_back(sum[band] / area[band]);
  return line;
}

/// Each inner point moves to the mean of itself and its neighbours, a few times.
void smooth(std::vector<Point>& line) {
  for (int round = 0; round < 3; ++round) {
    const std::vector<Point> old = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) line[i] = (old[i - 1] + old[i] + old[i + 1]) / 3;
  }
}

std::vector<Point> node_positions(const Reeb_layout& layout) {
  const std::vector<Point>& points = layout.embedding.surface.points;
  const int nodes = layout.graph.number_of_nodes();
  std::vector<Point> position(nodes, Point::Zero());
  std::vector<int> number(nodes, 0);
  for (std::size_t e = 0; e < layout.network.edges.size(); ++e)
    for (const int v : layout.network.edges[e].vertices) {
      position[layout.graph.contour_of_edge[e]] += points[v];
      ++number[layout.graph.contour_of_edge[e]];
    }
  for (int n = 0; n < nodes; ++n) {
    if (layout.graph.extremum[n] >= 0)
      position[n] = points[layout.graph.extremum[n]];
    else if (number[n] > 0)
      position[n] /= number[n];
  }
  return position;
}

void add_reeb_graph(Scene& scene, const Reeb_layout& layout) {
  const std::vector<Point> nodes = node_positions(layout);
  const std::vector<double> values = embedded_values(layout);
  std::vector<Colour> colours;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    colours.push_back(layout.graph.extremum[n] >= 0 ? Colour{196, 64, 48} : Colour{40, 90, 160});
  std::vector<std::vector<Point>> arcs;
  for (std::size_t c = 0; c < layout.atlas.charts.size(); ++c) {
    std::vector<Point> line = middle_line(*layout.atlas.charts[c], values);
    line.insert(line.begin(), nodes[layout.graph.arcs[c].low]);
    line.push_back(nodes[layout.graph.arcs[c].high]);
    smooth(line);
    arcs.push_back(std::move(line));
  }
  add_graph(scene, nodes, arcs, colours);
}

Image quality_histogram(const Mesh_statistics& statistics) {
  Histogram histogram;
  const auto& bins = statistics.scaled_jacobian_histogram;
  histogram.bins.assign(bins.begin(), bins.end());
  histogram.low = -1;
  histogram.title = "Scaled Jacobian";
  histogram.x_label = "scaled Jacobian";
  histogram.note =
      "quads " + std::to_string(statistics.quads) + "\ninverted " + std::to_string(statistics.inverted_quads);
  return histogram_image(histogram);
}

} // namespace

void write_pictures(const Run& run, const Run_options& options) {
  std::error_code failed;
  std::filesystem::create_directories(options.pictures, failed);
  if (failed)
    throw Failure(Exit_code::other_failure,
                  options.pictures + ": the folder cannot be made: " + failed.message());
  const Point up = options.pipeline.suggestion.axis;
  const auto write = [&](const Image& image, const char* name) {
    if (interrupted()) throw Failure(Exit_code::interrupted, "interrupted");
    const std::string file = (std::filesystem::path(options.pictures) / name).string();
    const Uninterruptible whole;
    succeed_or_fail(write_png(image, file), file);
  };
  const auto view = [&](const Scene& scene) {
    return render(scene, camera(View::three_quarter, up), width, height);
  };

  const Joined_layout layout = joined_layout(run);
  Scene field = scalar_scene(layout.surface, layout.values);
  add_contours(field, run, 3);
  write(view(field), "field.png");
  Scene charts = face_colour_scene(layout.surface, layout.chart_of_face);
  add_contours(charts, run, 2);
  write(view(charts), "charts.png");
  Scene graph = surface_scene(run.surface);
  for (const Component_run& component : run.components) add_reeb_graph(graph, component.result->layout);
  write(view(graph), "reeb_graph.png");
  const Scene quads = quad_scene(run.quads);
  write(view(quads), "quads.png");
  write(contact_sheet(quads, up, 3 * width / 2, 3 * height / 2), "quads_four_views.png");
  write(view(quality_scene(run.quads)), "quality.png");
  write(quality_histogram(*run.statistics), "quality_histogram.png");
}

} // namespace reebquad
