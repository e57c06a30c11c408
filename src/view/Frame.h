// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_FRAME_H
#define REEBQUAD_VIEW_FRAME_H

#include "view/Json.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace reebquad {
namespace studio {

/// The version of the protocol that this program speaks; see src/studio/protocol.md.
constexpr int protocol_version = 2;

/// A binary message: named arrays of numbers and a few words about them, as the protocol describes it.
class Frame {
public:
  explicit Frame(std::string layer) : m_layer(std::move(layer)) {}

  Json data = Json::object(); ///< the words
  Json patch = nullptr;       ///< where the message is one: the arrays that it makes; see `frame_patch()`

  void add(const std::string& name, const std::vector<float>& values) { append(name, "f32", values); }
  void add(const std::string& name, const std::vector<std::uint32_t>& values) { append(name, "u32", values); }
  void add(const std::string& name, const std::vector<std::int32_t>& values) { append(name, "i32", values); }
  void add(const std::string& name, const std::vector<std::uint8_t>& values) { append(name, "u8", values); }
  /// x, y, z of each point, less `origin`.
  void add_points(const std::string& name, const std::vector<Eigen::Vector3d>& points,
                  const Eigen::Vector3d& origin);
  template <std::size_t N>
  void add_indices(const std::string& name, const std::vector<std::array<int, N>>& faces) {
    std::vector<std::uint32_t> flat;
    flat.reserve(N * faces.size());
    for (const auto& face : faces)
      for (const int i : face) flat.push_back(std::uint32_t(i));
    add(name, flat);
  }

  /// The bytes of the message.
  std::shared_ptr<const std::string> encode() const;

private:
  template <class T> void append(const std::string& name, const char* type, const std::vector<T>& values) {
    append(name, type, values.data(), sizeof(T), values.size());
  }
  void append(const std::string& name, const char* type, const void* values, std::size_t size,
              std::size_t number);

  std::string m_layer;
  Json m_arrays = Json::array();
  std::string m_payload;
};

/// Reads what `Frame` encoded.
class Frame_view {
public:
  /// Keeps a reference to `message`.
  explicit Frame_view(const std::string& message);

  Json header; ///< `layer`, `arrays`, `data`, `patch`
  /// The numbers of an array of bytes, or the bits of those of an array of another type; none if there is no
  /// such array.
  std::vector<std::uint8_t> bytes(const std::string& name) const;
  std::vector<std::uint32_t> words(const std::string& name) const;

private:
  std::string_view raw(const std::string& name) const;

  const std::string& m_message;
  std::size_t m_payload;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_FRAME_H
