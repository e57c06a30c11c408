// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_BATCH_CHILD_H
#define REEBQUAD_CLI_BATCH_CHILD_H

#include "Command.h"

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>

namespace reebquad {

struct Child_limits {
  int megabytes = 0;  ///< of address space; 0: no limit
  double seconds = 0; ///< of wall time; 0: no limit
};

/// How a child ended.
struct Child_end {
  int code = 0;               ///< as a shell gives it: 128 + the signal that ended it, if one did
  int signal = 0;             ///< that signal, or 0
  bool is_time_limit = false; ///< it was stopped because its time was over
  double seconds = 0, cpu_seconds = 0, peak_megabytes = 0;
};

/// This same program in a process of its own, with other arguments and limits. It does not outlive its
/// parent where the system can see to that (Linux), however that ends, and is killed when this object goes.
class Batch_child {
public:
  /// What it says as errors goes into the file `errors`, its other output nowhere. The descriptor `lock`,
  /// if it is not negative, stays open in the child. A `Failure` says why there is no more process.
  Batch_child(const Arguments& arguments, const std::string& errors, const Child_limits& limits, int lock);
  Batch_child(Batch_child&& other) noexcept;
  Batch_child& operator=(Batch_child&& other) noexcept;
  ~Batch_child();

  /// How it has ended, if it has; stops it first where its time is over.
  std::optional<Child_end> end();

private:
  using Clock = std::chrono::steady_clock;

  pid_t m_process = -1; ///< -1: it has ended
  Clock::time_point m_start = Clock::now();
  double m_seconds = 0; ///< the limit
  bool m_is_stopped = false;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_BATCH_CHILD_H
