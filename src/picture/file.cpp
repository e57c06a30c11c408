// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/render.h>

namespace CGAL {
namespace Reeb_quadrangulation {

Result<void> write_png(const Image& image, const std::string& path) {
  if (!can_write_png())
    return make_error(Error_code::unsupported_format, "this library was built without libpng");
  const std::vector<unsigned char> bytes = encode_png(image);
  return write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
