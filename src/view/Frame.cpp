// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Frame.h"

#include <cstring>

namespace reebquad {
namespace studio {

namespace {

constexpr std::size_t alignment = 8;

bool is_little_endian() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace

void Frame::add_points(const std::string& name, const std::vector<Eigen::Vector3d>& points,
                       const Eigen::Vector3d& origin) {
  std::vector<float> flat;
  flat.reserve(3 * points.size());
  for (const Eigen::Vector3d& p : points)
    for (int i = 0; i < 3; ++i) flat.push_back(float(p[i] - origin[i]));
  add(name, flat);
}

void Frame::append(const std::string& name, const char* type, const void* values, std::size_t size,
                   std::size_t number) {
  m_arrays.push_back({{"name", name}, {"type", type}, {"offset", m_payload.size()}, {"length", number}});
  const std::size_t begin = m_payload.size();
  m_payload.append(static_cast<const char*>(values), size * number);
  if (!is_little_endian() && size > 1)
    for (std::size_t i = begin; i < m_payload.size(); i += size)
      std::reverse(m_payload.begin() + std::ptrdiff_t(i), m_payload.begin() + std::ptrdiff_t(i + size));
  m_payload.append((alignment - m_payload.size() % alignment) % alignment, '\0');
}

std::shared_ptr<const std::string> Frame::encode() const {
  Json words{{"layer", m_layer}, {"arrays", m_arrays}, {"data", data}};
  if (!patch.is_null()) words["patch"] = patch;
  std::string header = words.dump();
  header.append((alignment - header.size() % alignment) % alignment, ' ');
  auto bytes = std::make_shared<std::string>();
  bytes->reserve(alignment + header.size() + m_payload.size());
  bytes->append("RQS");
  bytes->push_back(char(protocol_version));
  for (int shift = 0; shift < 32; shift += 8) bytes->push_back(char(header.size() >> shift & 255));
  bytes->append(header);
  bytes->append(m_payload);
  return bytes;
}

Frame_view::Frame_view(const std::string& message) : m_message(message) {
  std::uint32_t size = 0;
  for (std::size_t i = 8; i-- > 4;) size = size << 8 | static_cast<unsigned char>(message[i]);
  m_payload = alignment + size;
  header =
      Json::parse(message.begin() + std::ptrdiff_t(alignment), message.begin() + std::ptrdiff_t(m_payload));
}

std::string_view Frame_view::raw(const std::string& name) const {
  for (const Json& array : header["arrays"]) {
    if (array["name"] != name) continue;
    const std::size_t size = array["type"] == "u8" ? 1 : 4;
    return std::string_view(m_message).substr(m_payload + array["offset"].get<std::size_t>(),
                                              size * array["length"].get<std::size_t>());
  }
  return {};
}

std::vector<std::uint8_t> Frame_view::bytes(const std::string& name) const {
  const std::string_view all = raw(name);
  return {all.begin(), all.end()};
}

std::vector<std::uint32_t> Frame_view::words(const std::string& name) const {
  const std::string_view all = raw(name);
  std::vector<std::uint32_t> numbers(all.size() / 4);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) // one load where the machine is little endian
      numbers[i] |= std::uint32_t(static_cast<unsigned char>(all[4 * i + k])) << 8 * k;
  return numbers;
}

} // namespace studio
} // namespace reebquad
