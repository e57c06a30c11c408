// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_PARALLEL_FOR_H
#define REEBQUAD_BASE_PARALLEL_FOR_H

#include <algorithm>
#include <atomic>
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

/// Calls `work(i)` for i in [0, n), each once, from at most `threads` threads, and from fewer if the system gives no more, in increasing
/// order of start. The first exception is thrown again when all threads have ended.
template <class Work> void parallel_for(int n, int threads, const Work& work) {
  threads = std::min(threads, n);
  if (threads <= 1) {
    for (int i = 0; i < n; ++i) work(i);
    return;
  }
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto loop = [&] {
    try {
      for (int i = next++; i < n; i = next++) work(i);
    } catch (...) {
      next = n;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> pool;
  pool.reserve(std::size_t(threads));
  try {
    for (int t = 1; t < threads; ++t) pool.emplace_back(loop);
  } catch (const std::system_error&) {
    // Those that there are do it all.
  }
  loop();
  for (std::thread& thread : pool) thread.join();
  if (failure) std::rethrow_exception(failure);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_PARALLEL_FOR_H
