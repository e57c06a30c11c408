// SPDX-License-Identifier: GPL-3.0-or-later
// OFF, as the Geomview manual describes it ("OFF Files"), in ascii and with points in space.
#include "io/readers.h"
#include "io/text_cursor.h"

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

class Off_parser {
public:
  Off_parser(const char* data, std::size_t size, Notes& notes, Mesh_attributes* attributes)
      : m_cursor(data, data + size, '#'), m_notes(notes), m_attributes(attributes) {}

  Result<Polygon_soup> parse() {
    for (auto step : {&Off_parser::header, &Off_parser::counts, &Off_parser::points, &Off_parser::faces})
      if (Result<void> done = (this->*step)(); !done) return done.error();
    // Edges, comments without their sign, or a second mesh that some programs append.
    if (m_cursor.find_word())
      m_notes.push_back("what follows the " + std::to_string(m_faces) +
                        " faces that the header announces was passed over, from line " +
                        std::to_string(m_cursor.line()) + " on: " + quoted_word(m_cursor));
    return std::move(m_soup);
  }

private:
  Error fail(const std::string& text) const { return line_error("OFF", m_cursor.line(), text); }
  Error expected(const char* what) const {
    return fail(std::string("expected ") + what + ", found " + quoted_word(m_cursor));
  }
  static Error refuse(const char* text) { return make_error(Error_code::unsupported_format, text); }

  // [ST][C][N][4][n]OFF [BINARY]. The keyword may be missing, and some writers put the first count right
  // behind it.
  Result<void> header() {
    if (!m_cursor.find_word()) return fail("the file is empty");
    std::string_view word = m_cursor.peek();
    const std::size_t off = word.find("OFF");
    if (off == std::string_view::npos) {
      if (word[0] >= '0' && word[0] <= '9') return {};
      return expected("the keyword OFF");
    }
    std::string_view prefix = word.substr(0, off);
    const auto take = [&prefix](std::string_view part) {
      const bool is = prefix.substr(0, part.size()) == part;
      if (is) prefix.remove_prefix(part.size());
      return is;
    };
    for (const auto& [part, words] :
         {std::pair("ST", "texture coordinates"), std::pair("C", "colours"), std::pair("N", "normals")}) {
      if (!take(part)) continue;
      m_has_extras = true;
      note_other(m_attributes, words);
    }
    if (take("4")) return refuse("OFF: points with four coordinates (4OFF) are not supported.");
    if (take("n")) return refuse("OFF: points in other dimensions (nOFF) are not supported.");
    const std::string_view rest = word.substr(off + 3);
    if (!prefix.empty() || (!rest.empty() && (rest[0] < '0' || rest[0] > '9')))
      return expected("the keyword OFF");
    m_cursor.advance(off + 3);
    if (m_cursor.find_word_on_line() && m_cursor.peek() == "BINARY")
      return refuse("OFF: binary OFF is not supported; write it as text, or as PLY.");
    return {};
  }

  // The number of edges is not used, and is missing in some files.
  Result<void> counts() {
    std::int64_t edges = 0;
    if (!m_cursor.find_word() || !m_cursor.integer(m_points)) return expected("the number of points");
    const std::int64_t line = m_cursor.line();
    if (!m_cursor.find_word() || !m_cursor.integer(m_faces)) return expected("the number of faces");
    const bool more = m_cursor.line() == line ? m_cursor.find_word_on_line() : m_cursor.find_word();
    if (more && !m_cursor.integer(edges)) return expected("the number of edges");
    if (m_points < 0 || m_faces < 0) return fail("a count is negative");
    if (m_points > largest_count || m_faces > largest_count)
      return fail("more than 2147483646 elements are announced");
    // A point takes at least six bytes and a face two (the last one perhaps no line end).
    const std::int64_t bytes = std::int64_t(m_cursor.bytes_left()) + 1;
    if (m_points > bytes / 6 || m_faces > (bytes - 6 * m_points) / 2)
      return fail("the header announces " + std::to_string(m_points) + " points and " +
                  std::to_string(m_faces) + " faces, but only " + std::to_string(bytes - 1) +
                  " bytes follow");
    m_soup.points.reserve(std::size_t(m_points));
    m_soup.begin.reserve(std::size_t(m_faces) + 1);
    return {};
  }

  Result<void> points() {
    for (std::int64_t i = 0; i < m_points; ++i) {
      Point p;
      for (int k = 0; k < 3; ++k) {
        if (!m_cursor.find_word()) return missing("point", i, m_points);
        if (!m_cursor.number(p[k])) return expected("a coordinate");
      }
      m_soup.points.push_back(p);
      while (m_cursor.find_word_on_line()) {
        double skipped;
        if (!m_has_extras)
          return fail("a point has more than three numbers, which the keyword OFF does not allow");
        if (!m_cursor.number(skipped)) return expected("a colour, normal or texture coordinate");
      }
    }
    return {};
  }

  // Behind the corners of a face there may be a colour.
  Result<void> faces() {
    for (std::int64_t i = 0; i < m_faces; ++i) {
      std::int64_t corners = 0, corner = 0;
      if (!m_cursor.find_word()) return missing("face", i, m_faces);
      if (!m_cursor.integer(corners)) return expected("the number of corners of a face");
      if (corners < 0 || corners > std::int64_t(m_cursor.bytes_left()))
        return fail("a face cannot have " + std::to_string(corners) + " corners");
      if (corners + std::int64_t(m_soup.corner.size()) > largest_count)
        return fail("more than 2147483646 corners");
      for (std::int64_t k = 0; k < corners; ++k) {
        if (!m_cursor.find_word()) return missing("face", i, m_faces);
        if (!m_cursor.integer(corner)) return expected("the index of a point");
        if (corner < 0 || corner >= m_points)
          return fail("index " + std::to_string(corner) + " is not one of " + std::to_string(m_points) +
                      " points, which count from 0");
        m_soup.corner.push_back(int(corner));
      }
      m_soup.close_polygon();
      m_cursor.skip_line();
    }
    return {};
  }

  Error missing(const char* what, std::int64_t i, std::int64_t count) const {
    return fail(std::string("the file ends at ") + what + " " + std::to_string(i) + " of " +
                std::to_string(count));
  }

  Text_cursor m_cursor;
  Notes& m_notes;
  Mesh_attributes* m_attributes;
  bool m_has_extras = false;
  std::int64_t m_points = 0, m_faces = 0;
  Polygon_soup m_soup;
};

} // namespace

Result<Polygon_soup> parse_off(const char* data, std::size_t size, Notes& notes,
                               Mesh_attributes* attributes) {
  return Off_parser(data, size, notes, attributes).parse();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
