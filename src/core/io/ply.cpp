// SPDX-License-Identifier: GPL-3.0-or-later
// PLY, ascii and both binaries (G. Turk, "The PLY Polygon File Format", 1994): points from the element
// `vertex`, polygons from `face`, triangles from `tristrips` (strips that -1 restarts). What else is in the
// file is passed over.
#include "io/readers.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

bool type_of(std::string_view word, Ply_type& type) {
  constexpr std::array<std::pair<std::string_view, Ply_type>, 18> names = {{{"char", Ply_type::int8},
                                                                            {"int8", Ply_type::int8},
                                                                            {"uchar", Ply_type::uint8},
                                                                            {"uint8", Ply_type::uint8},
                                                                            {"short", Ply_type::int16},
                                                                            {"int16", Ply_type::int16},
                                                                            {"ushort", Ply_type::uint16},
                                                                            {"uint16", Ply_type::uint16},
                                                                            {"int", Ply_type::int32},
                                                                            {"int32", Ply_type::int32},
                                                                            {"uint", Ply_type::uint32},
                                                                            {"uint32", Ply_type::uint32},
                                                                            {"int64", Ply_type::int64},
                                                                            {"uint64", Ply_type::uint64},
                                                                            {"float", Ply_type::float32},
                                                                            {"float32", Ply_type::float32},
                                                                            {"double", Ply_type::float64},
                                                                            {"float64", Ply_type::float64}}};
  for (const auto& [text, value] : names)
    if (text == word) {
      type = value;
      return true;
    }
  return false;
}

int size_of(Ply_type type) {
  switch (type) {
  case Ply_type::int8:
  case Ply_type::uint8: return 1;
  case Ply_type::int16:
  case Ply_type::uint16: return 2;
  case Ply_type::int32:
  case Ply_type::uint32:
  case Ply_type::float32: return 4;
  case Ply_type::int64:
  case Ply_type::uint64:
  case Ply_type::float64: return 8;
  }
  return 8;
}

template <class T> double number_from_bits(std::uint64_t bits) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  const Bits narrow = Bits(bits);
  T value;
  std::memcpy(&value, &narrow, sizeof value);
  return double(value);
}

double number_of(Ply_type type, std::uint64_t bits) {
  switch (type) {
  case Ply_type::int8: return std::int8_t(bits);
  case Ply_type::uint8: return std::uint8_t(bits);
  case Ply_type::int16: return std::int16_t(bits);
  case Ply_type::uint16: return std::uint16_t(bits);
  case Ply_type::int32: return std::int32_t(bits);
  case Ply_type::uint32: return std::uint32_t(bits);
  case Ply_type::int64: return double(std::int64_t(bits));
  case Ply_type::uint64: return double(bits);
  case Ply_type::float32: return number_from_bits<float>(bits);
  case Ply_type::float64: return number_from_bits<double>(bits);
  }
  return 0;
}

struct Ply_property {
  std::string_view name;
  Ply_type type = Ply_type::int8;
  bool is_list = false;
  Ply_type count_type = Ply_type::uint8;
};

struct Ply_element {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<Ply_property> properties;
};

class Ply_parser {
public:
  Ply_parser(const char* data, std::size_t size, Mesh_attributes* attributes)
      : m_data(data), m_end(data + size), m_cursor(data, data + size), m_kept(attributes) {}

  Result<Polygon_soup> parse() {
    if (Result<void> done = header(); !done) return done.error();
    for (const Ply_element& e : m_elements) {
      Result<void> done = check_count(e);
      if (!done) return done.error();
      if (e.name == "vertex")
        done = points(e);
      else if (e.name == "face" || e.name == "tristrips")
        done = polygons(e);
      else if (!e.properties.empty()) {
        if (e.count > 0) note_other(m_kept, "elements " + printable(e.name));
        done = skip(e);
      }
      if (!done) return done.error();
    }
    if (m_kept) hand_over_attributes();
    return std::move(m_soup);
  }

private:
  enum class Encoding { none, ascii, little_endian, big_endian };

