// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Guide.h>

#include "base/diagonal.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Points of strokes keep so far from the border of their face, in barycentric coordinates, that a plane
// through them always leaves it across its edges.
constexpr double inside_face = 1e-4;

// A way on the surface that is so many times as long as the straight one goes around something.
constexpr double longest_detour = 3;

// So often a way is cut in two where it is not straight.
constexpr int most_halvings = 14;

// A point inside a face.
struct Site {
  Point point = Point::Zero();
  int face = -1;
};

class Stroke_tracer {
public:
  explicit Stroke_tracer(const Surface_projector& projector)
      : m_projector(projector), m_surface(projector.surface()) {}

  Site site(const Point& p) const {
    const Closest_point found = m_projector.closest(p);
    const Triangle& t = m_surface.triangles[std::size_t(found.face)];
    const Point &a = m_surface.points[std::size_t(t[0])], &b = m_surface.points[std::size_t(t[1])],
                &c = m_surface.points[std::size_t(t[2])];
    const Point n = (b - a).cross(c - a);
    const double square = n.squaredNorm();
    if (!(square > 0)) return {found.point, found.face};
    Eigen::Vector3d weight((c - b).cross(found.point - b).dot(n), (a - c).cross(found.point - c).dot(n),
                           (b - a).cross(found.point - a).dot(n));
    weight = (weight / square).cwiseMax(inside_face);
    weight /= weight.sum();
    return {weight[0] * a + weight[1] * b + weight[2] * c, found.face};
  }

  void begin(const Site& site) { m_points.push_back(site.point); }

  // Goes on to a point; nothing is added where there is no way.
  bool join(const Site& a, const Site& b, int halvings = most_halvings) {
    if (std::optional<Way> way = straight(a, b)) {
      m_points.insert(m_points.end(), way->points.begin(), way->points.end());
      m_faces.insert(m_faces.end(), way->faces.begin(), way->faces.end());
      m_crossings.insert(m_crossings.end(), way->crossings.begin(), way->crossings.end());
      return true;
    }
    if (halvings == 0) return false;
    const Site middle = site(0.5 * (a.point + b.point));
    if (middle.point == a.point || middle.point == b.point) return false;
    return join(a, middle, halvings - 1) && join(middle, b, halvings - 1);
  }

  Stroke stroke(bool closed) const {
    Stroke result;
    CGAL_assertion(!closed || m_points.front() == m_points.back());
    result.curve = make_surface_curve(m_points, closed);
    for (std::size_t i = 0; i + 1 < m_points.size(); ++i)
      if (m_points[i] != m_points[i + 1]) result.faces.push_back(m_faces[i]);
    for (const int face : result.faces) result.curve.normals.push_back(m_projector.normal(face));
    result.crossings = m_crossings;
    return result;
  }

private:
  struct Way {
    std::vector<Point> points;
    std::vector<int> faces;
    std::vector<Stroke_crossing> crossings;
  };

  // The way in the plane of two points and the mean of their normals, if it does not go far around.
  std::optional<Way> straight(const Site& a, const Site& b) const {
    const Point along = b.point - a.point;
    Point across = along.cross(m_projector.normal(a.face) + m_projector.normal(b.face));
    if (!(across.squaredNorm() > 0)) across = along.cross(m_projector.normal(a.face));
    if (a.face != b.face && !(across.squaredNorm() > 0)) return std::nullopt;
    const auto height = [&](int v) { return across.dot(m_surface.points[std::size_t(v)] - a.point); };
    Way way;
    double rest = longest_detour * along.norm();
    Point last = a.point;
    int entered = -1;
    for (int face = a.face; face != b.face;) {
      const std::optional<Stroke_crossing> exit = leave(face, entered, height, last, along);
      if (!exit || m_surface.opposite[std::size_t(exit->halfedge)] < 0) return std::nullopt;
      const Point p = at(*exit);
      rest -= (p - last).norm();
      if (rest < 0 || int(way.faces.size()) > m_surface.number_of_faces()) return std::nullopt;
      way.points.push_back(last = p);
      way.faces.push_back(face);
      way.crossings.push_back(*exit);
      entered = m_surface.opposite[std::size_t(exit->halfedge)];
      face = Triangle_surface::face(entered);
    }
    way.points.push_back(b.point);
    way.faces.push_back(b.face);
    return way;
  }

