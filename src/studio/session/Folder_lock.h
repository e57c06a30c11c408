// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_FOLDER_LOCK_H
#define REEBQUAD_SESSION_FOLDER_LOCK_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <filesystem>

namespace reebquad {
namespace studio {

/// Holds a folder for one studio, so that two do not write over each other's sessions: as long as it exists,
/// or a process that was forked since. It is a lock of the folder itself: no file is made, and the system
/// takes it back from a process that was killed.
class Folder_lock {
public:
  /// Waits up to two seconds for another to let go, then fails with `impossible_request`. Where the file
  /// system has no locks, it is as if there were no other.
  static CGAL::Reeb_quadrangulation::Result<Folder_lock> take(const std::filesystem::path& folder);
  Folder_lock(Folder_lock&& other) noexcept;
  Folder_lock& operator=(Folder_lock&& other) noexcept;
  ~Folder_lock();

private:
  explicit Folder_lock(int file) : m_file(file) {}
  int m_file;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_FOLDER_LOCK_H
