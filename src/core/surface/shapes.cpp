// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <CGAL/Reeb_quadrangulation/decimate.h>

#include "base/pi.h"
#include "surface/shapes_draft.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using shapes::Draft;
using shapes::Implicit_surface;

const int highest_genus = 12;

// How to make a shape: a draft for an edge length, the exact surface, and a map that is applied at the very
// end.
struct Recipe {
  std::function<Draft(double edge_length)> draft;
  shapes::Projection project;
  shapes::Projection bend; // empty if there is none
};

// A part of a body, thick by `radius` around a segment (a point if a == b) ...
struct Rod {
  Point a, b;
  double radius;
};
// ... or around a circle of radius `major` parallel to the xy-plane.
struct Ring {
  Point center;
  double major, radius;
};

double distance(const Rod& rod, const Point& p, Point& gradient) {
  const Point axis = rod.b - rod.a;
  const double squared = axis.squaredNorm();
  const double t = squared > 0 ? std::min(std::max((p - rod.a).dot(axis) / squared, 0.0), 1.0) : 0;
  const Point away = p - (rod.a + t * axis);
  const double length = away.norm();
  gradient = length > 0 ? Point(away / length) : Point(0, 0, 1);
  return length - rod.radius;
}

double distance(const Ring& ring, const Point& p, Point& gradient) {
  const Point q = p - ring.center;
  const double around = std::hypot(q.x(), q.y());
  const double out = around - ring.major, length = std::hypot(out, q.z());
  const Point radial = around > 0 ? Point(q.x() / around, q.y() / around, 0) : Point(1, 0, 0);
  gradient = length > 0 ? Point((out * radial + q.z() * Point::UnitZ()) / length) : Point(0, 0, 1);
  return length - ring.radius;
}

// The smooth union of parts: -1/k log sum exp(-k d_i), with the joints rounded over a length of about 1/k.
template <class Part> Implicit_surface body(const std::vector<Part>& parts, double k, Point low, Point high) {
  double thinnest = parts.front().radius;
  for (const Part& part : parts) thinnest = std::min(thinnest, part.radius);
  const auto value = [parts, k](const Point& p, Point& gradient) {
    std::vector<std::pair<double, Point>> d(parts.size());
    double least = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      d[i].first = distance(parts[i], p, d[i].second);
      least = i == 0 ? d[i].first : std::min(least, d[i].first);
    }
    double sum = 0;
    gradient.setZero();
    for (const auto& [distance_to_part, direction] : d) {
      const double weight = std::exp(-k * (distance_to_part - least));
      sum += weight;
      gradient += weight * direction;
    }
    gradient /= sum;
    return least - std::log(sum) / k;
  };
  return {value, low, high, thinnest};
}

Implicit_surface ellipsoid(const Point& axes) {
  const auto value = [axes](const Point& p, Point& gradient) {
    const Point q = p.cwiseQuotient(axes);
    gradient = 2 * q.cwiseQuotient(axes);
    return q.squaredNorm() - 1;
  };
  return {value, -axes, axes, axes.minCoeff()};
}

Implicit_surface torus_chain(int genus, double minor) {
  // Neighbouring circles of radius 1 touch. Long chains are bent, but never close.
  const double bend = genus < 4 ? 0 : 300.0 / 180 * pi / genus;
  std::vector<Ring> rings;
  Point center(0, 0, 0), low = center, high = center;
  double heading = 0;
  for (int i = 0; i < genus; ++i) {
    rings.push_back({center, 1, minor});
    low = low.cwiseMin(center);
    high = high.cwiseMax(center);
    center += 2 * Point(std::cos(heading), std::sin(heading), 0);
    heading += bend;
  }
  // The union swells by log(parts)/k at most.
  const Point reach(1.2 + minor, 1.2 + minor, 0.2 + minor);
  return body(rings, 15, low - reach, high + reach);
}

