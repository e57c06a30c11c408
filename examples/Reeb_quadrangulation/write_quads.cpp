// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a quad mesh in every format. STL and glTF hold triangles only, and the writer says so.
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

int main() {
  const Quad_mesh cube = {
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 0, 1), Point(1, 0, 1),
       Point(1, 1, 1), Point(0, 1, 1)},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  for (const std::string path : {"cube.obj", "cube.off", "cube.ply", "cube.vtk", "cube.stl", "cube.glb"}) {
    const auto written = write_mesh(path, cube);
    if (!written) {
      std::cerr << written.error().message << '\n';
      return 1;
    }
    std::cout << path << " is written\n";
    for (const std::string& warning : *written) std::cout << "  " << warning << '\n';
  }
  const Result<Polygon_soup> again = read_polygon_soup("cube.ply");
  return again && again->points == cube.points && again->number_of_polygons() == 6 ? 0 : 1;
}
