// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a run: field with contours, Reeb graph, charts, quads, quality.
#include "Interruption.h"
#include "Layout_view.h"
#include "Run.h"

#include <CGAL/Reeb_quadrangulation/render.h>

#include "view/Skeleton.h"

#include <filesystem>
#include <memory>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr int width = 1000, height = 800;
constexpr int thumbnail_width = 240, thumbnail_height = 192;

using Views = std::vector<std::unique_ptr<const Layout_view>>; // one for each component

/// The embedded surfaces of all components as one, with the field and the chart of each face.
struct Joined_layout {
  Triangle_surface surface;
  std::vector<double> values;
  std::vector<int> chart_of_face;
};

Joined_layout joined_layout(const Views& views) {
  Joined_layout all;
  int charts = 0;
  for (const auto& view : views) {
    const Triangle_surface& surface = view->embedded.embedding.surface;
    const int first = all.surface.number_of_vertices();
    all.surface.points.insert(all.surface.points.end(), surface.points.begin(), surface.points.end());
    for (const Triangle& t : surface.triangles)
      all.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    all.values.insert(all.values.end(), view->values.begin(), view->values.end());
    for (const int chart : view->embedded.chart_of_face) all.chart_of_face.push_back(charts + chart);
    charts += int(view->graph.arcs.size());
  }
  return all;
}

void add_contours(Scene& scene, const Views& views, double pixels) {
  for (const auto& view : views)
    for (const Contour_edge& edge : view->charted.network.edges) {
      std::vector<Point> line;
      for (const int v : edge.vertices) line.push_back(view->embedded.embedding.surface.points[v]);
      add_polyline(scene, line, {30, 28, 34}, pixels);
    }
}

void add_reeb_graph(Scene& scene, const Layout_view& view) {
  const studio::Skeleton drawn = studio::skeleton(view.charted);
  std::vector<Colour> colours;
  for (const int vertex : view.graph.extremum)
    colours.push_back(vertex >= 0 ? Colour{196, 64, 48} : Colour{40, 90, 160});
  add_graph(scene, drawn.nodes, drawn.arcs, colours);
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

  Views views;
  for (const Component_run& component : run.components)
    if (component.result) views.push_back(std::make_unique<const Layout_view>(component.result->editor));
  const Joined_layout layout = joined_layout(views);
  Scene field = scalar_scene(layout.surface, layout.values);
  add_contours(field, views, 3);
  write(view(field), "field.png");
  Scene charts = face_colour_scene(layout.surface, layout.chart_of_face);
  add_contours(charts, views, 2);
  write(view(charts), "charts.png");
  Scene graph = surface_scene(run.surface);
  for (const auto& component : views) add_reeb_graph(graph, *component);
  write(view(graph), "reeb_graph.png");
  const Scene quads = quad_scene(run.quads);
  write(view(quads), "quads.png");
  write(contact_sheet(quads, up, 3 * width / 2, 3 * height / 2), "quads_four_views.png");
  write(view(quality_scene(run.quads)), "quality.png");
  write(quality_histogram(*run.statistics), "quality_histogram.png");
}

void write_thumbnail(const Run& run, const Run_options& options) {
  Quad_scene_options look;
  look.legend = false;
  look.dot_radius = 2;
  Scene scene = run.is_written() ? quad_scene(run.quads, look) : surface_scene(run.as_read);
  scene.side_width = 0.6;
  const Camera eye = camera(View::three_quarter, options.pipeline.suggestion.axis);
  const Image image = render(scene, eye, thumbnail_width, thumbnail_height);
  const Uninterruptible whole;
  succeed_or_fail(write_png(image, options.thumbnail), options.thumbnail);
}

} // namespace reebquad
