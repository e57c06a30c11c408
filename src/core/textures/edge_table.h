// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_TEXTURES_EDGE_TABLE_H
#define REEBQUAD_TEXTURES_EDGE_TABLE_H

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// From directed edges to halfedges, by open addressing. It is only asked for single edges, never walked
/// through, so its order does not matter.
class Edge_table {
public:
  explicit Edge_table(std::size_t edges) {
    std::size_t size = 64;
    while (size < 2 * edges) size *= 2;
    m_slots.resize(size);
  }

  /// The halfedge from a to b, or -1.
  int find(int a, int b) const { return m_slots[slot(key(a, b))].halfedge; }

  /// Sets the halfedge; -1 takes the edge out.
  void set(int a, int b, int halfedge) {
    Slot& s = m_slots[slot(key(a, b))];
    m_used += s.key == empty;
    s.key = key(a, b);
    s.halfedge = halfedge;
    if (2 * m_used > m_slots.size()) grow();
  }

private:
  static constexpr std::uint64_t empty = ~std::uint64_t(0);
  struct Slot {
    std::uint64_t key = empty;
    int halfedge = -1;
  };

  static std::uint64_t key(int a, int b) { return std::uint64_t(std::uint32_t(a)) << 32 | std::uint32_t(b); }
  std::size_t slot(std::uint64_t k) const {
    std::uint64_t h = k * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
    std::size_t i = std::size_t(h * 0xbf58476d1ce4e5b9u >> 20) & (m_slots.size() - 1);
    while (m_slots[i].key != empty && m_slots[i].key != k) i = (i + 1) & (m_slots.size() - 1);
    return i;
  }
  void grow() {
    std::vector<Slot> old(2 * m_slots.size());
    old.swap(m_slots);
    for (const Slot& s : old)
      if (s.key != empty) m_slots[slot(s.key)] = s;
  }

  std::vector<Slot> m_slots;
  std::size_t m_used = 0;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_TEXTURES_EDGE_TABLE_H
