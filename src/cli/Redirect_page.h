// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_REDIRECT_PAGE_H
#define REEBQUAD_CLI_REDIRECT_PAGE_H

#include <optional>
#include <string>

namespace reebquad {

/// A page, in a file that only the user can read, that leads to an address. A browser is asked to open the
/// file: the address itself, with the secret in it, would stand in the list of processes for all users of the
/// machine. The file is removed with the object.
class Redirect_page {
public:
  /// Nothing if no such file can be made.
  static std::optional<Redirect_page> write(const std::string& address);
  Redirect_page(Redirect_page&& other) noexcept;
  Redirect_page& operator=(Redirect_page&& other) noexcept;
  ~Redirect_page();

  const std::string& path() const { return m_path; }

private:
  explicit Redirect_page(std::string path) : m_path(std::move(path)) {}
  std::string m_path;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_REDIRECT_PAGE_H
