// SPDX-License-Identifier: GPL-3.0-or-later
// Binary glTF, after the Khronos Group's "glTF 2.0 Specification": a header, a chunk of JSON and a chunk of bytes.
#include "io/writers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Json = nlohmann::ordered_json;

constexpr int component_float = 5126, component_unsigned_int = 5125;
constexpr int target_array = 34962, target_element_array = 34963;

Json description(const Polygon_soup& mesh, std::size_t triangles) {
  std::array<double, 3> low{}, high{};
  for (int v = 0; v < mesh.number_of_points(); ++v)
    for (int k = 0; k < 3; ++k) {
      const double x = double(float(mesh.points[v][k]));
      low[k] = v == 0 ? x : std::min(low[k], x);
      high[k] = v == 0 ? x : std::max(high[k], x);
    }
  const std::size_t points = mesh.points.size(), split = 12 * points, size = split + 12 * triangles;
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", "reebquad"}};
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", {0}}}});
  json["nodes"] = Json::array({{{"mesh", 0}}});
  json["meshes"] =
      Json::array({{{"primitives", Json::array({{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}})}}});
  json["accessors"] = Json::array({{{"bufferView", 0},
                                    {"componentType", component_float},
                                    {"count", points},
                                    {"type", "VEC3"},
                                    {"min", low},
                                    {"max", high}},
                                   {{"bufferView", 1},
                                    {"componentType", component_unsigned_int},
                                    {"count", 3 * triangles},
                                    {"type", "SCALAR"}}});
  json["bufferViews"] =
      Json::array({{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", split}, {"target", target_array}},
                   {{"buffer", 0},
                    {"byteOffset", split},
                    {"byteLength", size - split},
                    {"target", target_element_array}}});
  json["buffers"] = Json::array({{{"byteLength", size}}});
  return json;
}

} // namespace

std::string encode_glb(const Polygon_soup& mesh) {
  const std::vector<Triangle> triangles = triangles_of(mesh);
  // glTF has no empty accessors: an empty mesh is an asset without a scene.
  std::string json = triangles.empty() ? R"({"asset":{"version":"2.0","generator":"reebquad"}})"
                                       : description(mesh, triangles.size()).dump();
  json.append((4 - json.size() % 4) % 4, ' ');
  std::string binary;
  if (!triangles.empty()) {
    for (const Point& p : mesh.points)
      for (int k = 0; k < 3; ++k) append_little_endian(binary, float(p[k]));
    for (const Triangle& t : triangles)
      for (int v : t) append_little_endian(binary, std::uint32_t(v));
  }
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