  Error header_error(const std::string& text) const { return line_error("PLY", m_cursor.line(), text); }
  Error header_expected(const char* what) const {
    return header_error(std::string("expected ") + what + ", found " + quoted_word(m_cursor));
  }
  Error fail(const std::string& text) const {
    return m_encoding == Encoding::ascii ? header_error(text)
                                         : byte_error("PLY", m_cursor.at() - m_data, text);
  }
  static Error refuse(const std::string& text) {
    return make_error(Error_code::unsupported_format, "PLY: " + text + ".");
  }

  Result<void> header() {
    if (m_cursor.peek() != "ply") return header_expected("ply");
    for (;;) {
      m_cursor.skip_line();
      if (!m_cursor.find_word()) return header_error("the header does not end");
      const std::string_view keyword = m_cursor.peek();
      if (keyword == "comment" && m_kept) name_in_comment();
      if (keyword == "comment" || keyword == "obj_info") continue;
      m_cursor.word();
      if (keyword == "end_header") break;
      Result<void> done =
          header_error("unknown statement '" + std::string(keyword.substr(0, 24)) + "' in the header");
      if (keyword == "format") done = format();
      if (keyword == "element") done = element();
      if (keyword == "property") done = property();
      if (!done) return done;
    }
    if (Result<void> done = check_header(); !done) return done;
    end_header_line();
    return {};
  }

  /// "comment KIND I is NAME", as our writer has it.
  void name_in_comment() {
    m_cursor.word();
    if (!m_cursor.find_word_on_line()) return;
    const std::string kind(m_cursor.word());
    std::int64_t number = 0;
    if (!m_cursor.find_word_on_line() || !m_cursor.integer(number)) return;
    if (!m_cursor.find_word_on_line() || m_cursor.word() != "is" || !m_cursor.find_word_on_line()) return;
    m_names[{kind, number}] = std::string(m_cursor.word());
  }

  static std::string printable(std::string_view name) {
    std::string text(name.substr(0, 24));
    for (char& c : text)
      if (c < 32 || c > 126) c = '?';
    return text;
  }

  // The data begin behind the line end. A CR alone ends lines only in files whose first line ends so; then an
  // LF that follows would be data.
  void end_header_line() {
    const char* const first_end = m_data + 3;
    const bool lone_cr =
        first_end != m_end && *first_end == '\r' && (first_end + 1 == m_end || first_end[1] != '\n');
    m_cursor.find_word_on_line();
    if (lone_cr && m_cursor.bytes_left() > 0 && *m_cursor.at() == '\r')
      m_cursor.advance(1);
    else
      m_cursor.skip_line();
  }

  Result<void> format() {
    if (m_encoding != Encoding::none) return header_error("a second format");
    const std::string_view word = m_cursor.find_word_on_line() ? m_cursor.peek() : std::string_view();
    if (word == "ascii")
      m_encoding = Encoding::ascii;
    else if (word == "binary_little_endian")
      m_encoding = Encoding::little_endian;
    else if (word == "binary_big_endian")
      m_encoding = Encoding::big_endian;
    else
      return header_expected("ascii, binary_little_endian or binary_big_endian");
    return {};
  }

  Result<void> element() {
    Ply_element e;
    if (!m_cursor.find_word_on_line()) return header_expected("the name of an element");
    e.name = m_cursor.word();
    if (!m_cursor.find_word_on_line() || !m_cursor.integer(e.count))
      return header_expected("the number of elements");
    if (e.count < 0) return header_error("a number of elements is negative");
    if (m_elements.size() >= 1000) return refuse("more than 1000 elements");
    m_elements.push_back(std::move(e));
    return {};
  }

