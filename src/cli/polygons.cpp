// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad polygons QUADS -o OUT: writes a quad mesh as hexagons or other polygons.
#include "Command.h"
#include "Input.h"
#include "Outputs.h"

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/polygon_mesh.h>
#include <CGAL/Reeb_quadrangulation/render.h>

#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

Polygon_kind kind_of(const std::string& text) {
  for (const Polygon_kind kind : {Polygon_kind::hexagons, Polygon_kind::dual, Polygon_kind::diagonal})
    if (text == name(kind)) return kind;
  throw Usage_error("--kind is one of hex, dual, diagonal; it got '" + text + "'");
}

void put_on_surface(Polygon_soup& mesh, const std::string& file) {
  const Triangle_surface surface = joined(value_or_fail(mend_surface(read_soup(file)), file));
  const Surface_projector projector(surface);
  for (Point& p : mesh.points) p = projector.closest(p).point;
}

// Polygons of fewer sides than `regular` in green, of more in blue.
std::vector<Colour> colours_by_sides(const Polygon_soup& mesh, int regular) {
  std::vector<Colour> colours;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    const int n = mesh.size_of_polygon(p);
    colours.push_back(n == regular ? Scene().surface_colour : valence_colour(n < regular ? 3 : 5));
  }
  return colours;
}

} // namespace

Exit_code execute_polygons(const Arguments& arguments) {
  Command_line line(
      "polygons QUADS -o OUT [--kind hex|dual|diagonal] [--on INPUT]\n"
      "The result is not all-quad and has no certificate; OBJ, OFF and PLY files say so in a comment");
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  line.options.add_options()("output,o", text("FILE"), "the polygons")(
      "kind", text("KIND")->default_value("hex"),
      "hex: hexagons; dual: a polygon around every vertex; diagonal: a quad for every edge")(
      "on", text("INPUT"), "put the corners on this triangle surface")("picture", text("FILE"),
                                                                       "draw the polygons as PNG");
  declare_force(line);
  line.take("QUADS");
  if (!line.parse(arguments)) return Exit_code::success;
  const std::string file = line.required("QUADS"), output = line.required("output");
  require_writable_format(output);
  keep_inputs(line, {{file, line.has("on") ? line.text("on") : ""},
                     {output, line.has("picture") ? line.text("picture") : ""},
                     ""});
  const Polygon_kind kind = kind_of(line.text("kind"));
  Polygon_soup mesh = value_or_fail(polygon_mesh(quads_of(read_soup(file), file), kind), file);
  if (line.has("on")) put_on_surface(mesh, line.text("on"));
  Write_options options;
  options.comment = "not all-quad:";
  for (const auto& [sides, number] : polygon_sizes(mesh))
    options.comment += " " + std::to_string(number) + " of " + std::to_string(sides) + " sides";
  for (const std::string& warning : value_or_fail(write_mesh(output, mesh, options), output))
    std::cerr << "reebquad: " << output << ": " << warning << '\n';
  if (line.has("picture")) {
    const Scene scene = polygon_scene(mesh, colours_by_sides(mesh, kind == Polygon_kind::hexagons ? 6 : 4));
    succeed_or_fail(
        write_png(render(scene, camera(View::three_quarter, Up_axis::z), 1000, 800), line.text("picture")),
        line.text("picture"));
  }
  std::cout << output << ": " << options.comment << '\n';
  return Exit_code::success;
}

} // namespace reebquad
