// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: points with colours, texture coordinates, objects, groups and materials.
#include "io/writers.h"

#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// Texture coordinates, each once, in the order of the corners; and of each corner the number of its own, 0
/// if it has none.
std::vector<int> append_uv(const Mesh_attributes& attributes, std::string& out) {
  std::vector<int> number;
  std::map<std::pair<double, double>, int> known;
  for (const Eigen::Vector2d& uv : attributes.uv) {
    if (!uv.allFinite()) {
      number.push_back(0);
      continue;
    }
    const auto [at, is_new] = known.insert({{uv.x(), uv.y()}, int(known.size()) + 1});
    number.push_back(at->second);
    if (!is_new) continue;
    append_number(out += "vt ", uv.x());
    append_number(out += ' ', uv.y());
    out += '\n';
  }
  return number;
}

/// The statements that name a polygon: of groups all kinds together, since a second g takes the first back.
std::string statements(const Mesh_attributes& attributes, int polygon) {
  std::string objects, groups, materials;
  for (const Face_labels& labels : attributes.labels) {
    const int label = labels.label[std::size_t(polygon)];
    const std::string word = label < 0 ? "" : word_of(labels.names[std::size_t(label)]);
    if (labels.kind == "object") objects = "o " + (word.empty() ? "none" : word) + '\n';
    if (labels.kind == "material") materials = "usemtl " + (word.empty() ? "none" : word) + '\n';
    if (labels.kind == "group" || labels.kind == "chart") groups += word.empty() ? "" : ' ' + word;
  }
  const bool has_groups = labels_of(attributes, "group") || labels_of(attributes, "chart");
  if (has_groups) groups = "g" + (groups.empty() ? " default" : groups) + '\n';
  return objects + groups + materials;
}

} // namespace

std::string encode_obj(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  std::string out, named;
  if (!attributes.material_library.empty() && labels_of(attributes, "material"))
    out += "mtllib " + attributes.material_library + '\n';
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    append_point(out += "v ", mesh.points[v]);
    if (!attributes.colours.empty()) append_point(out += ' ', attributes.colours[v]);
    out += '\n';
  }
  const std::vector<int> uv = append_uv(attributes, out);
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    if (!attributes.labels.empty()) {
      const std::string names = statements(attributes, p);
      if (names != named) out += names;
      named = names;
    }
    out += 'f';
    for (int c = mesh.begin[p]; c < mesh.begin[p + 1]; ++c) {
      append_number(out += ' ', mesh.corner[c] + 1);
      if (!uv.empty() && uv[std::size_t(c)] > 0) append_number(out += '/', uv[std::size_t(c)]);
    }
    out += '\n';
  }
  return out;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
