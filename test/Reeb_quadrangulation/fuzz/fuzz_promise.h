// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_PROMISE_H
#define FUZZ_PROMISE_H

#include <cstdlib>

namespace fuzz {

/// Ends the target as a crash does if a promise is broken.
inline void promise(bool kept) {
  if (!kept) std::abort();
}

} // namespace fuzz

#endif // FUZZ_PROMISE_H
