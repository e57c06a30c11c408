// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include <algorithm>
#include <fstream>

namespace CGAL {
namespace Reeb_quadrangulation {

Result<std::string> read_file(const std::string& path, std::uint64_t limit) {
  constexpr std::uint64_t first_piece = 1u << 16;
  std::ifstream stream(path, std::ios::binary);
  std::string bytes;
  // Longer pieces as the file grows; one byte more than the limit tells that it is exceeded.
  while (stream && bytes.size() <= limit) {
    const std::size_t size = bytes.size();
    const std::uint64_t wanted =
        std::min(limit + 1 - size, std::max<std::uint64_t>(first_piece, std::uint64_t(size)));
    bytes.resize(size + std::size_t(wanted));
    stream.read(bytes.data() + size, std::streamsize(wanted));
    bytes.resize(size + std::size_t(stream.gcount()));
  }
  if (bytes.size() > limit) return make_error(Error_code::unreadable_file, "the file is too large");
  if (stream.bad() || !stream.eof())
    return make_error(Error_code::unreadable_file, "the file cannot be read");
  return bytes;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