  Result<void> property() {
    Ply_property p;
    if (m_elements.empty()) return header_error("a property before any element");
    if (!m_cursor.find_word_on_line()) return header_expected("the type of a property");
    p.is_list = m_cursor.peek() == "list";
    if (p.is_list) {
      m_cursor.word();
      if (!m_cursor.find_word_on_line() || !type_of(m_cursor.peek(), p.count_type))
        return header_expected("the type of a list's count");
      m_cursor.word();
    }
    if (!m_cursor.find_word_on_line() || !type_of(m_cursor.peek(), p.type))
      return header_expected("the type of a property");
    m_cursor.word();
    if (!m_cursor.find_word_on_line()) return header_expected("the name of a property");
    p.name = m_cursor.word();
    if (m_elements.back().properties.size() >= 1000) return refuse("more than 1000 properties");
    m_elements.back().properties.push_back(p);
    return {};
  }

  Result<void> check_header() {
    if (m_encoding == Encoding::none) return header_error("the header names no format");
    for (const char* unique : {"vertex", "face", "tristrips"})
      if (std::count_if(m_elements.begin(), m_elements.end(),
                        [&](const auto& e) { return e.name == unique; }) > 1)
        return header_error(std::string("the element ") + unique + " occurs twice");
    for (const Ply_element& e : m_elements)
      if (e.name == "vertex") m_points = e.count;
    if (m_points < 0) return header_error("the header has no element vertex");
    return {};
  }

  // Every property takes at least its size, a list its count, and a word of text at least two bytes.
  Result<void> check_count(const Ply_element& e) {
    std::int64_t least = 0;
    for (const Ply_property& p : e.properties)
      least += m_encoding == Encoding::ascii ? 2 : size_of(p.is_list ? p.count_type : p.type);
    const std::int64_t bytes = std::int64_t(m_cursor.bytes_left());
    const std::string announced =
        "the header announces " + std::to_string(e.count) + " elements " + std::string(e.name.substr(0, 24));
    if (least > 0 && e.count > (bytes + 1) / least)
      return fail(announced + ", but only " + std::to_string(bytes) + " bytes follow");
    if (least > 0 && e.count > largest_count) return fail(announced + ", more than 2147483646");
    return {};
  }

  /// The next number of the file; false if there is none.
  bool read(Ply_type type, double& value) {
    if (m_encoding == Encoding::ascii) return m_cursor.find_word() && m_cursor.number(value);
    const int size = size_of(type);
    if (m_cursor.bytes_left() < std::size_t(size)) return false;
    const char* const p = m_cursor.at();
    std::uint64_t bits = 0;
    for (int i = 0; i < size; ++i) {
      const int shift = 8 * (m_encoding == Encoding::little_endian ? i : size - 1 - i);
      bits |= std::uint64_t(static_cast<unsigned char>(p[i])) << shift;
    }
    m_cursor.advance(std::size_t(size));
    value = number_of(type, bits);
    return true;
  }

  Error no_number(const Ply_element& e, std::int64_t i) {
    const std::string where =
        std::string(e.name.substr(0, 24)) + " " + std::to_string(i) + " of " + std::to_string(e.count);
    if (m_encoding != Encoding::ascii || !m_cursor.find_word())
      return fail("the file ends at element " + where);
    return fail("expected a number of element " + where + ", found " + quoted_word(m_cursor));
  }

  // The number of entries of a list, each of which takes at least `least` bytes.
  Result<void> list_size(const Ply_element& e, const Ply_property& p, std::int64_t i, std::int64_t& size) {
    double count;
    if (!read(p.count_type, count)) return no_number(e, i);
    const double least = m_encoding == Encoding::ascii ? 1 : size_of(p.type);
    if (!(count >= 0) || count != std::floor(count) || count * least > double(m_cursor.bytes_left()))
      return fail("a list of element " + std::string(e.name.substr(0, 24)) + " " + std::to_string(i) +
                  " has an impossible number of entries");
    size = std::int64_t(count);
    return {};
  }

