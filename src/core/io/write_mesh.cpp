// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>

#include "base/quad_cut.h"
#include "io/writers.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// "SIZE i j k ...\n"
void append_polygon(std::string& out, const Polygon_soup& mesh, int p) {
  append_number(out, mesh.size_of_polygon(p));
  for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) append_number(out += ' ', mesh.corner[c]);
  out += '\n';
}

std::string encode_off(const Polygon_soup& mesh) {
  std::string out = "OFF\n" + std::to_string(mesh.number_of_points()) + ' ' +
                    std::to_string(mesh.number_of_polygons()) + " 0\n";
  for (const Point& p : mesh.points) {
    append_point(out, p);
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
    append_point(out, p);
    out += '\n';
  }
  out += "POLYGONS " + polygons + ' ' + std::to_string(mesh.corner.size() + mesh.begin.size() - 1) + '\n';
  for (int p = 0; p < mesh.number_of_polygons(); ++p) append_polygon(out, mesh, p);
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
    append_point(out += "facet normal ", normal_of(mesh, t));
    out += "\nouter loop\n";
    for (int v : t) {
      append_point(out += "vertex ", mesh.points[v]);
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

void append_point(std::string& out, const Point& p) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    append_number(out, p[k]);
  }
}

std::vector<Triangle> corner_triangles_of(const Polygon_soup& mesh, std::vector<int>* polygon) {
  std::vector<Triangle> triangles;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    const int begin = mesh.begin[p], size = mesh.size_of_polygon(p);
    const auto p_of = [&](int i) -> const Point& { return mesh.points[mesh.corner[begin + i]]; };
    // All triangles of a polygon begin at its first corner, of a quad perhaps at its second.
    const int first = size == 4 ? internal::first_corner_of_cut(p_of(0), p_of(1), p_of(2), p_of(3)) : 0;
    for (int i = 1; i + 1 < size; ++i) {
      triangles.push_back({begin + first, begin + (first + i) % size, begin + (first + i + 1) % size});
      if (polygon) polygon->push_back(p);
    }
  }
  return triangles;
}

std::vector<Triangle> triangles_of(const Polygon_soup& mesh) {
  std::vector<Triangle> triangles = corner_triangles_of(mesh);
  for (Triangle& t : triangles)
    for (int& corner : t) corner = mesh.corner[corner];
  return triangles;
}

const Face_labels* labels_of(const Mesh_attributes& attributes, const std::string& kind) {
  for (const Face_labels& labels : attributes.labels)
    if (labels.kind == kind) return &labels;
  return nullptr;
}

std::string word_of(const std::string& name) {
  std::string word;
  for (const char c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == '.' || c == '-' || (c & 0x80) != 0;
    word += is_plain ? c : '_';
  }
  return word.empty() ? "_" : word;
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

namespace {

/// What a format holds.
struct Capacity {
  int corners = std::numeric_limits<int>::max(); ///< of a polygon at most
  bool uv = false, colours = false, labels = false;
};

Capacity capacity(Mesh_format format) {
  const int any = Capacity().corners;
  switch (format) {
  case Mesh_format::obj:
  case Mesh_format::ply: return {any, true, true, true};
  case Mesh_format::vtu: return {any, false, true, true};
  case Mesh_format::inp:
  case Mesh_format::msh: return {4, false, false, true};
  case Mesh_format::glb: return {3, true, true, false}; // materials only, of all names
  case Mesh_format::stl: return {3, false, false, false};
  case Mesh_format::off:
  case Mesh_format::vtk:
  case Mesh_format::automatic: break;
  }
  return {any, false, false, false};
}

/// As words for people.
std::vector<std::string> dropped(const Mesh_attributes& attributes, Mesh_format format) {
  const Capacity holds = capacity(format);
  std::vector<std::string> words;
  if (!attributes.uv.empty() && !holds.uv) words.push_back("texture coordinates");
  if (!attributes.colours.empty() && !holds.colours) words.push_back("colours");
  for (const Face_labels& labels : attributes.labels)
    if (!holds.labels && !(format == Mesh_format::glb && labels.kind == "material"))
      words.push_back(labels.kind + 's');
  if (!attributes.material_library.empty() && format != Mesh_format::obj)
    words.push_back("the material library " + attributes.material_library);
  words.insert(words.end(), attributes.others.begin(), attributes.others.end());
  return words;
}

/// The mesh and its attributes with polygons of more than `most` corners divided into triangles.
void divide(int most, Polygon_soup& mesh, Mesh_attributes& attributes) {
  std::vector<int> polygon;
  const std::vector<Triangle> triangles = corner_triangles_of(mesh, &polygon);
  Polygon_soup divided;
  Mesh_attributes carried = attributes;
  carried.uv.clear();
  for (Face_labels& labels : carried.labels) labels.label.clear();
  divided.points = std::move(mesh.points);
  const auto add = [&](int p, const std::vector<int>& corners) {
    for (const int c : corners) {
      divided.corner.push_back(mesh.corner[std::size_t(c)]);
      if (!attributes.uv.empty()) carried.uv.push_back(attributes.uv[std::size_t(c)]);
    }
    divided.close_polygon();
    for (std::size_t l = 0; l < carried.labels.size(); ++l)
      carried.labels[l].label.push_back(attributes.labels[l].label[std::size_t(p)]);
  };
  std::size_t next = 0; // of the triangles
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    std::vector<int> corners;
    for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) corners.push_back(c);
    if (int(corners.size()) >= 3 && int(corners.size()) <= most) add(p, corners);
    for (; next < triangles.size() && polygon[next] == p; ++next)
      if (int(corners.size()) > most) add(p, {triangles[next][0], triangles[next][1], triangles[next][2]});
  }
  mesh = std::move(divided);
  attributes = std::move(carried);
}

