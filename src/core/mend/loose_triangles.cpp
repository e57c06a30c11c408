// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/loose_triangles.h"

namespace CGAL {
namespace Reeb_quadrangulation {

std::vector<Triangle> divided(const Triangle& face, const std::array<std::vector<int>, 3>& on_side) {
  std::vector<Triangle> parts = {face};
  for (int i = 0; i < 3; ++i) {
    if (on_side[i].empty()) continue;
    const int a = face[i], b = face[(i + 1) % 3];
    for (std::size_t p = 0; p < parts.size(); ++p) {
      Triangle t = parts[p];
      for (int turn = 0; turn < 3 && !(t[0] == a && t[1] == b); ++turn) t = {t[1], t[2], t[0]};
      if (t[0] != a || t[1] != b) continue;
      int last = a;
      for (int v : on_side[i]) {
        parts.push_back({last, v, t[2]});
        last = v;
      }
      parts[p] = {last, b, t[2]};
      break;
    }
  }
  return parts;
}

std::string text_of_count(std::int64_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

void say(std::vector<Mend>& mends, std::int64_t count, const char* one, const char* many) {
  if (count > 0) mends.push_back({count, text_of_count(count, one, many)});
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
