// SPDX-License-Identifier: GPL-3.0-or-later
#include "certificate/shared_intersections.h"

#include "certificate/geometry.h"
#include "certificate/intersections.h"
#include "certificate/tree.h"

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

namespace {

using Box = Eigen::AlignedBox3d;

Box box_of(const Quad_corners& p) {
  return Box(p[0]).extend(p[1]).extend(p[2]).extend(p[3]);
}

// Where two quads meet, and half their size around it.
Box around(const Quad_mesh& mesh, const std::pair<int, int>& pair) {
  const Box first = box_of(corners(mesh, pair.first)), second = box_of(corners(mesh, pair.second));
  Box common = first.intersection(second);
  const double reach = 0.25 * (first.diagonal().norm() + second.diagonal().norm());
  common.min().array() -= reach;
  common.max().array() += reach;
  return common;
}

} // namespace

std::optional<std::vector<char>> are_in_input(const std::vector<std::pair<int, int>>& pairs,
                                              const Quad_mesh& mesh, const Soup_topology& topology,
                                              const Input_surface& input, const Observer* observer) {
  std::vector<char> result(pairs.size(), 0);
  if (pairs.empty()) return result;
  const Triangle_tree all(input.points(), input.triangles);
  std::vector<char> near(input.triangles.size(), 0);
  for (const auto& pair : pairs) all.for_boxes_meeting(around(mesh, pair), [&](int t) { near[t] = 1; });
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < near.size(); ++t)
    if (near[t]) triangles.push_back(input.triangles[t]);
  const Triangle_tree tree(input.points(), triangles);
  const auto crossings =
      intersecting_triangles(input.points(), triangles, tree, std::numeric_limits<int>::max(), observer);
  if (!crossings) return std::nullopt;

  // A crossing is found by its first triangle.
  std::vector<Triangle> first;
  for (const auto& crossing : *crossings) first.push_back(triangles[crossing.first]);
  const Triangle_tree places(input.points(), first);
  const auto component = [&](int t) { return input.topology.component[triangles[t][0]]; };
  for (std::size_t i = 0; i < pairs.size() && !first.empty(); ++i) {
    const auto [p, q] = pairs[i];
    const bool together = topology.component[mesh.quads[p][0]] == topology.component[mesh.quads[q][0]];
    const Box box = around(mesh, pairs[i]);
    places.for_boxes_meeting(box, [&](int k) {
      const auto [s, t] = (*crossings)[k];
      if (tree.box(s).intersection(tree.box(t)).intersects(box) && (component(s) == component(t)) == together)
        result[i] = 1;
    });
  }
  return result;
}

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL
