// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where threads are started for computations.
#ifndef REEBQUAD_BASE_PARALLEL_FOR_H
#define REEBQUAD_BASE_PARALLEL_FOR_H

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// As many as asked for, or as the machine has if `asked` is 0.
inline int number_of_threads(int asked) {
  return asked > 0 ? asked : int(std::max(1u, std::thread::hardware_concurrency()));
}

/// Calls `work(i)` for i in [0, n), each once, from at most `threads` threads, in increasing order of start.
/// A thread takes `at_once` of them at a time. After an exception no more are begun, and the first one is
/// thrown again when all threads have ended. Where the system refuses a thread, those that there are do the
/// work.
template <class Work> void parallel_for(int n, int threads, int at_once, const Work& work) {
  const std::int64_t parts = (std::int64_t(n) + at_once - 1) / at_once;
  if (threads <= 1 || parts <= 1) {
    for (int i = 0; i < n; ++i) work(i);
    return;
  }
  std::atomic<std::int64_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto loop = [&] {
    try {
      for (std::int64_t part = next++; part < parts; part = next++) {
        const std::int64_t end = std::min<std::int64_t>(n, (part + 1) * at_once);
        for (std::int64_t i = part * at_once; i < end; ++i) work(int(i));
      }
    } catch (...) {
      next = parts;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  others.reserve(std::size_t(std::min<std::int64_t>(threads, parts)));
  try {
    while (std::int64_t(others.size()) + 1 < std::min<std::int64_t>(threads, parts))
      others.emplace_back(loop);
  } catch (const std::system_error&) {
    // No more threads to be had. One that was started must be joined before anything can be thrown.
  }
  loop();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

/// The same, one at a time.
template <class Work> void parallel_for(int n, int threads, const Work& work) {
  parallel_for(n, threads, 1, work);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_PARALLEL_FOR_H
