// SPDX-License-Identifier: GPL-3.0-or-later
// readme_pictures FOLDER RECIPES: the pictures of README.md, four small PNG files, drawn by the renderer of
// this project.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/polygon_mesh.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/render.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdio>
#include <cstdlib>

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr int panel_height = 290;
constexpr int wide = 320, narrow = 230;

template <class T> T value(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "readme_pictures: %s\n", result.error().message.c_str());
  std::exit(1);
}

/// Bytes with fewer different colours, which take a third of the room and look the same.
void simplify(Image& image) {
  constexpr int step = 9;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3 && image.rgba[i] < 255)
      image.rgba[i] = static_cast<unsigned char>(image.rgba[i] / step * step);
}

Image drawn(const Scene& scene, int width = wide) {
  return render(scene, camera(View::three_quarter, Up_axis::z), width, panel_height);
}

void write(const std::string& file, const std::vector<Image>& panels) {
  Image image = compose(panels, int(panels.size()), 4);
  simplify(image);
  if (const Result<void> written = write_png(image, file); !written) {
    std::fprintf(stderr, "readme_pictures: %s\n", written.error().message.c_str());
    std::exit(1);
  }
}

Scene input_scene(const Triangle_surface& surface) {
  Scene scene = surface_scene(surface);
  scene.drawn_sides.assign(scene.faces.size(), 7);
  scene.side_width = 0.6;
  return scene;
}

Quad_scene_options look(double dot_radius) {
  Quad_scene_options options;
  options.legend = false;
  options.dot_radius = dot_radius;
  return options;
}

Scene quads_scene(const Quad_mesh& mesh) {
  Scene scene = quad_scene(mesh, look(3.5));
  scene.side_width = 0.8;
  return scene;
}

/// Charts in colours, with the contours between them and the extrema.
Scene atlas_scene(const Editor& editor) {
  const Design& design = editor.design();
  const Embedded_design embedded = embed_design(editor.working_surface(), design);
  const std::vector<Point>& points = embedded.embedding.surface.points;
  Scene scene = face_colour_scene(embedded.embedding.surface, embedded.chart_of_face);
  for (const Contour_edge& edge : design.network.edges)
    for (std::size_t i = 1; i < edge.vertices.size(); ++i)
      scene.lines.push_back({points[std::size_t(edge.vertices[i - 1])],
                             points[std::size_t(edge.vertices[i])],
                             {24, 24, 30},
                             1.6});
  for (const Design_extremum& e : design.extrema)
    scene.dots.push_back(
        {points[std::size_t(e.vertex)], e.is_maximum ? Colour{196, 64, 48} : Colour{40, 90, 160}});
  return scene;
}

Quadrangulation quads_of(const Triangle_surface& surface, int quads, bool adaptive = false,
                         bool lines = false) {
  Quadrangulation_options options;
  options.quads = quads;
  options.suggestion.axis = Point(0, 0, 1);
  if (adaptive) options.adaptive.ratio = 4;
  options.features.lines = lines;
  return value(quadrangulate(surface, options));
}

Recipe recipe_in(const std::string& file) {
  return value(recipe_from_json(value(read_file(file, std::uint64_t(1) << 24))));
}

/// The surface edited by all edits of a recipe but the last `without` ones.
Editor edited(const Triangle_surface& surface, const Recipe& recipe, std::size_t without) {
  Editor editor = value(Editor::create(surface, recipe.options));
  for (std::size_t i = 0; i + without < recipe.edits.size(); ++i)
    static_cast<void>(value(editor.apply(recipe.edits[i])));
  return editor;
}

Quad_mesh finished(const Editor& editor, const Recipe& recipe) {
  return value(editor.finished_quads(recipe.finish)).quads.mesh;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string folder = std::string(argv[1]) + "/", recipes = std::string(argv[2]) + "/";

  const Triangle_surface hand = value(make_shape("hand", 5000));
  const Quadrangulation quads = quads_of(hand, 1400);
  write(folder + "pipeline.png", {drawn(input_scene(hand), narrow), drawn(atlas_scene(quads.editor), narrow),
                                  drawn(quads_scene(quads.mesh), narrow)});

  const Recipe recipe = recipe_in(recipes + "quarter_saddle.json");
  const Triangle_surface torus = value(make_shape("torus", 4000));
  const Editor before = edited(torus, recipe, 1), after = edited(torus, recipe, 0);
  write(folder + "edit.png", {drawn(quads_scene(finished(before, recipe))), drawn(atlas_scene(after)),
                              drawn(quads_scene(finished(after, recipe)))});

  const Triangle_surface bar = value(make_shape("twisted-bar", 5000)),
                         corner = value(make_shape("l-shape", 4000)),
                         tori = value(make_shape("genus-3", 6000));
  Recipe polycube =
      recipe_in(recipes + "../../../../test/Reeb_quadrangulation/recipes/l_shape_polycube.json");
  polycube.finish.features.lines = true;
  write(folder + "shapes.png", {drawn(quads_scene(quads_of(bar, 700, false, true).mesh)),
                                drawn(quads_scene(finished(edited(corner, polycube, 0), polycube))),
                                drawn(quads_scene(quads_of(tori, 1100).mesh))});

  Scene hexagons = quad_scene(value(polygon_mesh(quads.mesh, Polygon_kind::hexagons)), look(0));
  hexagons.side_width = 0.8;
  Scene quality = quality_scene(quads.mesh);
  quality.legend = {};
  write(folder + "more.png", {drawn(quads_scene(quads_of(hand, 1200, true).mesh), narrow),
                              drawn(hexagons, narrow), drawn(quality, narrow)});
}
