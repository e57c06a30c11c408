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

Point position(const Chart& chart, const Chart_location& location) {
  const Triangle& t = chart.mesh.triangles[location.face];
  return location.weights[0] * chart.mesh.points[t[0]] + location.weights[1] * chart.mesh.points[t[1]] +
         location.weights[2] * chart.mesh.points[t[2]];
}

namespace {

// A triangle in the plane; on an annulus its V are lifted to follow its first corner.
struct Plane_triangle {
  double v[3], u[3];
};

Plane_triangle plane_triangle(const Chart& chart, const Chart_parameterization& map, int f) {
  const Triangle& t = chart.mesh.triangles[f];
  Plane_triangle p;
  for (int i = 0; i < 3; ++i) {
    p.v[i] = map.v()[t[i]];
    p.u[i] = map.u()[t[i]];
  }
  p.v[1] += map.jump(3 * f);
  p.v[2] -= map.jump(3 * f + 2);
  return p;
}

double area(double ax, double ay, double bx, double by, double cx, double cy) {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

// Moves the location to triangle f if (x, y) lies deeper in it, or less far outside, than `margin`.
void try_triangle(const Plane_triangle& t, int f, double x, double y, double& margin,
                  Chart_location& location) {
  const double a = area(x, y, t.v[1], t.u[1], t.v[2], t.u[2]), b = area(t.v[0], t.u[0], x, y, t.v[2], t.u[2]),
               c = area(t.v[0], t.u[0], t.v[1], t.u[1], x, y), sum = a + b + c;
  if (!(sum > 0)) return;
  const double least = std::min({a, b, c}) / sum;
  if (least <= margin) return;
  margin = least;
  const double wa = std::max(a, 0.0), wb = std::max(b, 0.0), wc = std::max(c, 0.0), w = wa + wb + wc;
  location = {f, {{wa / w, wb / w, wc / w}}};
}

// Buckets of query points on a uniform grid over the parameter domain; V wraps around on an annulus.
class Point_grid {
public:
  Point_grid(const std::vector<double>& v, const std::vector<double>& u, bool periodic, double width,
             double height)
      : m_v(v), m_u(u), m_periodic(periodic) {
    const double n = std::max(1.0, double(v.size()));
    m_columns = std::max(1, std::min(4096, int(std::sqrt(n * width / height))));
    m_rows = std::max(1, std::min(4096, int(n / m_columns)));
    m_column_width = width / m_columns;
    m_row_height = height / m_rows;
    m_begin.assign(m_columns * m_rows + 1, 0);
    for (std::size_t i = 0; i < v.size(); ++i) ++m_begin[cell(i) + 1];
    for (std::size_t c = 0; c + 1 < m_begin.size(); ++c) m_begin[c + 1] += m_begin[c];
    m_item.resize(v.size());
    std::vector<int> end(m_begin.begin(), m_begin.end() - 1);
    for (std::size_t i = 0; i < v.size(); ++i) m_item[end[cell(i)]++] = int(i);
  }

  // Calls `visit(point, shift)` for each point whose V + shift may lie in the box.
  template <class Visit> void query(double v0, double v1, double u0, double u1, const Visit& visit) const {
    const int r0 = row(u0), r1 = row(u1);
    const int c0 = int(std::floor(v0 / m_column_width)), c1 = int(std::floor(v1 / m_column_width));
    for (int c = m_periodic ? c0 : clamp(c0, m_columns); c <= (m_periodic ? c1 : clamp(c1, m_columns)); ++c) {
      const int turn = int(std::floor(double(c) / m_columns)), column = c - turn * m_columns;
      for (int r = r0; r <= r1; ++r)
        for (int k = m_begin[r * m_columns + column]; k < m_begin[r * m_columns + column + 1]; ++k)
          visit(m_item[k], turn);
    }
  }

private:
  static int clamp(int i, int n) { return std::max(0, std::min(n - 1, i)); }
  int row(double u) const { return clamp(int(std::floor(u / m_row_height)), m_rows); }
  int cell(std::size_t i) const {
    return row(m_u[i]) * m_columns + clamp(int(std::floor(m_v[i] / m_column_width)), m_columns);
  }

  const std::vector<double>&m_v, &m_u;
  bool m_periodic;
  int m_columns = 1, m_rows = 1;
  double m_column_width = 1, m_row_height = 1;
  std::vector<int> m_begin, m_item;
};

} // namespace

std::vector<Chart_location> locate(const Chart& chart, const Chart_parameterization& map,
                                   const std::vector<double>& v, const std::vector<double>& u) {
  const bool periodic = chart.kind == Chart_kind::annulus;
  double width = 1, height = 1;
  if (!periodic) {
    width = std::max(1e-300, *std::max_element(map.v().begin(), map.v().end()));
    height = std::max(1e-300, *std::max_element(map.u().begin(), map.u().end()));
  }
  const Point_grid grid(v, u, periodic, width, height);
  std::vector<Chart_location> found(v.size());
  std::vector<double> margin(v.size(),
                             -1e300); // the least barycentric coordinate in the best triangle so far
  // A point may sit on an edge whose triangles both miss it by rounding: boxes are widened by a few units in the last place.
  const double slack = 1e-9;
  for (int f = 0; f < chart.mesh.number_of_faces(); ++f) {
    const Plane_triangle t = plane_triangle(chart, map, f);
    const auto [v0, v1] = std::minmax({t.v[0], t.v[1], t.v[2]});
    const auto [u0, u1] = std::minmax({t.u[0], t.u[1], t.u[2]});
    grid.query(v0 - slack * width, v1 + slack * width, u0 - slack * height, u1 + slack * height,
               [&](int i, int turn) { try_triangle(t, f, v[i] + turn, u[i], margin[i], found[i]); });
  }
  // Outside of all boxes: where a disc's border cuts off a corner of the rectangle. All triangles are tried.
  for (std::size_t i = 0; i < found.size(); ++i)
    for (int f = 0; margin[i] < -slack && f < chart.mesh.number_of_faces(); ++f) {
      const Plane_triangle t = plane_triangle(chart, map, f);
      const double turn = periodic ? std::round((t.v[0] + t.v[1] + t.v[2]) / 3 - v[i]) : 0;
      try_triangle(t, f, v[i] + turn, u[i], margin[i], found[i]);
    }
  for (Chart_location& location : found)
    if (location.face < 0) location = {0, {{1, 0, 0}}}; // every triangle is degenerate in the plane
  return found;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
