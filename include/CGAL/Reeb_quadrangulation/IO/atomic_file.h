// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_IO_ATOMIC_FILE_H
#define CGAL_REEB_QUADRANGULATION_IO_ATOMIC_FILE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <string>
#include <string_view>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What becomes of a symbolic link that stands where a file is to be written.
enum class Written_link { followed, replaced };

/// Writes a file whole or not at all: a temporary file in the same folder takes the bytes, is flushed to the
/// disk and then renamed to `path`, and the folder is flushed. Whoever looks sees the old file or the new
/// one; on a failure the old one is untouched and the temporary file is removed. Only where the very last
/// step fails, flushing the folder, is the new file in its place; the error says so.
///
/// The temporary file has no name until it is whole, where the system can do that, so that a process that is
/// killed leaves nothing behind; elsewhere it is called `.writing-...`, and what a killed process left of
/// that kind a minute ago or earlier is removed.
///
/// An existing file keeps its permissions, but for the bits that let others run it in its owner's name. By
/// default a symbolic link to a file keeps pointing there. What exists and is not a regular file (a folder, a
/// device) is refused. Errors: `unwritable_file`, with the system's reason.
Result<void> write_file_atomically(const std::string& path, std::string_view bytes,
                                   Written_link link = Written_link::followed);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_IO_ATOMIC_FILE_H