  Result<void> skip_property(const Ply_element& e, const Ply_property& p, std::int64_t i) {
    std::int64_t size = 1;
    if (p.is_list)
      if (Result<void> done = list_size(e, p, i, size); !done) return done;
    if (m_encoding != Encoding::ascii) {
      const std::size_t bytes = std::size_t(size) * std::size_t(size_of(p.type));
      if (bytes > m_cursor.bytes_left()) return no_number(e, i);
      m_cursor.advance(bytes);
      return {};
    }
    for (double skipped; size > 0; --size)
      if (!read(p.type, skipped)) return no_number(e, i);
    return {};
  }

  Result<void> skip(const Ply_element& e) {
    for (std::int64_t i = 0; i < e.count; ++i)
      for (const Ply_property& p : e.properties)
        if (Result<void> done = skip_property(e, p, i); !done) return done;
    return {};
  }

  Result<void> points(const Ply_element& e) {
    std::vector<int> axis(e.properties.size(), -1);
    int axes = 0;
    for (std::size_t k = 0; k < e.properties.size(); ++k)
      for (int a = 0; a < 3; ++a)
        if (e.properties[k].name == std::string_view(a == 0   ? "x"
                                                     : a == 1 ? "y"
                                                              : "z") &&
            !e.properties[k].is_list) {
          axis[k] = a;
          axes += 1 << (2 * a);
        }
    if (axes != 1 + 4 + 16)
      return fail("the element vertex does not have the properties x, y and z once each");
    // Where the other numbers of a point go: colours 0 to 2, texture coordinates 3 and 4.
    std::vector<int> slot(e.properties.size(), -1);
    if (m_kept)
      for (std::size_t k = 0; k < e.properties.size(); ++k) slot[k] = slot_of(e, e.properties[k]);
    const int sizes = m_kept ? place_of_sizes(e) : -1;
    const bool has_colours =
        std::count_if(slot.begin(), slot.end(), [](int i) { return i >= 0 && i < 3; }) == 3;
    const bool has_uv = std::count_if(slot.begin(), slot.end(), [](int i) { return i >= 3; }) == 2;
    m_soup.points.reserve(std::size_t(e.count));
    for (std::int64_t i = 0; i < e.count; ++i) {
      Point point;
      std::array<double, 5> extra{};
      for (std::size_t k = 0; k < e.properties.size(); ++k) {
        if (axis[k] < 0 && slot[k] < 0 && int(k) != sizes) {
          if (Result<void> done = skip_property(e, e.properties[k], i); !done) return done;
          continue;
        }
        double value = 0;
        if (!read(e.properties[k].type, value)) return no_number(e, i);
        if (axis[k] >= 0)
          point[axis[k]] = value;
        else if (int(k) == sizes)
          m_kept->sizes.push_back(value);
        else
          extra[std::size_t(slot[k])] = value / (slot[k] < 3 ? full_scale(e.properties[k].type) : 1);
      }
      m_soup.points.push_back(point);
      if (has_colours) m_kept->colours.push_back({extra[0], extra[1], extra[2]});
      if (has_uv) m_uv_of_point.push_back({extra[3], extra[4]});
    }
    return {};
  }

  /// The value that stands for 1 in a colour.
  static double full_scale(Ply_type type) {
    return type == Ply_type::uint8 ? 255 : type == Ply_type::uint16 ? 65535 : 1;
  }

  /// The property of points that tells sizes, or -1.
  static int place_of_sizes(const Ply_element& e) {
    for (const char* name : {"size", "quality"})
      for (std::size_t k = 0; k < e.properties.size(); ++k)
        if (e.properties[k].name == name && !e.properties[k].is_list) return int(k);
    return -1;
  }

