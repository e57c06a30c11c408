// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/find_mirror_planes.h>

#include <CGAL/Reeb_quadrangulation/halve_surface.h>

#include "base/place.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int most_vertices = 20000, area_points = 2000, refining_points = 600;
constexpr int most_rounds = 60;

// As fractions of the diagonal: planes whose mean deviations differ by less are equally good.
constexpr double as_good = 1e-4, rounding = 1e-6;

// What 0 and the middle of the box are worth as places of a plane, in parts of the mean deviation.
constexpr double worth_of_middle = 0.9;

struct Shape {
  Point low = Point::Zero(), high = Point::Zero(), centroid = Point::Zero();
  double diagonal = 0;
  std::array<Eigen::Vector3d, 3> axes; ///< of inertia
};

Shape shape_of(const Triangle_surface& s) {
  Shape shape;
  shape.low = shape.high = s.points[std::size_t(s.triangles[0][0])];
  double total = 0;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  const Point origin = shape.low;
  for (int f = 0; f < s.number_of_faces(); ++f) {
    const double a = area(s, f);
    Point sum = Point::Zero();
    for (int v : s.triangles[std::size_t(f)]) {
      const Point& p = s.points[std::size_t(v)];
      shape.low = shape.low.cwiseMin(p);
      shape.high = shape.high.cwiseMax(p);
      sum += p - origin;
      moments += a / 12 * (p - origin) * (p - origin).transpose();
    }
    moments += a / 12 * sum * sum.transpose();
    shape.centroid += a / 3 * sum;
    total += a;
  }
  shape.diagonal = (shape.high - shape.low).norm();
  if (total > 0) shape.centroid /= total;
  const Eigen::Matrix3d central = moments - total * shape.centroid * shape.centroid.transpose();
  shape.centroid += origin;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(central);
  for (int k = 0; k < 3; ++k) shape.axes[std::size_t(k)] = solver.eigenvectors().col(k);
  return shape;
}

// Points at equal steps of the area, each in the middle of a face.
std::vector<Point> spread_points(const Triangle_surface& s, int number) {
  const double step = area(s) / number;
  std::vector<Point> points;
  double next = 0.5 * step, sum = 0;
  for (int f = 0; f < s.number_of_faces() && int(points.size()) < number; ++f) {
    sum += area(s, f);
    const Triangle& t = s.triangles[std::size_t(f)];
    // A large face has several: they go round its middle.
    for (int i = 0; next < sum && int(points.size()) < number; ++i, next += step) {
      const double a = i % 3 == 0 ? 1.0 / 3 : i % 3 == 1 ? 0.6 : 0.2, b = i % 3 == 2 ? 0.6 : (1 - a) / 2;
      points.push_back(a * s.points[std::size_t(t[0])] + b * s.points[std::size_t(t[1])] +
                       (1 - a - b) * s.points[std::size_t(t[2])]);
    }
  }
  return points;
}

class Mirror_finder {
public:
  Mirror_finder(const Surface_projector& projector, const Observer* observer)
      : m_projector(projector), m_observer(observer), m_shape(shape_of(projector.surface())),
        m_points(spread_points(projector.surface(), refining_points)) {}

  const Shape& shape() const { return m_shape; }

  // Across an axis of coordinates, at the best place that leaves two halves: through 0 or the middle of the
  // box if that is as good.
  Mirror_plane across(int axis) const {
    Mirror_plane plane{m_shape.centroid, Eigen::Vector3d::Unit(axis)};
    refine(plane, false);
    std::vector<std::pair<double, double>> places; // mean deviation, less a bonus, and coordinate
    const double middle = 0.5 * (m_shape.low[axis] + m_shape.high[axis]);
    for (const double c : {0.0, middle, plane.point[axis], m_shape.centroid[axis]}) {
      if (std::abs(c - plane.point[axis]) > 1e-2 * m_shape.diagonal) continue;
      Mirror_plane other = plane;
      other.point[axis] = c;
      const double mean = mean_of(other);
      places.emplace_back(c == plane.point[axis] ? mean : worth_of_middle * mean - rounding, c);
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& p, const auto& q) { return p.first < q.first; });
    plane.point[axis] = places.front().second;
    for (const auto& place : places) {
      Mirror_plane other = plane;
      other.point[axis] = place.second;
      if (halve_surface(m_projector.surface(), other)) return other;
    }
    return plane;
  }

  // Any plane near one that is given.
  Mirror_plane near(Mirror_plane plane) const {
    refine(plane, true);
    return plane;
  }

  double mean_of(const Mirror_plane& plane) const {
    double sum = 0;
    for (const Point& p : m_points)
      sum += std::sqrt(m_projector.closest(plane.reflected(p)).squared_distance);
    return sum / (double(m_points.size()) * m_shape.diagonal);
  }

  bool cancelled() const { return m_observer && m_observer->cancelled(); }

