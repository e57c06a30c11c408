// SPDX-License-Identifier: GPL-3.0-or-later
// A quad mesh of any origin as the base domain: cutting it into patches, building the locator, and putting in
// a patch that was subdivided. One JSON line each, seconds of processor time.
#include <CGAL/Reeb_quadrangulation/base_domain.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>
#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// A cube of n x n quads a side, blown up to a sphere.
Quad_mesh sphere(int n) {
  Quad_mesh mesh;
  std::map<std::array<int, 3>, int> vertex;
  const auto id = [&](std::array<int, 3> p) {
    const auto [place, added] = vertex.emplace(p, int(mesh.points.size()));
    if (added) mesh.points.push_back((Point(p[0], p[1], p[2]) * 2.0 / n - Point(1, 1, 1)).normalized());
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int x, int y) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = x;
            p[(axis + 2) % 3] = y;
            return id(p);
          };
          Quad q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if (side == 0) std::swap(q[1], q[3]);
          mesh.quads.push_back(q);
        }
  return mesh;
}

template <class F> double seconds(const F& run) {
  const std::clock_t start = std::clock();
  run();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

} // namespace

int main() {
  for (int n : {40, 129, 408}) {
    const Quad_mesh mesh = sphere(n);
    Triangle_surface surface;
    surface.points = mesh.points;
    for (const Quad& q : mesh.quads) {
      surface.triangles.push_back({q[0], q[1], q[2]});
      surface.triangles.push_back({q[0], q[2], q[3]});
    }
    if (!surface.connect()) return 1;
    const Surface_projector projector(surface);
    projector.build();
    Base_domain domain;
    const double cut = seconds([&] { domain = *base_domain(mesh); });
    const double locator = seconds([&] { Base_locator(mesh, domain); });
    const Patch_texture fine = *edit_texture(patch_texture(domain.patches[0]), Subdivide_texture{});
    Textured_base result;
    const double apply = seconds([&] {
      result = *apply_textures(mesh, domain, {{0, fine}}, projector, Relax_options{0, false, 1, 0});
    });
    std::cout << nlohmann::json{{"benchmark", "base"},
                                {"quads", mesh.quads.size()},
                                {"cut_seconds", cut},
                                {"locator_seconds", locator},
                                {"apply_seconds", apply},
                                {"patches", domain.patches.size()},
                                {"quads_after", result.mesh.quads.size()}}
                     .dump()
              << std::endl;
  }
  return 0;
}