  /// Of a property of points that is kept; -1 if it is none, which is told.
  int slot_of(const Ply_element& e, const Ply_property& p) {
    constexpr std::array<std::pair<std::string_view, int>, 9> slots{{{"red", 0},
                                                                     {"green", 1},
                                                                     {"blue", 2},
                                                                     {"s", 3},
                                                                     {"t", 4},
                                                                     {"u", 3},
                                                                     {"v", 4},
                                                                     {"texture_u", 3},
                                                                     {"texture_v", 4}}};
    for (const auto& [name, slot] : slots) {
      const auto same = std::count_if(e.properties.begin(), e.properties.end(),
                                      [n = name](const Ply_property& other) { return other.name == n; });
      if (p.name == name && !p.is_list && same == 1) return slot;
    }
    if (p.name == "nx" || p.name == "ny" || p.name == "nz")
      note_other(m_kept, "normals");
    else if (p.name != "x" && p.name != "y" && p.name != "z")
      note_other(m_kept, "the property " + printable(p.name) + " of points");
    return -1;
  }

  Result<void> polygons(const Ply_element& e) {
    int indices = -1;
    for (std::size_t k = 0; k < e.properties.size(); ++k)
      if (const auto n = e.properties[k].name;
          (n == "vertex_indices" || n == "vertex_index") && e.properties[k].is_list)
        indices = int(k);
    if (indices < 0 && e.count > 0)
      return fail("the element " + std::string(e.name) + " has no list vertex_indices");
    const std::vector<int> kept = kept_properties(e, indices);
    for (std::int64_t i = 0; i < e.count; ++i)
      for (std::size_t k = 0; k < e.properties.size(); ++k) {
        const Ply_property& p = e.properties[k];
        Result<void> done = kept[k] == texcoord ? coordinates(e, p, i)
                            : kept[k] >= 0      ? label(e, p, i, m_kept->labels[std::size_t(kept[k])])
                            : int(k) != indices ? skip_property(e, p, i)
                            : e.name == "face"  ? polygon(e, p, i)
                                                : strip(e, p, i);
        if (!done) return done;
      }
    return {};
  }

  static constexpr int texcoord = 1000;

  /// Of each property of faces the index of the names that it is the number of, `texcoord`, or -1; others
  /// are told.
  std::vector<int> kept_properties(const Ply_element& e, int indices) {
    std::vector<int> kept(e.properties.size(), -1);
    for (std::size_t k = 0; m_kept && k < e.properties.size(); ++k) {
      const Ply_property& p = e.properties[k];
      const auto is = [&p](const char* name) { return p.name == name; };
      const bool is_names = is("object") || is("group") || is("material") || is("chart");
      const bool is_new = std::none_of(m_kept->labels.begin(), m_kept->labels.end(),
                                       [&p](const Face_labels& l) { return p.name == l.kind; });
      const bool is_integer = p.type != Ply_type::float32 && p.type != Ply_type::float64;
      if (int(k) == indices) continue;
      if (e.name == "face" && is("texcoord") && p.is_list && int(k) > indices) {
        kept[k] = texcoord;
      } else if (e.name == "face" && is_names && is_new && is_integer && !p.is_list) {
        kept[k] = int(m_kept->labels.size());
        m_kept->labels.push_back({std::string(p.name), {}, std::vector<int>(m_soup.begin.size() - 1, -1)});
      } else {
        note_other(m_kept, "the property " + printable(p.name) + " of faces");
      }
    }
    return kept;
  }

  Result<void> label(const Ply_element& e, const Ply_property& p, std::int64_t i, Face_labels& labels) {
    double value = 0;
    if (!read(p.type, value)) return no_number(e, i);
    labels.label.push_back(-1);
    if (!(value >= 0 && value < double(largest_count))) return {};
    const auto [at, is_new] =
        m_label_of_number.insert({{labels.kind, std::int64_t(value)}, int(labels.names.size())});
    labels.label.back() = at->second;
    if (!is_new) return {};
    const auto name = m_names.find({labels.kind, std::int64_t(value)});
    labels.names.push_back(name != m_names.end() ? name->second : std::to_string(std::int64_t(value)));
    return {};
  }