  // Where the plane leaves a face: of the first face, on the side that `along` shows to.
  template <class Height>
  std::optional<Stroke_crossing> leave(int face, int entered, const Height& height, const Point& from,
                                       const Point& along) const {
    std::optional<Stroke_crossing> best;
    double most = 0;
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const double low = height(m_surface.source(h)), high = height(m_surface.target(h));
      if (h == entered || (low >= 0) == (high >= 0)) continue;
      const Stroke_crossing crossing{h, low / (low - high)};
      const double progress = (at(crossing) - from).dot(along);
      if (best && progress <= most) continue;
      best = crossing;
      most = progress;
    }
    return best;
  }

  Point at(const Stroke_crossing& c) const {
    const Point &a = m_surface.points[std::size_t(m_surface.source(c.halfedge))],
                &b = m_surface.points[std::size_t(m_surface.target(c.halfedge))];
    return a + c.t * (b - a);
  }

  const Surface_projector& m_projector;
  const Triangle_surface& m_surface;
  std::vector<Point> m_points;
  std::vector<int> m_faces; // of the segments between them
  std::vector<Stroke_crossing> m_crossings;
};

Error bad_point(const std::string& what, std::size_t i) {
  return make_error(Error_code::impossible_request, "point " + std::to_string(i) + " of the guide " + what,
                    Element_kind::vertex, std::int64_t(i));
}

// The number of each point of a guide that is not the same as the one before, and not, of a closed one, the
// first.
std::vector<std::size_t> different_points(const Guide& guide) {
  std::vector<std::size_t> different;
  for (std::size_t i = 0; i < guide.points.size(); ++i)
    if (different.empty() || guide.points[i] != guide.points[different.back()]) different.push_back(i);
  while (guide.closed && different.size() > 1 && guide.points[different.back()] == guide.points[0])
    different.pop_back();
  return different;
}

} // namespace

Result<Stroke> trace_stroke(const Surface_projector& projector, const Guide& guide) {
  if (!(guide.strength > 0 && guide.strength <= 1))
    return make_error(Error_code::impossible_request,
                      "the strength of a guide lies between 0 and 1, and is not 0");
  for (std::size_t i = 0; i < guide.points.size(); ++i)
    if (!guide.points[i].allFinite()) return bad_point("is not finite", i);
  const std::vector<std::size_t> different = different_points(guide);
  if (different.size() < (guide.closed ? 3u : 2u))
    return make_error(Error_code::impossible_request, guide.closed
                                                          ? "a closed guide has three points at least"
                                                          : "a guide has two points at least");
  const double diagonal = internal::diagonal_of(projector.surface().points);
  Stroke_tracer tracer(projector);
  std::vector<Site> sites;
  for (const std::size_t i : different) {
    sites.push_back(tracer.site(guide.points[i]));
    if (const double off = (sites.back().point - guide.points[i]).norm(); off > guide_tolerance * diagonal)
      return bad_point("lies off the surface by " + std::to_string(100 * off / diagonal) +
                           " % of its diagonal, and 1 % is allowed",
                       i);
  }
  tracer.begin(sites.front());
  const std::size_t ways = guide.closed ? sites.size() : sites.size() - 1;
  for (std::size_t i = 0; i < ways; ++i)
    if (!tracer.join(sites[i], sites[(i + 1) % sites.size()]))
      return bad_point("has no way on the surface to the next one", different[i]);
  Stroke stroke = tracer.stroke(guide.closed);
  if (!(stroke.curve.length() > 0))
    return make_error(Error_code::impossible_request, "the guide has no length on the surface");
  return stroke;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
