// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_INTERRUPTION_H
#define REEBQUAD_CLI_INTERRUPTION_H

namespace reebquad {

/// From now on Ctrl-C (SIGINT) and SIGTERM ask the work to stop: `interrupted()` becomes true. Work that does
/// not come back within 0.4 s, or a second Ctrl-C, ends the process with exit code 130 at once.
void watch_for_interruption();

bool interrupted();

/// While one exists, the process is not ended in the middle: files are written whole or not at all.
class Uninterruptible {
public:
  Uninterruptible();
  ~Uninterruptible();
  Uninterruptible(const Uninterruptible&) = delete;
  Uninterruptible& operator=(const Uninterruptible&) = delete;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_INTERRUPTION_H
