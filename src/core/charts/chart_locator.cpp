// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Chart_locator.h>

#include "base/plane_quad.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int crowded = 48; // boxes in a cell that gets a grid of its own
constexpr int deepest = 24;
constexpr double most_copies = 16; // of a box in the cells of one grid, on average
constexpr double most_items = 64;  // entries of all cells for each triangle before no more grids are nested

constexpr double infinity = std::numeric_limits<double>::infinity();

double area(double ax, double ay, double bx, double by, double cx, double cy) {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

// Whether p is not to the right of ab: by an exact predicate where the sign of the area is in doubt
// (Shewchuk's static bound).
bool not_right(double ax, double ay, double bx, double by, double px, double py) {
  const double left = (ax - px) * (by - py), right = (ay - py) * (bx - px), det = left - right;
  const double size = std::abs(left) + std::abs(right);
  if (size > 1e-280 && std::abs(det) > 4e-16 * size) return det > 0;
  return internal::orientation({ax, ay}, {bx, by}, {px, py}) >= 0;
}

} // namespace

Point position(const Chart& chart, const Chart_location& location) {
  const Triangle& t = chart.mesh.triangles[location.face];
  return location.weights[0] * chart.mesh.points[t[0]] + location.weights[1] * chart.mesh.points[t[1]] +
         location.weights[2] * chart.mesh.points[t[2]];
}

Chart_locator::Chart_locator(const Chart& chart, const Chart_parameterization& map)
    : m_periodic(chart.kind == Chart_kind::annulus), m_domain{infinity, -infinity, infinity, -infinity},
      m_last_v(-infinity) {
  CGAL_precondition(int(map.v().size()) == chart.mesh.number_of_vertices());
  for (int i = 0; i < chart.mesh.number_of_vertices(); ++i) {
    m_domain.v0 = std::min(m_domain.v0, map.v()[i]);
    m_domain.v1 = std::max(m_domain.v1, map.v()[i]);
    m_domain.u0 = std::min(m_domain.u0, map.u()[i]);
    m_domain.u1 = std::max(m_domain.u1, map.u()[i]);
  }
  if (m_periodic) { // jumps and turns add a few units
    int exponent;
    std::frexp(std::max(std::abs(m_domain.v0), std::abs(m_domain.v1)) + 4, &exponent);
    m_rounding = std::ldexp(1.5, exponent);
  }
  m_triangles.reserve(chart.mesh.triangles.size());
  for (int f = 0; f < chart.mesh.number_of_faces(); ++f) add_triangle(chart, map, f);
  std::vector<int> all(m_triangles.size());
  std::iota(all.begin(), all.end(), 0);
  build_grid({m_periodic ? 0 : m_domain.v0, m_periodic ? m_last_v : m_domain.v1, m_domain.u0, m_domain.u1},
             all, 0);
  gather();
}

void Chart_locator::add_triangle(const Chart& chart, const Chart_parameterization& map, int f) {
  const Triangle& corner = chart.mesh.triangles[f];
  Plane_triangle t{{}, {}, f};
  for (int i = 0; i < 3; ++i) {
    t.v[i] = rounded(map.v()[corner[i]]);
    t.u[i] = map.u()[corner[i]];
  }
  t.v[1] += map.jump(3 * f);
  t.v[2] -= map.jump(3 * f + 2);
  const double turn = m_periodic ? std::floor(*std::min_element(t.v.begin(), t.v.end())) : 0;
  for (double& v : t.v) v -= turn;
  for (int i = 0; i < 3; ++i)
    if (chart.mesh.is_boundary(3 * f + i))
      m_border.push_back({{t.v[i], t.v[(i + 1) % 3]}, {t.u[i], t.u[(i + 1) % 3]}, 3 * f + i});
  if (internal::orientation({t.v[0], t.u[0]}, {t.v[1], t.u[1]}, {t.v[2], t.u[2]}) <= 0) return;
  m_last_v = std::max({m_last_v, t.v[0], t.v[1], t.v[2]});
  m_triangles.push_back(t);
}

// Monotone in v, as every step of the computation is: a point between two others is in a cell between theirs.
int Chart_locator::Grid::column(double v) const {
  return std::clamp(int((v - v0) * columns_per_v), 0, columns - 1);
}

