// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_PRINTABLE_H
#define REEBQUAD_CLI_PRINTABLE_H

#include <iosfwd>
#include <streambuf>
#include <string_view>

namespace reebquad {

/// Passes text on to another buffer, with control characters as \xNN but for ends of lines and tabulators: a
/// file whose name, or a name in a file, has an escape sequence in it does not get to command the terminal.
/// The two-byte control characters of UTF-8 (U+0080 to U+009F) count as well. As long as it exists, a stream
/// writes through it.
class Printable : public std::streambuf {
public:
  explicit Printable(std::ostream& stream);
  ~Printable() override;
  Printable(const Printable&) = delete;
  Printable& operator=(const Printable&) = delete;

protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

private:
  bool put(unsigned char c);
  bool put_code(unsigned char c);

  std::ostream& m_stream;
  std::streambuf* m_target;
  bool m_after_c2 = false; ///< the first byte of a two-byte control character, perhaps, is held back
};

} // namespace reebquad

#endif // REEBQUAD_CLI_PRINTABLE_H
