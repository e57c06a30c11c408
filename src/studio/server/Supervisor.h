// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_SUPERVISOR_H
#define REEBQUAD_SERVER_SUPERVISOR_H

#include <functional>

namespace reebquad {
namespace studio {

/// How often the work may crash within a minute before it is given up.
constexpr int most_crashes = 5;

/// Runs `work` in a child process, and again in another one when a signal that it did not ask for ends it: a
/// crash, or the system that needs memory. `work` is told how often it has crashed within the last minute,
/// and returns the exit code. The child ends when this process ends, however that happens; when `stop` says
/// so it is sent SIGTERM. Returns the child's exit code, or 1 when it is given up.
/// \pre no other thread runs
int supervise(const std::function<int(int crashes)>& work, const std::function<bool()>& stop,
              const std::function<void(int signal, int crashes)>& crashed);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_SUPERVISOR_H
