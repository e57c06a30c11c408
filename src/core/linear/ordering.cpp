// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/ordering.h"

#include <amd.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

Error no_memory() {
  return make_error(Error_code::solver_failure, "The unknowns could not be ordered: not enough memory.");
}

struct Graph {
  std::vector<int> begin, neighbour; // both directions of every edge
  std::vector<int> edge_weight;      // like `neighbour`
  std::vector<int> weight;           // of the vertices
  int size() const { return int(weight.size()); }
};

Graph graph_of(const Symmetric_matrix& m) {
  Graph g;
  g.weight.assign(m.size, 1);
  g.begin.assign(m.size + 1, 0);
  for (int j = 0; j < m.size; ++j)
    for (int k = m.column_begin[j] + 1; k < m.column_begin[j + 1]; ++k) {
      ++g.begin[j + 1];
      ++g.begin[m.row[k] + 1];
    }
  std::partial_sum(g.begin.begin(), g.begin.end(), g.begin.begin());
  g.neighbour.resize(g.begin.back());
  std::vector<int> end(g.begin.begin(), g.begin.end() - 1);
  for (int j = 0; j < m.size; ++j)
    for (int k = m.column_begin[j] + 1; k < m.column_begin[j + 1]; ++k) {
      g.neighbour[end[j]++] = m.row[k];
      g.neighbour[end[m.row[k]]++] = j;
    }
  g.edge_weight.assign(g.neighbour.size(), 1);
  return g;
}

// Vertices by breadth-first search from the first one of each component.
std::vector<int> breadth_first_order(const Graph& g) {
  std::vector<int> order;
  order.reserve(g.size());
  std::vector<char> seen(g.size(), 0);
  for (int seed = 0; seed < g.size(); ++seed) {
    if (seen[seed]) continue;
    seen[seed] = 1;
    order.push_back(seed);
    for (std::size_t i = order.size() - 1; i < order.size(); ++i)
      for (int k = g.begin[order[i]]; k < g.begin[order[i] + 1]; ++k)
        if (!seen[g.neighbour[k]]) {
          seen[g.neighbour[k]] = 1;
          order.push_back(g.neighbour[k]);
        }
  }
  return order;
}

// Neighbours get numbers close together: everything after runs from the caches.
Graph renumbered(const Graph& g, const std::vector<int>& order) {
  std::vector<int> place(g.size());
  for (int i = 0; i < g.size(); ++i) place[order[i]] = i;
  Graph r;
  r.weight.resize(g.size());
  r.begin.push_back(0);
  r.neighbour.reserve(g.neighbour.size());
  for (int i = 0; i < g.size(); ++i) {
    r.weight[i] = g.weight[order[i]];
    for (int k = g.begin[order[i]]; k < g.begin[order[i] + 1]; ++k)
      r.neighbour.push_back(place[g.neighbour[k]]);
    r.begin.push_back(int(r.neighbour.size()));
  }
  r.edge_weight.assign(r.neighbour.size(), 1);
  return r;
}

// Merges pairs of neighbours, the heaviest edges and lightest partners first; `coarse_of` receives the new
// numbers.
Graph coarsened(const Graph& g, std::vector<int>& coarse_of) {
  std::vector<int> members; // one or two fine vertices for each coarse one
  coarse_of.assign(g.size(), -1);
  for (int u = 0; u < g.size(); ++u) {
    if (coarse_of[u] >= 0) continue;
    int partner = -1, best = 0;
    for (int k = g.begin[u]; k < g.begin[u + 1]; ++k) {
      const int v = g.neighbour[k];
      if (coarse_of[v] >= 0 || v == u || g.edge_weight[k] < best) continue;
      if (g.edge_weight[k] > best || g.weight[v] < g.weight[partner]) {
        partner = v;
        best = g.edge_weight[k];
      }
    }
    coarse_of[u] = int(members.size() / 2);
    if (partner >= 0) coarse_of[partner] = coarse_of[u];
    members.push_back(u);
    members.push_back(partner);
  }
  Graph c;
  const int size = int(members.size() / 2);
  c.weight.assign(size, 0);
  c.begin.push_back(0);
  c.neighbour.reserve(g.neighbour.size() / 2);
  c.edge_weight.reserve(g.neighbour.size() / 2);
  std::vector<int> slot(size, -1);
  for (int x = 0; x < size; ++x) {
    const int first = int(c.neighbour.size());
    for (const int u : {members[2 * x], members[2 * x + 1]}) {
      if (u < 0) continue;
      c.weight[x] += g.weight[u];
      for (int k = g.begin[u]; k < g.begin[u + 1]; ++k) {
        const int y = coarse_of[g.neighbour[k]];
        if (y == x) continue;
        if (slot[y] < first) {
          slot[y] = int(c.neighbour.size());
          c.neighbour.push_back(y);
          c.edge_weight.push_back(0);
        }
        c.edge_weight[slot[y]] += g.edge_weight[k];
      }
    }
    c.begin.push_back(int(c.neighbour.size()));
  }
  return c;
}

