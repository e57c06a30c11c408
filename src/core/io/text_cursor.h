// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_IO_TEXT_CURSOR_H
#define REEBQUAD_IO_TEXT_CURSOR_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Walks over bytes as lines of blank-separated words. Never reads outside [begin, end); knows its line.
/// Lines end with LF, CR LF or CR. If `comment` is not 0, a word that begins with it is blank, to the end of
/// the line.
class Text_cursor {
public:
  Text_cursor(const char* begin, const char* end, char comment = 0)
      : m_at(begin), m_end(end), m_comment(comment) {}

  const char* at() const { return m_at; }
  std::size_t bytes_left() const { return std::size_t(m_end - m_at); }
  std::int64_t line() const { return m_line; }

  /// Goes to the next word, if there is one on this line.
  bool find_word_on_line() {
    while (m_at != m_end && is_blank(*m_at)) ++m_at;
    if (m_at != m_end && *m_at == m_comment && m_comment != 0)
      while (m_at != m_end && !is_newline(*m_at)) ++m_at;
    return m_at != m_end && !is_newline(*m_at);
  }

  /// Goes to the next word, on this line or a later one.
  bool find_word() {
    while (!find_word_on_line()) {
      if (m_at == m_end) return false;
      pass_newline();
    }
    return true;
  }

  /// Goes to the beginning of the next line.
  void skip_line() {
    while (m_at != m_end && !is_newline(*m_at)) ++m_at;
    if (m_at != m_end) pass_newline();
  }

  /// The word here; the cursor stays.
  std::string_view peek() const {
    const char* last = m_at;
    while (last != m_end && !ends_word(*last)) ++last;
    return std::string_view(m_at, std::size_t(last - m_at));
  }

  /// The word here; the cursor goes behind it.
  std::string_view word() {
    const std::string_view result = peek();
    m_at += result.size();
    return result;
  }

  void advance(std::size_t bytes) { m_at += bytes; }

  /// The number that is the word here, and goes behind it; false, without moving, if the word is not a
  /// number. Overflow gives an infinite number and underflow zero.
  bool number(double& value) {
    const char* first = m_at;
    if (first != m_end && *first == '+') ++first;
    if (first != m_at && first != m_end && *first == '-') return false;
    const std::from_chars_result parsed = std::from_chars(first, m_end, value);
    if (parsed.ec == std::errc::invalid_argument || (parsed.ptr != m_end && !ends_word(*parsed.ptr)))
      return false;
    if (parsed.ec == std::errc::result_out_of_range)
      value = out_of_range_value(std::string_view(first, std::size_t(parsed.ptr - first)));
    m_at = parsed.ptr;
    return true;
  }

  /// The integer that is the word here, likewise. One that does not fit is not an integer.
  bool integer(std::int64_t& value) {
    const char* first = m_at;
    if (first != m_end && *first == '+') ++first;
    if (first != m_at && first != m_end && *first == '-') return false;
    const std::from_chars_result parsed = std::from_chars(first, m_end, value);
    if (parsed.ec != std::errc() || (parsed.ptr != m_end && !ends_word(*parsed.ptr))) return false;
    m_at = parsed.ptr;
    return true;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }
  static bool ends_word(char c) { return is_blank(c) || is_newline(c); }

  void pass_newline() {
    if (*m_at == '\r' && m_at + 1 != m_end && m_at[1] == '\n') ++m_at;
    ++m_at;
    ++m_line;
  }

  static double out_of_range_value(std::string_view text);

  const char* m_at;
  const char* m_end;
  char m_comment;
  std::int64_t m_line = 1;
};

/// At most 24 characters of what stands at the cursor's word, in quotes and printable; "the end of the file"
/// at the end.
std::string quoted_word(const Text_cursor& cursor);

/// `malformed_file` with "FORMAT, line N: text".
Error line_error(const char* format, std::int64_t line, const std::string& text);

/// `malformed_file` with "FORMAT, byte N: text".
Error byte_error(const char* format, std::int64_t byte, const std::string& text);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_IO_TEXT_CURSOR_H
