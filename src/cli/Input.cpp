// SPDX-License-Identifier: GPL-3.0-or-later
#include "Input.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#include <charconv>
#include <cmath>
#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace po = boost::program_options;

void declare_mending(Command_line& line) {
  line.options.add_options()                                                       //
      ("fill-holes", "fill small holes instead of keeping them as boundary loops") //
      ("hole-edges", po::value<int>()->value_name("N")->default_value(100),
       "what is small: at most N edges") //
      ("weld", po::value<double>()->value_name("D"),
       "weld rims that lie nearer than D to each other; 0: only equal points; default: a millionth of the "
       "diagonal") //
      ("drop-components-below", po::value<std::string>()->value_name("SIZE"),
       "leave out small components: a length for the diagonal of their box (0.5), a part of the whole's "
       "diagonal (2%) "
       "or a number of triangles (20t)") //
      ("refuse-non-manifold",
       "refuse components with edges of more than two faces instead of cutting them there");
}

namespace {

// "0.5", "2%" or "20t".
void set_smallest(const std::string& text, Mend_options& options) {
  const char unit = text.empty() ? ' ' : text.back();
  const bool has_unit = unit == '%' || unit == 't';
  double size = 0;
  const char *first = text.data(), *last = text.data() + text.size() - (has_unit ? 1 : 0);
  const std::from_chars_result parsed = std::from_chars(first, last, size);
  if (parsed.ec != std::errc() || parsed.ptr != last || !std::isfinite(size) || !(size > 0) ||
      (unit == '%' && size > 100) || (unit == 't' && (size != std::floor(size) || size > 1e9)))
    throw Usage_error(
        "--drop-components-below takes a length as 0.5, a part as 2% or a number of triangles as 20t; "
        "it got '" +
        text + "'");
  if (unit == '%')
    options.smallest_part = size / 100;
  else if (unit == 't')
    options.fewest_triangles = int(size);
  else
    options.smallest_diagonal = size;
}

} // namespace

Mend_options mending(const Command_line& line) {
  Mend_options options;
  const int edges = line.values["hole-edges"].as<int>();
  if (edges < 3) throw Usage_error("--hole-edges is at least 3; it got " + std::to_string(edges));
  if (line.has("fill-holes"))
    options.fill_holes = edges;
  else if (!line.values["hole-edges"].defaulted())
    throw Usage_error("--hole-edges has no meaning without --fill-holes");
  if (line.has("weld")) {
    options.weld = line.values["weld"].as<double>();
    if (!(options.weld >= 0) || !std::isfinite(options.weld))
      throw Usage_error("--weld takes a distance that is not negative");
  }
  if (line.has("drop-components-below")) set_smallest(line.text("drop-components-below"), options);
  options.cut_non_manifold_edges = !line.has("refuse-non-manifold");
  return options;
}

void require_writable_format(const std::string& file) {
  if (format_of_extension(file) == Mesh_format::automatic)
    throw Usage_error(file + ": the extension is not one of obj, off, ply, vtk, vtu, inp, msh, stl, glb");
}

Polygon_soup read_soup(const std::string& file, std::vector<std::string>* notes,
                       Mesh_attributes* attributes) {
  std::vector<std::string> passed_over;
  Polygon_soup soup =
      value_or_fail(read_polygon_soup(file, largest_mesh_file, &passed_over, attributes), file);
  for (const std::string& note : passed_over)
    if (notes)
      notes->push_back(note);
    else
      std::cerr << "reebquad: " << file << ": " << note << '\n';
  return soup;
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