private:
  // Of all planes the one that brings points nearest to the partners that they have now.
  Mirror_plane fitted(const Mirror_plane& plane) const {
    Point mean_p = Point::Zero(), mean_q = Point::Zero();
    std::vector<Point> partners;
    for (const Point& p : m_points) {
      partners.push_back(m_projector.closest(plane.reflected(p)).point);
      mean_p += p / double(m_points.size());
      mean_q += partners.back() / double(m_points.size());
    }
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < partners.size(); ++i)
      sum += (m_points[i] - mean_p) * (partners[i] - mean_q).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum + sum.transpose());
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    return {0.5 * (mean_p + mean_q), normal.dot(plane.normal) < 0 ? Eigen::Vector3d(-normal) : normal};
  }

  // A step of Newton's method: partners may slide in the planes of their faces. Only along the normal, unless
  // the plane may turn.
  Mirror_plane slid(const Mirror_plane& plane, bool turn) const {
    const Eigen::Vector3d &n = plane.normal, side = n.unitOrthogonal(), other = n.cross(side);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Point& p : m_points) {
      const Point image = plane.reflected(p), from = p - plane.point;
      const Closest_point near = m_projector.closest(image);
      const Eigen::Vector3d m = m_projector.normal(near.face);
      const double height = plane.signed_distance(p), along = m.dot(n);
      Eigen::Vector3d row(2 * along, 0, 0); // by the plane's way along its normal, then by its two turns
      if (turn)
        for (int k = 0; k < 2; ++k) {
          const Eigen::Vector3d& axis = k == 0 ? side : other;
          row[k + 1] = -2 * (axis.dot(from) * along + height * m.dot(axis));
        }
      matrix += row * row.transpose();
      right += m.dot(near.point - image) * row;
    }
    const Eigen::Vector3d step = matrix.completeOrthogonalDecomposition().solve(right);
    return {plane.point + step[0] * n, (n + step[1] * side + step[2] * other).normalized()};
  }

  void refine(Mirror_plane& plane, bool turn) const {
    double best = mean_of(plane);
    for (int round = 0; round < most_rounds && !cancelled(); ++round) {
      Mirror_plane next = slid(plane, turn);
      double mean = mean_of(next);
      if (turn && !(mean < best)) {
        next = fitted(plane);
        mean = mean_of(next);
      }
      if (!(mean < best * (1 - 1e-3))) return;
      plane = next;
      best = mean;
    }
  }

  const Surface_projector& m_projector;
  const Observer* m_observer;
  Shape m_shape;
  std::vector<Point> m_points;
};

double curve_length(const Triangle_surface& s, const Mirror_plane& plane) {
  double length = 0;
  for (const Triangle& t : s.triangles) {
    Point ends[3];
    int number = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &a = s.points[std::size_t(t[i])], &b = s.points[std::size_t(t[(i + 1) % 3])];
      const double da = plane.signed_distance(a), db = plane.signed_distance(b);
      if ((da < 0) != (db < 0)) ends[number++] = a + da / (da - db) * (b - a);
    }
    if (number == 2) length += (ends[1] - ends[0]).norm();
  }
  return length;
}

// A plane that turned a little away from an axis is the same as the one across it.
bool is_same(const Mirror_plane& a, const Mirror_plane& b, const Shape& shape) {
  return std::abs(a.normal.dot(b.normal)) > 1 - 1e-4 &&
         std::abs(a.signed_distance(b.projected(shape.centroid))) < 1e-2 * shape.diagonal;
}

std::string percent(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * x);
  return text;
}

Error not_symmetric(const Found_mirror& found, double tolerance, const char* which) {
  return make_error(Error_code::impossible_request,
                    "the surface is not symmetric: mirrored in the " + std::string(which) + " " +
                        to_text(found.plane) + ", it lies up to " + percent(found.deviation.largest) +
                        " of its diagonal away from itself, near " + place(found.deviation.at) +
                        "; at most " + percent(tolerance) + " is allowed");
}

// The candidates, better ones first where two are the same.
std::vector<Mirror_plane> candidates(const Mirror_finder& finder) {
  std::vector<Mirror_plane> planes;
  for (int axis = 0; axis < 3; ++axis) planes.push_back(finder.across(axis));
  for (int axis = 0; axis < 3; ++axis)
    planes.push_back(finder.near({finder.shape().centroid, Eigen::Vector3d::Unit(axis)}));
  for (const Eigen::Vector3d& axis : finder.shape().axes)
    planes.push_back(finder.near({finder.shape().centroid, axis}));
  return planes;
}

// Lengths that differ by about a percent are equal.
long rounded_length(const Found_mirror& m) {
  return std::lround(100 * std::log(m.curve_length));
}

