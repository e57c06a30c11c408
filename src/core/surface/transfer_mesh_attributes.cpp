// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/transfer_mesh_attributes.h>

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/transfer_attribute.h>

#include "io/writers.h"

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

/// A triangulated mesh that knows the polygon and the corners of each triangle.
struct Source {
  Triangle_surface surface;
  std::vector<Triangle> corners; ///< indices into the mesh's `corner`
  std::vector<int> polygon;
};

Source source_of(const Polygon_soup& mesh) {
  Source source;
  source.surface.points = mesh.points;
  std::vector<int> polygon;
  const std::vector<Triangle> all = corner_triangles_of(mesh, &polygon);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Triangle t;
    bool is_finite = true;
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = mesh.corner[std::size_t(all[i][k])];
      is_finite = is_finite && mesh.points[std::size_t(t[k])].allFinite();
    }
    if (!is_finite) continue;
    source.surface.triangles.push_back(t);
    source.corners.push_back(all[i]);
    source.polygon.push_back(polygon[i]);
  }
  return source;
}

class Transfer {
public:
  Transfer(const Source& source, const Mesh_attributes& from, const Polygon_soup& to)
      : m_source(source), m_from(from), m_to(to), m_projector(source.surface) {}

  Mesh_attributes run() {
    Mesh_attributes out;
    out.material_library = m_from.material_library;
    out.others = m_from.others;
    for (const Face_labels& labels : m_from.labels) out.labels.push_back({labels.kind, labels.names, {}});
    if (!m_from.colours.empty())
      for (const Point& p : m_to.points) out.colours.push_back(colour(p));
    for (int p = 0; p < m_to.number_of_polygons(); ++p) {
      middle_of(p);
      if (!m_from.labels.empty()) add_labels(p, out);
      if (!m_from.uv.empty()) add_uv(p, out);
    }
    return out;
  }

private:
  const Point& corner(int c) const { return m_to.points[std::size_t(m_to.corner[std::size_t(c)])]; }

  void middle_of(int p) {
    m_middle = Point::Zero();
    for (int c = m_to.begin[p]; c < m_to.begin[p + 1]; ++c) m_middle += corner(c);
    m_middle /= std::max(1, m_to.size_of_polygon(p));
    m_middle_face = m_projector.closest(m_middle).face;
  }

  Eigen::Vector3d colour(const Point& p) const {
    const Closest_point closest = m_projector.closest(p);
    const auto weight = internal::barycentric_coordinates(m_source.surface, closest.face, closest.point);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      sum +=
          weight[k] * m_from.colours[std::size_t(m_source.surface.triangles[std::size_t(closest.face)][k])];
    return sum;
  }

  void add_labels(int p, Mesh_attributes& out) const {
    std::vector<int> polygons{m_source.polygon[std::size_t(m_middle_face)]};
    for (int c = m_to.begin[p]; c < m_to.begin[p + 1]; ++c) {
      const int face = m_projector.closest(0.75 * corner(c) + 0.25 * m_middle).face;
      polygons.push_back(m_source.polygon[std::size_t(face)]);
    }
    for (std::size_t l = 0; l < m_from.labels.size(); ++l) {
      std::vector<int> found;
      for (const int polygon : polygons) found.push_back(m_from.labels[l].label[std::size_t(polygon)]);
      int best = found[0];
      for (const int label : found)
        if (std::count(found.begin(), found.end(), label) > std::count(found.begin(), found.end(), best))
          best = label;
      out.labels[l].label.push_back(best);
    }
  }

  /// In the map of a triangle of the source, extended over its plane unless the triangle has no area.
  Eigen::Vector2d uv(int face, const Point& p) const {
    const Triangle& t = m_source.surface.triangles[std::size_t(face)];
    const Triangle& corners = m_source.corners[std::size_t(face)];
    const auto point = [&](std::size_t k) -> const Point& {
      return m_source.surface.points[std::size_t(t[k])];
    };
    std::array<double, 3> weight = internal::barycentric_coordinates(m_source.surface, face, p);
    const Point normal = (point(1) - point(0)).cross(point(2) - point(0));
    if (const double area = normal.squaredNorm(); area > 0)
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = point((k + 1) % 3), &b = point((k + 2) % 3);
        weight[k] = (b - a).cross(p - a).dot(normal) / area;
      }
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < 3; ++k) sum += weight[k] * m_from.uv[std::size_t(corners[k])];
    return sum;
  }

  void add_uv(int p, Mesh_attributes& out) const {
    std::vector<Eigen::Vector2d> expected, found;
    for (int c = m_to.begin[p]; c < m_to.begin[p + 1]; ++c) {
      const int face = m_projector.closest(0.9 * corner(c) + 0.1 * m_middle).face;
      expected.push_back(uv(m_middle_face, corner(c)));
      found.push_back(uv(face, corner(c)));
    }
    double size = 0; // of the polygon in the plane of the texture
    for (const Eigen::Vector2d& e : expected) size = std::max(size, (e - expected[0]).norm());
    const Eigen::Vector2d at_middle = uv(m_middle_face, m_middle);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool jumps = !at_middle.allFinite() ? false : !((found[i] - expected[i]).norm() <= 2 * size);
      out.uv.push_back(jumps ? expected[i] : found[i]);
    }
  }

  const Source& m_source;
  const Mesh_attributes& m_from;
  const Polygon_soup& m_to;
  Surface_projector m_projector;
  Point m_middle = Point::Zero(); ///< of the polygon at hand
  int m_middle_face = -1;         ///< the triangle of the source nearest to it
};

} // namespace

Mesh_attributes transfer_mesh_attributes(const Polygon_soup& from, const Mesh_attributes& attributes,
                                         const Polygon_soup& to) {
  CGAL_precondition(attributes.uv.empty() || attributes.uv.size() == from.corner.size());
  CGAL_precondition(attributes.colours.empty() || attributes.colours.size() == from.points.size());
  const Source source = source_of(from);
  if (!attributes.empty() && !source.surface.triangles.empty()) return Transfer(source, attributes, to).run();
  Mesh_attributes out;
  out.material_library = attributes.material_library;
  out.others = attributes.others;
  return out;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
