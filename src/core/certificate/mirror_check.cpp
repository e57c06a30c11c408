// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/mirror_check.h>

#include "base/diagonal.h"

#include <algorithm>
#include <cstdio>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The same cycle of corners for all its rotations.
Quad rotated(Quad q) {
  std::rotate(q.begin(), std::min_element(q.begin(), q.end()), q.end());
  return q;
}

// What is wrong with the connectivity, or nothing.
std::string asymmetry(const Quad_mesh& quads, const std::vector<int>& image) {
  const int n = int(quads.points.size());
  if (int(image.size()) != n)
    return std::to_string(image.size()) + " images for " + std::to_string(n) + " vertices";
  for (int v = 0; v < n; ++v) {
    const int w = image[std::size_t(v)];
    if (w < 0 || w >= n || image[std::size_t(w)] != v)
      return "vertex " + std::to_string(v) + " is not the image of its image";
  }
  std::vector<Quad> all;
  for (const Quad& q : quads.quads) {
    for (const int v : q)
      if (v < 0 || v >= n) return "a quad names a vertex that does not exist";
    all.push_back(rotated(q));
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < quads.quads.size(); ++i) {
    Quad mirrored = quads.quads[i];
    for (int& v : mirrored) v = image[std::size_t(v)];
    std::reverse(mirrored.begin(), mirrored.end());
    if (!std::binary_search(all.begin(), all.end(), rotated(mirrored)))
      return "quad " + std::to_string(i) + " has no mirror image";
  }
  return {};
}

} // namespace

Mirror_check check_mirror(const Quad_mesh& quads, const Mirror_plane& plane, const std::vector<int>& image) {
  Mirror_check check;
  check.message = quads.quads.empty() ? "there are no quads" : asymmetry(quads, image);
  check.is_symmetric = check.is_exact = check.message.empty();
  if (!check.is_symmetric) return check;
  const double diagonal = internal::diagonal_of(quads.points);
  for (std::size_t v = 0; v < image.size(); ++v) {
    const Point &p = quads.points[v], &q = quads.points[std::size_t(image[v])];
    check.on_plane += image[v] == int(v);
    const double deviation = (plane.reflected(q) - p).norm() / diagonal;
    if (!(deviation <= check.deviation)) {
      check.deviation = deviation;
      check.vertex = int(v);
    }
    if (check.is_exact && !are_exact_images(plane, p, q)) {
      check.is_exact = false;
      check.message = "vertex " + std::to_string(v) + " and its mirror vertex " + std::to_string(image[v]) +
                      " are not exactly each other's images";
    }
  }
  return check;
}

std::string to_text(const Mirror_check& check, const Mirror_plane& plane) {
  const std::string where = "its mirror image in " + to_text(plane);
  if (!check.is_symmetric) return "does not equal " + where + ": " + check.message;
  if (check.is_exact) return "equals " + where + " to the bit";
  char deviation[32];
  std::snprintf(deviation, sizeof deviation, "%.3g", check.deviation);
  return "has the connectivity of " + where + ", vertices deviate by up to " + deviation + " of the diagonal";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
