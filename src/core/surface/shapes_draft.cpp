// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/shapes_draft.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace shapes {

Projection projection(const Implicit_surface& shape) {
  return [shape](Point p) {
    // Quadratic convergence: from a fraction of the feature size, six steps end at rounding.
    for (int i = 0; i < 8; ++i) {
      Point gradient(0, 0, 0);
      const double value = shape.value(p, gradient), squared = gradient.squaredNorm();
      if (!(squared > 0)) break;
      const Point step = gradient * (value / squared);
      p -= step;
      if (step.squaredNorm() < 1e-30 * shape.feature_size * shape.feature_size) break;
    }
    return p;
  };
}

namespace {

// Values and shaken positions at the corners of a cubic grid. A corner's number is i + n0 (j + n1 k).
class Grid {
public:
  Grid(const Implicit_surface& shape, double spacing) {
    const Point margin = Point::Constant(1.5 * spacing), low = shape.low - margin;
    for (int d = 0; d < 3; ++d) m_size[d] = int(std::ceil((shape.high[d] - low[d]) / spacing)) + 3;
    Random_sequence random;
    Point gradient;
    for (int k = 0; k < m_size[2]; ++k)
      for (int j = 0; j < m_size[1]; ++j)
        for (int i = 0; i < m_size[0]; ++i) {
          Point p(i, j, k);
          for (int d = 0; d < 3; ++d) p[d] += 0.15 * random.next();
          m_position.push_back(low + spacing * p);
          m_value.push_back(shape.value(m_position.back(), gradient));
        }
  }

  int size(int dimension) const { return m_size[dimension]; }
  int corner(int i, int j, int k) const { return i + m_size[0] * (j + m_size[1] * k); }
  bool is_inside(int c) const { return m_value[c] < 0; }

  // Where the surface crosses the segment between two corners of different sides.
  Point crossing(int a, int b) const {
    const double t = m_value[a] / (m_value[a] - m_value[b]);
    return m_position[a] + std::min(std::max(t, 0.05), 0.95) * (m_position[b] - m_position[a]);
  }

private:
  std::array<int, 3> m_size{};
  std::vector<Point> m_position;
  std::vector<double> m_value;
};

using Crossing = std::pair<int, int>; // grid corners, the smaller first

// Appends the triangles of one tetrahedron, given positively oriented, outward normals towards positive
// values.
void march_tetrahedron(const Grid& grid, std::array<int, 4> corner,
                       std::vector<std::array<Crossing, 3>>& out) {
  // Bring the inside corners to the front; every exchange reverses the orientation.
  bool reversed = false;
  for (int i = 0; i < 4; ++i)
    for (int j = 3; j > 0; --j)
      if (grid.is_inside(corner[j]) && !grid.is_inside(corner[j - 1])) {
        std::swap(corner[j], corner[j - 1]);
        reversed = !reversed;
      }
  const int inside =
      int(std::count_if(corner.begin(), corner.end(), [&](int c) { return grid.is_inside(c); }));
  const auto cross = [&](int i, int j) { return Crossing(std::minmax(corner[i], corner[j])); };
  const auto add = [&](Crossing a, Crossing b, Crossing c) {
    if (reversed) std::swap(b, c);
    out.push_back({a, b, c});
  };
  if (inside == 1) add(cross(0, 1), cross(0, 2), cross(0, 3));
  if (inside == 2) {
    add(cross(0, 2), cross(0, 3), cross(1, 3));
    add(cross(0, 2), cross(1, 3), cross(1, 2));
  }
  if (inside == 3) add(cross(3, 0), cross(3, 1), cross(3, 2));
}

// The six tetrahedra around the main diagonal of a cube: one for each order of the three steps.
void march_cube(const Grid& grid, int i, int j, int k, std::vector<std::array<Crossing, 3>>& out) {
  std::array<int, 3> order{0, 1, 2};
  do {
    std::array<int, 3> at{i, j, k};
    std::array<int, 4> corner{grid.corner(i, j, k), 0, 0, 0};
    for (int step = 0; step < 3; ++step) {
      ++at[order[step]];
      corner[step + 1] = grid.corner(at[0], at[1], at[2]);
    }
    const bool even = (order[1] - order[0] + 3) % 3 == 1;
    if (!even) std::swap(corner[2], corner[3]);
    march_tetrahedron(grid, corner, out);
  } while (std::next_permutation(order.begin(), order.end()));
}

} // namespace

Draft polygonize(const Implicit_surface& shape, double spacing) {
  const Grid grid(shape, spacing);
  std::vector<std::array<Crossing, 3>> faces;
  for (int k = 0; k + 1 < grid.size(2); ++k)
    for (int j = 0; j + 1 < grid.size(1); ++j)
      for (int i = 0; i + 1 < grid.size(0); ++i) {
        int inside = 0;
        for (int c = 0; c < 8; ++c)
          inside += grid.is_inside(grid.corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)));
        if (inside > 0 && inside < 8) march_cube(grid, i, j, k, faces);
      }
  std::vector<Crossing> crossings;
  for (const auto& face : faces) crossings.insert(crossings.end(), face.begin(), face.end());
  std::sort(crossings.begin(), crossings.end());
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());

  Draft draft;
  for (const Crossing& c : crossings) draft.surface.points.push_back(grid.crossing(c.first, c.second));
  for (const auto& face : faces) {
    Triangle t{};
    for (int i = 0; i < 3; ++i)
      t[i] = int(std::lower_bound(crossings.begin(), crossings.end(), face[i]) - crossings.begin());
    draft.surface.triangles.push_back(t);
  }
  return draft;
}

