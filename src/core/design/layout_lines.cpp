// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/layout_lines.h"

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

int modulo(int a, int n) {
  return ((a % n) + n) % n;
}

int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

bool is_regular(const Design_chart& chart) {
  return !chart.edited && chart.settings.dislocations.empty() && chart.texture.texture.holes.empty() &&
         int(chart.texture.texture.quads.size()) == chart.grid[0] * chart.grid[1];
}

} // namespace

std::optional<Layout_lines> Layout_lines::of(const Design& design) {
  Layout_lines lines;
  if (!lines.read(design) || !lines.find_kinds(design)) return std::nullopt;
  lines.merge_across_plain_contours(design);
  lines.number();
  return lines;
}

bool Layout_lines::read(const Design& design) {
  m_now.counts = design.samples.counts;
  m_nodes = int(design.network.nodes.size());
  for (const Contour_edge& e : design.network.edges) m_ends.push_back({e.from, e.to});
  for (const auto& chart : design.charts) {
    if (!is_regular(*chart) || chart->chart->kind == Chart_kind::region) return false;
    Lines lines;
    lines.disc = chart->chart->kind == Chart_kind::disc;
    lines.clockwise = chart->chart->walks[0].side == Side::high;
    lines.rectangle = !rectangle_corners(design.network, *chart->chart).empty();
    int samples = 0;
    for (std::size_t w = 0; w < chart->chart->walks.size(); ++w)
      for (const Walk_edge& e : chart->chart->walks[w].edges) {
        lines.walks[w].push_back({e.edge, e.forward});
        if (w == 0) samples += m_now.counts[e.edge];
      }
    const bool swapped = lines.clockwise && lines.disc;
    lines.grid = {chart->grid[swapped ? 1 : 0], chart->grid[swapped ? 0 : 1]};
    // A rectangle's grid begins with its first side, however its walk runs.
    if (lines.rectangle) lines.grid = chart->grid;
    // Where sides are unlike those that a cap gets from its number of samples, they are somebody's choice,
    // and stay.
    if (lines.disc && chart->grid[0] != (samples / 2 + 1) / 2) lines.rectangle = true;
    m_now.turn.push_back(lines.disc ? modulo(-chart->texture.offset[0], samples) : chart->texture.offset[1]);
    m_charts.push_back(std::move(lines));
  }
  return !m_charts.empty();
}

bool Layout_lines::find_kinds(const Design& design) {
  m_on_boundary.assign(std::size_t(m_nodes), 0);
  m_boundary_edge.assign(m_ends.size(), 0);
  for (std::size_t e = 0; e < m_ends.size(); ++e) {
    if (design.network.is_removed(design.network.edges[e])) continue;
    const std::array<int, 2>& sides = design.atlas.charts_of_edge[e];
    if (sides[0] >= 0 && sides[1] >= 0) continue;
    m_boundary_edge[e] = 1;
    for (int node : m_ends[e]) m_on_boundary[node] = 1;
  }
  std::vector<int> ends(std::size_t(m_nodes), 0), quads(std::size_t(m_nodes), 0);
  for (std::size_t e = 0; e < m_ends.size(); ++e)
    if (!design.network.is_removed(design.network.edges[e]))
      for (int node : m_ends[e]) ++ends[node];
  for (const Lines& chart : m_charts)
    for (const auto& walk : chart.walks)
      for (const Part& part : walk) quads[m_ends[part.edge][part.forward ? 0 : 1]] += 2;
  for (std::size_t c = 0; c < m_charts.size(); ++c)
    if (m_charts[c].rectangle)
      for (int i : rectangle_corners(design.network, *design.charts[c]->chart)) {
        const Part& part = m_charts[c].walks[0][i];
        --quads[m_ends[part.edge][part.forward ? 0 : 1]];
      }
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i] > 2 && quads[i] == 4) return false;
  return true;
}

