// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/given_features.h>

#include "base/sharp_edge.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Calls `use(h)` for each feature halfedge that leaves v; a boundary halfedge that enters v is given as -1 -
// h.
template <class Use>
void for_each_feature_at(const Triangle_surface& s, const std::vector<char>& feature, int v, Use use) {
  const int first = s.outgoing[v];
  if (first < 0) return;
  int h = first, last = h;
  do {
    if (feature[h]) use(h);
    last = h;
    h = s.rotate_ccw(h);
  } while (h >= 0 && h != first);
  if (h < 0) use(-1 - s.previous(last));
}

Point direction_from(const Triangle_surface& s, int code) {
  const Point d = code >= 0 ? Point(s.points[s.target(code)] - s.points[s.source(code)])
                            : Point(s.points[s.source(-1 - code)] - s.points[s.target(-1 - code)]);
  const double length = d.norm();
  return length > 0 ? Point(d / length) : d;
}

bool is_corner(const Triangle_surface& s, const std::vector<char>& feature, int v, double corner_cosine) {
  int count = 0, codes[2] = {0, 0};
  for_each_feature_at(s, feature, v, [&](int code) {
    if (count < 2) codes[count] = code;
    ++count;
  });
  if (count == 0) return false;
  if (count != 2) return true;
  return -direction_from(s, codes[0]).dot(direction_from(s, codes[1])) < corner_cosine;
}

// The halfedges of sharp edges.
std::vector<char> sharp_halfedges(const Triangle_surface& s, double dihedral_angle) {
  std::vector<char> feature(s.number_of_halfedges(), 0);
  std::vector<Point> normal;
  if (dihedral_angle > 0) {
    normal.reserve(s.number_of_faces());
    for (int f = 0; f < s.number_of_faces(); ++f) normal.push_back(internal::area_normal(s, f));
  }
  const double cosine = internal::cosine_of(dihedral_angle);
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    const int o = s.opposite[h];
    if (o < h || dihedral_angle <= 0) continue;
    feature[h] = feature[o] = internal::is_sharp(normal[h / 3], normal[o / 3], cosine);
  }
  return feature;
}

// Chains of features between corners: the vertices that are marked in `corner`, and those that the features
// make.
Feature_edges traced(const Triangle_surface& s, std::vector<char> feature, std::vector<char> corner,
                     double corner_angle);

} // namespace

Feature_edges feature_edges(const Triangle_surface& s, double dihedral_angle, double corner_angle) {
  return feature_edges(s, sharp_halfedges(s, dihedral_angle), corner_angle);
}

Feature_edges feature_edges(const Triangle_surface& s, std::vector<char> feature, double corner_angle) {
  return traced(s, std::move(feature), std::vector<char>(s.points.size(), 0), corner_angle);
}

Given_features given_features(const Triangle_surface& s, std::vector<char> sharp, std::vector<int> points,
                              double corner_angle) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<char> corner(s.points.size(), 0);
  for (int v : points) {
    CGAL_precondition(v >= 0 && v < s.number_of_vertices());
    corner[std::size_t(v)] = 1;
  }
  return {traced(s, std::move(sharp), std::move(corner), corner_angle), std::move(points)};
}

namespace {

Feature_edges traced(const Triangle_surface& s, std::vector<char> feature, std::vector<char> corner,
                     double corner_angle) {
  const int nh = s.number_of_halfedges();
  CGAL_precondition(int(feature.size()) == nh);
  for (int h = 0; h < nh; ++h)
    if (s.opposite[h] < 0) feature[h] = 1;
  Feature_edges result;
  std::vector<char> has_feature(s.number_of_vertices(), 0), used(nh, 0);
  for (int h = 0; h < nh; ++h)
    if (feature[h]) has_feature[s.source(h)] = has_feature[s.target(h)] = 1;
  for (int v = 0; v < s.number_of_vertices(); ++v)
    if (corner[v] || (has_feature[v] && is_corner(s, feature, v, internal::cosine_of(corner_angle)))) {
      corner[v] = 1;
      result.corners.push_back(v);
    }

  // The feature that goes on from the target of h, which is no corner: a boundary goes on along the boundary.
  const auto following = [&](int h) {
    if (s.is_boundary(h)) return s.outgoing[s.target(h)];
    int next = -1;
    for_each_feature_at(s, feature, s.target(h), [&](int code) {
      if (code >= 0 && code != s.opposite[h]) next = code;
    });
    return next;
  };
  const auto trace = [&](int first) {
    Feature_chain chain;
    chain.boundary = s.is_boundary(first);
    for (int h = first;;) {
      used[h] = 1;
      if (s.opposite[h] >= 0) used[s.opposite[h]] = 1;
      chain.halfedges.push_back(h);
      if (corner[s.target(h)]) break;
      h = following(h);
      if (h < 0 || used[h]) {
        chain.closed = h == first;
        break;
      }
    }
    result.chains.push_back(std::move(chain));
  };
  for (int h = 0; h < nh; ++h)
    if (feature[h] && !used[h] && corner[s.source(h)]) trace(h);
  for (int h = 0; h < nh; ++h)
    if (feature[h] && !used[h]) trace(h);
  std::sort(result.chains.begin(), result.chains.end(), [](const Feature_chain& a, const Feature_chain& b) {
    return *std::min_element(a.halfedges.begin(), a.halfedges.end()) <
           *std::min_element(b.halfedges.begin(), b.halfedges.end());
  });
  return result;
}

} // namespace

} // namespace Reeb_quadrangulation
} // namespace CGAL
