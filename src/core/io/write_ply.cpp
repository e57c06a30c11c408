// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: colours as properties of points, texture coordinates and names (as numbers, which comments explain)
// of faces.
#include "io/writers.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

unsigned char byte_of(double part) {
  return static_cast<unsigned char>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
}

class Ply_writer {
public:
  Ply_writer(const Polygon_soup& mesh, const Mesh_attributes& attributes, bool ascii)
      : m_mesh(mesh), m_attributes(attributes), m_ascii(ascii) {
    for (int p = 0; p < mesh.number_of_polygons(); ++p)
      m_largest = std::max(m_largest, mesh.size_of_polygon(p));
  }

  std::string encode() {
    header();
    for (std::size_t v = 0; v < m_mesh.points.size(); ++v) {
      for (int k = 0; k < 3; ++k) put(m_mesh.points[v][k]);
      if (!m_attributes.colours.empty())
        for (int k = 0; k < 3; ++k) put_byte(byte_of(m_attributes.colours[v][k]));
      end_line();
    }
    for (int p = 0; p < m_mesh.number_of_polygons(); ++p) {
      face(p);
      end_line();
    }
    return std::move(m_out);
  }

private:
  void header() {
    m_out = std::string("ply\nformat ") + (m_ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
    for (const Face_labels& labels : m_attributes.labels)
      for (std::size_t i = 0; i < labels.names.size(); ++i)
        m_out +=
            "comment " + labels.kind + ' ' + std::to_string(i) + " is " + word_of(labels.names[i]) + '\n';
    m_out += "element vertex " + std::to_string(m_mesh.number_of_points()) +
             "\nproperty double x\nproperty double y\nproperty double z\n";
    if (!m_attributes.colours.empty())
      m_out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    m_out += "element face " + std::to_string(m_mesh.number_of_polygons()) + "\nproperty list " +
             (m_largest < 256 ? "uchar" : "int") + " int vertex_indices\n";
    if (!m_attributes.uv.empty())
      m_out += std::string("property list ") + (m_largest < 128 ? "uchar" : "int") + " float texcoord\n";
    for (const Face_labels& labels : m_attributes.labels) m_out += "property int " + labels.kind + '\n';
    m_out += "end_header\n";
  }

  void face(int p) {
    const int size = m_mesh.size_of_polygon(p);
    put_count(size, m_largest < 256);
    for (int c = m_mesh.begin[p]; c < m_mesh.begin[p + 1]; ++c) put(std::int32_t(m_mesh.corner[c]));
    if (!m_attributes.uv.empty()) {
      put_count(2 * size, m_largest < 128);
      for (int c = m_mesh.begin[p]; c < m_mesh.begin[p + 1]; ++c)
        for (int k = 0; k < 2; ++k) {
          const double x = m_attributes.uv[std::size_t(c)][k];
          put(std::isfinite(x) ? float(x) : 0.0f);
        }
    }
    for (const Face_labels& labels : m_attributes.labels) put(std::int32_t(labels.label[std::size_t(p)]));
  }

  template <class T> void put(T x) {
    if (m_ascii)
      append_number(space(), x);
    else
      append_little_endian(m_out, x);
  }
  void put_byte(unsigned char x) {
    if (m_ascii)
      append_number(space(), int(x));
    else
      m_out += char(x);
  }
  void put_count(int count, bool fits_byte) {
    if (fits_byte)
      put_byte(static_cast<unsigned char>(count));
    else
      put(std::int32_t(count));
  }
  std::string& space() { return m_out.back() == '\n' ? m_out : m_out += ' '; }
  void end_line() {
    if (m_ascii) m_out += '\n';
  }

  const Polygon_soup& m_mesh;
  const Mesh_attributes& m_attributes;
  bool m_ascii;
  int m_largest = 0; ///< number of corners
  std::string m_out;
};

} // namespace

std::string encode_ply(const Polygon_soup& mesh, const Mesh_attributes& attributes, bool ascii) {
  return Ply_writer(mesh, attributes, ascii).encode();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
