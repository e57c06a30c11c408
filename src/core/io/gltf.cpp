// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of a glTF 2.0 file, binary or JSON with embedded buffers, after the Khronos Group's "glTF 2.0
// Specification". We read it ourselves, over nlohmann's JSON: the readers that exist trust the offsets and
// counts of the file, and bring images and materials along.
#include "io/readers.h"
#include "io/text_cursor.h"

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Json = nlohmann::json;

/// What ends the reading; the doors turn it into an `Error`.
struct Gltf_failure : std::runtime_error {
  explicit Gltf_failure(const std::string& text, Error_code code_ = Error_code::malformed_file)
      : std::runtime_error("glTF: " + text + "."), code(code_) {}
  Error_code code;
};

std::uint32_t little_endian_32(const char* p) {
  const auto byte = [p](int i) { return std::uint32_t(static_cast<unsigned char>(p[i])); };
  return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}

/// Parses JSON that is neither deeper nor richer in values than files of meshes are, so that memory stays
/// bounded.
Json parse_json(const char* begin, const char* end) {
  constexpr int deepest = 64;
  constexpr std::int64_t most = 4'000'000;
  std::int64_t values = 0;
  const auto watch = [&values](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest || ++values > most) throw Gltf_failure("its JSON is too deep or has too many values");
    return true;
  };
  return Json::parse(begin, end, watch);
}

std::string decode_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int n = 0;
  for (char c : text) {
    int digit = -1;
    if (c >= 'A' && c <= 'Z') digit = c - 'A';
    if (c >= 'a' && c <= 'z') digit = c - 'a' + 26;
    if (c >= '0' && c <= '9') digit = c - '0' + 52;
    if (c == '+') digit = 62;
    if (c == '/') digit = 63;
    if (c == '=') break;
    if (digit < 0) throw Gltf_failure("a buffer is not base64");
    bits = bits << 6 | std::uint32_t(digit);
    if (++n % 4 == 0) {
      for (int shift : {16, 8, 0}) bytes += char(bits >> shift & 0xff);
      bits = 0;
    }
  }
  if (n % 4 == 2) bytes += char(bits >> 4 & 0xff);
  if (n % 4 == 3) {
    bytes += char(bits >> 10 & 0xff);
    bytes += char(bits >> 2 & 0xff);
  }
  return bytes;
}

/// A non-negative integer member; `otherwise` if it is missing and that is not -1.
std::int64_t integer(const Json& object, const char* key, std::int64_t otherwise = -1) {
  const auto found = object.find(key);
  if (found == object.end()) {
    if (otherwise >= 0) return otherwise;
    throw Gltf_failure(std::string("\"") + key + "\" is missing");
  }
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > (std::uint64_t(1) << 53))
    throw Gltf_failure(std::string("\"") + key + "\" is no index or size");
  return std::int64_t(found->get<std::uint64_t>());
}

/// Values of an accessor where they lie in a buffer; all of them are inside.
struct Values {
  const char* begin = nullptr;
  std::int64_t count = 0, stride = 0;
  int type = 0;
  bool normalized = false;
};

int size_of_type(int type) {
  switch (type) {
  case 5120:
  case 5121: return 1;
  case 5122:
  case 5123: return 2;
  case 5125:
  case 5126: return 4;
  default: throw Gltf_failure("there is no component type " + std::to_string(type));
  }
}