Implicit_surface hand() {
  const Point wrist_left(-0.22, 0, -0.75), wrist_right(0.22, 0, -0.75);
  std::vector<Rod> rods{{wrist_left, wrist_right, 0.24}};
  const double x[] = {-0.45, -0.15, 0.15, 0.45}, tip[] = {0.95, 1.25, 1.35, 1.15};
  for (int i = 0; i < 4; ++i) {
    const Point knuckle(x[i], 0, 0.25), wrist(0.5 * x[i], 0, -0.6), end(1.75 * x[i], 0.1 * (i % 2), tip[i]);
    rods.push_back({wrist, knuckle, 0.2});
    rods.push_back({knuckle, end, 0.12});
  }
  const Point thumb(0.75, 0.2, -0.05);
  rods.push_back({wrist_right, thumb, 0.17});
  rods.push_back({thumb, Point(1.1, 0.3, 0.4), 0.14});
  return body(rods, 30, Point(-1.3, -0.6, -1.3), Point(1.6, 0.8, 1.8));
}

Recipe implicit_recipe(const Implicit_surface& shape) {
  const auto draft = [shape](double edge_length) {
    return shapes::polygonize(shape, std::min(1.2 * edge_length, shape.feature_size / 2));
  };
  return {draft, shapes::projection(shape), {}};
}

Recipe cube_recipe(const std::vector<std::array<int, 3>>& cubes, const shapes::Projection& bend = {}) {
  const auto draft = [cubes](double edge_length) {
    return shapes::cube_complex(cubes, std::max(1, int(std::ceil(1 / edge_length))));
  };
  // All planes are at whole numbers: takes back what rounding did while vertices moved inside them.
  const auto snap = [](Point p) {
    for (double& x : p)
      if (std::abs(x - std::round(x)) < 1e-9) x = std::round(x);
    return p;
  };
  return {draft, snap, bend};
}

Recipe cylinder_recipe() {
  const double height = 3;
  const auto draft = [=](double edge_length) {
    return shapes::open_cylinder(height, int(std::ceil(2 * pi / edge_length)),
                                 int(std::ceil(height / edge_length)));
  };
  const auto project = [](const Point& p) {
    const double radius = std::hypot(p.x(), p.y());
    return Point(p.x() / radius, p.y() / radius, p.z());
  };
  return {draft, project, {}};
}

// Half a turn about the axis of the bar [0, 1]^2 x [0, 4].
Point twist(const Point& p) {
  const double angle = pi * p.z() / 4, c = std::cos(angle), s = std::sin(angle);
  return Point(c * (p.x() - 0.5) - s * (p.y() - 0.5), s * (p.x() - 0.5) + c * (p.y() - 0.5), p.z());
}

