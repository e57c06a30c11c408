// SPDX-License-Identifier: GPL-3.0-or-later
#include "Input.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace po = boost::program_options;

void declare_mending(Command_line& line) {
  line.options.add_options()("fill-holes", "fill small holes instead of keeping them as boundary loops")(
      "hole-edges", po::value<int>()->value_name("N")->default_value(100), "what is small: at most N edges");
}

Mend_options mending(const Command_line& line) {
  Mend_options options;
  const int edges = line.values["hole-edges"].as<int>();
  if (edges < 3) throw Usage_error("--hole-edges is at least 3; it got " + std::to_string(edges));
  if (line.has("fill-holes"))
    options.fill_holes = edges;
  else if (!line.values["hole-edges"].defaulted())
    throw Usage_error("--hole-edges has no meaning without --fill-holes");
  return options;
}

void require_writable_format(const std::string& file) {
  if (format_of_extension(file) == Mesh_format::automatic)
    throw Usage_error(file + ": the extension is not one of obj, off, ply, vtk, stl, glb");
}

Polygon_soup read_soup(const std::string& file) {
  return value_or_fail(read_polygon_soup(file), file);
}

Quad_mesh quads_of(const Polygon_soup& soup, const std::string& file) {
  Quad_mesh mesh;
  mesh.points = soup.points;
  mesh.quads.reserve(std::size_t(soup.number_of_polygons()));
  for (int p = 0; p < soup.number_of_polygons(); ++p) {
    if (soup.size_of_polygon(p) != 4)
      throw Failure(Exit_code::not_a_surface, file + ": face " + std::to_string(p) + " has " +
                                                  std::to_string(soup.size_of_polygon(p)) +
                                                  " corners; a quad mesh is needed");
    const int* corner = soup.corner.data() + soup.begin[p];
    mesh.quads.push_back({corner[0], corner[1], corner[2], corner[3]});
  }
  return mesh;
}

Triangle_surface joined(const Mended_surface& mended) {
  Triangle_surface all;
  for (const Mended_component& component : mended.components) {
    const int first = all.number_of_vertices();
    all.points.insert(all.points.end(), component.surface.points.begin(), component.surface.points.end());
    for (const Triangle& t : component.surface.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

} // namespace reebquad
