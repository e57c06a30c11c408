// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>

#include "io/file_descriptor.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// Removes a file at the end of its scope, unless told not to.
class Removal {
public:
  explicit Removal(std::string path) : m_path(std::move(path)) {}
  Removal(const Removal&) = delete;
  Removal& operator=(const Removal&) = delete;
  ~Removal() {
    if (!m_path.empty()) ::unlink(m_path.c_str());
  }
  void cancel() { m_path.clear(); }

private:
  std::string m_path;
};

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// The file behind a symbolic link, so that the link survives; `path` itself if it is none.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

/// A new file in `folder`; its name does not grow with the final one, which may be as long as names can be.
int create_temporary(const std::string& folder, std::string& path) {
  static std::atomic<unsigned> counter{0};
  for (int attempt = 0; attempt < 1000; ++attempt) {
    path = folder + "/.writing-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
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

} // namespace

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
  const auto fail = [&path](const std::string& why) {
    return make_error(Error_code::unwritable_file, "Cannot write '" + path + "': " + why + ".");
  };
  const auto fail_with = [&fail](int error) { return fail(std::generic_category().message(error)); };

  if (path.empty()) return fail_with(ENOENT);
  struct stat status;
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) return fail("it is a folder");
  if (exists && !S_ISREG(status.st_mode)) return fail("it exists and is not a regular file");
  const std::string target = exists ? resolved(path) : path, folder = folder_of(target);

  std::string temporary;
  File_descriptor file(create_temporary(folder, temporary));
  if (!file.is_open()) return fail_with(errno);
  Removal removal(temporary);
  if (exists && ::fchmod(file.get(), status.st_mode & 07777) != 0) return fail_with(errno);
  if (!write_all(file.get(), bytes) || ::fsync(file.get()) != 0 || !file.close()) return fail_with(errno);
  if (::rename(temporary.c_str(), target.c_str()) != 0) return fail_with(errno);
  removal.cancel();

  // Some file systems cannot flush a folder; the file is whole all the same.
  const File_descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.is_open()) ::fsync(directory.get());
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