int Chart_locator::Grid::row(double u) const {
  return std::clamp(int((u - u0) * rows_per_u), 0, rows - 1);
}

// A grid over `box` whose cells have the proportions of the mean of `boxes`, about one cell for each of them.
Chart_locator::Grid Chart_locator::fit_grid(const Box& box, const std::vector<Box>& boxes) {
  double width = 0, height = 0; // of all boxes
  for (const Box& b : boxes) {
    width += b.v1 - b.v0;
    height += b.u1 - b.u0;
  }
  const double n = double(boxes.size()), most = std::max(1.0, n);
  const double wide = width > 0 ? n * (box.v1 - box.v0) / width : 1,
               high = height > 0 ? n * (box.u1 - box.u0) / height : 1;
  const double scale = std::sqrt(most / std::max(1.0, wide * high));
  Grid grid{box.v0, box.u0, 0, 0, 1, 1, 0};
  grid.columns = int(std::clamp(wide * scale, 1.0, most));
  grid.rows = int(std::clamp(high * scale, 1.0, most / grid.columns));
  // Some large boxes among many small ones would be in most of the cells: then there are fewer cells.
  for (bool fits = false; !fits;) {
    grid.columns_per_v = box.v1 > box.v0 ? grid.columns / (box.v1 - box.v0) : 0;
    grid.rows_per_u = box.u1 > box.u0 ? grid.rows / (box.u1 - box.u0) : 0;
    double copies = 0;
    for (const Box& b : boxes)
      copies += double(grid.column(b.v1) - grid.column(b.v0) + 1) * (grid.row(b.u1) - grid.row(b.u0) + 1);
    fits = copies <= most_copies * most || grid.columns * grid.rows == 1;
    if (fits) continue;
    grid.columns = (grid.columns + 1) / 2;
    grid.rows = (grid.rows + 1) / 2;
  }
  return grid;
}

