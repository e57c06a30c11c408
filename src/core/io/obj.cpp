// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: the points (v) and the faces (f), and where they are asked for their texture coordinates,
// colours and names. Other statements are passed over, as readers are meant to do.
#include "io/readers.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// The names of one kind that faces get from the last statement before them.
class Names {
public:
  explicit Names(const char* kind) { m_labels.kind = kind; }

  void begin(const std::string& name) {
    const auto [at, is_new] = m_known.insert({name, int(m_labels.names.size())});
    if (is_new) m_labels.names.push_back(name);
    m_label = at->second;
  }
  void add_face() { m_labels.label.push_back(m_label); }
  void hand_over(std::vector<Face_labels>& to) {
    if (!m_labels.names.empty()) to.push_back(std::move(m_labels));
  }

private:
  Face_labels m_labels;
  std::map<std::string, int> m_known;
  int m_label = -1;
};

class Obj_parser {
public:
  Obj_parser(const char* data, std::size_t size, Notes& notes, Mesh_attributes* attributes)
      : m_cursor(data, data + size, '#'), m_notes(notes), m_kept(attributes) {}

  Result<Polygon_soup> parse() {
    while (m_cursor.find_word()) {
      const std::string_view keyword = m_cursor.peek();
      Result<void> done;
      if (keyword == "v")
        done = point();
      else if (keyword == "f" || keyword == "fo")
        done = face();
      else
        done = other(keyword);
      if (!done) return done.error();
      m_cursor.skip_line();
    }
    for (std::size_t i = 0; i < m_forward.size(); ++i)
      if (m_forward[i].index >= m_soup.number_of_points())
        return out_of_range(m_forward[i].index + 1, m_forward[i].line);
    const bool missing = m_largest[0] > m_attributes[0] || m_largest[1] > m_attributes[1];
    if (missing && m_bad_attributes == 0)
      m_notes.push_back("faces name texture coordinates or normals that do not exist; they are not used");
    if (m_bad_attributes > 0)
      m_notes.push_back("the texture coordinates or normals of " + std::to_string(m_bad_attributes) +
                        " corners are no indices, first in line " + std::to_string(m_bad_line) +
                        "; they are not used");
    if (m_soup.points.empty()) return line_error("OBJ", m_cursor.line(), "the file holds no points");
    if (m_kept) hand_over_attributes();
    return std::move(m_soup);
  }

private:
  struct Forward_reference {
    std::int64_t index, line;
  };

  Error fail(const std::string& text) const { return line_error("OBJ", m_cursor.line(), text); }
  Error expected(const char* what) const {
    return fail(std::string("expected ") + what + ", found " + quoted_word(m_cursor));
  }

  // A backslash at the end of a line joins the next line.
  bool find_word_of_statement() {
    while (m_cursor.find_word_on_line()) {
      if (m_cursor.peek() != "\\") return true;
      m_cursor.skip_line();
    }
    return false;
  }

  // Behind the three coordinates there may be a weight or a colour.
  Result<void> point() {
    m_cursor.advance(1);
    Point p;
    for (int k = 0; k < 3; ++k)
      if (!find_word_of_statement() || !m_cursor.number(p[k])) return expected("a coordinate");
    Eigen::Vector3d rest = Eigen::Vector3d::Ones();
    int numbers = 0;
    for (double number; find_word_of_statement(); ++numbers)
      if (!m_cursor.number(number))
        return expected("a weight or a colour");
      else if (numbers < 3)
        rest[numbers] = number;
    if (m_soup.number_of_points() >= largest_count) return fail("more than 2147483646 points");
    if (m_kept && numbers >= 3 && m_colours.empty())
      m_colours.assign(m_soup.points.size(), Eigen::Vector3d::Ones());
    if (m_kept && (numbers >= 3 || !m_colours.empty()))
      m_colours.push_back(numbers >= 3 ? rest : Eigen::Vector3d::Ones());
    m_soup.points.push_back(p);
    return {};
  }

  Result<void> face() {
    m_cursor.word();
    int corners = 0;
    for (; find_word_of_statement(); ++corners)
      if (Result<void> done = corner(); !done) return done;
    if (corners == 0) return fail("a face without corners");
    m_soup.close_polygon();
    if (m_kept)
      for (Names* names : {&m_objects, &m_groups, &m_materials}) names->add_face();
    return {};
  }

