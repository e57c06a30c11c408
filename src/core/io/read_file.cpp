// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include "io/file_descriptor.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int patience = 10000; // milliseconds that a pipe may be silent

Error unreadable(const std::string& why) {
  return make_error(Error_code::unreadable_file, "the file cannot be read: " + why);
}

Error unreadable(int error) {
  return unreadable(std::generic_category().message(error));
}

/// Null if the file is of a kind that ends.
const char* why_not(mode_t mode) {
  if (S_ISREG(mode) || S_ISFIFO(mode)) return nullptr;
  return S_ISDIR(mode) ? "it is a folder" : "it is neither a regular file nor a pipe";
}

/// The number of bytes read, 0 at the end, -1 on an error, which may be that a pipe is silent: ETIMEDOUT.
ssize_t read_some(int file, char* to, std::size_t size) {
  for (;;) {
    const ssize_t n = ::read(file, to, size);
    if (n >= 0) return n;
    if (errno == EINTR) continue;
    if (errno != EAGAIN) return -1;
    pollfd waiting{file, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, patience);
    if (ready == 0) errno = ETIMEDOUT;
    if (ready == 0 || (ready < 0 && errno != EINTR)) return -1;
  }
}

} // namespace

Result<std::string> read_file(const std::string& path, std::uint64_t limit, Symbolic_link link) {
  constexpr std::uint64_t first_piece = 1u << 16, longest_piece = 1u << 26;
  // Non-blocking: to open a pipe that nobody writes into would wait for ever.
  const int no_link = link == Symbolic_link::refused ? O_NOFOLLOW : 0;
  const File_descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | no_link));
  if (!file.is_open()) return no_link && errno == ELOOP ? unreadable("it is a link") : unreadable(errno);
  struct stat status;
  if (::fstat(file.get(), &status) != 0) return unreadable(errno);
  if (const char* why = why_not(status.st_mode)) return unreadable(why);
  std::string bytes;
  // Longer pieces as the file grows; one byte more than the limit tells that it is exceeded.
  while (bytes.size() <= limit) {
    const std::size_t size = bytes.size();
    const std::uint64_t wanted = std::min(
        limit + 1 - size, std::clamp<std::uint64_t>(std::uint64_t(size), first_piece, longest_piece));
    bytes.resize(size + std::size_t(wanted));
    const ssize_t n = read_some(file.get(), bytes.data() + size, std::size_t(wanted));
    if (n < 0) return errno == ETIMEDOUT ? unreadable("nothing comes out of the pipe") : unreadable(errno);
    bytes.resize(size + std::size_t(n));
    if (n > 0) continue;
    if (bytes.empty() && S_ISFIFO(status.st_mode)) return unreadable("nobody writes into the pipe");
    return bytes;
  }
  return make_error(Error_code::unreadable_file, "the file is too large");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