// Returns the grid's index.
int Chart_locator::build_grid(const Box& box, const std::vector<int>& items, int depth) {
  std::vector<Box> boxes; // of the items, as far as they are in this one
  boxes.reserve(items.size());
  for (int i : items) {
    const Plane_triangle& t = m_triangles[i];
    const auto [v0, v1] = std::minmax({t.v[0], t.v[1], t.v[2]});
    const auto [u0, u1] = std::minmax({t.u[0], t.u[1], t.u[2]});
    boxes.push_back({std::max(v0, box.v0), std::min(v1, box.v1), std::max(u0, box.u0), std::min(u1, box.u1)});
  }
  Grid grid = fit_grid(box, boxes);
  grid.first = int(m_cells.size());
  const int index = int(m_grids.size()), cells = grid.columns * grid.rows;
  m_grids.push_back(grid);
  m_cells.resize(m_cells.size() + cells);
  const auto for_each_cell = [&](const auto& visit) {
    for (std::size_t k = 0; k < items.size(); ++k) {
      const int c0 = grid.column(boxes[k].v0), c1 = grid.column(boxes[k].v1);
      const int r0 = grid.row(boxes[k].u0), r1 = grid.row(boxes[k].u1);
      for (int r = r0; r <= r1; ++r)
        for (int c = c0; c <= c1; ++c) visit(r * grid.columns + c, items[k]);
    }
  };
  std::vector<int> begin(cells + 1, 0);
  for_each_cell([&](int c, int) { ++begin[c + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> inside(begin.back()), end(begin.begin(), begin.end() - 1);
  for_each_cell([&](int c, int item) { inside[end[c]++] = item; });
  for (int c = 0; c < cells; ++c) {
    const int number = begin[c + 1] - begin[c];
    if (number > crowded && depth < deepest && number < int(items.size()) &&
        double(m_items.size()) < most_items * double(m_triangles.size())) {
      const int row = c / grid.columns, column = c % grid.columns;
      const double dv = (box.v1 - box.v0) / grid.columns, du = (box.u1 - box.u0) / grid.rows;
      const int child = build_grid(
          {box.v0 + column * dv, box.v0 + (column + 1) * dv, box.u0 + row * du, box.u0 + (row + 1) * du},
          {inside.begin() + begin[c], inside.begin() + begin[c + 1]}, depth + 1);
      m_cells[grid.first + c].grid = child;
      continue;
    }
    m_cells[grid.first + c] = {int(m_items.size()), int(m_items.size()) + number, -1};
    m_items.insert(m_items.end(), inside.begin() + begin[c], inside.begin() + begin[c + 1]);
  }
  return index;
}

// Stores the triangles in the order of the cells, so that those of a query lie together.
void Chart_locator::gather() {
  std::vector<int> place(m_triangles.size(), -1);
  std::vector<Plane_triangle> gathered;
  gathered.reserve(m_triangles.size());
  for (int& item : m_items) {
    if (place[item] < 0) {
      place[item] = int(gathered.size());
      gathered.push_back(m_triangles[item]);
    }
    item = place[item];
  }
  m_triangles = std::move(gathered);
}

// The triangle of the smallest face that contains the point; `found` stays where none is smaller than its
// face.
void Chart_locator::find_triangle(double v, double u, const Plane_triangle*& found) const {
  const Cell* cell;
  for (int g = 0; g >= 0; g = cell->grid) {
    const Grid& grid = m_grids[g];
    cell = &m_cells[grid.first + grid.row(u) * grid.columns + grid.column(v)];
  }
  for (int i = cell->begin; i < cell->end; ++i) {
    const Plane_triangle& t = m_triangles[m_items[i]];
    if ((!found || t.face < found->face) && not_right(t.v[0], t.u[0], t.v[1], t.u[1], v, u) &&
        not_right(t.v[1], t.u[1], t.v[2], t.u[2], v, u) && not_right(t.v[2], t.u[2], t.v[0], t.u[0], v, u))
      found = &t;
  }
}

Chart_location Chart_locator::locate(double v, double u) const {
  CGAL_precondition(std::isfinite(v) && std::isfinite(u));
  u = std::clamp(u, m_domain.u0, m_domain.u1);
  v = m_periodic ? rounded(v) : std::clamp(v, m_domain.v0, m_domain.v1);
  if (m_periodic) v -= std::floor(v); // exact after rounding
  const Plane_triangle* t = nullptr;
  double turn = 0; // of the triangle that is found
  for (int k = 0; k == 0 || (m_periodic && v + k <= m_last_v); ++k) {
    const Plane_triangle* before = t;
    find_triangle(v + k, u, t);
    if (t != before) turn = k;
  }
  if (!t) return nearest_on_border(v, u);
  std::array<double, 3> w;
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    w[i] = std::max(0.0, area(v + turn, u, t->v[a], t->u[a], t->v[b], t->u[b]));
  }
  const double sum = w[0] + w[1] + w[2];
  if (!(sum > 0)) return {t->face, {{1.0 / 3, 1.0 / 3, 1.0 / 3}}}; // smaller than numbers can tell
  return {t->face, {{w[0] / sum, w[1] / sum, w[2] / sum}}};
}

std::vector<Chart_location> Chart_locator::locate(const std::vector<double>& v,
                                                  const std::vector<double>& u) const {
  CGAL_precondition(v.size() == u.size());
  std::vector<Chart_location> found;
  found.reserve(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) found.push_back(locate(v[i], u[i]));
  return found;
}

Chart_location Chart_locator::nearest_on_border(double v, double u) const {
  Chart_location nearest;
  double least = infinity;
  for (const Border_edge& e : m_border) {
    const double dv = e.v[1] - e.v[0], du = e.u[1] - e.u[0], length = dv * dv + du * du;
    double x = v;
    if (m_periodic) x += std::round(0.5 * (e.v[0] + e.v[1]) - v);
    const double t = length > 0 ? std::clamp(((x - e.v[0]) * dv + (u - e.u[0]) * du) / length, 0.0, 1.0) : 0;
    const double distance = std::hypot(e.v[0] + t * dv - x, e.u[0] + t * du - u);
    if (!(distance < least)) continue;
    least = distance;
    nearest = {e.halfedge / 3, {{0, 0, 0}}};
    nearest.weights[e.halfedge % 3] = 1 - t;
    nearest.weights[(e.halfedge + 1) % 3] = t;
  }
  return nearest;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
