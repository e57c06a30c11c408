// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/design_energy.h>

#include "base/quad_cut.h"

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Sweeps that take the kinks at contours out of the quads; more of them change the order of designs no
// further.
constexpr int sweeps = 3;

// What an inverted quad costs.
constexpr double price_of_inversion = 0.002;

// No two places that are reported lie nearer to each other, in edges.
constexpr double apart = 4;

// Only what lies farther from the quads than so many edges is reported, and at most so many places.
constexpr double far_away = 0.8;
constexpr std::size_t most_places = 8;

double area_of(const Quad_mesh& mesh, const Quad& q) {
  const Point d = mesh.points[q[2]] - mesh.points[q[0]], e = mesh.points[q[3]] - mesh.points[q[1]];
  return 0.5 * d.cross(e).norm();
}

Triangle_surface triangulated(const Quad_mesh& mesh) {
  Triangle_surface surface;
  surface.points = mesh.points;
  for (const Quad& q : mesh.quads) {
    const int c = internal::first_corner_of_cut(mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]],
                                                mesh.points[q[3]]);
    surface.triangles.push_back({q[c], q[c + 1], q[c + 2]});
    surface.triangles.push_back({q[c], q[c + 2], q[(c + 3) % 4]});
  }
  return surface;
}

void add_shapes(const Quad_mesh& mesh, Design_energy& energy) {
  double sum = 0, logarithms = 0, squares = 0;
  double least_area = 0;
  for (const Quad& q : mesh.quads) least_area += area_of(mesh, q);
  least_area *= 1e-6 / double(mesh.quads.size()); // keeps a quad without area from outweighing all others
  for (const Quad& q : mesh.quads) {
    const double jacobian =
        scaled_jacobian(mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]);
    sum += jacobian;
    energy.inverted += jacobian <= 0;
    const double x = std::log(std::max(area_of(mesh, q), least_area));
    logarithms += x;
    squares += x * x;
  }
  const double n = double(mesh.quads.size());
  energy.angle = 1 - sum / n;
  energy.size = std::max(0.0, squares / n - (logarithms / n) * (logarithms / n));
}

std::vector<Far_sample> farthest(std::vector<Far_sample> samples, double edge) {
  samples.erase(std::remove_if(samples.begin(), samples.end(),
                               [](const Far_sample& s) { return s.distance < far_away; }),
                samples.end());
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Far_sample& a, const Far_sample& b) { return a.distance > b.distance; });
  std::vector<Far_sample> places;
  for (const Far_sample& s : samples) {
    const bool near = std::any_of(places.begin(), places.end(), [&](const Far_sample& p) {
      return (p.point - s.point).norm() < apart * edge;
    });
    if (!near) places.push_back(s);
    if (places.size() == most_places) break;
  }
  return places;
}

} // namespace

double Design_energy::total(const Energy_weights& weights) const {
  return weights.shape * shape + weights.farthest * farthest * farthest + weights.angle * angle +
         weights.size * size + weights.vertices * extraordinary + price_of_inversion * inverted;
}

Surface_samples sample_surface(const Triangle_surface& surface, int number) {
  Surface_samples samples;
  const double total = samples.area = area(surface);
  // Faces laid end to end are sampled at equal steps; where in a face a sample lies follows the
  // two-dimensional golden ratio sequence (Roberts, "The unreasonable effectiveness of quasirandom
  // sequences", 2018).
  constexpr double g1 = 0.7548776662466927, g2 = 0.5698402909980532;
  double before = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const double after = before + (total > 0 ? area(surface, f) * number / total : 0);
    for (double i = std::ceil(before - 0.5); i + 0.5 < after; i += 1) {
      double a = g1 * (i + 1), b = g2 * (i + 1);
      a -= std::floor(a);
      b -= std::floor(b);
      if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
      }
      const Triangle& t = surface.triangles[f];
      samples.points.push_back((1 - a - b) * surface.points[t[0]] + a * surface.points[t[1]] +
                               b * surface.points[t[2]]);
      samples.faces.push_back(f);
    }
    before = after;
  }
  return samples;
}

Design_energy design_energy(Stitched_mesh quads, const Surface_projector& projector,
                            const Surface_samples& samples, std::vector<Far_sample>* far,
                            const Energy_bound* bound) {
  Relax_options relaxation;
  relaxation.iterations = sweeps;
  relaxation.more_iterations = 0;
  relaxation.untangle = false;
  const Result<Relax_report> relaxed =
      relax_quads(quads.mesh, projector, std::vector<char>(quads.mesh.points.size(), 0), relaxation);
  CGAL_assertion(bool(relaxed)); // nobody can cancel it
  CGAL_USE(relaxed);
  Design_energy energy;
  add_shapes(quads.mesh, energy);
  for (const auto& [valence, number] : quads.valences)
    if (valence != 4) energy.extraordinary += number;
  const auto is_above = [&] { return bound && energy.total(bound->weights) > bound->most; };
  if (is_above()) return energy;
  const double edge = std::sqrt(samples.area / double(quads.mesh.quads.size()));
  const double part = 1 / double(std::max<std::size_t>(1, samples.points.size()));
  const Triangle_surface surface = triangulated(quads.mesh);
  const Surface_projector onto_quads(surface);
  std::vector<Far_sample> distances;
  distances.reserve(samples.points.size());
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const double d = std::sqrt(onto_quads.closest(samples.points[i]).squared_distance) / edge;
    energy.shape += part * d * d;
    energy.farthest = std::max(energy.farthest, d);
    distances.push_back({samples.points[i], samples.faces[i], d});
    if (is_above()) return energy;
  }
  if (far) *far = farthest(std::move(distances), edge);
  return energy;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
