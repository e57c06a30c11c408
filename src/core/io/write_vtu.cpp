// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML format for unstructured grids, as text: polygons are cells, names are numbers of cells.
#include "io/writers.h"

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int vtk_triangle = 5, vtk_polygon = 7, vtk_quad = 9;

std::string array(const std::string& type, const std::string& name, int components = 1) {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"ascii\">\n";
}

void append_cells(const Polygon_soup& mesh, std::string& out) {
  out += "<Cells>\n" + array("Int32", "connectivity");
  for (const int v : mesh.corner) append_number(out, v), out += ' ';
  out += "\n</DataArray>\n" + array("Int32", "offsets");
  for (std::size_t p = 1; p < mesh.begin.size(); ++p) append_number(out, mesh.begin[p]), out += ' ';
  out += "\n</DataArray>\n" + array("UInt8", "types");
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    const int size = mesh.size_of_polygon(p);
    append_number(out, size == 4 ? vtk_quad : size == 3 ? vtk_triangle : vtk_polygon);
    out += ' ';
  }
  out += "\n</DataArray>\n</Cells>\n";
}

} // namespace

std::string encode_vtu(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                    "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                    std::to_string(mesh.number_of_points()) + "\" NumberOfCells=\"" +
                    std::to_string(mesh.number_of_polygons()) + "\">\n<Points>\n" +
                    array("Float64", "Points", 3);
  for (const Point& p : mesh.points) append_point(out, p), out += '\n';
  out += "</DataArray>\n</Points>\n";
  append_cells(mesh, out);
  if (!attributes.colours.empty()) {
    out += "<PointData>\n" + array("Float32", "colour", 3);
    for (const Eigen::Vector3d& colour : attributes.colours)
      append_point(out, colour.cast<float>().cast<double>()), out += '\n';
    out += "</DataArray>\n</PointData>\n";
  }
  if (!attributes.labels.empty()) {
    out += "<CellData>\n";
    for (const Face_labels& labels : attributes.labels) {
      out += array("Int32", labels.kind);
      for (const int label : labels.label) append_number(out, label), out += ' ';
      out += "\n</DataArray>\n";
    }
    out += "</CellData>\n";
  }
  return out + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
