// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_cursor.h"

#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

// std::from_chars says that a number is out of range but not on which side. A negative exponent, or a number
// that begins with zero, lies below the smallest number; files with 400 digits and a correcting exponent do
// not occur.
double Text_cursor::out_of_range_value(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t exponent = text.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos
                        ? exponent + 1 < text.size() && text[exponent + 1] == '-'
                        : !text.empty() && (text.front() == '0' || text.front() == '.');
  const double value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return negative ? -value : value;
}

std::string quoted_word(const Text_cursor& cursor) {
  if (cursor.bytes_left() == 0) return "the end of the file";
  std::string_view word = cursor.peek();
  if (word.empty()) return "the end of the line";
  std::string text = "'";
  for (char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 24 ? "...'" : "'");
}

Error line_error(const char* format, std::int64_t line, const std::string& text) {
  return make_error(Error_code::malformed_file,
                    std::string(format) + ", line " + std::to_string(line) + ": " + text + ".",
                    Element_kind::line, line);
}

Error byte_error(const char* format, std::int64_t byte, const std::string& text) {
  return make_error(Error_code::malformed_file,
                    std::string(format) + ", byte " + std::to_string(byte) + ": " + text + ".",
                    Element_kind::byte, byte);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
