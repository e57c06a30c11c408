// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Gate.h"

#include <array>
#include <cerrno>
#include <sys/random.h>
#include <system_error>
#include <utility>

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

Gate::Gate(unsigned short port, std::string secret, Clock::duration token_life)
    : m_host("127.0.0.1:" + std::to_string(port)), m_secret(std::move(secret)), m_token_life(token_life) {
  renew_token();
}

std::string Gate::url() const {
  const std::lock_guard<std::mutex> lock(m_mutex);
  return origin() + "/#token=" + m_token;
}

bool Gate::awaits_visitor() const {
  const std::lock_guard<std::mutex> lock(m_mutex);
  return !m_token_is_used && Clock::now() < m_token_end;
}

void Gate::renew_token() {
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_token = random_secret();
  m_token_end = Clock::now() + m_token_life;
  m_token_is_used = false;
}

bool Gate::token_opens(std::string_view token) {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_token_is_used || Clock::now() >= m_token_end || !equal_in_constant_time(token, m_token)) return false;
  m_token_is_used = true;
  return true;
}

std::string Gate::content_security_policy() const {
  return "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src "
         "'self'; "
         "worker-src 'self'; connect-src 'self' ws://" +
         m_host + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

} // namespace studio
} // namespace reebquad