constexpr std::int64_t largest_index = std::int64_t(1) << 32; // a power of two above all vertices

// A graph whose vertices belong to regions, and a bisection of one region at a time.
struct Bisector {
  explicit Bisector(const Graph& g)
      : graph(&g), region(g.size(), 0), side(g.size(), 0), mark(g.size(), 0), gain(g.size()),
        has_gain(g.size(), 0) {}

  const Graph* graph;
  std::vector<int> region;
  std::vector<signed char> side; // 0 or 1; -1: not known yet
  std::vector<int> mark;
  int latest_mark = 0;
  std::vector<int> gain, has_gain; // the latter: marks the pass that the former is of
  std::vector<std::int64_t> queue; // a heap of gains and, for a total order, vertices

  std::int64_t cut(const std::vector<int>& vertices) const;
  void grow(int start, std::vector<int>& order);
  void split_by_search(const std::vector<int>& vertices, int start);
  bool is_cut(int v) const;
  // `candidates` hold, on entry and in what is returned, at least the region's vertices at the cut.
  std::vector<int> refine(const std::vector<int>& vertices, std::vector<int> candidates, int passes);
  void find_gain(int v);
  void add_neighbours(const std::vector<int>& moved, std::size_t kept, std::vector<int>& candidates) const;
  bool pass(std::vector<int>& candidates, std::int64_t (&weight)[2]);
};

std::int64_t Bisector::cut(const std::vector<int>& vertices) const {
  std::int64_t sum = 0;
  for (const int v : vertices)
    for (int k = graph->begin[v]; k < graph->begin[v + 1]; ++k) {
      const int u = graph->neighbour[k];
      if (region[u] == region[v] && side[u] != side[v]) sum += graph->edge_weight[k];
    }
  return sum / 2;
}

// Appends the part of the start's region that has no mark yet, in breadth-first order.
void Bisector::grow(int start, std::vector<int>& order) {
  std::size_t i = order.size();
  mark[start] = latest_mark;
  order.push_back(start);
  for (; i < order.size(); ++i)
    for (int k = graph->begin[order[i]]; k < graph->begin[order[i] + 1]; ++k) {
      const int u = graph->neighbour[k];
      if (region[u] != region[start] || mark[u] == latest_mark) continue;
      mark[u] = latest_mark;
      order.push_back(u);
    }
}

// The first vertices of a breadth-first search, up to half of the weight, go to side 0, one component after
// the other.
void Bisector::split_by_search(const std::vector<int>& vertices, int start) {
  std::int64_t total = 0, sum = 0;
  for (const int v : vertices) {
    total += graph->weight[v];
    side[v] = 1;
  }
  ++latest_mark;
  std::vector<int> order;
  grow(start, order);
  std::size_t next = 0;
  for (std::size_t i = 0; 2 * sum < total; ++i) {
    if (i == order.size()) {
      while (mark[vertices[next]] == latest_mark) ++next;
      grow(vertices[next], order);
    }
    side[order[i]] = 0;
    sum += graph->weight[order[i]];
  }
}