// A contour that nothing extraordinary lies on is no line of the base complex: the annuli on its sides have
// the same columns.
void Layout_lines::merge_across_plain_contours(const Design& design) {
  std::vector<int> contour(m_nodes, 0);
  std::iota(contour.begin(), contour.end(), 0);
  std::vector<int> ends(std::size_t(m_nodes), 0);
  for (std::size_t e = 0; e < m_ends.size(); ++e) {
    if (design.network.is_removed(design.network.edges[e])) continue;
    for (int node : m_ends[e]) ++ends[node];
    contour[root(contour, m_ends[e][0])] = root(contour, m_ends[e][1]);
  }
  std::vector<char> line(std::size_t(m_nodes), 0);
  for (int i = 0; i < m_nodes; ++i)
    if (ends[i] > 2 || m_on_boundary[i]) line[root(contour, i)] = 1;
  for (const Lines& chart : m_charts)
    if (chart.disc) // its corners lie there
      for (const Part& part : chart.walks[0]) line[root(contour, m_ends[part.edge][0])] = 1;
  std::vector<int> group(m_charts.size());
  std::iota(group.begin(), group.end(), 0);
  for (std::size_t e = 0; e < m_ends.size(); ++e) {
    if (design.network.is_removed(design.network.edges[e]) || line[root(contour, m_ends[e][0])]) continue;
    const std::array<int, 2>& sides = design.atlas.charts_of_edge[e];
    group[root(group, sides[0])] = root(group, sides[1]);
  }
  for (std::size_t c = 0; c < group.size(); ++c) m_charts[c].counted = root(group, int(c)) == int(c);
}

void Layout_lines::set(const Layout_integers& integers) {
  const bool same = m_now.counts == integers.counts;
  m_now = integers;
  if (!same) number();
}

// Vertices: first the nodes, then those inside of the contour edges.
void Layout_lines::number() {
  int vertices = m_nodes;
  m_first.assign(m_ends.size(), 0);
  for (std::size_t e = 0; e < m_ends.size(); ++e) {
    m_first[e] = vertices;
    vertices += std::max(0, m_now.counts[e] - 1);
  }
  m_boundary.assign(std::size_t(vertices), 0);
  std::copy(m_on_boundary.begin(), m_on_boundary.end(), m_boundary.begin());
  for (std::size_t e = 0; e < m_ends.size(); ++e)
    if (m_boundary_edge[e]) std::fill_n(m_boundary.begin() + m_first[e], m_now.counts[e] - 1, char(1));
  for (auto& ports : m_ports) ports.clear();
  m_ports.resize(std::size_t(vertices));
  m_quads.assign(std::size_t(vertices), 0);
  m_corners.assign(std::size_t(vertices), 0);
  for (std::size_t c = 0; c < m_charts.size(); ++c) {
    Lines& chart = m_charts[c];
    for (int w = 0; w < 2; ++w) {
      std::vector<int>& ids = chart.ids[w];
      ids.clear();
      for (const Part& part : chart.walks[w]) {
        const std::size_t e = std::size_t(part.edge);
        ids.push_back(m_ends[e][part.forward ? 0 : 1]);
        for (int k = 1; k < m_now.counts[e]; ++k)
          ids.push_back(m_first[e] + (part.forward ? k : m_now.counts[e] - k) - 1);
      }
      for (int i = 0; i < int(ids.size()); ++i) {
        m_quads[ids[i]] += 2;
        m_ports[ids[i]].push_back({int(c), w, i});
      }
    }
    const int n = int(chart.ids[0].size());
    if (chart.disc && !chart.rectangle) {
      const int a = (n / 2 + 1) / 2, b = n / 2 - a;
      chart.grid = chart.clockwise ? std::array<int, 2>{{b, a}} : std::array<int, 2>{{a, b}};
    }
    chart.taken.assign(std::size_t(n), 0);
  }
  m_trace = 0;
}

