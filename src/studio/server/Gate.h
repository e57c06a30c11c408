// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_GATE_H
#define REEBQUAD_SERVER_GATE_H

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace reebquad {
namespace studio {

/// 256 bits from the operating system as 64 hexadecimal digits. Throws `std::system_error` if it gives none.
std::string random_secret();

/// Whether two texts are equal, in a time that depends on their lengths only.
bool equal_in_constant_time(std::string_view a, std::string_view b);

/// Decides who may come in. Three things must hold for a request that reads or changes anything of the
/// user's:
/// - its `Host` is exactly ours, so that a foreign name that resolves to this machine opens nothing (DNS
/// rebinding);
/// - its `Origin`, where there must be one, is exactly ours, so that foreign pages open nothing;
/// - it bears the secret that was given for the token, so that other users of this machine open nothing.
///
/// The token stands in the fragment of the address that the program prints; browsers send fragments to
/// nobody. It opens once, and not for long. The secret is no cookie, which a browser would also send to
/// servers of other users at other ports of this machine: the page keeps it where only pages of our origin,
/// port and all, can read it. All functions may be called from any thread.
class Gate {
public:
  using Clock = std::chrono::steady_clock;

  Gate(unsigned short port, std::string secret, Clock::duration token_life = std::chrono::minutes(10));

  std::string origin() const { return "http://" + m_host; }
  /// The address with the token.
  std::string url() const;
  /// Whether the token would open now: it is not too old, and nobody came in with it.
  bool awaits_visitor() const;
  /// Another token takes the place of the one that there was.
  void renew_token();

  bool host_is_ours(std::string_view host) const { return host == m_host; }
  /// \pre `origin` is empty if the request has none
  bool origin_is_ours(std::string_view origin) const { return origin == this->origin(); }
  bool origin_is_not_foreign(std::string_view origin) const {
    return origin.empty() || origin_is_ours(origin);
  }
  /// Once true, it is false from then on.
  bool token_opens(std::string_view token);
  bool secret_opens(std::string_view secret) const { return equal_in_constant_time(secret, m_secret); }
  const std::string& secret() const { return m_secret; }

  /// The value of `Content-Security-Policy` for everything that we serve.
  std::string content_security_policy() const;

private:
  std::string m_host; // "127.0.0.1:PORT"
  std::string m_secret;
  Clock::duration m_token_life;
  mutable std::mutex m_mutex; // of what follows
  std::string m_token;
  Clock::time_point m_token_end;
  bool m_token_is_used = false;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_GATE_H