  /// Two numbers for each corner of the polygon that was read last; of other lists nothing is kept.
  Result<void> coordinates(const Ply_element& e, const Ply_property& p, std::int64_t i) {
    std::int64_t size = 0;
    if (Result<void> done = list_size(e, p, i, size); !done) return done;
    const std::size_t corners = std::size_t(m_soup.size_of_polygon(m_soup.number_of_polygons() - 1));
    const double none = std::numeric_limits<double>::quiet_NaN();
    m_kept->uv.resize(m_soup.corner.size(), Eigen::Vector2d(none, none));
    for (std::int64_t k = 0; k < size; ++k) {
      double value = 0;
      if (!read(p.type, value)) return no_number(e, i);
      if (std::size_t(size) == 2 * corners)
        m_kept->uv[m_soup.corner.size() - corners + std::size_t(k / 2)][k % 2] = value;
    }
    return {};
  }

  void hand_over_attributes() {
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (!m_kept->uv.empty()) m_kept->uv.resize(m_soup.corner.size(), Eigen::Vector2d(none, none));
    if (m_kept->uv.empty() && !m_uv_of_point.empty())
      for (const int v : m_soup.corner) m_kept->uv.push_back(m_uv_of_point[std::size_t(v)]);
    // Strips, which have no names, may stand beside the faces.
    for (Face_labels& labels : m_kept->labels) labels.label.resize(m_soup.begin.size() - 1, -1);
  }

  Result<void> read_index(const Ply_element& e, const Ply_property& p, std::int64_t i, int lowest,
                          int& index) {
    double value;
    if (!read(p.type, value)) return no_number(e, i);
    if (!(value >= lowest && value < double(m_points)) || value != std::floor(value))
      return fail("an index of element " + std::string(e.name) + " " + std::to_string(i) + " is not one of " +
                  std::to_string(m_points) + " points, which count from 0");
    if (std::int64_t(m_soup.corner.size()) > largest_count - 3) return fail("more than 2147483646 corners");
    index = int(value);
    return {};
  }

  Result<void> polygon(const Ply_element& e, const Ply_property& p, std::int64_t i) {
    std::int64_t size = 0;
    if (Result<void> done = list_size(e, p, i, size); !done) return done;
    for (int index; size > 0; --size) {
      if (Result<void> done = read_index(e, p, i, 0, index); !done) return done;
      m_soup.corner.push_back(index);
    }
    m_soup.close_polygon();
    return {};
  }

  // Every second triangle of a strip is turned round; a triangle with a repeated corner only serves to go on.
  Result<void> strip(const Ply_element& e, const Ply_property& p, std::int64_t i) {
    std::int64_t size = 0, length = 0;
    if (Result<void> done = list_size(e, p, i, size); !done) return done;
    int a = -1, b = -1, c = -1;
    for (; size > 0; --size) {
      a = b;
      b = c;
      if (Result<void> done = read_index(e, p, i, -1, c); !done) return done;
      length = c < 0 ? 0 : length + 1;
      if (length < 3 || a == b || b == c || c == a) continue;
      const bool turned = length % 2 == 0;
      for (int v : {turned ? b : a, turned ? a : b, c}) m_soup.corner.push_back(v);
      m_soup.close_polygon();
    }
    return {};
  }

  const char* m_data;
  const char* m_end;
  Text_cursor m_cursor;
  Encoding m_encoding = Encoding::none;
  std::vector<Ply_element> m_elements;
  std::int64_t m_points = -1;
  Mesh_attributes* m_kept; ///< null if attributes are not asked for
  std::vector<Eigen::Vector2d> m_uv_of_point;
  std::map<std::pair<std::string, std::int64_t>, std::string> m_names; ///< of kind and number
  std::map<std::pair<std::string, std::int64_t>, int> m_label_of_number;
  Polygon_soup m_soup;
};

} // namespace

Result<Polygon_soup> parse_ply(const char* data, std::size_t size, Mesh_attributes* attributes) {
  return Ply_parser(data, size, attributes).parse();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
