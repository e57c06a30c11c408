// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_GATE_H
#define REEBQUAD_SERVER_GATE_H

#include <string>
#include <string_view>

namespace reebquad {
namespace studio {

/// 256 bits from the operating system as 64 hexadecimal digits. Throws `std::system_error` if it gives none.
std::string random_secret();

/// Whether two texts are equal, in a time that depends on their lengths only.
bool equal_in_constant_time(std::string_view a, std::string_view b);

/// Decides who may come in. Three things must hold for a request that reads or changes anything of the user's:
/// - its `Host` is exactly ours, so that a foreign name that resolves to this machine opens nothing (DNS rebinding);
/// - its `Origin`, where there must be one, is exactly ours, so that foreign pages open nothing;
/// - it bears the cookie that was given for the token, so that other users of this machine open nothing.
///
/// The token stands in the fragment of the URL that the program prints; browsers send fragments to nobody.
class Gate {
public:
  explicit Gate(unsigned short port);

  std::string origin() const { return "http://" + m_host; }
  std::string url() const { return origin() + "/#token=" + m_token; }
  const std::string& token() const { return m_token; }

  bool host_is_ours(std::string_view host) const { return host == m_host; }
  /// \pre `origin` is empty if the request has none
  bool origin_is_ours(std::string_view origin) const { return origin == this->origin(); }
  bool origin_is_not_foreign(std::string_view origin) const {
    return origin.empty() || origin_is_ours(origin);
  }
  bool token_opens(std::string_view token) const { return equal_in_constant_time(token, m_token); }
  /// Whether the value of a `Cookie` header has our cookie.
  bool cookie_opens(std::string_view cookies) const;

  /// The value of the `Set-Cookie` header that is given for the token.
  std::string set_cookie() const;
  /// The value of `Content-Security-Policy` for everything that we serve.
  std::string content_security_policy() const;

private:
  std::string m_host;        // "127.0.0.1:PORT"
  std::string m_cookie_name; // has the port in it: browsers share cookies between the ports of a host
  std::string m_token;
  std::string m_cookie_secret;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_GATE_H