double component(const char* at, int type, bool normalized) {
  const auto byte = [at](int i) { return std::uint32_t(static_cast<unsigned char>(at[i])); };
  const std::uint32_t bits16 = byte(0) | (size_of_type(type) > 1 ? byte(1) << 8 : 0);
  switch (type) {
  case 5120:
    return normalized ? std::max(double(std::int8_t(byte(0))) / 127, -1.0) : double(std::int8_t(byte(0)));
  case 5121: return double(byte(0)) / (normalized ? 255 : 1);
  case 5122:
    return normalized ? std::max(double(std::int16_t(bits16)) / 32767, -1.0) : double(std::int16_t(bits16));
  case 5123: return double(bits16) / (normalized ? 65535 : 1);
  case 5125: return double(little_endian_32(at));
  default: {
    const std::uint32_t bits = little_endian_32(at);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  }
}

class Gltf_parser {
public:
  Gltf_parser(const char* data, std::size_t size, Notes& notes, Mesh_attributes* attributes)
      : m_data(data), m_size(size), m_notes(notes), m_attributes(attributes),
        m_most(std::min<std::int64_t>(largest_count,
                                      std::max<std::int64_t>(30'000'000, 3 * std::int64_t(size)))) {}

  Polygon_soup parse() {
    split();
    refuse_what_is_required();
    load_buffers();
    visit_scene();
    note_what_is_passed_over();
    return std::move(m_soup);
  }

private:
  // ---- the container ----

  void split() {
    if (m_size < 4 || std::memcmp(m_data, "glTF", 4) != 0) {
      m_json = parse_json(m_data, m_data + m_size);
    } else {
      if (m_size < 20) throw Gltf_failure("the file ends in its header");
      if (little_endian_32(m_data + 4) != 2)
        throw Gltf_failure("version " + std::to_string(little_endian_32(m_data + 4)) + " is not read, only 2",
                           Error_code::unsupported_format);
      if (little_endian_32(m_data + 8) > m_size) throw Gltf_failure("the file is shorter than it says");
      const std::uint64_t json = little_endian_32(m_data + 12);
      if (std::memcmp(m_data + 16, "JSON", 4) != 0 || json > m_size - 20)
        throw Gltf_failure("the JSON chunk does not fit into the file");
      m_json = parse_json(m_data + 20, m_data + 20 + json);
      const std::uint64_t at = 20 + json;
      if (m_size - at >= 8 && std::memcmp(m_data + at + 4, "BIN\0", 4) == 0) {
        const std::uint64_t binary = little_endian_32(m_data + at);
        if (binary > m_size - at - 8) throw Gltf_failure("the binary chunk does not fit into the file");
        m_binary = std::string_view(m_data + at + 8, binary);
      }
    }
    if (!m_json.is_object() || !m_json.contains("asset")) throw Gltf_failure("there is no \"asset\"");
  }

  void refuse_what_is_required() const {
    for (const Json& name : list("extensionsRequired"))
      if (name.is_string() && (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression"))
        throw Gltf_failure("its meshes are compressed by " + name.get<std::string>() +
                               ", which is not read; save it without",
                           Error_code::unsupported_format);
  }

  const Json& list(const char* key) const {
    static const Json none = Json::array();
    const auto found = m_json.find(key);
    if (found == m_json.end()) return none;
    if (!found->is_array()) throw Gltf_failure(std::string("\"") + key + "\" is no list");
    return *found;
  }

  const Json& element(const char* key, std::int64_t i) const {
    const Json& all = list(key);
    if (i < 0 || std::size_t(i) >= all.size() || !all[std::size_t(i)].is_object())
      throw Gltf_failure(std::string("\"") + key + "\" has no element " + std::to_string(i));
    return all[std::size_t(i)];
  }

  void load_buffers() {
    const Json& buffers = list("buffers");
    m_embedded.reserve(buffers.size()); // the views below stay
    for (std::size_t b = 0; b < buffers.size(); ++b) {
      const Json& buffer = element("buffers", std::int64_t(b));
      if (!buffer.contains("uri")) {
        m_buffers.push_back(b == 0 ? m_binary : std::string_view());
        continue;
      }
      const std::string uri = buffer["uri"].is_string() ? buffer["uri"].get<std::string>() : std::string();
      const std::size_t comma = uri.find(";base64,");
      if (uri.compare(0, 5, "data:") != 0 || comma == std::string::npos)
        throw Gltf_failure("a buffer lies in another file; save it as .glb, which holds everything",
                           Error_code::unsupported_format);
      m_embedded.push_back(decode_base64(std::string_view(uri).substr(comma + 8)));
      m_buffers.push_back(m_embedded.back());
    }
  }

  Values values(std::int64_t accessor_index, int components) const {
    const Json& accessor = element("accessors", accessor_index);
    if (accessor.contains("sparse") || !accessor.contains("bufferView"))
      throw Gltf_failure("accessor " + std::to_string(accessor_index) + " is sparse, which is not read",
                         Error_code::unsupported_format);
    const std::string type = accessor.value("type", std::string());
    if (type != (components == 3 ? "VEC3" : "SCALAR"))
      throw Gltf_failure("accessor " + std::to_string(accessor_index) + " is of type " + quoted(type));
    const Json& view = element("bufferViews", integer(accessor, "bufferView"));
    const std::int64_t buffer = integer(view, "buffer");
    if (std::size_t(buffer) >= m_buffers.size())
      throw Gltf_failure("there is no buffer " + std::to_string(buffer));
    const std::string_view bytes = m_buffers[std::size_t(buffer)];
    const std::int64_t offset = integer(view, "byteOffset", 0), length = integer(view, "byteLength");
    if (offset > std::int64_t(bytes.size()) || length > std::int64_t(bytes.size()) - offset)
      throw Gltf_failure("a view of " + std::to_string(length) + " bytes does not fit into its buffer of " +
                         std::to_string(bytes.size()));
    Values result;
    result.type = int(std::min<std::int64_t>(integer(accessor, "componentType"), 1 << 20));
    result.count = integer(accessor, "count");
    result.normalized = accessor.value("normalized", false);
    const std::int64_t size = std::int64_t(size_of_type(result.type)) * components;
    result.stride = integer(view, "byteStride", size);
    const std::int64_t first = integer(accessor, "byteOffset", 0);
    const std::int64_t room = length - first;
    if (result.stride < size || result.stride > 1024 || first > length ||
        (result.count > 0 && (room < size || (room - size) / result.stride < result.count - 1)))
      throw Gltf_failure("the " + std::to_string(result.count) + " values of accessor " +
                         std::to_string(accessor_index) + " do not fit into their view");
    result.begin = bytes.data() + offset + first;
    return result;
  }

  static std::string quoted(const std::string& text) {
    return quoted_word(Text_cursor(text.data(), text.data() + text.size()));
  }

  // ---- the scene ----

  void visit_scene() {
    const Json& nodes = list("nodes");
    std::vector<std::int64_t> roots;
    if (const Json& scenes = list("scenes"); !scenes.empty()) {
      const Json& scene = element("scenes", integer(m_json, "scene", 0));
      for (const Json& root : scene.value("nodes", Json::array())) roots.push_back(child(root));
    } else {
      std::vector<char> is_child(nodes.size(), 0);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const Json& c : element("nodes", std::int64_t(i)).value("children", Json::array()))
          is_child[std::size_t(child(c))] = 1;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!is_child[i]) roots.push_back(std::int64_t(i));
    }
    // Without nodes the meshes are taken as they are.
    if (nodes.empty())
      for (std::size_t m = 0; m < list("meshes").size(); ++m)
        add_mesh(std::int64_t(m), Eigen::Affine3d::Identity());
    std::vector<std::pair<std::int64_t, Eigen::Affine3d>> open;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
      open.emplace_back(*root, Eigen::Affine3d::Identity());
    std::vector<char> seen(nodes.size(), 0);
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      if (seen[std::size_t(index)]++)
        throw Gltf_failure("node " + std::to_string(index) + " has two parents, or is its own");
      const Json& node = element("nodes", index);
      const Eigen::Affine3d placed = parent * transform(node);
      m_skins += node.contains("skin");
      // The place of a skinned mesh is that of its bones; it is taken as it was bound to them.
      if (node.contains("mesh"))
        add_mesh(integer(node, "mesh"), node.contains("skin") ? Eigen::Affine3d::Identity() : placed);
      const Json children = node.value("children", Json::array());
      for (auto c = children.rbegin(); c != children.rend(); ++c) open.emplace_back(child(*c), placed);
    }
  }

  std::int64_t child(const Json& index) const {
    if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= list("nodes").size())
      throw Gltf_failure("there is no node " + index.dump());
    return std::int64_t(index.get<std::uint64_t>());
  }

  template <std::size_t N>
  static std::array<double, N> numbers(const Json& node, const char* key, std::array<double, N> otherwise) {
    const auto found = node.find(key);
    if (found == node.end()) return otherwise;
    if (!found->is_array() || found->size() != N)
      throw Gltf_failure(std::string("\"") + key + "\" of a node has not " + std::to_string(N) + " numbers");
    std::array<double, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = (*found)[i].get<double>();
    return result;
  }

  static Eigen::Affine3d transform(const Json& node) {
    if (node.contains("matrix")) {
      const std::array<double, 16> m = numbers<16>(node, "matrix", {});
      return Eigen::Affine3d(Eigen::Matrix4d(m.data())); // by columns, as Eigen has it
    }
    const auto t = numbers<3>(node, "translation", {0, 0, 0});
    const auto r = numbers<4>(node, "rotation", {0, 0, 0, 1});
    const auto s = numbers<3>(node, "scale", {1, 1, 1});
    return Eigen::Translation3d(t[0], t[1], t[2]) * Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized() *
           Eigen::Scaling(s[0], s[1], s[2]);
  }

  // ---- meshes ----

  void add_mesh(std::int64_t mesh, const Eigen::Affine3d& placed) {
    for (const Json& primitive : element("meshes", mesh).value("primitives", Json::array())) {
      if (!primitive.is_object())
        throw Gltf_failure("a primitive of mesh " + std::to_string(mesh) + " is none");
      const std::int64_t mode = integer(primitive, "mode", 4);
      if (mode < 4 || mode > 6) {
        ++m_lines;
        continue;
      }
      m_morphs += primitive.contains("targets");
      const auto attributes = primitive.find("attributes");
      if (attributes == primitive.end() || !attributes->contains("POSITION")) continue;
      note_attributes(primitive, *attributes);
      add_primitive(primitive, values(integer(*attributes, "POSITION"), 3), int(mode), placed);
    }
  }

  void note_attributes(const Json& primitive, const Json& attributes) {
    if (attributes.contains("NORMAL")) note_other(m_attributes, "normals");
    if (attributes.contains("TEXCOORD_0")) note_other(m_attributes, "texture coordinates");
    if (attributes.contains("COLOR_0")) note_other(m_attributes, "colours");
    if (primitive.contains("material")) note_other(m_attributes, "materials");
  }

  void add_primitive(const Json& primitive, const Values& positions, int mode,
                     const Eigen::Affine3d& placed) {
    const std::int64_t first = m_soup.number_of_points();
    Values indices;
    indices.count = positions.count;
    if (primitive.contains("indices")) indices = values(integer(primitive, "indices"), 1);
    if (positions.count > m_most - first || 3 * indices.count > m_most - std::int64_t(m_soup.corner.size()))
      throw Gltf_failure("the nodes place more than " + std::to_string(m_most) + " points or corners");
    const int size = size_of_type(positions.type);
    for (std::int64_t v = 0; v < positions.count; ++v) {
      const char* at = positions.begin + v * positions.stride;
      Point p;
      for (int k = 0; k < 3; ++k) p[k] = component(at + k * size, positions.type, positions.normalized);
      m_soup.points.push_back(placed * p);
    }
    const auto index = [&](std::int64_t i) {
      if (!indices.begin) return int(first + i);
      const double v = component(indices.begin + i * indices.stride, indices.type, false);
      if (!(v >= 0 && v < double(positions.count)))
        throw Gltf_failure("index " + std::to_string(std::int64_t(v)) + " is not one of " +
                           std::to_string(positions.count) + " points");
      return int(first) + int(v);
    };
    if (indices.type == 5126) throw Gltf_failure("indices are no integers");
    const bool mirrored = placed.linear().determinant() < 0;
    const std::int64_t triangles =
        mode == 4 ? indices.count / 3 : std::max<std::int64_t>(indices.count - 2, 0);
    for (std::int64_t t = 0; t < triangles; ++t) {
      const std::int64_t a = mode == 4 ? 3 * t : mode == 5 ? t : 0, b = mode == 4 ? 3 * t + 1 : t + 1;
      const bool odd = mode == 5 && t % 2 == 1;
      int corners[3] = {index(a), index(b), index(b + 1)};
      if (odd != mirrored) std::swap(corners[1], corners[2]);
      m_soup.corner.insert(m_soup.corner.end(), corners, corners + 3);
      m_soup.close_polygon();
    }
  }

  void note_what_is_passed_over() {
    if (m_lines > 0)
      m_notes.push_back(std::to_string(m_lines) + " primitives of points or lines were passed over");
    if (m_skins > 0)
      m_notes.push_back("skins are not applied: their meshes are in the pose in which they were bound");
    if (m_morphs > 0) m_notes.push_back("morph targets are not applied");
  }

  const char* m_data;
  std::size_t m_size;
  Notes& m_notes;
  Mesh_attributes* m_attributes;
  const std::int64_t m_most; ///< points, and corners: many nodes may place one mesh
  Json m_json;
  std::string_view m_binary;
  std::vector<std::string> m_embedded;
  std::vector<std::string_view> m_buffers;
  std::int64_t m_primitives = 0, m_lines = 0, m_skins = 0, m_morphs = 0;
  Polygon_soup m_soup;
};

} // namespace

Result<Polygon_soup> parse_gltf(const char* data, std::size_t size, Notes& notes,
                                Mesh_attributes* attributes) {
  try {
    return Gltf_parser(data, size, notes, attributes).parse();
  } catch (const Gltf_failure& failure) {
    return make_error(failure.code, failure.what());
  } catch (const Json::parse_error& failure) {
    return make_error(Error_code::malformed_file,
                      "glTF: its JSON is broken at byte " + std::to_string(failure.byte) + ".");
  } catch (const Json::exception&) {
    return make_error(Error_code::malformed_file,
                      "glTF: a value in its JSON is not of the kind that belongs there.");
  }
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
