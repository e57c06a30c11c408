// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sizes_input.h"

#include "Failure.h"
#include "Text_input.h"
#include "surface/size_at.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#include <cmath>
#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr std::uint64_t largest_sizes = std::uint64_t(1) << 30;

Error malformed(const std::string& what) {
  return make_error(Error_code::malformed_file, what);
}

// Points and triangles of a mesh; polygons are cut from their first corner.
Triangle_surface fans_of(const Polygon_soup& mesh) {
  Triangle_surface surface;
  surface.points = mesh.points;
  for (int p = 0; p < mesh.number_of_polygons(); ++p)
    for (int c = mesh.begin[std::size_t(p)] + 1; c + 1 < mesh.begin[std::size_t(p) + 1]; ++c) {
      const Triangle t{mesh.corner[std::size_t(mesh.begin[std::size_t(p)])], mesh.corner[std::size_t(c)],
                       mesh.corner[std::size_t(c) + 1]};
      bool is_finite = true;
      for (int v : t) is_finite = is_finite && mesh.points[std::size_t(v)].allFinite();
      if (is_finite) surface.triangles.push_back(t);
    }
  return surface;
}

Result<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const Text_line& line : lines_of(text)) {
    std::istringstream in(line.text);
    in.imbue(std::locale::classic());
    double size = 0;
    std::string more;
    if (!(in >> size) || in >> more || !std::isfinite(size) || size <= 0)
      return malformed("line " + std::to_string(line.number) + ": expected one positive number");
    numbers.push_back(size);
  }
  return numbers;
}

Result<Given_sizes> sizes_of_ply(const std::string& text) {
  Mesh_attributes attributes;
  Result<Polygon_soup> mesh =
      parse_polygon_soup(text.data(), text.size(), Mesh_format::ply, nullptr, &attributes);
  if (!mesh) return mesh.error();
  if (attributes.sizes.empty()) return malformed("its points have no property 'size' or 'quality'");
  for (std::size_t v = 0; v < attributes.sizes.size(); ++v)
    if (!(attributes.sizes[v] > 0) || !std::isfinite(attributes.sizes[v]))
      return malformed("the size of point " + std::to_string(v) + " is not a positive number");
  Given_sizes given{fans_of(*mesh), std::move(attributes.sizes)};
  if (given.surface.triangles.empty()) return malformed("it has sizes, but no face");
  return given;
}

} // namespace

std::vector<double> Given_sizes::on(const Triangle_surface& other) const {
  const Surface_projector projector(surface);
  const CGAL::Reeb_quadrangulation::internal::Size_at size(projector, sizes);
  std::vector<double> found;
  for (const Point& p : other.points) found.push_back(size(p));
  return found;
}

Result<Given_sizes> parse_sizes(const std::string& text, const Polygon_soup& mesh) {
  if (text.compare(0, 3, "ply") == 0 && text.size() > 3 && (text[3] == '\n' || text[3] == '\r'))
    return sizes_of_ply(text);
  Result<std::vector<double>> numbers = numbers_of(text);
  if (!numbers) return numbers.error();
  if (int(numbers->size()) != mesh.number_of_points())
    return malformed("it has " + std::to_string(numbers->size()) + " sizes, the mesh has " +
                     std::to_string(mesh.number_of_points()) + " points");
  Given_sizes given{fans_of(mesh), std::move(*numbers)};
  if (given.surface.triangles.empty()) return malformed("the mesh that it is for has no face");
  return given;
}

Given_sizes read_sizes(const std::string& file, const Polygon_soup& mesh) {
  return value_or_fail(parse_sizes(value_or_fail(read_file(file, largest_sizes), file), mesh), file);
}

} // namespace reebquad