namespace {

using Cell = std::array<int, 3>;

// Adds the m x m cells of one square: `corner` in unit cubes, `u` and `v` its directions, u x v pointing
// outwards.
class Square_lattice {
public:
  explicit Square_lattice(int m) : m_m(m) {}

  void add(const Cell& corner, int u, int v, Draft& draft) {
    for (int j = 0; j < m_m; ++j)
      for (int i = 0; i < m_m; ++i) {
        const int a = vertex(corner, u, v, i, j, draft), b = vertex(corner, u, v, i + 1, j, draft);
        const int c = vertex(corner, u, v, i + 1, j + 1, draft), d = vertex(corner, u, v, i, j + 1, draft);
        const bool slash = m_random.next() < 0;
        draft.surface.triangles.push_back(slash ? Triangle{a, b, c} : Triangle{a, b, d});
        draft.surface.triangles.push_back(slash ? Triangle{a, c, d} : Triangle{b, c, d});
      }
  }

private:
  int vertex(const Cell& corner, int u, int v, int i, int j, Draft& draft) {
    Cell key{m_m * corner[0], m_m * corner[1], m_m * corner[2]};
    key[u] += i;
    key[v] += j;
    const auto [it, is_new] = m_vertex.try_emplace(key, int(draft.surface.points.size()));
    if (is_new) draft.surface.points.emplace_back(Point(key[0], key[1], key[2]) / m_m);
    return it->second;
  }

  int m_m;
  Random_sequence m_random;
  std::map<Cell, int> m_vertex;
};

Point normal(const Triangle_surface& s, int f) {
  const Triangle& t = s.triangles[f];
  return (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
}

// Moves the vertices that are on no crease by up to a third of a cell, along the plane of their faces.
void shake(Draft& draft, double cell) {
  Triangle_surface& s = draft.surface;
  std::vector<char> fixed(s.points.size(), 0);
  for (const auto& [a, b] : draft.creases) fixed[a] = fixed[b] = 1;
  Random_sequence random;
  for (int v = 0; v < s.number_of_vertices(); ++v) {
    const Point n = normal(s, s.outgoing[v] / 3).normalized();
    Point step;
    for (double& x : step) x = random.next();
    step -= n.dot(step) * n;
    if (!fixed[v]) s.points[v] += cell / 3 * step;
  }
}

} // namespace

Draft cube_complex(const std::vector<Cell>& cubes, int m) {
  Draft draft;
  Square_lattice lattice(m);
  for (const Cell& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Cell other = cube, corner = cube;
        other[axis] += 2 * side - 1;
        if (std::find(cubes.begin(), cubes.end(), other) != cubes.end()) continue;
        corner[axis] += side;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        lattice.add(corner, side ? u : v, side ? v : u, draft);
      }
  Triangle_surface& s = draft.surface;
  if (!s.connect()) return {};
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if (s.edge(h) == h && normal(s, h / 3).dot(normal(s, s.opposite[h] / 3)) <= 0)
      draft.creases.emplace_back(s.source(h), s.target(h));
  shake(draft, 1.0 / m);
  return draft;
}

Draft open_cylinder(double height, int m, int rings) {
  Draft draft;
  Triangle_surface& s = draft.surface;
  const double turn = 2 * std::acos(-1.0) / m;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < m; ++i)
      s.points.emplace_back(std::cos(turn * i), std::sin(turn * i), height * j / rings);
  Random_sequence random;
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < m; ++i) {
      const int a = j * m + i, b = j * m + (i + 1) % m, c = b + m, d = a + m;
      const bool slash = random.next() < 0;
      s.triangles.push_back(slash ? Triangle{a, b, c} : Triangle{a, b, d});
      s.triangles.push_back(slash ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  for (int i = 0; i < m; ++i) {
    draft.creases.emplace_back(i, (i + 1) % m);
    draft.creases.emplace_back(rings * m + i, rings * m + (i + 1) % m);
  }
  if (!s.connect()) return {};
  shake(draft, turn);
  return draft;
}

Triangle_surface quadrisect(const Triangle_surface& surface, const Projection& project) {
  Triangle_surface fine;
  fine.points = surface.points;
  std::vector<int> middle(surface.number_of_halfedges(), -1);
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    if (surface.edge(h) != h) continue;
    middle[h] = int(fine.points.size());
    fine.points.push_back(
        project((surface.points[surface.source(h)] + surface.points[surface.target(h)]) / 2));
  }
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const Triangle& t = surface.triangles[f];
    int m[3];
    for (int i = 0; i < 3; ++i) m[i] = middle[surface.edge(3 * f + i)];
    fine.triangles.insert(fine.triangles.end(),
                          {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
  }
  return fine;
}

} // namespace shapes
} // namespace Reeb_quadrangulation
} // namespace CGAL
