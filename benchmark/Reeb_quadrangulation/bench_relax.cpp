// SPDX-License-Identifier: GPL-3.0-or-later
// Building the projector and relaxing, on a torus of growing size. Seconds of wall clock, best of three.
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

std::vector<Point> torus_points(int m, int n, double shift) {
  std::vector<Point> points;
  const double tau = 2 * std::acos(-1.0);
  std::uint64_t state = 1;
  const auto noise = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return double(state >> 33) / double(1u << 30) - 1;
  };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * (i + shift * noise()) / m, b = tau * (j + shift * noise()) / n;
      points.emplace_back((1 + 0.4 * std::cos(b)) * std::cos(a), (1 + 0.4 * std::cos(b)) * std::sin(a),
                          0.4 * std::sin(b));
    }
  return points;
}

Quad_mesh torus(int m, int n, double shift) {
  Quad_mesh mesh{torus_points(m, n, shift), {}};
  const auto id = [&](int i, int j) { return (i % m) * n + j % n; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      mesh.quads.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
  return mesh;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

int main() {
  for (const auto& [triangles, quads] :
       {std::pair(20000, 3000), std::pair(400000, 3000), std::pair(400000, 20000), std::pair(1000000, 3000),
        std::pair(1000000, 20000)}) {
    const auto sides = [](int faces) {
      return std::pair(int(std::sqrt(2.0 * faces)), int(std::sqrt(0.5 * faces)));
    };
    const auto [m, n] = sides(triangles / 2);
    Triangle_surface input;
    for (const Quad& q : torus(m, n, 0.2).quads) {
      input.triangles.push_back({q[0], q[1], q[2]});
      input.triangles.push_back({q[0], q[2], q[3]});
    }
    input.points = torus_points(m, n, 0.2);
    if (!input.connect()) return 1;
    const auto [k, l] = sides(quads);
    double build = 1e9, relax = 1e9;
    Relax_report report;
    for (int run = 0; run < 3; ++run) {
      Quad_mesh mesh = torus(k, l, 0.35);
      auto start = std::chrono::steady_clock::now();
      const Surface_projector projector(input);
      projector.build();
      build = std::min(build, seconds_since(start));
      start = std::chrono::steady_clock::now();
      const auto result = relax_quads(mesh, projector);
      relax = std::min(relax, seconds_since(start));
      if (!result) return 1;
      report = *result;
    }
    std::cout << nlohmann::json{{"benchmark", "relax"},
                                {"triangles", input.number_of_faces()},
                                {"quads", k * l},
                                {"build_s", build},
                                {"relax_s", relax},
                                {"mean_before", report.mean_before},
                                {"mean_after", report.mean_after},
                                {"inverted_before", report.inverted_before},
                                {"inverted_after", report.inverted_after}}
                     .dump()
              << "\n";
  }
  return 0;
}
