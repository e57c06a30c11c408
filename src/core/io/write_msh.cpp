// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's format 4.1 as text, after "The MSH file format" of its manual: polygons with the same names are
// one surface, which belongs to a physical group for each of its names.
#include "io/writers.h"

#include <array>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int msh_triangle = 2, msh_quad = 3;

class Msh_writer {
public:
  Msh_writer(const Polygon_soup& mesh, const Mesh_attributes& attributes)
      : m_mesh(mesh), m_attributes(attributes) {
    m_first.push_back(1);
    for (const Face_labels& labels : attributes.labels)
      m_first.push_back(m_first.back() + int(labels.names.size()));
    for (int p = 0; p < mesh.number_of_polygons(); ++p) {
      std::vector<int> groups;
      for (std::size_t l = 0; l < attributes.labels.size(); ++l)
        if (const int label = attributes.labels[l].label[std::size_t(p)]; label >= 0)
          groups.push_back(m_first[l] + label);
      m_surfaces[groups][mesh.size_of_polygon(p) == 4].push_back(p);
    }
    if (m_surfaces.empty()) m_surfaces[{}];
  }

  std::string encode() {
    m_out = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    names();
    entities();
    nodes();
    elements();
    return std::move(m_out);
  }

private:
  template <class... Numbers> void line(Numbers... numbers) {
    bool is_first = true;
    ((append_number(is_first ? m_out : m_out += ' ', numbers), is_first = false), ...);
    m_out += '\n';
  }

  void names() {
    if (m_first.back() == 1) return;
    m_out += "$PhysicalNames\n";
    line(m_first.back() - 1);
    for (std::size_t l = 0; l < m_attributes.labels.size(); ++l)
      for (std::size_t i = 0; i < m_attributes.labels[l].names.size(); ++i)
        m_out += "2 " + std::to_string(m_first[l] + int(i)) + " \"" +
                 word_of(m_attributes.labels[l].kind + ':' + m_attributes.labels[l].names[i]) + "\"\n";
    m_out += "$EndPhysicalNames\n";
  }

  void entities() {
    m_out += "$Entities\n";
    line(0, 0, m_surfaces.size(), 0);
    Eigen::AlignedBox3d box;
    for (const Point& p : m_mesh.points) box.extend(p);
    if (m_mesh.points.empty()) box.extend(Point(0, 0, 0));
    int tag = 1;
    for (const auto& [groups, polygons] : m_surfaces) {
      append_number(m_out, tag++);
      append_point(m_out += ' ', box.min()); // of the whole: a box that holds the surface is asked for
      append_point(m_out += ' ', box.max());
      append_number(m_out += ' ', groups.size());
      for (const int group : groups) append_number(m_out += ' ', group);
      m_out += " 0\n";
    }
    m_out += "$EndEntities\n";
  }

  void nodes() {
    const std::size_t n = m_mesh.points.size();
    m_out += "$Nodes\n";
    line(n > 0 ? 1 : 0, n, 1, n);
    if (n > 0) line(2, 1, 0, n);
    for (std::size_t v = 1; v <= n; ++v) line(v);
    for (const Point& p : m_mesh.points) append_point(m_out, p), m_out += '\n';
    m_out += "$EndNodes\n";
  }

  void elements() {
    int blocks = 0;
    for (const auto& [groups, polygons] : m_surfaces) blocks += !polygons[0].empty() + !polygons[1].empty();
    m_out += "$Elements\n";
    line(blocks, m_mesh.number_of_polygons(), 1, m_mesh.number_of_polygons());
    int tag = 0;
    for (const auto& [groups, polygons] : m_surfaces) {
      ++tag;
      for (const bool is_quad : {false, true}) {
        if (polygons[is_quad].empty()) continue;
        line(2, tag, is_quad ? msh_quad : msh_triangle, polygons[is_quad].size());
        for (const int p : polygons[is_quad]) {
          append_number(m_out, p + 1);
          for (int c = m_mesh.begin[p]; c < m_mesh.begin[p + 1]; ++c)
            append_number(m_out += ' ', m_mesh.corner[c] + 1);
          m_out += '\n';
        }
      }
    }
    m_out += "$EndElements\n";
  }

  const Polygon_soup& m_mesh;
  const Mesh_attributes& m_attributes;
  std::vector<int>
      m_first; ///< the number of the first physical group of each kind of names, and the one after the last
  /// By physical groups: the triangles and the quads.
  std::map<std::vector<int>, std::array<std::vector<int>, 2>> m_surfaces;
  std::string m_out;
};

} // namespace

std::string encode_msh(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  return Msh_writer(mesh, attributes).encode();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
