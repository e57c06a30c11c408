// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/marks.h>

#include "base/diagonal.h"
#include "base/segment_tree.h"
#include "base/sharp_edge.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Marks among which those that an edge lies along are found.
class Mark_tree {
public:
  Mark_tree(const std::vector<Mark>& marks, double tolerance)
      : m_squared_tolerance(tolerance * tolerance), m_covered(marks.size(), 0), m_lengths(marks.size(), 0) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
      m_lengths[i] = (marks[i].to - marks[i].from).norm();
      m_segments.add(marks[i].from, marks[i].to);
    }
    m_segments.build();
  }

  // Whether the edge lies along marks; the mark at its middle is then found so far.
  bool take(const Point& a, const Point& b) {
    if (m_segments.empty()) return false;
    for (const Point& end : {a, b})
      if (m_segments.squared_distance(end) > m_squared_tolerance) return false;
    const Point middle = 0.5 * (a + b);
    const internal::Segment_tree::Nearest nearest = m_segments.nearest(middle);
    if (nearest.squared_distance > m_squared_tolerance) return false;
    m_covered[nearest.segment] += (b - a).norm();
    return true;
  }

  std::vector<double> found() const {
    std::vector<double> part;
    for (std::size_t i = 0; i < m_covered.size(); ++i)
      part.push_back(m_lengths[i] > 0 ? std::min(1.0, m_covered[i] / m_lengths[i]) : 1.0);
    return part;
  }

private:
  double m_squared_tolerance;
  std::vector<double> m_covered, m_lengths;
  internal::Segment_tree m_segments;
};

Result<void> check(const Marks& marks, double feature_angle) {
  for (const auto* list : {&marks.marked, &marks.unmarked})
    for (std::size_t i = 0; i < list->size(); ++i)
      if (!(*list)[i].from.allFinite() || !(*list)[i].to.allFinite())
        return make_error(Error_code::impossible_request,
                          "the position of mark " + std::to_string(i + 1) + " is not finite");
  if (!(marks.tolerance >= 0) || !std::isfinite(marks.tolerance))
    return make_error(Error_code::impossible_request, "the tolerance of marks is not a positive number");
  if (!(feature_angle >= 0 && feature_angle <= 180))
    return make_error(Error_code::impossible_request,
                      "the angle of sharp edges lies between 0 and 180 degrees");
  return {};
}

} // namespace

Result<Marked_features> marked_features(const Triangle_surface& surface, const Marks& marks,
                                        double feature_angle) {
  if (Result<void> fine = check(marks, feature_angle); !fine) return fine.error();
  const double tolerance = marks.tolerance * internal::diagonal_of(surface.points);
  Mark_tree marked(marks.marked, tolerance), unmarked(marks.unmarked, tolerance);
  std::vector<char> sharp(std::size_t(surface.number_of_halfedges()), 0);
  const double cosine = internal::cosine_of(feature_angle);
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const int o = surface.opposite[std::size_t(h)];
    if (o >= 0 && o < h) continue;
    const Point &a = surface.points[std::size_t(surface.source(h))],
                &b = surface.points[std::size_t(surface.target(h))];
    const bool is_unmarked = unmarked.take(a, b);
    const bool is_marked = marked.take(a, b);
    if (o < 0) continue; // the boundary is a feature anyway
    const bool is_sharp =
        feature_angle > 0 && internal::is_sharp(internal::area_normal(surface, h / 3),
                                                internal::area_normal(surface, o / 3), cosine);
    sharp[std::size_t(h)] = sharp[std::size_t(o)] = is_marked || (is_sharp && !is_unmarked);
  }
  return Marked_features{given_features(surface, std::move(sharp), {}), marked.found(), unmarked.found()};
}

std::vector<Mark> borders_of_groups(const Triangle_surface& surface, const std::vector<int>& group) {
  CGAL_precondition(int(group.size()) == surface.number_of_faces());
  std::vector<Mark> marks;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const int o = surface.opposite[std::size_t(h)];
    if (o < h || group[std::size_t(h / 3)] == group[std::size_t(o / 3)]) continue;
    marks.push_back(
        {surface.points[std::size_t(surface.source(h))], surface.points[std::size_t(surface.target(h))]});
  }
  return marks;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
