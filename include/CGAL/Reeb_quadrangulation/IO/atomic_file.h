// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_ATOMIC_FILE_H
#define CGAL_REEB_QUADRANGULATION_IO_ATOMIC_FILE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <string>
#include <string_view>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Writes a file whole or not at all: a temporary file in the same folder takes the bytes, is flushed to the disk and
/// then renamed to `path`, and the folder is flushed. Whoever looks sees the old file or the new one; on a failure the
/// old one is untouched and the temporary file is removed.
///
/// An existing file keeps its permissions, and a symbolic link to a file keeps pointing there. What exists and is not
/// a regular file (a folder, a device) is refused. Errors: `unwritable_file`, with the system's reason.
Result<void> write_file_atomically(const std::string& path, std::string_view bytes);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_ATOMIC_FILE_H