// How much smaller the cut becomes when `v` changes its side.
void Bisector::find_gain(int v) {
  gain[v] = 0;
  for (int k = graph->begin[v]; k < graph->begin[v + 1]; ++k) {
    const int u = graph->neighbour[k];
    if (region[u] == region[v])
      gain[v] += side[u] == side[v] ? -graph->edge_weight[k] : graph->edge_weight[k];
  }
  has_gain[v] = latest_mark;
}

// What is at the cut after a pass was there before or is next to what has moved: the first `kept` of `moved`.
void Bisector::add_neighbours(const std::vector<int>& moved, std::size_t kept,
                              std::vector<int>& candidates) const {
  for (std::size_t i = 0; i < kept; ++i) {
    const int v = moved[i];
    for (int k = graph->begin[v]; k < graph->begin[v + 1]; ++k) {
      const int u = graph->neighbour[k];
      if (region[u] == region[v]) candidates.push_back(u);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
}

// Moves vertices across the cut, best gain first and each at most once, beyond local minima; then takes back
// what came after the best state. Returns whether the cut became smaller.
bool Bisector::pass(std::vector<int>& candidates, std::int64_t (&weight)[2]) {
  // Moves without a new best; large regions, whose separators cost the most, are worth more.
  const std::size_t patience = std::size_t(std::min<std::int64_t>(200, 40 + (weight[0] + weight[1]) / 400));
  const std::int64_t most = (weight[0] + weight[1]) * 60 / 100 + 1;
  queue.clear();
  const auto push = [&](int v) {
    queue.push_back(std::int64_t(gain[v]) * largest_index + v);
    std::push_heap(queue.begin(), queue.end());
  };
  ++latest_mark; // marks the vertices that have moved
  for (const int v : candidates) {
    find_gain(v);
    push(v);
  }
  std::vector<int> moved;
  std::int64_t gained = 0, best = 0;
  std::size_t kept = 0;
  while (!queue.empty() && moved.size() < kept + patience) {
    std::pop_heap(queue.begin(), queue.end());
    const std::int64_t key = queue.back();
    queue.pop_back();
    const int v = int(key & (largest_index - 1)), g = int((key - v) / largest_index);
    if (mark[v] == latest_mark || g != gain[v]) continue;
    const int from = side[v], to = 1 - from;
    if (weight[to] + graph->weight[v] > most && weight[to] >= weight[from]) continue;
    mark[v] = latest_mark;
    side[v] = (signed char)to;
    weight[from] -= graph->weight[v];
    weight[to] += graph->weight[v];
    gained += g;
    moved.push_back(v);
    if (gained > best) {
      best = gained;
      kept = moved.size();
    }
    for (int k = graph->begin[v]; k < graph->begin[v + 1]; ++k) {
      const int u = graph->neighbour[k];
      if (region[u] != region[v] || mark[u] == latest_mark) continue;
      if (has_gain[u] == latest_mark)
        gain[u] += side[u] == side[v] ? -2 * graph->edge_weight[k] : 2 * graph->edge_weight[k];
      else
        find_gain(u);
      push(u);
    }
  }
  add_neighbours(moved, kept, candidates);
  for (; moved.size() > kept; moved.pop_back()) {
    const int v = moved.back(), from = side[v];
    side[v] = (signed char)(1 - from);
    weight[from] -= graph->weight[v];
    weight[1 - from] += graph->weight[v];
  }
  return best > 0;
}

bool Bisector::is_cut(int v) const {
  for (int k = graph->begin[v]; k < graph->begin[v + 1]; ++k) {
    const int u = graph->neighbour[k];
    if (region[u] == region[v] && side[u] != side[v]) return true;
  }
  return false;
}

std::vector<int> Bisector::refine(const std::vector<int>& vertices, std::vector<int> candidates, int passes) {
  std::int64_t weight[2] = {0, 0};
  for (const int v : vertices) weight[int(side[v])] += graph->weight[v];
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), [&](int v) { return !is_cut(v); }),
                   candidates.end());
  for (int i = 0; i < passes && pass(candidates, weight); ++i) {
  }
  return candidates;
}

