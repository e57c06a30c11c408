// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Folder_lock.h"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace reebquad {
namespace studio {

using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;
using CGAL::Reeb_quadrangulation::Result;

Result<Folder_lock> Folder_lock::take(const std::filesystem::path& folder) {
  Folder_lock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.m_file < 0) return lock;
  for (int attempt = 0; ::flock(lock.m_file, LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EWOULDBLOCK) return lock;
    if (attempt == 40)
      return make_error(
          Error_code::impossible_request,
          folder.string() +
              ": another studio works in this folder; use its page, or end it with Ctrl-C first");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return lock;
}

Folder_lock::Folder_lock(Folder_lock&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}

Folder_lock& Folder_lock::operator=(Folder_lock&& other) noexcept {
  std::swap(m_file, other.m_file);
  return *this;
}

Folder_lock::~Folder_lock() {
  if (m_file >= 0) ::close(m_file);
}

} // namespace studio
} // namespace reebquad
