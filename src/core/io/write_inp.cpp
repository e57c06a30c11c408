// SPDX-License-Identifier: GPL-3.0-or-later
// Abaqus' input file: nodes, shell elements, and a set of elements for each name.
#include "io/writers.h"

#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// Elements of one kind; element p + 1 is polygon p.
void append_elements(const Polygon_soup& mesh, int size, std::string& out) {
  bool has_any = false;
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    if (mesh.size_of_polygon(p) != size) continue;
    if (!has_any)
      out += "*ELEMENT, TYPE=S" + std::to_string(size) + ", ELSET=S" + std::to_string(size) + "_ALL\n";
    has_any = true;
    append_number(out, p + 1);
    for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) append_number(out += ", ", mesh.corner[c] + 1);
    out += '\n';
  }
}

/// Abaqus' names begin with a letter, have at most 80 characters, and no two differ by capitals alone.
std::string set_name(const Face_labels& labels, std::size_t label, std::set<std::string>& taken) {
  std::string name = word_of(labels.kind + '_' + labels.names[label]).substr(0, 60);
  for (char& c : name) c = c == '.' ? '_' : c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
  const std::string base = name;
  for (int i = 2; !taken.insert(name).second; ++i) name = base + '_' + std::to_string(i);
  return name;
}

} // namespace

std::string encode_inp(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  std::string out = "*HEADING\nreebquad\n*NODE\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    append_number(out, v + 1);
    for (int k = 0; k < 3; ++k) append_number(out += ", ", mesh.points[v][k]);
    out += '\n';
  }
  append_elements(mesh, 4, out);
  append_elements(mesh, 3, out);
  std::set<std::string> taken;
  for (const Face_labels& labels : attributes.labels) {
    std::vector<std::vector<int>> elements(labels.names.size());
    for (std::size_t p = 0; p < labels.label.size(); ++p)
      if (labels.label[p] >= 0) elements[std::size_t(labels.label[p])].push_back(int(p) + 1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements[i].empty()) continue;
      out += "*ELSET, ELSET=" + set_name(labels, i, taken) + '\n';
      constexpr std::size_t most = 16; // in a line
      for (std::size_t k = 0; k < elements[i].size(); ++k) {
        append_number(out, elements[i][k]);
        out += k + 1 == elements[i].size() || k % most == most - 1 ? "\n" : ", ";
      }
    }
  }
  return out;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