// Cuts a graph into two halves: on a coarser one first, then refined.
std::vector<signed char> bisected(const Graph& g) {
  constexpr int smallest = 80;
  Bisector bisector(g);
  std::vector<int> all(g.size());
  std::iota(all.begin(), all.end(), 0);
  if (g.size() > smallest) {
    std::vector<int> coarse_of;
    const Graph coarse = coarsened(g, coarse_of);
    if (coarse.size() < g.size() * 9 / 10) {
      const std::vector<signed char> side = bisected(coarse);
      for (const int v : all) bisector.side[v] = side[coarse_of[v]];
      bisector.refine(all, all, 4);
      return bisector.side;
    }
  }
  // Large regions are worth more attempts.
  const std::int64_t weight = std::accumulate(g.weight.begin(), g.weight.end(), std::int64_t(0));
  const int starts = 2 + int(std::min<std::int64_t>(10, weight / 3000));
  std::vector<signed char> best;
  std::int64_t best_cut = std::numeric_limits<std::int64_t>::max();
  for (int i = 0; i < starts; ++i) {
    bisector.split_by_search(all, int(std::int64_t(g.size()) * i / starts));
    bisector.refine(all, all, 8);
    const std::int64_t cut = bisector.cut(all);
    if (cut >= best_cut) continue;
    best_cut = cut;
    best = bisector.side;
  }
  return best;
}

// A smallest set of vertices that meets every cut edge of a region: by a largest matching of the cut's
// bipartite graph (Koenig 1931), found by augmenting paths.
class Vertex_cover {
public:
  explicit Vertex_cover(const Bisector& b)
      : m_bisector(&b), m_mate(b.graph->size(), -1), m_visit(b.graph->size(), 0) {}

  // \pre `candidates`, in increasing order, hold all of the region's vertices at the cut.
  std::vector<int> operator()(const std::vector<int>& candidates) {
    std::vector<int> left, right;
    for (const int v : candidates)
      if (m_bisector->is_cut(v)) (m_bisector->side[v] == 0 ? left : right).push_back(v);
    for (const int v : left)
      for_across(v, [&](int u) {
        if (m_mate[u] >= 0) return false;
        m_mate[u] = v;
        m_mate[v] = u;
        return true;
      });
    for (const int v : left)
      if (m_mate[v] < 0) {
        ++m_latest;
        augment_from(v, 0);
      }
    // Reached from the unmatched left by alternating paths: the cover is the left not reached and the right
    // reached.
    ++m_latest;
    for (const int v : left)
      if (m_mate[v] < 0) reach(v);
    std::vector<int> cover;
    for (const int v : left)
      if (m_visit[v] != m_latest) cover.push_back(v);
    for (const int v : right)
      if (m_visit[v] == m_latest) cover.push_back(v);
    for (const auto* half : {&left, &right})
      for (const int v : *half) m_mate[v] = -1;
    return cover;
  }

private:
  template <class Action> bool for_across(int v, Action action) const {
    const Graph& g = *m_bisector->graph;
    for (int k = g.begin[v]; k < g.begin[v + 1]; ++k) {
      const int u = g.neighbour[k];
      if (m_bisector->region[u] == m_bisector->region[v] && m_bisector->side[u] != m_bisector->side[v] &&
          action(u))
        return true;
    }
    return false;
  }
  bool augment_from(int v, int depth) {
    if (depth > 200) return false; // the matching may then not be the largest; the cover is one all the same
    return for_across(v, [&](int u) {
      if (m_visit[u] == m_latest) return false;
      m_visit[u] = m_latest;
      if (m_mate[u] >= 0 && !augment_from(m_mate[u], depth + 1)) return false;
      m_mate[u] = v;
      m_mate[v] = u;
      return true;
    });
  }
  void reach(int root) {
    std::vector<int> stack = {root};
    m_visit[root] = m_latest;
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      for_across(v, [&](int u) {
        if (m_visit[u] == m_latest) return false;
        m_visit[u] = m_latest;
        const int w = m_mate[u];
        if (w >= 0 && m_visit[w] != m_latest) {
          m_visit[w] = m_latest;
          stack.push_back(w);
        }
        return false;
      });
    }
  }

  const Bisector* m_bisector;
  std::vector<int> m_mate, m_visit;
  int m_latest = 0;
};

