// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/area_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

// A point of the searched surface, and the nearest triangle of the other.
struct Place {
  Point point;
  int nearest = -1;
  double distance = 0;
};

// A triangle or a part of one.
struct Part {
  std::array<Place, 3> corner;
  double bound = 0;
  bool operator<(const Part& other) const { return bound < other.bound; }
};

class Search {
public:
  Search(const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Triangle_tree& to,
         const Distance_precision& precision, const Observer* observer)
      : m_points(points), m_triangles(triangles), m_to(to), m_precision(precision), m_observer(observer) {}

  bool measure(std::vector<Area_sample>& samples) {
    double sum = 0;
    int last = -1;
    for (Area_sample& sample : samples) {
      if (cancelled()) return false;
      const Place place = look_up(sample.point, last);
      sample.nearest = last = place.nearest;
      sample.distance = place.distance;
      sum += place.distance;
    }
    m_result.mean = samples.empty() ? 0 : sum / double(samples.size());
    return true;
  }

  bool run() {
    if (!scan()) return false;
    const std::int64_t last = m_queries + m_precision.queries;
    while (!m_open.empty() && !is_settled(m_open.top().bound)) {
      if (cancelled()) return false;
      if (m_queries >= last) break;
      const Part part = m_open.top();
      m_open.pop();
      halve(part);
    }
    m_result.bound = std::max(m_result.maximum, m_settled);
    if (!m_open.empty()) m_result.bound = std::max(m_result.bound, m_open.top().bound);
    return true;
  }

  const Area_distance& result() const { return m_result; }

private:
  bool cancelled() { return m_observer && ++m_steps % 1024 == 0 && m_observer->cancelled(); }

  // A triangle that is nearer than `enough` will do. \pre `enough` is not above the maximum found so far
  Place look_up(const Point& p, int hint, double enough = -1) {
    ++m_queries;
    const Triangle_tree::Nearest nearest = m_to.nearest(p, hint, enough > 0 ? enough * enough : -1);
    const Place place{p, nearest.triangle, std::sqrt(nearest.squared_distance)};
    if (place.distance > m_result.maximum || m_queries == 1) {
      m_result.maximum = place.distance;
      m_result.at = p;
    }
    return place;
  }

  double distance(const Point& p, int triangle) const {
    return std::sqrt(m_to.squared_distance(p, triangle));
  }

  double good_enough() const {
    return std::max((1 + m_precision.relative) * m_result.maximum, m_precision.absolute);
  }

  bool is_settled(double bound) {
    if (bound > good_enough()) return false;
    m_settled = std::max(m_settled, bound);
    return true;
  }

  // Most triangles are settled by one triangle of the other surface that is near to a corner or to the
  // triangle before.
  bool scan() {
    std::vector<Place> places(m_points.size());
    int near = -1;
    for (const Triangle& t : m_triangles) {
      if (cancelled()) return false;
      for (int v : t)
        if (places[v].nearest >= 0) near = places[v].nearest;
      if (near >= 0 && is_settled(std::max({distance(m_points[t[0]], near), distance(m_points[t[1]], near),
                                            distance(m_points[t[2]], near)})))
        continue;
      Part part;
      for (int i = 0; i < 3; ++i) {
        Place& place = places[t[i]];
        if (place.nearest < 0) place = look_up(m_points[t[i]], near, 0.5 * m_result.maximum);
        near = place.nearest;
        part.corner[i] = place;
      }
      add(part);
    }
    return true;
  }

  void add(Part& part) {
    part.bound = bound(part.corner);
    if (!is_settled(part.bound)) m_open.push(part);
  }

  void halve(const Part& part) {
    int longest = 0;
    double length = -1;
    for (int i = 0; i < 3; ++i) {
      const double side = (part.corner[(i + 1) % 3].point - part.corner[i].point).squaredNorm();
      if (side > length) {
        length = side;
        longest = i;
      }
    }
    const Place &a = part.corner[longest], &b = part.corner[(longest + 1) % 3],
                &c = part.corner[(longest + 2) % 3];
    const Place middle = look_up(0.5 * (a.point + b.point), a.nearest, 0.5 * m_result.maximum);
    for (const Place* end : {&a, &b}) {
      Part half;
      half.corner = {*end, middle, c};
      // A half has no point that the whole has not.
      half.bound = std::min(part.bound, bound(half.corner));
      if (!is_settled(half.bound)) m_open.push(half);
    }
  }