Recipe recipe(const std::string& name, int genus) {
  if (name == "sphere") return implicit_recipe(ellipsoid(Point(1, 1, 1)));
  if (name == "ellipsoid") return implicit_recipe(ellipsoid(Point(1, 0.7, 2)));
  if (name == "torus") return implicit_recipe(torus_chain(1, 0.4));
  if (name == "hand") return implicit_recipe(hand());
  if (name == "cube") return cube_recipe({{0, 0, 0}});
  if (name == "l-shape") return cube_recipe({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  if (name == "twisted-bar") return cube_recipe({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}}, twist);
  if (name == "cylinder") return cylinder_recipe();
  return implicit_recipe(torus_chain(genus, 0.35));
}

Triangle_surface tetrahedron() {
  return {{Point(1, 1, 1), Point(-1, -1, 1), Point(-1, 1, -1), Point(1, -1, -1)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
          {},
          {}};
}

Triangle_surface octahedron() {
  Triangle_surface s;
  for (int d = 0; d < 3; ++d)
    for (int sign : {1, -1}) s.points.push_back(sign * Point::Unit(d));
  for (int side = 0; side < 8; ++side) {
    const int a = side & 1, b = 2 + (side >> 1 & 1), c = 4 + (side >> 2);
    const bool even = (a + b + c) % 2 == 0;
    s.triangles.push_back(even ? Triangle{a, b, c} : Triangle{a, c, b});
  }
  return s;
}

Result<Triangle_surface> connected(Triangle_surface s) {
  if (Result<void> done = s.connect(); !done) return done.error();
  return s;
}

// Remeshes until the number of triangles is near enough; it reacts smoothly to the edge length.
Triangle_surface remesh_to_count(const Recipe& how, int triangles) {
  const double rough = area(how.draft(0.2).surface);
  // An equilateral triangle has sqrt(3)/4 squared edge lengths; remeshing ends with edges a little below its
  // target.
  double edge_length = 1.05 * std::sqrt(4 / std::sqrt(3.0) * rough / triangles);
  Triangle_surface best;
  double best_error = 0;
  for (int attempt = 0; attempt < 4; ++attempt) {
    Triangle_surface s = shapes::remesh(how.draft(edge_length), edge_length, how.project);
    const double ratio = double(s.number_of_faces()) / triangles, error = std::abs(std::log(ratio));
    if (attempt == 0 || error < best_error) {
      best = std::move(s);
      best_error = error;
    }
    if (best_error < 0.06) break;
    edge_length *= std::sqrt(ratio);
  }
  return best;
}

} // namespace

std::vector<Shape_info> shape_names() {
  return {{"sphere", "the unit sphere", 0, 0},
          {"ellipsoid", "an ellipsoid with semi-axes 1, 0.7 and 2", 0, 0},
          {"torus", "a torus of revolution with radii 1 and 0.4", 1, 0},
          {"bitorus", "two smoothly joined tori", 2, 0},
          {"genus-N", "a chain of N smoothly joined tori, N from 1 to 12", 0, 0},
          {"l-shape", "three unit cubes in the form of an L, with sharp edges", 0, 0},
          {"twisted-bar", "a square bar turned by half a turn, with sharp edges", 0, 0},
          {"cylinder", "a cylinder with two open ends", 0, 2},
          {"hand", "a palm with five fingers", 0, 0},
          {"cube", "the unit cube, with sharp edges", 0, 0},
          {"tetrahedron", "the regular tetrahedron: four triangles", 0, 0},
          {"octahedron", "the regular octahedron: eight triangles", 0, 0}};
}

Result<Shape_info> shape_info(const std::string& name) {
  std::string known;
  for (const Shape_info& shape : shape_names()) {
    if (shape.name == name && name != "genus-N") return shape;
    known += (known.empty() ? "" : ", ") + shape.name;
  }
  for (int genus = 1; genus <= highest_genus; ++genus)
    if (name == "genus-" + std::to_string(genus))
      return Shape_info{name, "a chain of smoothly joined tori", genus, 0};
  return make_error(Error_code::impossible_request, "there is no shape '" + name + "'; there are " + known);
}

Result<Triangle_surface> make_shape(const std::string& name, int triangles) {
  const Result<Shape_info> info = shape_info(name);
  if (!info) return info.error();
  const int least = std::max(400, 100 * info->genus), most = 4000000, remeshed_at_most = 50000;
  if (triangles < least || triangles > most)
    return make_error(Error_code::impossible_request,
                      "the shape '" + name + "' has from " + std::to_string(least) + " to " +
                          std::to_string(most) + " triangles, not " + std::to_string(triangles));
  if (name == "tetrahedron") return connected(tetrahedron());
  if (name == "octahedron") return connected(octahedron());

  const Recipe how = recipe(name, info->genus);
  int rounds = 0, coarse = triangles;
  for (; coarse > remeshed_at_most; coarse = (coarse + 2) / 4) ++rounds;
  Result<Triangle_surface> s = connected(remesh_to_count(how, coarse));
  for (; s && rounds > 0; --rounds) s = connected(shapes::quadrisect(*s, how.project));
  if (s && how.bend)
    for (Point& p : s->points) p = how.bend(p);
  return s;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
