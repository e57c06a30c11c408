// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_KEEP_FREED_MEMORY_H
#define REEBQUAD_CLI_KEEP_FREED_MEMORY_H

#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Lets large arrays reuse what was freed before, for a process that does one run and ends: glibc otherwise
/// returns them to the system one by one, and a tenth of a run at a million triangles goes into getting
/// zeroed pages again. Changes nothing elsewhere, and no result.
inline void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int gigabyte = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, gigabyte);
  mallopt(M_TRIM_THRESHOLD, gigabyte);
  mallopt(M_TOP_PAD, gigabyte / 16);
#endif
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CLI_KEEP_FREED_MEMORY_H
