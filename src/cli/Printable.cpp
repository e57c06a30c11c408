// SPDX-License-Identifier: GPL-3.0-or-later
#include "Printable.h"

#include <ostream>

namespace reebquad {

namespace {

constexpr unsigned char first_of_two = 0xc2;

bool is_control(unsigned char c) {
  return (c < 32 && c != '\n' && c != '\t') || c == 127;
}

} // namespace

Printable::Printable(std::ostream& stream) : m_stream(stream), m_target(stream.rdbuf(this)) {}

Printable::~Printable() {
  sync();
  m_stream.rdbuf(m_target);
}

bool Printable::put_code(unsigned char c) {
  const char* const digits = "0123456789abcdef";
  const char text[] = {'\\', 'x', digits[c >> 4], digits[c & 15]};
  return m_target->sputn(text, sizeof text) == sizeof text;
}

bool Printable::put(unsigned char c) {
  if (m_after_c2) {
    m_after_c2 = false;
    if (c >= 0x80 && c < 0xa0) return put_code(first_of_two) && put_code(c);
    if (m_target->sputc(char(first_of_two)) == traits_type::eof()) return false;
  }
  if (is_control(c)) return put_code(c);
  m_after_c2 = c == first_of_two;
  return m_after_c2 || m_target->sputc(char(c)) != traits_type::eof();
}

Printable::int_type Printable::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return sync() == 0 ? 0 : traits_type::eof();
  return put(static_cast<unsigned char>(c)) ? c : traits_type::eof();
}

std::streamsize Printable::xsputn(const char* text, std::streamsize size) {
  for (std::streamsize i = 0; i < size; ++i)
    if (!put(static_cast<unsigned char>(text[i]))) return i;
  return size;
}

int Printable::sync() {
  if (m_after_c2) m_target->sputc(char(first_of_two));
  m_after_c2 = false;
  return m_target->pubsync();
}

} // namespace reebquad