std::vector<Found_mirror> best_first(const Surface_projector& projector, const Mirror_finder& finder) {
  std::vector<Found_mirror> found;
  for (const Mirror_plane& plane : candidates(finder)) {
    if (finder.cancelled()) break;
    Found_mirror mirror{plane, mirror_deviation(projector, plane), curve_length(projector.surface(), plane)};
    if (!(mirror.curve_length > 0)) continue; // a plane through the middle that misses the surface
    const auto same = std::find_if(found.begin(), found.end(), [&](const Found_mirror& other) {
      return is_same(other.plane, plane, finder.shape());
    });
    if (same == found.end())
      found.push_back(mirror);
    else if (mirror.deviation.mean < 0.8 * same->deviation.mean - as_good)
      *same = mirror;
  }
  if (found.empty()) return found;
  const auto mean = [](const Found_mirror& m) { return m.deviation.mean; };
  double best = mean(found.front());
  for (const Found_mirror& m : found) best = std::min(best, mean(m));
  const auto good = std::stable_partition(
      found.begin(), found.end(), [&](const Found_mirror& m) { return mean(m) <= 2 * best + as_good; });
  std::stable_sort(found.begin(), good, [](const Found_mirror& a, const Found_mirror& b) {
    if ((a.plane.axis() < 0) != (b.plane.axis() < 0)) return b.plane.axis() < 0;
    return rounded_length(a) < rounded_length(b);
  });
  std::stable_sort(good, found.end(),
                   [&](const Found_mirror& a, const Found_mirror& b) { return mean(a) < mean(b); });
  std::stable_partition(found.begin(), found.end(), [&](const Found_mirror& m) {
    return bool(halve_surface(projector.surface(), m.plane));
  });
  return found;
}

} // namespace

Mirror_deviation mirror_deviation(const Surface_projector& projector, const Mirror_plane& plane) {
  const Triangle_surface& s = projector.surface();
  const double diagonal = shape_of(s).diagonal;
  Mirror_deviation result;
  const auto see = [&](const Point& p) {
    const double d = std::sqrt(projector.closest(plane.reflected(p)).squared_distance) / diagonal;
    if (d > result.largest) {
      result.largest = d;
      result.at = p;
    }
    return d;
  };
  const int step = 1 + (s.number_of_vertices() - 1) / most_vertices;
  for (int v = 0; v < s.number_of_vertices(); v += step)
    if (s.outgoing[std::size_t(v)] >= 0) see(s.points[std::size_t(v)]);
  const std::vector<Point> points = spread_points(s, area_points);
  for (const Point& p : points) result.mean += see(p) / double(points.size());
  return result;
}

std::vector<Found_mirror> find_mirror_planes(const Surface_projector& projector, double tolerance,
                                             const Observer* observer) {
  std::vector<Found_mirror> found = best_first(projector, Mirror_finder(projector, observer));
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const Found_mirror& m) { return !(m.deviation.largest <= tolerance); }),
              found.end());
  for (Found_mirror& m : found) m.plane = Mirror_grid(m.plane, projector.surface().points).plane();
  return found;
}

namespace {

Result<Found_mirror> best_mirror(const Surface_projector& projector, double tolerance,
                                 const Observer* observer) {
  const std::vector<Found_mirror> all = best_first(projector, Mirror_finder(projector, observer));
  if (all.empty()) return make_error(Error_code::cancelled, "the search of mirror planes was cancelled");
  for (const Found_mirror& m : all)
    if (m.deviation.largest <= tolerance) return m;
  const auto least = std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.deviation.largest < b.deviation.largest;
  });
  return not_symmetric(*least, tolerance, "best plane,");
}

} // namespace

Result<Found_mirror> choose_mirror(const Surface_projector& projector, const Mirror_request& request,
                                   const Observer* observer) {
  if (!(request.tolerance >= 0 && request.tolerance <= 1))
    return make_error(Error_code::impossible_request, "the tolerance of a mirror lies between 0 and 1");
  Found_mirror found;
  if (request.choice == Mirror_choice::best) {
    Result<Found_mirror> best = best_mirror(projector, request.tolerance, observer);
    if (!best) return best;
    found = *best;
  } else if (request.choice == Mirror_choice::given) {
    if (!request.plane.point.allFinite() || !request.plane.normal.allFinite() ||
        request.plane.normal.isZero(0))
      return make_error(Error_code::impossible_request, "the plane of the mirror has no normal");
    found.plane = request.plane;
  } else {
    const int axis = int(request.choice) - int(Mirror_choice::across_x);
    found.plane = Mirror_finder(projector, observer).across(axis);
  }
  if (request.is_turned) found.plane.normal = -found.plane.normal;
  found.plane = Mirror_grid(found.plane, projector.surface().points).plane();
  found.deviation = mirror_deviation(projector, found.plane);
  found.curve_length = curve_length(projector.surface(), found.plane);
  if (!(found.deviation.largest <= request.tolerance))
    return not_symmetric(found, request.tolerance, "plane");
  return found;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
