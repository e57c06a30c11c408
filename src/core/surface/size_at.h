// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SURFACE_SIZE_AT_H
#define REEBQUAD_SURFACE_SIZE_AT_H

#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/transfer_attribute.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Sizes given at the vertices of a surface, at any point near it: those of its nearest point, linear in
/// triangles. Keeps references.
class Size_at {
public:
  /// \pre One size a vertex.
  Size_at(const Surface_projector& projector, const std::vector<double>& sizes)
      : m_projector(projector), m_sizes(sizes) {}

  double operator()(const Point& p) const {
    const Closest_point closest = m_projector.closest(p);
    const Triangle_surface& surface = m_projector.surface();
    const Triangle& t = surface.triangles[std::size_t(closest.face)];
    return mixed(barycentric_coordinates(surface, closest.face, closest.point), m_sizes[std::size_t(t[0])],
                 m_sizes[std::size_t(t[1])], m_sizes[std::size_t(t[2])]);
  }

private:
  const Surface_projector& m_projector;
  const std::vector<double>& m_sizes;
};

/// Fails with `impossible_request` unless there is a positive, finite size for each vertex; of vertices
/// without a triangle nothing is asked.
inline Result<void> check_sizes(const Triangle_surface& surface, const std::vector<double>& sizes) {
  if (int(sizes.size()) != surface.number_of_vertices())
    return make_error(Error_code::impossible_request,
                      std::to_string(sizes.size()) + " sizes are given for a surface of " +
                          std::to_string(surface.number_of_vertices()) + " vertices");
  for (const Triangle& t : surface.triangles)
    for (int v : t)
      if (!(sizes[std::size_t(v)] > 0) || !std::isfinite(sizes[std::size_t(v)]))
        return make_error(Error_code::impossible_request, "a size is not a positive number",
                          Element_kind::vertex, v);
  return {};
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_SIZE_AT_H
