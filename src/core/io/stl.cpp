// SPDX-License-Identifier: GPL-3.0-or-later
// STL, ascii and binary. The format has no indices: equal points are made one.
#include "base/equal_points.h"
#include "io/readers.h"
#include "io/text_cursor.h"

#include <cmath>
#include <cstring>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

std::uint32_t little_endian_32(const char* p) {
  const auto byte = [p](int i) { return std::uint32_t(static_cast<unsigned char>(p[i])); };
  return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}

double little_endian_float(const char* p) {
  const std::uint32_t bits = little_endian_32(p);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

bool equals_ignoring_case(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if ((word[i] >= 'A' && word[i] <= 'Z' ? char(word[i] - 'A' + 'a') : word[i]) != lower[i]) return false;
  return true;
}

// Corner i of the soup is point i; afterwards equal points are one, in the order of their first use.
Polygon_soup indexed(std::vector<Point> corners) {
  Polygon_soup soup;
  const std::vector<int> first = first_equal_points(corners);
  std::vector<int> number(corners.size(), -1);
  soup.corner.reserve(corners.size());
  soup.begin.reserve(corners.size() / 3 + 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    int& n = number[std::size_t(first[i])];
    if (n < 0) {
      n = soup.number_of_points();
      soup.points.push_back(corners[i]);
    }
    soup.corner.push_back(n);
    if (i % 3 == 2) soup.close_polygon();
  }
  return soup;
}

Result<Polygon_soup> parse_binary(const char* data, std::size_t size, Notes& notes) {
  std::int64_t facets = little_endian_32(data + header_size - 4);
  const std::int64_t room = std::int64_t((size - header_size) / facet_size);
  // Programs that do not know the number when they begin leave it 0, and some never come back.
  if (facets == 0 && room > 0) {
    facets = room;
    notes.push_back("the header announces no triangles; the " + std::to_string(room) +
                    " for which there are bytes were read");
  }
  if (facets > room)
    return byte_error("Binary STL", std::int64_t(header_size) - 4,
                      std::to_string(facets) + " triangles are announced, but the file has bytes for " +
                          std::to_string(room));
  if (3 * facets > largest_count)
    return byte_error("Binary STL", 80, "more than 715827882 triangles are announced");
  std::vector<Point> corners;
  corners.reserve(std::size_t(3 * facets));
  for (std::int64_t f = 0; f < facets; ++f) {
    const char* p = data + header_size + std::size_t(f) * facet_size + 12; // behind the normal
    for (int k = 0; k < 3; ++k, p += 12)
      corners.emplace_back(little_endian_float(p), little_endian_float(p + 4), little_endian_float(p + 8));
  }
  return indexed(std::move(corners));
}

class Ascii_parser {
public:
  Ascii_parser(const char* data, std::size_t size, Notes& notes)
      : m_cursor(data, data + size), m_notes(notes) {}

  Result<Polygon_soup> parse() {
    while (m_cursor.find_word()) {
      if (!take("solid")) return expected("solid");
      m_cursor.skip_line();
      while (m_cursor.find_word() && equals_ignoring_case(m_cursor.peek(), "facet"))
        if (Result<void> done = facet(); !done) return done.error();
      if (!m_cursor.find_word()) {
        if (m_corners.empty()) return expected("facet or endsolid");
        m_notes.push_back("the file ends without endsolid, behind a whole facet");
        break;
      }
      if (equals_ignoring_case(m_cursor.peek(), "solid") && !m_corners.empty()) {
        m_notes.push_back("a solid ends without endsolid before line " + std::to_string(m_cursor.line()));
        continue;
      }
      if (!take("endsolid")) return expected("facet or endsolid");
      m_cursor.skip_line();
    }
    return indexed(std::move(m_corners));
  }

private:
  Error expected(const char* what) const {
    return line_error("STL", m_cursor.line(),
                      std::string("expected ") + what + ", found " + quoted_word(m_cursor));
  }

  bool take(std::string_view keyword) {
    if (!m_cursor.find_word() || !equals_ignoring_case(m_cursor.peek(), keyword)) return false;
    m_cursor.word();
    return true;
  }

  Result<void> three_numbers(Point& p) {
    for (int k = 0; k < 3; ++k)
      if (!m_cursor.find_word() || !m_cursor.number(p[k])) return expected("a number");
    return {};
  }

  Result<void> facet() {
    Point p;
    take("facet");
    if (!take("normal")) return expected("normal");
    if (Result<void> done = three_numbers(p); !done) return done;
    if (!take("outer")) return expected("outer loop");
    if (!take("loop")) return expected("loop");
    for (int k = 0; k < 3; ++k) {
      if (!take("vertex")) return expected("vertex");
      if (Result<void> done = three_numbers(p); !done) return done;
      if (std::int64_t(m_corners.size()) >= largest_count) return expected("at most 715827882 triangles");
      m_corners.push_back(p);
    }
    if (!take("endloop")) return expected("endloop");
    if (!take("endfacet")) return expected("endfacet");
    return {};
  }

  Text_cursor m_cursor;
  Notes& m_notes;
  std::vector<Point> m_corners;
};

// Binary files may begin with "solid" too: the size tells, and else a byte that no text has.
bool looks_like_text(const char* data, std::size_t size) {
  Text_cursor cursor(data, data + size);
  if (!cursor.find_word() || !equals_ignoring_case(cursor.peek(), "solid")) return false;
  const std::size_t looked_at = size < 512 ? size : 512;
  return std::memchr(data, 0, looked_at) == nullptr;
}

} // namespace

Result<Polygon_soup> parse_stl(const char* data, std::size_t size, Notes& notes) {
  const bool exact =
      size >= header_size && size == header_size + facet_size * std::size_t(little_endian_32(data + 80));
  if (!exact && looks_like_text(data, size)) return Ascii_parser(data, size, notes).parse();
  if (size < header_size)
    return byte_error("STL", std::int64_t(size),
                      "the file begins like no ascii STL and is too short for a binary one");
  return parse_binary(data, size, notes);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