  double bound(const std::array<Place, 3>& c) const {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const Place &p = c[i], &q = c[(i + 1) % 3], &r = c[(i + 2) % 3];
      best =
          std::min(best, std::max({p.distance, distance(q.point, p.nearest), distance(r.point, p.nearest)}));
      best = std::min(best, p.distance + std::sqrt(std::max((q.point - p.point).squaredNorm(),
                                                            (r.point - p.point).squaredNorm())));
    }
    if (best <= good_enough()) return best;
    for (int i = 0; i < 3; ++i)
      if (c[i].nearest == c[(i + 1) % 3].nearest)
        return std::min(best, bound_by_two(c[i], c[(i + 1) % 3], c[(i + 2) % 3]));
    return std::min(best, bound_by_three(c));
  }

  // Where on the segment from p to q the nearest triangles of both are about equally far, and how far; how
  // far is all that matters, and only if it is good enough: infinitely, as soon as it is clear that it is
  // not.
  std::pair<Point, double> between(const Place& p, const Place& q) const {
    const double enough = good_enough(), length = (q.point - p.point).norm();
    double low = 0, high = 1;
    for (int i = 0; i < 12; ++i) {
      const double t = 0.5 * (low + high);
      const Point x = p.point + t * (q.point - p.point);
      const double first = distance(x, p.nearest), second = distance(x, q.nearest);
      if (std::max(first, second) <= enough) return {x, std::max(first, second)};
      if (std::min(first, second) - 0.5 * (high - low) * length > enough) break;
      (first < second ? low : high) = t;
    }
    return {p.point, infinity};
  }

  // p and q have the same nearest triangle: cut off the corner r.
  double bound_by_two(const Place& p, const Place& q, const Place& r) const {
    const double first = between(p, r).second;
    if (std::isinf(first)) return infinity;
    return std::max({p.distance, q.distance, r.distance, first, between(q, r).second});
  }

  // Three pieces, one at each corner, that meet at a point in the middle.
  double bound_by_three(const std::array<Place, 3>& c) const {
    double result = 0;
    Point middle = Point::Zero();
    for (const Place& place : c) middle += place.point / 3;
    for (const Place& place : c) result = std::max(result, distance(middle, place.nearest));
    for (int i = 0; i < 3 && result <= good_enough(); ++i)
      result = std::max({result, c[i].distance, between(c[i], c[(i + 1) % 3]).second});
    return result <= good_enough() ? result : infinity;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Point>& m_points;
  const std::vector<Triangle>& m_triangles;
  const Triangle_tree& m_to;
  const Distance_precision& m_precision;
  const Observer* m_observer;
  Area_distance m_result;
  double m_settled = 0; // the greatest bound that was good enough
  std::priority_queue<Part> m_open;
  std::int64_t m_queries = 0, m_steps = 0;
};

double fraction(double x) {
  return x - std::floor(x);
}

} // namespace

std::vector<Area_sample> area_samples(const std::vector<Point>& points,
                                      const std::vector<Triangle>& triangles, int count) {
  std::vector<double> until(triangles.size());
  double total = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Point &a = points[triangles[t][0]], &b = points[triangles[t][1]], &c = points[triangles[t][2]];
    until[t] = total += 0.5 * (b - a).cross(c - a).norm();
  }
  std::vector<Area_sample> samples;
  if (!(total > 0) || !std::isfinite(total)) return samples;
  samples.reserve(std::size_t(count));
  std::size_t t = 0;
  for (int k = 0; k < count; ++k) {
    while (t + 1 < triangles.size() && until[t] < (k + 0.5) / count * total) ++t;
    // Roberts' sequence with the plastic number, which spreads evenly in any run of it.
    double u = fraction(0.5 + k * 0.7548776662466927), v = fraction(0.5 + k * 0.5698402909980532);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Point &a = points[triangles[t][0]], &b = points[triangles[t][1]], &c = points[triangles[t][2]];
    samples.push_back({a + u * (b - a) + v * (c - a), int(t), -1, 0});
  }
  return samples;
}

std::optional<Area_distance> area_distance(const std::vector<Point>& points,
                                           const std::vector<Triangle>& triangles, const Triangle_tree& to,
                                           const Distance_precision& precision,
                                           std::vector<Area_sample>& samples, const Observer* observer) {
  if (observer && observer->cancelled()) return std::nullopt;
  Search search(points, triangles, to, precision, observer);
  if (!search.measure(samples) || !search.run()) return std::nullopt;
  return search.result();
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
