// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/mesh_format.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

namespace CGAL {
namespace Reeb_quadrangulation {

const char* name(Mesh_format format) {
  switch (format) {
  case Mesh_format::automatic: return "automatic";
  case Mesh_format::off: return "OFF";
  case Mesh_format::obj: return "OBJ";
  case Mesh_format::ply: return "PLY";
  case Mesh_format::stl: return "STL";
  case Mesh_format::vtk: return "VTK";
  case Mesh_format::glb: return "GLB";
  case Mesh_format::vtu: return "VTU";
  case Mesh_format::inp: return "INP";
  case Mesh_format::msh: return "MSH";
  }
  return "";
}

Mesh_format format_of_extension(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return Mesh_format::automatic;
  std::string extension;
  for (char c : path.substr(dot + 1)) extension += c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
  for (Mesh_format format :
       {Mesh_format::off, Mesh_format::obj, Mesh_format::ply, Mesh_format::stl, Mesh_format::vtk,
        Mesh_format::glb, Mesh_format::vtu, Mesh_format::inp, Mesh_format::msh})
    if (extension == name(format)) return format;
  return Mesh_format::automatic;
}

namespace {

template <class Polygons> Polygon_soup make_soup(const std::vector<Point>& points, const Polygons& polygons) {
  Polygon_soup soup;
  soup.points = points;
  soup.begin.reserve(polygons.size() + 1);
  soup.corner.reserve(polygons.size() * (polygons.empty() ? 0 : polygons[0].size()));
  for (const auto& polygon : polygons) {
    soup.corner.insert(soup.corner.end(), polygon.begin(), polygon.end());
    soup.close_polygon();
  }
  return soup;
}

} // namespace

Polygon_soup polygon_soup(const Triangle_surface& surface) {
  return make_soup(surface.points, surface.triangles);
}

Polygon_soup polygon_soup(const Quad_mesh& mesh) {
  return make_soup(mesh.points, mesh.quads);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
