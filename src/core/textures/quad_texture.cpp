// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Quad_texture.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

std::vector<double> equal_rows(const Height_profile& profile, int rows) {
  CGAL_precondition(rows >= 1);
  std::vector<double> levels{0.0};
  for (int r = 1; r < rows; ++r) levels.push_back(profile.level_at(double(r) / rows));
  levels.push_back(1.0);
  return levels;
}

Quad_texture regular_annulus_texture(int columns, const std::vector<double>& levels) {
  CGAL_precondition(columns >= 3 && levels.size() >= 2);
  Quad_texture texture;
  const int rows = int(levels.size()) - 1;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns; ++c) {
      texture.v.push_back(double(c) / columns);
      texture.u.push_back(levels[r]);
    }
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int next = (c + 1) % columns, below = r * columns, above = below + columns;
      texture.quads.push_back({below + c, below + next, above + next, above + c});
    }
  texture.sides.resize(2);
  for (int c = 0; c < columns; ++c) {
    texture.sides[0].push_back(c);
    texture.sides[1].push_back(rows * columns + c);
  }
  return texture;
}

Quad_texture regular_disc_texture(int a, int b, bool clockwise) {
  CGAL_precondition(a >= 1 && b >= 1);
  Quad_texture texture;
  const auto id = [&](int x, int y) { return y * (a + 1) + x; };
  for (int y = 0; y <= b; ++y)
    for (int x = 0; x <= a; ++x) {
      texture.v.push_back(x);
      texture.u.push_back(y);
    }
  for (int y = 0; y < b; ++y)
    for (int x = 0; x < a; ++x)
      texture.quads.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)});
  std::vector<int> side;
  for (int x = 0; x < a; ++x) side.push_back(id(x, 0));
  for (int y = 0; y < b; ++y) side.push_back(id(a, y));
  for (int x = a; x > 0; --x) side.push_back(id(x, b));
  for (int y = b; y > 0; --y) side.push_back(id(0, y));
  if (clockwise) std::reverse(side.begin() + 1, side.end());
  texture.sides.push_back(std::move(side));
  return texture;
}

namespace {

Result<void> bad_texture(const char* reason) {
  return make_error(Error_code::impossible_request, std::string("a chart's texture ") + reason);
}

using Directed_edge = std::array<int, 2>;

// The edges of the sides, each as the quad inside runs along it.
std::vector<Directed_edge> side_edges(const Quad_texture& texture, bool clockwise) {
  std::vector<Directed_edge> edges;
  for (std::size_t w = 0; w < texture.sides.size(); ++w) {
    const std::vector<int>& side = texture.sides[w];
    const bool backward = texture.sides.size() == 2 ? w == 1 : clockwise;
    for (std::size_t i = 0; i < side.size(); ++i) {
      const int a = side[i], b = side[(i + 1) % side.size()];
      edges.push_back(backward ? Directed_edge{b, a} : Directed_edge{a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

} // namespace

Result<void> check_texture(const Quad_texture& texture, const std::vector<int>& samples, bool clockwise) {
  const int n = int(texture.v.size());
  if (texture.u.size() != texture.v.size()) return bad_texture("has different numbers of U and V");
  if (!texture.holes.empty() && texture.holes.size() != texture.quads.size())
    return bad_texture("does not say of each quad whether it is a hole");
  for (int i = 0; i < n; ++i)
    if (!std::isfinite(texture.v[i]) || !std::isfinite(texture.u[i]))
      return bad_texture("has a parameter that is not finite");
  if (texture.sides.size() != samples.size()) return bad_texture("has not one side for each walk");
  std::vector<char> used(n, 0);
  for (std::size_t w = 0; w < samples.size(); ++w) {
    if (int(texture.sides[w].size()) != samples[w])
      return bad_texture("has not one side vertex for each sample");
    for (int v : texture.sides[w]) {
      if (v < 0 || v >= n) return bad_texture("has a side vertex that does not exist");
      if (used[v]++) return bad_texture("has a vertex twice on its sides");
    }
  }
  std::vector<Directed_edge> edges, border;
  std::fill(used.begin(), used.end(), 0);
  for (const Quad& q : texture.quads)
    for (int i = 0; i < 4; ++i) {
      if (q[i] < 0 || q[i] >= n) return bad_texture("has a quad with a vertex that does not exist");
      used[q[i]] = 1;
      edges.push_back({q[i], q[(i + 1) % 4]});
    }
  if (std::find(used.begin(), used.end(), 0) != used.end()) return bad_texture("has a vertex without a quad");
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return bad_texture("has an edge that two quads pass in the same direction");
  for (const Directed_edge& e : edges)
    if (e[0] == e[1] || !std::binary_search(edges.begin(), edges.end(), Directed_edge{e[1], e[0]}))
      border.push_back(e);
  if (border != side_edges(texture, clockwise)) return bad_texture("has a boundary that is not its sides");
  const int inner_edges = int(edges.size() - border.size()) / 2;
  const int euler = n - inner_edges - int(border.size()) + int(texture.quads.size());
  if (euler != 2 - int(samples.size())) return bad_texture("is not a disc or an annulus as its chart is");
  return {};
}

std::vector<Chart_location> locate(const Chart& chart, const Chart_parameterization& map,
                                   const std::vector<double>& v, const std::vector<double>& u) {
  return Chart_locator(chart, map).locate(v, u);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
