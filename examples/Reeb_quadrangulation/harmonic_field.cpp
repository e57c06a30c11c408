// SPDX-License-Identifier: GPL-3.0-or-later
// A harmonic field on a torus between two points, and then between three: the second solve reuses most of the
// first.
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

RQ::Triangle_surface make_torus(int around, int across) {
  RQ::Triangle_surface torus;
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = turn * i / around, b = turn * j / across, r = 1 + 0.4 * std::cos(b);
      torus.points.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
      const int right = (i + 1) % around * across, here = i * across, up = (j + 1) % across;
      torus.triangles.push_back({here + j, right + j, right + up});
      torus.triangles.push_back({here + j, right + up, here + up});
    }
  return torus;
}

int main() {
  RQ::Triangle_surface torus = make_torus(60, 30);
  if (const RQ::Result<void> connected = torus.connect(); !connected) {
    std::cerr << connected.error().message << '\n';
    return 1;
  }

  RQ::Harmonic_field field(torus);
  field.set_incremental(true);
  const int minimum = 0, maximum = 30 * 30, another_maximum = 15 * 30;
  for (const auto& [vertex, value] : {std::pair(minimum, 0.0), std::pair(maximum, 1.0)})
    if (const RQ::Result<void> set = field.set_constraint(vertex, value); !set) return 1;

  for (const bool with_third : {false, true}) {
    if (with_third && !field.set_constraint(another_maximum, 0.8)) return 1;
    const RQ::Result<std::vector<double>> values = field.solve();
    if (!values) {
      std::cerr << values.error().message << '\n';
      return 1;
    }
    const auto [low, high] = std::minmax_element(values->begin(), values->end());
    std::cout << field.constraints().size() << " constraints: values from " << *low << " to " << *high
              << ", residual below 1e-12: " << (field.residual() < 1e-12 ? "yes" : "no") << '\n';
  }
}
