// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/equal_points.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
  x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
  return x ^ (x >> 32);
}

std::uint64_t bits(double x) {
  std::uint64_t b;
  x += 0.0; // -0 becomes 0
  std::memcpy(&b, &x, sizeof b);
  return b;
}

std::uint64_t hash(const Point& p) {
  return mixed(bits(p[0]) + mixed(bits(p[1]) + mixed(bits(p[2]))));
}

std::size_t slots_for(std::size_t points) {
  std::size_t slots = 16;
  while (slots < 2 * points) slots *= 2;
  return slots;
}

} // namespace

std::vector<int> first_equal_points(const std::vector<Point>& points) {
  // Open addressing; a point's slot depends on its coordinates only, and the result not on the slots.
  const std::size_t slots = slots_for(points.size());
  std::vector<int> table(slots, -1), first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    first[i] = int(i);
    if (!p.allFinite()) continue;
    std::size_t slot = hash(p) & (slots - 1);
    while (table[slot] >= 0 && points[std::size_t(table[slot])] != p) slot = (slot + 1) & (slots - 1);
    if (table[slot] < 0) table[slot] = int(i);
    first[i] = table[slot];
  }
  return first;
}

std::vector<int> first_near_points(const std::vector<Point>& points, double distance) {
  if (distance == 0) return first_equal_points(points);
  // Cells as wide as the distance, chained by their hash: what is near lies in one of 27 cells.
  const std::size_t slots = slots_for(points.size());
  std::vector<int> head(slots, -1), next(points.size(), -1), first(points.size());
  const auto slot_of = [&](const Point& cell) { return hash(cell) & (slots - 1); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    first[i] = int(i);
    const Point cell = (points[i] / distance).array().floor();
    if (!cell.allFinite()) continue;
    for (int k = 0; k < 27 && first[i] == int(i); ++k) {
      const Point there = cell + Point(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      for (int j = head[slot_of(there)]; j >= 0; j = next[std::size_t(j)])
        if ((points[std::size_t(j)] - points[i]).norm() < distance) first[i] = j;
    }
    if (first[i] != int(i)) continue;
    int& begin = head[slot_of(cell)];
    next[i] = begin;
    begin = int(i);
  }
  return first;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
