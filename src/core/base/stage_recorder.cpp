// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stage_recorder.h"

#include <sys/resource.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

double seconds(const timeval& time) {
  return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

rusage usage() {
  rusage result;
  getrusage(RUSAGE_SELF, &result);
  return result;
}

double cpu_seconds() {
  const rusage now = usage();
  return seconds(now.ru_utime) + seconds(now.ru_stime);
}

} // namespace

void Stage_recorder::progress(const std::string& stage, double fraction) {
  if (m_next) m_next->progress(stage, fraction);
  if (!m_names.count(stage) || (m_current >= 0 && m_stages[std::size_t(m_current)].name == stage)) return;
  end();
  const auto known = std::find_if(m_stages.begin(), m_stages.end(),
                                  [&](const Stage_time& entry) { return entry.name == stage; });
  m_current = int(known - m_stages.begin());
  if (known == m_stages.end()) m_stages.push_back({stage, 0, 0, 0});
  m_start = std::chrono::steady_clock::now();
  m_cpu_start = cpu_seconds();
}

void Stage_recorder::end() {
  if (m_current < 0) return;
  Stage_time& entry = m_stages[std::size_t(m_current)];
  entry.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  entry.cpu_seconds += cpu_seconds() - m_cpu_start;
  entry.peak_megabytes = double(usage().ru_maxrss) / 1024;
  m_current = -1;
}

std::vector<Stage_time> Stage_recorder::finish() {
  end();
  return std::move(m_stages);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
