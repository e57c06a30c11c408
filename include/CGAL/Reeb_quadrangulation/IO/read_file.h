// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_READ_FILE_H
#define CGAL_REEB_QUADRANGULATION_IO_READ_FILE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The bytes of a file, at most `limit` of them; also of a pipe, which is read to its end. Fails with `unreadable_file` if it cannot be
/// opened or read, or is longer.
Result<std::string> read_file(const std::string& path, std::uint64_t limit);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_READ_FILE_H