void check_sizes([[maybe_unused]] const Polygon_soup& mesh,
                 [[maybe_unused]] const Mesh_attributes& attributes) {
  CGAL_precondition(attributes.uv.empty() || attributes.uv.size() == mesh.corner.size());
  CGAL_precondition(attributes.colours.empty() || attributes.colours.size() == mesh.points.size());
  for ([[maybe_unused]] const Face_labels& labels : attributes.labels)
    CGAL_precondition(labels.label.size() + 1 == mesh.begin.size());
}

std::string encode(const Polygon_soup& mesh, const Mesh_attributes& attributes, Mesh_format format,
                   bool ascii) {
  switch (format) {
  case Mesh_format::off: return encode_off(mesh);
  case Mesh_format::obj: return encode_obj(mesh, attributes);
  case Mesh_format::ply: return encode_ply(mesh, attributes, ascii);
  case Mesh_format::vtk: return encode_vtk(mesh);
  case Mesh_format::stl: return ascii ? encode_ascii_stl(mesh) : encode_binary_stl(mesh);
  case Mesh_format::glb: return encode_glb(mesh, attributes);
  case Mesh_format::vtu: return encode_vtu(mesh, attributes);
  case Mesh_format::inp: return encode_inp(mesh, attributes);
  case Mesh_format::msh: return encode_msh(mesh, attributes);
  case Mesh_format::automatic: break;
  }
  return {};
}

} // namespace

Result<Encoded_mesh> encode_mesh(const Polygon_soup& mesh, Mesh_format format, bool ascii,
                                 const std::string& comment) {
  return encode_mesh(mesh, Mesh_attributes(), format, ascii, comment);
}

Result<Encoded_mesh> encode_mesh(const Polygon_soup& mesh, const Mesh_attributes& attributes,
                                 Mesh_format format, bool ascii, const std::string& comment) {
  CGAL_precondition(comment.find_first_of("\r\n") == std::string::npos);
  check_sizes(mesh, attributes);
  if (format == Mesh_format::automatic)
    return make_error(Error_code::unsupported_format,
                      "The name does not tell the format: use .obj, .off, .ply, "
                      ".vtk, .vtu, .inp, .msh, .stl or .glb.");
  const bool only_triangles = format == Mesh_format::stl || format == Mesh_format::glb;
  if (Result<void> good = check_coordinates(mesh, only_triangles && !ascii); !good) return good.error();
  // Of each corner its index and, where points are divided at seams, position, coordinates and colour.
  const std::size_t split = attributes.uv.empty() ? 0 : 32 * mesh.corner.size();
  if (format == Mesh_format::glb && 24 * mesh.points.size() + 12 * mesh.corner.size() + split > 0xffff0000u)
    return make_error(Error_code::impossible_request,
                      "The mesh is too large for binary glTF, which holds four gigabytes.");
  const int most = capacity(format).corners;
  int larger = 0;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) larger += mesh.size_of_polygon(p) > most;
  Encoded_mesh encoded;
  if (larger > 0 && most == 4) {
    Polygon_soup divided = mesh;
    Mesh_attributes carried = attributes;
    divide(most, divided, carried);
    encoded.bytes = encode(divided, carried, format, ascii);
  } else {
    encoded.bytes = encode(mesh, attributes, format, ascii);
  }
  add_comment(encoded.bytes, format, comment);
  encoded.dropped = dropped(attributes, format);
  if (larger > 0)
    encoded.warnings.push_back(std::string(name(format)) + " holds triangles " +
                               (most == 4 ? "and quads only: " : "only: ") + std::to_string(larger) +
                               " faces with more corners were divided.");
  return encoded;
}

Result<std::vector<std::string>> write_mesh(const std::string& path, const Polygon_soup& mesh,
                                            const Write_options& options) {
  const Mesh_format format =
      options.format == Mesh_format::automatic ? format_of_extension(path) : options.format;
  Result<Encoded_mesh> encoded =
      encode_mesh(mesh, options.attributes ? *options.attributes : Mesh_attributes(), format, options.ascii,
                  options.comment);
  if (!encoded) {
    Error error = encoded.error();
    error.message = "Cannot write '" + path + "': " + error.message;
    return error;
  }
  if (Result<void> written = write_file_atomically(path, encoded->bytes); !written) return written.error();
  if (options.dropped) *options.dropped = std::move(encoded->dropped);
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
