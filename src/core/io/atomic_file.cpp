// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>

#include "io/file_descriptor.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr const char* temporary_prefix = ".writing-";
constexpr std::time_t long_ago = 60; // seconds: nobody needs that long between making and locking a file

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// The file behind a symbolic link, so that the link survives; `path` itself if it is none.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file, bytes.data(), std::min(bytes.size(), std::size_t(1) << 26));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(std::size_t(n));
  }
  return true;
}

/// A file that is being written, in the folder where it shall lie. Removed at the end of its scope, unless it
/// was put in its place.
class Temporary_file {
public:
  explicit Temporary_file(std::string folder) : m_folder(std::move(folder)), m_file(-1) {}
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file() {
    if (!m_name.empty()) ::unlink(m_name.c_str());
  }

  /// \name Steps
  /// False, with the reason in `errno`, if the system refuses.
  /// @{
  bool fill(std::string_view bytes, const struct stat* old) {
    if (fill_unnamed(bytes, old)) return true;
    return create_named() && fill_open(bytes, old);
  }
  bool put(const std::string& target) {
    if (!m_file.close() || ::rename(m_name.c_str(), target.c_str()) != 0) return false;
    m_name.clear();
    return true;
  }
  /// @}

private:
  bool fill_open(std::string_view bytes, const struct stat* old) {
    if (old && ::fchmod(m_file.get(), old->st_mode & 0777) != 0) return false;
    return write_all(m_file.get(), bytes) && ::fsync(m_file.get()) == 0;
  }

  // Not every file system has files without names, and a name is given through /proc, which may be missing:
  // then the same is done again with a named file.
  bool fill_unnamed(std::string_view bytes, const struct stat* old) {
#ifdef O_TMPFILE
    m_file = File_descriptor(::open(m_folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666));
    if (!m_file.is_open() || !fill_open(bytes, old)) return false;
    const std::string open_file = "/proc/self/fd/" + std::to_string(m_file.get());
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const std::string name = next_name();
      if (::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
        m_name = name;
        return true;
      }
      if (errno != EEXIST) return false;
    }
#else
    (void)bytes;
    (void)old;
#endif
    return false;
  }

  // The lock tells others that the file is not one that a killed process left.
  bool create_named() {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const std::string name = next_name();
      m_file = File_descriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (m_file.is_open()) {
        m_name = name;
        ::flock(m_file.get(), LOCK_EX | LOCK_NB);
        return true;
      }
      if (errno != EEXIST) return false;
    }
    return false;
  }

  // It does not grow with the final name, which may be as long as names can be.
  std::string next_name() const {
    static std::atomic<unsigned> counter{0};
    return m_folder + "/" + temporary_prefix + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  }

  std::string m_folder, m_name;
  File_descriptor m_file;
};

bool was_left_behind(const std::string& path) {
  struct stat status;
  if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  if (status.st_uid != ::geteuid() || std::time(nullptr) - status.st_mtime < long_ago) return false;
  const File_descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

/// Removes what killed processes left in a folder.
void tidy(const std::string& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), ::closedir);
  if (!entries) return;
  while (const dirent* entry = ::readdir(entries.get())) {
    const std::string name = entry->d_name;
    if (name.rfind(temporary_prefix, 0) != 0) continue;
    const std::string path = folder + "/" + name;
    if (was_left_behind(path)) ::unlink(path.c_str());
  }
}

/// False, with the reason in `errno`, if what lies in the folder may be lost when the machine fails.
bool flush_folder(const std::string& folder) {
  const File_descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Who may write into a folder need not be allowed to read it, and some file systems cannot flush one.
  if (!directory.is_open()) return errno == EACCES;
  return ::fsync(directory.get()) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EBADF;
}

} // namespace

Result<void> write_file_atomically(const std::string& path, std::string_view bytes, Written_link link) {
  const auto fail = [&path](const std::string& why) {
    return make_error(Error_code::unwritable_file, "Cannot write '" + path + "': " + why + ".");
  };
  const auto fail_with = [&fail](int error) { return fail(std::generic_category().message(error)); };

  if (path.empty()) return fail_with(ENOENT);
  struct stat status;
  const bool replaces_link =
      link == Written_link::replaced && ::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
  const bool exists = !replaces_link && ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) return fail("it is a folder");
  if (exists && !S_ISREG(status.st_mode)) return fail("it exists and is not a regular file");
  const std::string target = exists ? resolved(path) : path, folder = folder_of(target);

  Temporary_file file(folder);
  if (!file.fill(bytes, exists ? &status : nullptr) || !file.put(target)) return fail_with(errno);
  tidy(folder);
  if (!flush_folder(folder))
    return make_error(Error_code::unwritable_file,
                      "'" + path + "' is written, but may be lost if the machine fails now: " +
                          std::generic_category().message(errno) + ".");
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