std::array<int, 4> Layout_lines::corners(const Lines& chart, int turn) const {
  const int n = int(chart.ids[0].size()), first = chart.grid[0], half = n / 2;
  return {{modulo(turn, n), modulo(turn + first, n), modulo(turn + half, n), modulo(turn + half + first, n)}};
}

int Layout_lines::turns_of_disc(int chart) const {
  const std::array<int, 2>& grid = m_charts[chart].grid;
  return grid[0] == grid[1] ? grid[0] : grid[0] + grid[1];
}

bool Layout_lines::is_corner(const Port& port) const {
  const Lines& chart = m_charts[port.chart];
  if (!chart.disc) return false;
  const int half = int(chart.ids[0].size()) / 2;
  const int at = modulo(port.sample - m_now.turn[port.chart], half);
  return at == 0 || at == chart.grid[0];
}

Layout_lines::Port Layout_lines::across(const Port& port) const {
  const Lines& chart = m_charts[port.chart];
  const int n = int(chart.ids[0].size()), turn = m_now.turn[port.chart];
  if (!chart.disc)
    return {port.chart, 1 - port.walk, modulo(port.walk == 0 ? port.sample - turn : port.sample + turn, n)};
  const int first = chart.grid[0], half = n / 2, at = modulo(port.sample - turn, n);
  // Opposite samples of the sides 0 and 2 have the sum half + first, of 1 and 3 that of n + first.
  const bool along = at < first || (at > half && at < half + first);
  return {port.chart, 0, modulo((along ? half + first : n + first) - at + turn, n)};
}

// The column or line that begins at a port.
int Layout_lines::line(const Port& port) const {
  const Lines& chart = m_charts[port.chart];
  const Port other = across(port);
  if (!chart.disc) return port.walk == 0 ? port.sample : other.sample;
  return std::min(port.sample, other.sample);
}

void Layout_lines::trace(Port port) {
  for (;;) {
    int& taken = m_charts[port.chart].taken[line(port)];
    if (taken == m_trace) return;
    taken = m_trace;
    const Port end = across(port);
    const int v = m_charts[end.chart].ids[end.walk][end.sample];
    const std::vector<Port>& ports = m_ports[v];
    const int quads = m_quads[v] - m_corners[v];
    if (m_boundary[v] || quads != 4 || ports.size() != 2) return;
    const bool first =
        ports[0].chart == end.chart && ports[0].walk == end.walk && ports[0].sample == end.sample;
    port = ports[first ? 1 : 0];
  }
}

int Layout_lines::patches() {
  ++m_trace;
  std::vector<int> vertices;
  for (std::size_t c = 0; c < m_charts.size(); ++c)
    if (m_charts[c].disc)
      for (int i : corners(m_charts[c], m_now.turn[c])) {
        vertices.push_back(m_charts[c].ids[0][i]);
        ++m_corners[vertices.back()];
      }
  const auto run = [&](int v) {
    if (m_ports[v].size() <= 2 && m_quads[v] - m_corners[v] == (m_boundary[v] ? 2 : 4)) return;
    for (const Port& port : m_ports[v])
      if (!is_corner(port)) trace(port);
  };
  for (int v = 0; v < m_nodes; ++v)
    if (!m_ports[v].empty()) run(v);
  for (int v : vertices) run(v);
  for (int v : vertices) m_corners[v] = 0;
  int number = 0;
  for (const Lines& chart : m_charts) {
    if (!chart.counted) continue;
    if (!chart.disc) {
      number += std::max(1, int(std::count(chart.taken.begin(), chart.taken.end(), m_trace)));
      continue;
    }
    const int first = chart.grid[0], n = int(chart.taken.size()), turn = m_now.turn[&chart - &m_charts[0]];
    std::array<int, 2> lines{{1, 1}};
    for (int i = 0; i < n; ++i)
      if (chart.taken[i] == m_trace) ++lines[modulo(i - turn, n / 2) < first ? 0 : 1];
    number += lines[0] * lines[1];
  }
  return number;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
