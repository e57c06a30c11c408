// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Gate.h"

#include <array>
#include <cerrno>
#include <sys/random.h>
#include <system_error>

namespace reebquad {
namespace studio {

std::string random_secret() {
  std::array<unsigned char, 32> bytes{};
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = getrandom(bytes.data() + filled, bytes.size() - filled, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw std::system_error(errno, std::generic_category(), "the system gives no random bytes");
    filled += std::size_t(got);
  }
  const char* const digits = "0123456789abcdef";
  std::string text;
  for (const unsigned char b : bytes) {
    text += digits[b >> 4];
    text += digits[b & 15];
  }
  return text;
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  volatile unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = static_cast<unsigned char>(
        difference | (static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i])));
  return difference == 0;
}

Gate::Gate(unsigned short port)
    : m_host("127.0.0.1:" + std::to_string(port)), m_cookie_name("reebquad-" + std::to_string(port)),
      m_token(random_secret()), m_cookie_secret(random_secret()) {}

bool Gate::cookie_opens(std::string_view cookies) const {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view cookie = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (!cookie.empty() && cookie.front() == ' ') cookie.remove_prefix(1);
    const std::size_t sign = cookie.find('=');
    if (sign == std::string_view::npos || cookie.substr(0, sign) != m_cookie_name) continue;
    if (equal_in_constant_time(cookie.substr(sign + 1), m_cookie_secret)) return true;
  }
  return false;
}

std::string Gate::set_cookie() const {
  return m_cookie_name + "=" + m_cookie_secret + "; Path=/; HttpOnly; SameSite=Strict";
}

std::string Gate::content_security_policy() const {
  return "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src "
         "'self'; "
         "worker-src 'self'; connect-src 'self' ws://" +
         m_host + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

} // namespace studio
} // namespace reebquad
