// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_AUTOMATIC_SEARCH_LIMIT_H
#define REEBQUAD_AUTOMATIC_SEARCH_LIMIT_H

#include <CGAL/Reeb_quadrangulation/search_extrema.h>

#include <algorithm>
#include <chrono>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

// When a search ends: after so many tries, or so many seconds after this was made.
class Search_limit {
public:
  explicit Search_limit(const Search_options& options)
      : m_tries(options.tries), m_seconds(options.seconds), m_begin(std::chrono::steady_clock::now()) {}

  bool is_reached(int tries) const { return tries >= m_tries || (m_seconds > 0 && elapsed() >= m_seconds); }
  // How much of the search is done, 0 to 1.
  double done(int tries) const {
    const double time = m_seconds > 0 ? elapsed() / m_seconds : 0;
    return std::min(1.0, std::max(double(tries) / double(m_tries), time));
  }

private:
  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
  }

  int m_tries;
  double m_seconds;
  std::chrono::steady_clock::time_point m_begin;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_AUTOMATIC_SEARCH_LIMIT_H