// Numbers regions from the outermost separators, which come last, inwards.
class Dissection {
public:
  Dissection(const Graph& fine, const Graph& coarse, const std::vector<int>& coarse_of)
      : m_fine(fine), m_coarse(coarse), m_coarse_of(&coarse_of), m_cover(m_fine), m_local(fine.size(), -1),
        m_members_begin(coarse.size() + 1, 0), m_members(fine.size()) {
    for (const int c : coarse_of) ++m_members_begin[c + 1];
    std::partial_sum(m_members_begin.begin(), m_members_begin.end(), m_members_begin.begin());
    std::vector<int> end(m_members_begin.begin(), m_members_begin.end() - 1);
    for (int v = 0; v < fine.size(); ++v) m_members[end[coarse_of[v]]++] = v;
  }

  Result<std::vector<int>> order() {
    std::vector<Region> stack(1);
    stack[0].fine.resize(m_fine.graph->size());
    stack[0].coarse.resize(m_coarse.graph->size());
    std::iota(stack[0].fine.begin(), stack[0].fine.end(), 0);
    std::iota(stack[0].coarse.begin(), stack[0].coarse.end(), 0);
    while (!stack.empty()) {
      const Region region = std::move(stack.back());
      stack.pop_back();
      if (int(region.fine.size()) <= leaf_size || int(region.coarse.size()) < smallest_coarse) {
        if (!order_leaf(region.fine)) return no_memory();
        continue;
      }
      Region part[2];
      split(region, part);
      if (part[0].fine.empty() || part[1].fine.empty()) {
        // Everything became separator or one side: no progress to be expected here.
        std::vector<int> all = part[0].fine;
        all.insert(all.end(), part[1].fine.begin(), part[1].fine.end());
        if (!order_leaf(all)) return no_memory();
        continue;
      }
      stack.push_back(std::move(part[0]));
      stack.push_back(std::move(part[1]));
    }
    std::reverse(m_reversed.begin(), m_reversed.end());
    return std::move(m_reversed);
  }

private:
  struct Region {
    std::vector<int> fine, coarse;
  };
  static constexpr int leaf_size = 800, smallest_coarse = 16;

  // Bisects on the coarse graph, refines on the fine one, numbers the separator, and gives the two sides new
  // regions.
  void split(const Region& region, Region (&part)[2]) {
    const std::vector<signed char> coarse_side = bisected(part_of(*m_coarse.graph, region.coarse));
    for (std::size_t i = 0; i < region.coarse.size(); ++i) m_coarse.side[region.coarse[i]] = coarse_side[i];
    const int coarse_region = m_coarse.region[region.coarse.front()];
    std::vector<int> strays; // refinement moved them away from their coarse vertex
    for (const int v : region.fine) {
      const int c = (*m_coarse_of)[v];
      m_fine.side[v] = m_coarse.region[c] == coarse_region ? m_coarse.side[c] : (signed char)(-1);
      if (m_fine.side[v] < 0) strays.push_back(v);
    }
    const Graph& g = *m_fine.graph;
    for (const int v : strays) {
      int balance = 0;
      for (int k = g.begin[v]; k < g.begin[v + 1]; ++k) {
        const int u = g.neighbour[k];
        if (m_fine.region[u] == m_fine.region[v] && m_fine.side[u] >= 0)
          balance += m_fine.side[u] == 1 ? 1 : -1;
      }
      m_fine.side[v] = balance > 0;
    }
    const std::vector<int> separator = m_cover(m_fine.refine(region.fine, near_cut(region, strays), 3));
    m_reversed.insert(m_reversed.end(), separator.rbegin(), separator.rend());
    for (const int v : separator) m_fine.region[v] = -1;
    const int first = m_regions + 1;
    m_regions += 2;
    for (const int v : region.fine)
      if (m_fine.region[v] >= 0) {
        m_fine.region[v] = first + m_fine.side[v];
        part[int(m_fine.side[v])].fine.push_back(v);
      }
    for (const int c : region.coarse) {
      m_coarse.region[c] = first + m_coarse.side[c];
      part[int(m_coarse.side[c])].coarse.push_back(c);
    }
  }

