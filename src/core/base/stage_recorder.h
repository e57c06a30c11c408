// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_STAGE_RECORDER_H
#define REEBQUAD_BASE_STAGE_RECORDER_H

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <chrono>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// An observer that measures the stages it hears of, and passes everything on. A stage begins with its first
/// `progress()` and lasts until another one begins; a name that is not in `names` is a part of the stage at
/// that time.
class Stage_recorder : public Observer {
public:
  Stage_recorder(Observer* next, std::set<std::string> names) : m_next(next), m_names(std::move(names)) {}

  void progress(const std::string& stage, double fraction) override;
  bool cancelled() const override { return m_next && m_next->cancelled(); }

  /// Ends the present stage, if there is one: what follows belongs to none.
  void end();
  /// Ends the last stage, and gives all of them in the order in which they began; the time of one that came
  /// again is added up.
  std::vector<Stage_time> finish();

private:
  Observer* m_next;
  std::set<std::string> m_names;
  std::vector<Stage_time> m_stages;
  int m_current = -1;
  std::chrono::steady_clock::time_point m_start;
  double m_cpu_start = 0;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_STAGE_RECORDER_H
