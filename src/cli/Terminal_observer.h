// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_TERMINAL_OBSERVER_H
#define REEBQUAD_CLI_TERMINAL_OBSERVER_H

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <chrono>
#include <string>

namespace reebquad {

/// Shows progress on standard error once work has lasted a second: on a terminal one line that is rewritten,
/// else one plain line a stage. Passes Ctrl-C on to the library.
class Terminal_observer : public CGAL::Reeb_quadrangulation::Observer {
public:
  explicit Terminal_observer(bool quiet);
  ~Terminal_observer() override { clear(); }

  void progress(const std::string& stage, double fraction) override;
  bool cancelled() const override;
  /// Removes the line from the terminal; call it before printing anything else.
  void clear();

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last_shown{};
  std::string m_last_stage;
  bool m_quiet;
  bool m_terminal;
  bool m_line_shown = false;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_TERMINAL_OBSERVER_H
