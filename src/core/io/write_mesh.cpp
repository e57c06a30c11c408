// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>

#include "base/quad_cut.h"
#include "io/writers.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

void append(std::string& out, double x) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, x).ptr);
}

void append(std::string& out, int i) {
  char text[16];
  out.append(text, std::to_chars(text, text + sizeof text, i).ptr);
}

void append(std::string& out, const Point& p) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    append(out, p[k]);
  }
}

/// "SIZE i j k ...\n"
void append_polygon(std::string& out, const Polygon_soup& mesh, int p) {
  append(out, mesh.size_of_polygon(p));
  for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) append(out += ' ', mesh.corner[c]);
  out += '\n';
}

std::string encode_obj(const Polygon_soup& mesh) {
  std::string out;
  for (const Point& p : mesh.points) {
    append(out += "v ", p);
    out += '\n';
  }
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    out += 'f';
    for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) append(out += ' ', mesh.corner[c] + 1);
    out += '\n';
  }
  return out;
}

std::string encode_off(const Polygon_soup& mesh) {
  std::string out = "OFF\n" + std::to_string(mesh.number_of_points()) + ' ' +
                    std::to_string(mesh.number_of_polygons()) + " 0\n";
  for (const Point& p : mesh.points) {
    append(out, p);
    out += '\n';
  }
  for (int p = 0; p < mesh.number_of_polygons(); ++p) append_polygon(out, mesh, p);
  return out;
}

std::string encode_vtk(const Polygon_soup& mesh) {
  const std::string polygons = std::to_string(mesh.number_of_polygons());
  std::string out = "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\nPOINTS " +
                    std::to_string(mesh.number_of_points()) + " double\n";
  for (const Point& p : mesh.points) {
    append(out, p);
    out += '\n';
  }
  out += "POLYGONS " + polygons + ' ' + std::to_string(mesh.corner.size() + mesh.begin.size() - 1) + '\n';
  for (int p = 0; p < mesh.number_of_polygons(); ++p) append_polygon(out, mesh, p);
  return out;
}

std::string encode_ply(const Polygon_soup& mesh, bool ascii) {
  int largest = 0;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) largest = std::max(largest, mesh.size_of_polygon(p));
  std::string out = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
                    " 1.0\nelement vertex " + std::to_string(mesh.number_of_points()) +
                    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(mesh.number_of_polygons()) + "\nproperty list " +
                    (largest < 256 ? "uchar" : "int") + " int vertex_indices\nend_header\n";
  for (const Point& p : mesh.points) {
    if (ascii) {
      append(out, p);
      out += '\n';
    } else {
      for (int k = 0; k < 3; ++k) append_little_endian(out, p[k]);
    }
  }
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    if (ascii) {
      append_polygon(out, mesh, p);
      continue;
    }
    const int size = mesh.size_of_polygon(p);
    if (largest < 256)
      out += char(static_cast<unsigned char>(size));
    else
      append_little_endian(out, std::int32_t(size));
    for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c)
      append_little_endian(out, std::int32_t(mesh.corner[c]));
  }
  return out;
}

Point normal_of(const Polygon_soup& mesh, const Triangle& t) {
  const Point n = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
  const double length = n.norm();
  return length > 0 && std::isfinite(length) ? Point(n / length) : Point(0, 0, 0);
}

std::string encode_ascii_stl(const Polygon_soup& mesh) {
  std::string out = "solid mesh\n";
  for (const Triangle& t : triangles_of(mesh)) {
    append(out += "facet normal ", normal_of(mesh, t));
    out += "\nouter loop\n";
    for (int v : t) {
      append(out += "vertex ", mesh.points[v]);
      out += '\n';
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid mesh\n";
}

std::string encode_binary_stl(const Polygon_soup& mesh) {
  const std::vector<Triangle> triangles = triangles_of(mesh);
  std::string out(80, ' ');
  out.replace(0, 11, "binary STL "); // does not begin with "solid", as ascii files do
  append_little_endian(out, std::uint32_t(triangles.size()));
  const auto add = [&out](const Point& p) {
    for (int k = 0; k < 3; ++k) append_little_endian(out, float(p[k]));
  };
  for (const Triangle& t : triangles) {
    add(normal_of(mesh, t));
    for (int v : t) add(mesh.points[v]);
    out.append(2, '\0');
  }
  return out;
}

Result<void> check_coordinates(const Polygon_soup& mesh, bool single_precision) {
  for (int v = 0; v < mesh.number_of_points(); ++v) {
    const Point& p = mesh.points[v];
    const bool fits =
        !single_precision || p.cwiseAbs().maxCoeff() <= double(std::numeric_limits<float>::max());
    if (!p.allFinite() || !fits)
      return make_error(Error_code::impossible_request,
                        "Point " + std::to_string(v) +
                            (p.allFinite() ? " is too far away for single precision." : " is not finite."),
                        Element_kind::vertex, v);
  }
  return {};
}

} // namespace

std::vector<Triangle> triangles_of(const Polygon_soup& mesh) {
  std::vector<Triangle> triangles;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    const int* const corner = mesh.corner.data() + mesh.begin[p];
    const int size = mesh.size_of_polygon(p);
    const auto p_of = [&](int i) -> const Point& { return mesh.points[corner[i]]; };
    // All triangles of a polygon begin at its first corner, of a quad perhaps at its second.
    const int first = size == 4 ? internal::first_corner_of_cut(p_of(0), p_of(1), p_of(2), p_of(3)) : 0;
    for (int i = 1; i + 1 < size; ++i)
      triangles.push_back({corner[first], corner[(first + i) % size], corner[(first + i + 1) % size]});
  }
  return triangles;
}

