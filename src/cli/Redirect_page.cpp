// SPDX-License-Identifier: GPL-3.0-or-later
#include "Redirect_page.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace reebquad {

namespace fs = std::filesystem;

namespace {

/// The user's own folder for such files, where there is one.
fs::path folder() {
  const char* const own = std::getenv("XDG_RUNTIME_DIR");
  std::error_code failed;
  if (own && *own == '/' && fs::is_directory(own, failed)) return own;
  return fs::temp_directory_path(failed);
}

} // namespace

std::optional<Redirect_page> Redirect_page::write(const std::string& address) {
  std::string path = (folder() / "reebquad-XXXXXX.html").string();
  const int file = ::mkstemps(path.data(), 5); // readable by the user alone
  if (file < 0) return std::nullopt;
  Redirect_page page(path);
  const std::string text = "<!doctype html><meta charset=\"utf-8\"><title>reebquad studio</title>"
                           "<meta http-equiv=\"refresh\" content=\"0; url=" +
                           address + "\">\n";
  const bool written = ::write(file, text.data(), text.size()) == ssize_t(text.size());
  if (::close(file) != 0 || !written) return std::nullopt;
  return page;
}

Redirect_page::Redirect_page(Redirect_page&& other) noexcept : m_path(std::exchange(other.m_path, "")) {}

Redirect_page& Redirect_page::operator=(Redirect_page&& other) noexcept {
  m_path.swap(other.m_path);
  return *this;
}

Redirect_page::~Redirect_page() {
  if (!m_path.empty()) ::unlink(m_path.c_str());
}

} // namespace reebquad
