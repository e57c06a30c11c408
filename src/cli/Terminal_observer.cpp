// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terminal_observer.h"

#include "Interruption.h"

#include <cstdio>
#include <unistd.h>

namespace reebquad {

Terminal_observer::Terminal_observer(bool quiet) : m_quiet(quiet), m_terminal(isatty(STDERR_FILENO) != 0) {}

void Terminal_observer::progress(const std::string& stage, double fraction) {
  const Clock::time_point now = Clock::now();
  if (m_quiet || now - m_start < std::chrono::seconds(1)) return;
  const int percent = int(100 * fraction);
  if (m_terminal) {
    if (stage == m_last_stage && now - m_last_shown < std::chrono::milliseconds(100)) return;
    std::fprintf(stderr, "\r\033[K%s %d %%", stage.c_str(), percent);
    std::fflush(stderr);
    m_line_shown = true;
  } else if (stage != m_last_stage) {
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    std::fprintf(stderr, "%s (%.1f s)\n", stage.c_str(), seconds);
  }
  m_last_stage = stage;
  m_last_shown = now;
}

bool Terminal_observer::cancelled() const {
  return interrupted();
}

void Terminal_observer::clear() {
  if (m_line_shown) std::fputs("\r\033[K", stderr);
  m_line_shown = false;
}

} // namespace reebquad
