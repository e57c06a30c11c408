// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_READ_FILE_H
#define CGAL_REEB_QUADRANGULATION_IO_READ_FILE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What to do where the last part of a path is a symbolic link.
enum class Symbolic_link { followed, refused };

/// The bytes of a regular file, at most `limit` of them; or of a pipe that someone writes into, until he has
/// closed it. It waits for nobody: a pipe that has no writer, or from which nothing comes for ten seconds, is
/// refused, as are devices, sockets and folders. Fails with `unreadable_file` and the reason.
Result<std::string> read_file(const std::string& path, std::uint64_t limit,
                              Symbolic_link link = Symbolic_link::followed);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_READ_FILE_H
