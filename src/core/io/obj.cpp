// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: the points (v) and the faces (f). Other statements are passed over, as readers are meant to
// do.
#include "io/readers.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Obj_parser {
public:
  Obj_parser(const char* data, std::size_t size, Notes& notes)
      : m_cursor(data, data + size, '#'), m_notes(notes) {}

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
    for (double skipped; find_word_of_statement();)
      if (!m_cursor.number(skipped)) return expected("a weight or a colour");
    if (m_soup.number_of_points() >= largest_count) return fail("more than 2147483646 points");
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
    return {};
  }

  // One of  v  v/vt  v//vn  v/vt/vn ; negative indices count back from the last point so far.
  Result<void> corner() {
    const std::string_view word = m_cursor.peek();
    const char* const end = word.data() + word.size();
    std::int64_t index = 0, skipped = 0;
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
    m_cursor.advance(std::size_t(at.ptr - word.data()));
    return {};
  }

  void note_bad_attribute() {
    if (m_bad_attributes++ == 0) m_bad_line = m_cursor.line();
  }

  Result<void> other(std::string_view keyword) {
    if (keyword == "vt") ++m_attributes[0];
    if (keyword == "vn") ++m_attributes[1];
    for (char c : keyword)
      if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'))
        return expected("a statement");
    if (keyword[0] >= '0' && keyword[0] <= '9') return expected("a statement");
    while (find_word_of_statement()) m_cursor.word();
    return {};
  }

  Error out_of_range(std::int64_t index, std::int64_t line) const {
    return line_error("OBJ", line,
                      "index " + std::to_string(index) + " is not one of " +
                          std::to_string(m_soup.number_of_points()) + " points, which count from 1");
  }

  Text_cursor m_cursor;
  Notes& m_notes;
  std::int64_t m_bad_attributes = 0, m_bad_line = 0;
  /// Of texture coordinates and normals: how many there are, and the largest index of one.
  std::array<std::int64_t, 2> m_attributes{}, m_largest{};
  std::vector<Forward_reference> m_forward;
  Polygon_soup m_soup;
};

} // namespace

Result<Polygon_soup> parse_obj(const char* data, std::size_t size, Notes& notes) {
  return Obj_parser(data, size, notes).parse();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
