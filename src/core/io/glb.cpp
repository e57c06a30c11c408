// SPDX-License-Identifier: GPL-3.0-or-later
// Binary glTF, after the Khronos Group's "glTF 2.0 Specification": a header, a chunk of JSON and a chunk of
// bytes.
#include "io/writers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Ordered_json = nlohmann::ordered_json;

constexpr int component_float = 5126, component_unsigned_int = 5125;
constexpr int target_array = 34962, target_element_array = 34963;

/// Files have colours as screens do; glTF has light.
double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

/// Points once for each of their texture coordinates, and triangles of these by material.
struct Split_mesh {
  std::vector<int> point;                                   ///< the point of each
  std::vector<Eigen::Vector2d> uv;                          ///< of each, if there are any
  std::vector<std::pair<int, std::vector<Triangle>>> parts; ///< material, or -1, and triangles
};

/// Corners of triangles as points of the file.
class Splitter {
public:
  Splitter(const Polygon_soup& mesh, const Mesh_attributes& attributes)
      : m_mesh(mesh), m_attributes(attributes) {
    if (!attributes.uv.empty()) return;
    for (int v = 0; v < mesh.number_of_points(); ++v) split.point.push_back(v);
  }

  int operator()(int corner) {
    const int v = m_mesh.corner[std::size_t(corner)];
    if (m_attributes.uv.empty()) return v;
    Eigen::Vector2d uv = m_attributes.uv[std::size_t(corner)];
    if (!uv.allFinite()) uv = Eigen::Vector2d::Zero();
    const auto [at, is_new] = m_known.insert({{v, uv.x(), uv.y()}, int(split.point.size())});
    if (is_new) {
      split.point.push_back(v);
      split.uv.push_back(uv);
    }
    return at->second;
  }

  Split_mesh split;

private:
  const Polygon_soup& m_mesh;
  const Mesh_attributes& m_attributes;
  std::map<std::tuple<int, double, double>, int> m_known;
};

Split_mesh split(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  std::vector<int> polygon;
  const std::vector<Triangle> triangles = corner_triangles_of(mesh, &polygon);
  const Face_labels* const materials = labels_of(attributes, "material");
  Splitter splitter(mesh, attributes);
  std::map<int, std::vector<Triangle>> parts;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = splitter(triangles[i][k]);
    parts[materials ? materials->label[std::size_t(polygon[i])] : -1].push_back(t);
  }
  splitter.split.parts.assign(parts.begin(), parts.end());
  return std::move(splitter.split);
}

/// The JSON of the file and its bytes, which it describes.
struct Glb_writer {
  Ordered_json json;
  std::string binary;

  /// Adds a view of the bytes from `begin` on and an accessor of it; its number.
  std::size_t add(std::size_t begin, const char* type, int component, std::size_t count, int target) {
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary.size() - begin}, {"target", target}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  }

  /// Appends `count` tuples of numbers `value(i, k)` of single precision.
  template <class Value> std::size_t add_points(int size, std::size_t count, const Value& value) {
    const std::size_t begin = binary.size();
    for (std::size_t i = 0; i < count; ++i)
      for (int k = 0; k < size; ++k) append_little_endian(binary, float(value(i, k)));
    return add(begin, size == 2 ? "VEC2" : "VEC3", component_float, count, target_array);
  }
};

/// The least and the greatest coordinates, as glTF asks for them.
void add_bounds(const Polygon_soup& mesh, const std::vector<int>& point, Ordered_json& accessor) {
  std::array<double, 3> low{}, high{};
  for (std::size_t i = 0; i < point.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = double(float(mesh.points[std::size_t(point[i])][Eigen::Index(k)]));
      low[k] = i == 0 ? x : std::min(low[k], x);
      high[k] = i == 0 ? x : std::max(high[k], x);
    }
  accessor["min"] = low;
  accessor["max"] = high;
}

void add_parts(const Split_mesh& mesh, const Face_labels* materials, const Ordered_json& attributes,
               Glb_writer& out) {
  Ordered_json primitives = Ordered_json::array();
  for (const auto& [material, triangles] : mesh.parts) {
    const std::size_t begin = out.binary.size();
    for (const Triangle& t : triangles)
      for (const int v : t) append_little_endian(out.binary, std::uint32_t(v));
    const std::size_t indices =
        out.add(begin, "SCALAR", component_unsigned_int, 3 * triangles.size(), target_element_array);
    primitives.push_back({{"attributes", attributes}, {"indices", indices}});
    if (material < 0) continue;
    primitives.back()["material"] = out.json["materials"].size();
    const std::string& name = materials->names[std::size_t(material)];
    out.json["materials"].push_back({{"name", name}});
  }
  out.json["meshes"] = Ordered_json::array({{{"primitives", primitives}}});
}

Glb_writer described(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  Glb_writer out;
  out.json["asset"] = {{"version", "2.0"}, {"generator", "reebquad"}};
  const Split_mesh parts = split(mesh, attributes);
  // glTF has no empty accessors: an empty mesh is an asset without a scene.
  if (parts.parts.empty()) return out;
  out.json["scene"] = 0;
  out.json["scenes"] = Ordered_json::array({{{"nodes", {0}}}});
  out.json["nodes"] = Ordered_json::array({{{"mesh", 0}}});
  const std::size_t n = parts.point.size();
  const auto point = [&](std::size_t i) { return std::size_t(parts.point[i]); };
  Ordered_json given;
  given["POSITION"] = out.add_points(3, n, [&](std::size_t i, int k) { return mesh.points[point(i)][k]; });
  add_bounds(mesh, parts.point, out.json["accessors"][0]);
  if (!attributes.uv.empty()) // v goes down there
    given["TEXCOORD_0"] = out.add_points(
        2, n, [&](std::size_t i, int k) { return k == 0 ? parts.uv[i].x() : 1 - parts.uv[i].y(); });
  if (!attributes.colours.empty())
    given["COLOR_0"] = out.add_points(3, n, [&](std::size_t i, int k) {
      return linear(std::clamp(attributes.colours[point(i)][k], 0.0, 1.0));
    });
  add_parts(parts, labels_of(attributes, "material"), given, out);
  out.json["buffers"] = Ordered_json::array({{{"byteLength", out.binary.size()}}});
  return out;
}

} // namespace

std::string encode_glb(const Polygon_soup& mesh, const Mesh_attributes& attributes) {
  const Glb_writer written = described(mesh, attributes);
  const std::string& binary = written.binary;
  std::string json = written.json.dump(-1, ' ', false, Ordered_json::error_handler_t::replace);
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::size_t size = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
  std::string out = "glTF";
  append_little_endian(out, std::uint32_t(2));
  append_little_endian(out, std::uint32_t(size));
  append_little_endian(out, std::uint32_t(json.size()));
  out += "JSON" + json;
  if (binary.empty()) return out;
  append_little_endian(out, std::uint32_t(binary.size()));
  out.append("BIN\0", 4);
  return out + binary;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
