// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/render.h>

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace {

bool write_and_sync(int file, const std::vector<unsigned char>& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    if (written <= 0) return false;
    done += std::size_t(written);
  }
  return ::fsync(file) == 0;
}

} // namespace

Result<void> write_png(const Image& image, const std::string& path) {
  const std::vector<unsigned char> bytes = encode_png(image);
  const std::string temporary = path + "." + std::to_string(::getpid()) + ".part";
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return make_error(Error_code::unwritable_file, "The picture " + path + " cannot be created.");
  const bool written = write_and_sync(file, bytes);
  const bool closed = ::close(file) == 0;
  if (written && closed && std::rename(temporary.c_str(), path.c_str()) == 0) return {};
  ::unlink(temporary.c_str());
  return make_error(Error_code::unwritable_file, "The picture " + path + " cannot be written whole.");
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