namespace {

// After the first line of OFF, the second of PLY, before all of OBJ.
void add_comment(std::string& bytes, Mesh_format format, const std::string& comment) {
  if (comment.empty()) return;
  if (format == Mesh_format::obj) bytes.insert(0, "# " + comment + "\n");
  if (format == Mesh_format::off) bytes.insert(bytes.find('\n') + 1, "# " + comment + "\n");
  if (format == Mesh_format::ply)
    bytes.insert(bytes.find('\n', bytes.find('\n') + 1) + 1, "comment " + comment + "\n");
}

} // namespace

Result<Encoded_mesh> encode_mesh(const Polygon_soup& mesh, Mesh_format format, bool ascii,
                                 const std::string& comment) {
  CGAL_precondition(comment.find_first_of("\r\n") == std::string::npos);
  const bool only_triangles = format == Mesh_format::stl || format == Mesh_format::glb;
  if (Result<void> good = check_coordinates(mesh, only_triangles && !ascii); !good) return good.error();
  if (format == Mesh_format::glb && 12 * (mesh.points.size() + mesh.corner.size()) > 0xffff0000u)
    return make_error(Error_code::impossible_request,
                      "The mesh is too large for binary glTF, which holds four gigabytes.");
  Encoded_mesh encoded;
  switch (format) {
  case Mesh_format::off: encoded.bytes = encode_off(mesh); break;
  case Mesh_format::obj: encoded.bytes = encode_obj(mesh); break;
  case Mesh_format::ply: encoded.bytes = encode_ply(mesh, ascii); break;
  case Mesh_format::vtk: encoded.bytes = encode_vtk(mesh); break;
  case Mesh_format::stl: encoded.bytes = ascii ? encode_ascii_stl(mesh) : encode_binary_stl(mesh); break;
  case Mesh_format::glb: encoded.bytes = encode_glb(mesh); break;
  case Mesh_format::automatic:
    return make_error(Error_code::unsupported_format,
                      "The name does not tell the format: use .obj, .off, .ply, .vtk, .stl or .glb.");
  }
  add_comment(encoded.bytes, format, comment);
  int larger = 0;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) larger += mesh.size_of_polygon(p) > 3;
  if (only_triangles && larger > 0)
    encoded.warnings.push_back(std::string(name(format)) + " holds triangles only: " +
                               std::to_string(larger) + " faces with more corners were divided.");
  return encoded;
}

Result<std::vector<std::string>> write_mesh(const std::string& path, const Polygon_soup& mesh,
                                            const Write_options& options) {
  const Mesh_format format =
      options.format == Mesh_format::automatic ? format_of_extension(path) : options.format;
  Result<Encoded_mesh> encoded = encode_mesh(mesh, format, options.ascii, options.comment);
  if (!encoded) {
    Error error = encoded.error();
    error.message = "Cannot write '" + path + "': " + error.message;
    return error;
  }
  if (Result<void> written = write_file_atomically(path, encoded->bytes); !written) return written.error();
  return std::move(encoded->warnings);
}

Result<std::vector<std::string>> write_mesh(const std::string& path, const Quad_mesh& mesh,
                                            const Write_options& options) {
  return write_mesh(path, polygon_soup(mesh), options);
}

Result<std::vector<std::string>> write_mesh(const std::string& path, const Triangle_surface& surface,
                                            const Write_options& options) {
  return write_mesh(path, polygon_soup(surface), options);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