  // All that can be at the cut before refinement: what is in a coarse vertex at the cut, and strays with
  // their neighbours.
  std::vector<int> near_cut(const Region& region, const std::vector<int>& strays) const {
    std::vector<int> near = strays;
    for (const int c : region.coarse)
      if (m_coarse.is_cut(c))
        near.insert(near.end(), m_members.begin() + m_members_begin[c],
                    m_members.begin() + m_members_begin[c + 1]);
    const Graph& g = *m_fine.graph;
    for (const int v : strays)
      near.insert(near.end(), g.neighbour.begin() + g.begin[v], g.neighbour.begin() + g.begin[v + 1]);
    const int own = m_fine.region[region.fine.front()];
    near.erase(std::remove_if(near.begin(), near.end(), [&](int v) { return m_fine.region[v] != own; }),
               near.end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  // The subgraph of the given vertices, numbered as they are listed.
  Graph part_of(const Graph& g, const std::vector<int>& vertices) {
    Graph part;
    for (std::size_t i = 0; i < vertices.size(); ++i) m_local[vertices[i]] = int(i);
    part.begin.push_back(0);
    for (const int v : vertices) {
      part.weight.push_back(g.weight[v]);
      for (int k = g.begin[v]; k < g.begin[v + 1]; ++k)
        if (m_local[g.neighbour[k]] >= 0) {
          part.neighbour.push_back(m_local[g.neighbour[k]]);
          part.edge_weight.push_back(g.edge_weight[k]);
        }
      part.begin.push_back(int(part.neighbour.size()));
    }
    for (const int v : vertices) m_local[v] = -1;
    return part;
  }

  bool order_leaf(const std::vector<int>& vertices) {
    const int size = int(vertices.size());
    if (size == 0) return true;
    Graph leaf = part_of(*m_fine.graph, vertices);
    std::vector<int> order(size);
    leaf.neighbour.push_back(0); // amd_order wants a pointer, even to nothing
    const int status =
        amd_order(size, leaf.begin.data(), leaf.neighbour.data(), order.data(), nullptr, nullptr);
    for (int i = size - 1; i >= 0; --i) m_reversed.push_back(vertices[order[i]]);
    return status == AMD_OK || status == AMD_OK_BUT_JUMBLED;
  }

  Bisector m_fine, m_coarse;
  const std::vector<int>* m_coarse_of;
  Vertex_cover m_cover;
  std::vector<int> m_local, m_reversed;
  std::vector<int> m_members_begin, m_members; // the fine vertices of each coarse one
  int m_regions = 0;
};

} // namespace

Result<std::vector<int>> minimum_degree_order(const Symmetric_matrix& m) {
  std::vector<int> order(m.size);
  if (m.size > 0 &&
      amd_order(m.size, m.column_begin.data(), m.row.data(), order.data(), nullptr, nullptr) != AMD_OK)
    return no_memory();
  return order;
}

Result<std::vector<int>> dissection_order(const Symmetric_matrix& m) {
  const Graph given = graph_of(m);
  const std::vector<int> outer = breadth_first_order(given);
  const Graph fine = renumbered(given, outer);
  std::vector<int> coarse_of(m.size);
  std::iota(coarse_of.begin(), coarse_of.end(), 0);
  Graph coarse = fine;
  constexpr int levels = 4;
  for (int i = 0; i < levels; ++i) {
    std::vector<int> next;
    coarse = coarsened(coarse, next);
    for (int& c : coarse_of) c = next[c];
  }
  Result<std::vector<int>> order = Dissection(fine, coarse, coarse_of).order();
  if (order)
    for (int& v : *order) v = outer[v];
  return order;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
