// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_OBSERVER_H
#define CGAL_REEB_QUADRANGULATION_OBSERVER_H

#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Receives progress and may ask to stop. The library calls it from the thread that called the library.
/// A stage that is asked to stop returns `Error_code::cancelled` and leaves its inputs as they were.
class Observer {
public:
  virtual ~Observer() = default;
  /// `stage` begins or goes on; `fraction` is in [0, 1].
  virtual void progress(const std::string& stage, double fraction) {
    (void)stage;
    (void)fraction;
  }
  /// Polled between short steps of work (at most about 50 ms apart); must be thread-safe.
  virtual bool cancelled() const { return false; }
};

/// One stage of a run, as it was measured.
struct Stage_time {
  std::string name;
  double seconds = 0;        ///< wall time
  double cpu_seconds = 0;    ///< of all threads
  double peak_megabytes = 0; ///< resident, of the process so far
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_OBSERVER_H
