// SPDX-License-Identifier: GPL-3.0-or-later
#include "stitching/meetings.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// Lets every stop of the shorter of two lists meet one of the longer, so that the sum of their distances is
// least.
Meetings meet_nearest(const std::vector<Stop>& a, int a0, int a1, const std::vector<Stop>& b, int b0,
                      int b1) {
  const bool swap = a1 - a0 > b1 - b0;
  if (swap) {
    Meetings out = meet_nearest(b, b0, b1, a, a0, a1);
    for (std::array<int, 2>& m : out) std::swap(m[0], m[1]);
    return out;
  }
  // cost[i][j]: of the first i of a among the first j of b.
  const int p = a1 - a0, q = b1 - b0;
  std::vector<std::vector<double>> cost(p + 1, std::vector<double>(q + 1, 0));
  for (int i = 1; i <= p; ++i)
    for (int j = i; j <= q - (p - i); ++j) {
      const double both = cost[i - 1][j - 1] + std::abs(a[a0 + i - 1].at - b[b0 + j - 1].at);
      cost[i][j] = j > i ? std::min(both, cost[i][j - 1]) : both;
    }
  Meetings out;
  for (int i = p, j = q; j > 0; --j) {
    const bool skip =
        i == 0 ||
        (j > i && cost[i][j - 1] <= cost[i - 1][j - 1] + std::abs(a[a0 + i - 1].at - b[b0 + j - 1].at));
    out.push_back({skip ? -1 : a0 + --i, b0 + j - 1});
  }
  std::reverse(out.begin(), out.end());
  return out;
}

} // namespace

Meetings meet(const std::vector<Stop>& a, const std::vector<Stop>& b) {
  Meetings out;
  int a0 = 0, b0 = 0;
  const auto flush = [&](int a1, int b1) {
    const Meetings between = meet_nearest(a, a0, a1, b, b0, b1);
    out.insert(out.end(), between.begin(), between.end());
    a0 = a1;
    b0 = b1;
  };
  for (int i = 0, j = 0; i < int(a.size()) && j < int(b.size());) {
    if (a[i].at < b[j].at)
      ++i;
    else if (b[j].at < a[i].at)
      ++j;
    else {
      flush(i, j);
      out.push_back({i++, j++});
      a0 = i;
      b0 = j;
    }
  }
  flush(int(a.size()), int(b.size()));
  return out;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
