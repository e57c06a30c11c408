// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_STAGE_CLOCK_H
#define REEBQUAD_BASE_STAGE_CLOCK_H

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <sys/resource.h>

#include <chrono>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Measures the stages of a run into a list of records with `name`, `seconds`, `cpu_seconds` and `peak_megabytes`, and tells the
/// observer.
template <class Record> class Stage_clock {
public:
  Stage_clock(Observer* observer, std::vector<Record>& records) : m_observer(observer), m_records(records) {}

  /// Begins a stage; false if the observer asks to stop.
  bool begin(const std::string& name) {
    if (cancelled()) return false;
    if (m_observer) m_observer->progress(name, 0);
    m_records.push_back(Record{name, 0, 0, 0});
    m_start = std::chrono::steady_clock::now();
    m_cpu_start = cpu();
    return true;
  }
  void end() {
    Record& record = m_records.back();
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    record.cpu_seconds = cpu() - m_cpu_start;
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    record.peak_megabytes = double(usage.ru_maxrss) / 1024;
    if (m_observer) m_observer->progress(record.name, 1);
  }
  bool cancelled() const { return m_observer && m_observer->cancelled(); }
  Observer* observer() const { return m_observer; }

private:
  static double cpu() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  }

  Observer* m_observer;
  std::vector<Record>& m_records;
  std::chrono::steady_clock::time_point m_start;
  double m_cpu_start = 0;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_STAGE_CLOCK_H