  // One of  v  v/vt  v//vn  v/vt/vn ; negative indices count back from the last point so far.
  Result<void> corner() {
    const std::string_view word = m_cursor.peek();
    const char* const end = word.data() + word.size();
    std::int64_t index = 0, skipped = 0, uv = 0; // uv: counted from 1, 0 for none
    std::from_chars_result at = std::from_chars(word.data(), end, index);
    bool good = at.ec == std::errc();
    for (int part = 1; good && at.ptr != end && *at.ptr != '\\'; ++part) {
      good = part <= 2 && *at.ptr == '/';
      if (!good) break;
      const char* const first = ++at.ptr;
      if (first == end || *first == '/' || *first == '\\') continue;
      at = std::from_chars(first, end, skipped);
      // Out of range, or 0: the surface does not depend on it.
      good = at.ec == std::errc() || at.ec == std::errc::result_out_of_range;
      if (at.ec != std::errc() || skipped == 0 || std::abs(skipped) > largest_count)
        note_bad_attribute();
      else
        m_largest[part - 1] = std::max(m_largest[part - 1], std::abs(skipped));
      if (part == 1 && at.ec == std::errc()) uv = skipped < 0 ? m_attributes[0] + skipped + 1 : skipped;
    }
    if (!good) return expected("the index of a point");
    const std::int64_t count = m_soup.number_of_points();
    if (index == 0) return fail("index 0: indices count from 1");
    if (index < -count) return fail("index " + std::to_string(index) + " counts back before the first point");
    index = index < 0 ? count + index : index - 1;
    // A face may name a point that comes later in the file; whether it comes is known at the end.
    if (index > largest_count) return out_of_range(index + 1, m_cursor.line());
    if (index >= count) m_forward.push_back({index, m_cursor.line()});
    if (std::int64_t(m_soup.corner.size()) >= largest_count) return fail("more than 2147483646 corners");
    m_soup.corner.push_back(int(index));
    if (m_kept) m_uv_of_corner.push_back(uv >= 0 && uv <= largest_count ? int(uv) : 0);
    m_cursor.advance(std::size_t(at.ptr - word.data()));
    return {};
  }

  void note_bad_attribute() {
    if (m_bad_attributes++ == 0) m_bad_line = m_cursor.line();
  }

  Result<void> other(std::string_view keyword) {
    if (keyword == "vt") {
      ++m_attributes[0];
      if (m_kept) return texture_coordinates();
    }
    if (keyword == "vn") ++m_attributes[1];
    for (char c : keyword)
      if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'))
        return expected("a statement");
    if (keyword[0] >= '0' && keyword[0] <= '9') return expected("a statement");
    m_cursor.word();
    std::string text;
    while (find_word_of_statement()) {
      const std::string_view word = m_cursor.word();
      if (m_kept) (text += text.empty() ? "" : " ") += word;
    }
    if (m_kept) keep(keyword, text);
    return {};
  }

  void keep(std::string_view keyword, const std::string& text) {
    if (keyword == "o") m_objects.begin(text);
    if (keyword == "g") m_groups.begin(text);
    if (keyword == "usemtl") m_materials.begin(text);
    if (keyword == "mtllib") m_kept->material_library = text;
    if (keyword == "vn") note_other(m_kept, "normals");
    if (keyword == "s" && text != "off" && text != "0") note_other(m_kept, "smoothing groups");
    if (keyword == "l" || keyword == "p") note_other(m_kept, "lines and points");
  }

  // What is no number is not used, as without being asked for.
  Result<void> texture_coordinates() {
    m_cursor.word();
    Eigen::Vector2d uv(0, 0);
    for (int k = 0; k < 2 && find_word_of_statement(); ++k)
      if (!m_cursor.number(uv[k])) uv[k] = std::numeric_limits<double>::quiet_NaN();
    m_uv.push_back(uv);
    return {};
  }

  void hand_over_attributes() {
    m_kept->colours = std::move(m_colours);
    m_objects.hand_over(m_kept->labels);
    m_groups.hand_over(m_kept->labels);
    m_materials.hand_over(m_kept->labels);
    if (std::all_of(m_uv_of_corner.begin(), m_uv_of_corner.end(), [](int uv) { return uv == 0; })) return;
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const int uv : m_uv_of_corner)
      m_kept->uv.push_back(uv > 0 && std::size_t(uv) <= m_uv.size() ? m_uv[std::size_t(uv - 1)]
                                                                    : Eigen::Vector2d(none, none));
  }

  Error out_of_range(std::int64_t index, std::int64_t line) const {
    return line_error("OBJ", line,
                      "index " + std::to_string(index) + " is not one of " +
                          std::to_string(m_soup.number_of_points()) + " points, which count from 1");
  }

  Text_cursor m_cursor;
  Notes& m_notes;
  Mesh_attributes* m_kept; ///< null if attributes are not asked for
  std::vector<Eigen::Vector3d> m_colours;
  std::vector<Eigen::Vector2d> m_uv;
  std::vector<int> m_uv_of_corner; ///< counted from 1; 0: none
  Names m_objects{"object"}, m_groups{"group"}, m_materials{"material"};
  std::int64_t m_bad_attributes = 0, m_bad_line = 0;
  /// Of texture coordinates and normals: how many there are, and the largest index of one.
  std::array<std::int64_t, 2> m_attributes{}, m_largest{};
  std::vector<Forward_reference> m_forward;
  Polygon_soup m_soup;
};

} // namespace

Result<Polygon_soup> parse_obj(const char* data, std::size_t size, Notes& notes,
                               Mesh_attributes* attributes) {
  return Obj_parser(data, size, notes, attributes).parse();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
