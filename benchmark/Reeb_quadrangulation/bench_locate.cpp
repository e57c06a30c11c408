// SPDX-License-Identifier: GPL-3.0-or-later
// From (V, U) to the surface: 100,000 points in charts of up to 400,000 triangles, by the package's search
// tree and by a CGAL AABB tree over the same triangles in the plane z = 0. One JSON line each, seconds of
// processor time, best of three.
#include "base/compatibility.h"
#include <CGAL/Reeb_quadrangulation/Chart_locator.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Quad_texture.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace CGAL::Reeb_quadrangulation;

namespace {

double best_of_three(const std::function<void()>& run) {
  double best = 1e9;
  for (int k = 0; k < 3; ++k) {
    const std::clock_t start = std::clock();
    run();
    best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

// A chart and its map by the natural V.
struct Mapped_chart {
  std::shared_ptr<const Chart> chart;
  Chart_parameterization map;
};

// A tube between two boundary loops is one annulus.
Mapped_chart tube(int triangles) {
  const Triangle_surface s = *make_shape("cylinder", triangles);
  Designed_field field;
  field.boundary_is_maximum = {false, true};
  Harmonic_field harmonic(s);
  const std::vector<std::vector<int>> loops = boundary_loops(s);
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (int h : loops[i])
      if (!harmonic.set_constraint(s.source(h), double(i))) std::exit(1);
  field.values = *harmonic.solve();
  const Reeb_layout layout = *make_layout(s, field);
  Mapped_chart mapped{layout.atlas.charts.at(0), *Chart_parameterization::prepare(*layout.atlas.charts[0])};
  if (!mapped.map.solve_columns(*mapped.chart, mapped.map.natural(Side::low), mapped.map.natural(Side::high)))
    std::exit(1);
  return mapped;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;

struct Primitive { // the standard triangle primitive under the name that both versions of CGAL have
  using Id = Triangles::const_iterator;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  Primitive() = default;
  Primitive(Id i) : m_id(i) {}
  Id id() const { return m_id; }
  const Datum& datum() const { return *m_id; }
  const Point& reference_point() const { return (*m_id)[0]; }

private:
  Id m_id;
};

using Tree = CGAL::AABB_tree<internal::Aabb_traits<Kernel, Primitive>>;

// The triangles of a map, once more a turn further where they cross V = 1.
Triangles flat_triangles(const Mapped_chart& mapped) {
  Triangles out;
  for (int f = 0; f < mapped.chart->mesh.number_of_faces(); ++f) {
    const Triangle& t = mapped.chart->mesh.triangles[f];
    std::array<double, 3> v{mapped.map.v()[t[0]], mapped.map.v()[t[1]] + mapped.map.jump(3 * f),
                            mapped.map.v()[t[2]] - mapped.map.jump(3 * f + 2)};
    const double turn = std::floor(std::min({v[0], v[1], v[2]}));
    for (double k : {0.0, 1.0}) {
      std::array<Kernel::Point_3, 3> p;
      for (int i = 0; i < 3; ++i) p[i] = Kernel::Point_3(v[i] - turn - k, mapped.map.u()[t[i]], 0);
      if (k == 0 || std::max({v[0], v[1], v[2]}) - turn >= 1) out.emplace_back(p[0], p[1], p[2]);
    }
  }
  return out;
}

void print(const std::string& method, int triangles, double build, double queries, int lost) {
  std::cout << nlohmann::json{{"benchmark", "locate"}, {"method", method},       {"triangles", triangles},
                              {"points", 100000},      {"build_seconds", build}, {"query_seconds", queries},
                              {"lost", lost}}
                   .dump()
            << std::endl;
}

void measure(int triangles) {
  const Mapped_chart mapped = tube(triangles);
  const int faces = mapped.chart->mesh.number_of_faces();
  // A texture's vertices, disturbed by half an edge.
  std::uint64_t state = 1;
  const auto random = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return double(state >> 11) / 9007199254740992.0;
  };
  std::vector<double> v, u;
  for (int row = 0; row < 250; ++row)
    for (int column = 0; column < 400; ++column) {
      v.push_back((column + random()) / 400);
      u.push_back((row + random()) / 250);
    }

  const double build = best_of_three([&] { Chart_locator(*mapped.chart, mapped.map); });
  const Chart_locator locator(*mapped.chart, mapped.map);
  std::vector<Chart_location> found;
  const double queries = best_of_three([&] { found = locator.locate(v, u); });
  print("nested grids", faces, build, queries,
        int(std::count_if(found.begin(), found.end(), [](auto& l) { return l.face < 0; })));

  const Triangles flat = flat_triangles(mapped);
  const double build_cgal = best_of_three([&] {
    Tree tree(flat.begin(), flat.end());
    tree.build();
  });
  Tree tree(flat.begin(), flat.end());
  tree.build();
  int lost = 0;
  const double queries_cgal = best_of_three([&] {
    lost = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      lost += !tree.any_intersected_primitive(Kernel::Point_3(v[i], u[i], 0)).has_value();
  });
  print("CGAL AABB tree", faces, build_cgal, queries_cgal, lost);
}

} // namespace

int main() {
  for (int triangles : {25000, 100000, 400000}) measure(triangles);
  return 0;
}
