// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_TRANSFER_ATTRIBUTE_H
#define CGAL_REEB_QUADRANGULATION_TRANSFER_ATTRIBUTE_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/face_graph_surface.h>

#include <array>
#include <type_traits>
#include <utility>

/// \file
/// Where points lie on a triangle mesh, and what the mesh says there: normals, colours, weights, texture
/// coordinates, patches.

namespace CGAL {
namespace Reeb_quadrangulation {

/// A point of a triangle mesh: a face, and the weights of the source of its halfedge `halfedge(face, mesh)`,
/// of the target, and of the third vertex; none is negative and their sum is 1. The type and the order are
/// those of `CGAL::Polygon_mesh_processing::Face_location`.
template <class TriangleMesh>
using Face_location =
    std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>;

namespace internal {

// The weights of a triangle's corners at the point of its plane nearest to p, brought into the triangle; a
// triangle without area counts as its longest edge.
inline std::array<double, 3> barycentric_coordinates(const Triangle_surface& surface, int face,
                                                     const Point& p) {
  const Triangle& t = surface.triangles[std::size_t(face)];
  const Point &a = surface.points[std::size_t(t[0])], &b = surface.points[std::size_t(t[1])],
              &c = surface.points[std::size_t(t[2])];
  const Point normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  std::array<double, 3> weight{};
  if (area > 0) {
    weight = {(c - b).cross(p - b).dot(normal) / area, (a - c).cross(p - c).dot(normal) / area, 0};
    weight[2] = 1 - weight[0] - weight[1];
  } else {
    const std::array<Point, 3> corners{a, b, c};
    int from = 0;
    for (int i = 1; i < 3; ++i)
      if ((corners[std::size_t((i + 1) % 3)] - corners[std::size_t(i)]).norm() >
          (corners[std::size_t((from + 1) % 3)] - corners[std::size_t(from)]).norm())
        from = i;
    const int to = (from + 1) % 3;
    const Point along = corners[std::size_t(to)] - corners[std::size_t(from)];
    const double length = along.squaredNorm();
    weight[std::size_t(to)] = length > 0 ? along.dot(p - corners[std::size_t(from)]) / length : 0;
    weight[std::size_t(from)] = 1 - weight[std::size_t(to)];
  }
  double sum = 0;
  for (double& w : weight) sum += w = w > 0 ? w : 0;
  for (double& w : weight) w /= sum;
  return weight;
}

// The nearest point of a surface.
template <class Graph>
Face_location<Graph> location(const Face_graph_surface<Graph>& mesh, const Surface_projector& projector,
                              const Point& p) {
  const Closest_point closest = projector.closest(p);
  return {mesh.faces[std::size_t(closest.face)],
          barycentric_coordinates(mesh.surface, closest.face, closest.point)};
}

// A value between three, weighted. Numbers below a word are mixed as doubles.
template <class Value>
Value mixed(const std::array<double, 3>& weight, const Value& a, const Value& b, const Value& c) {
  if constexpr (std::is_arithmetic<Value>::value)
    return Value(weight[0] * double(a) + weight[1] * double(b) + weight[2] * double(c));
  else
    return Value(weight[0] * a + weight[1] * b + weight[2] * c);
}

// The attribute at a point.
template <class Key, class Graph, class In_map>
auto attribute_at(const Graph& mesh, const In_map& in, const Face_location<Graph>& at) {
  using Traits = boost::graph_traits<Graph>;
  using Value = std::decay_t<typename boost::property_traits<In_map>::value_type>;
  const auto h = halfedge(at.first, mesh), i = next(h, mesh), j = next(i, mesh);
  if constexpr (std::is_same<Key, typename Traits::face_descriptor>::value)
    return Value(get(in, at.first));
  else if constexpr (std::is_same<Key, typename Traits::halfedge_descriptor>::value)
    return mixed(at.second, Value(get(in, j)), Value(get(in, h)), Value(get(in, i)));
  else
    return mixed(at.second, Value(get(in, source(h, mesh))), Value(get(in, target(h, mesh))),
                 Value(get(in, target(i, mesh))));
}

template <class Graph, class Point_map, class NamedParameters>
Point centre(const Graph& quads, const Point_map& points, const NamedParameters& np,
             typename boost::graph_traits<Graph>::face_descriptor f) {
  Point sum(0, 0, 0);
  int corners = 0;
  for (const auto h : CGAL::halfedges_around_face(halfedge(f, quads), quads)) {
    sum += point_of(np, get(points, target(h, quads)));
    ++corners;
  }
  return sum / corners;
}

} // namespace internal

/// Carries an attribute of a triangle mesh over to a mesh on or near its surface, as the quads made from it.
/// What kind of attribute it is, the key of `in` says; `out` has the same kind of key, of `quads`:
/// - of vertices: interpolated linearly at the nearest point of the surface; the values have `+` and a
///   product with `double` from the left;
/// - of faces: the value of the face nearest to the quad's centre, whatever type it has;
/// - of halfedges, the corner at their target: interpolated in the face nearest to a point a tenth of the way
///   from the corner to the quad's centre, extended to the corner's nearest place in that face. So attributes
///   that jump at an edge (texture coordinates at a seam, normals at a crease) jump in the quads that lie
///   along it, and are not mixed.
///
/// Fails with `not_a_surface` as `to_triangle_surface()` does, or if `tmesh` has no face. O((F + Q) log F).
/// Named parameters of either mesh: `vertex_point_map`, `geom_traits`.
template <class TriangleMesh, class QuadMesh, class InMap, class OutMap,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters>
Result<void> transfer_attribute(const TriangleMesh& tmesh, const QuadMesh& quads, InMap in, OutMap out,
                                const NamedParameters1& np1 = CGAL::parameters::default_values(),
                                const NamedParameters2& np2 = CGAL::parameters::default_values()) {
  static_assert(parameters::reads_all<NamedParameters1>(parameters::Point_tags()));
  static_assert(parameters::reads_all<NamedParameters2>(parameters::Point_tags()));
  using Traits = boost::graph_traits<TriangleMesh>;
  using Key = typename boost::property_traits<InMap>::key_type;
  using Out_key = typename boost::property_traits<OutMap>::key_type;
  const auto mesh = internal::triangle_surface(tmesh, np1);
  if (!mesh) return mesh.error();
  if (mesh->faces.empty()) return make_error(Error_code::not_a_surface, "the triangle mesh has no face");
  const Surface_projector projector(mesh->surface);
  const auto points = parameters::vertex_points(np2, quads);
  const auto position = [&](auto v) { return internal::point_of(np2, get(points, v)); };
  const auto value = [&](const Point& p) {
    return internal::attribute_at<Key>(tmesh, in, internal::location(*mesh, projector, p));
  };
  if constexpr (std::is_same<Key, typename Traits::vertex_descriptor>::value) {
    static_assert(std::is_same<Out_key, typename boost::graph_traits<QuadMesh>::vertex_descriptor>::value,
                  "attributes of vertices go to vertices");
    for (const auto v : vertices(quads)) put(out, v, value(position(v)));
  } else if constexpr (std::is_same<Key, typename Traits::face_descriptor>::value) {
    static_assert(std::is_same<Out_key, typename boost::graph_traits<QuadMesh>::face_descriptor>::value,
                  "attributes of faces go to faces");
    for (const auto f : faces(quads)) put(out, f, value(internal::centre(quads, points, np2, f)));
  } else {
    static_assert(std::is_same<Key, typename Traits::halfedge_descriptor>::value,
                  "attributes are of vertices, faces or halfedges");
    static_assert(std::is_same<Out_key, typename boost::graph_traits<QuadMesh>::halfedge_descriptor>::value,
                  "attributes of halfedges go to halfedges");
    for (const auto f : faces(quads)) {
      const Point middle = internal::centre(quads, points, np2, f);
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, quads), quads)) {
        const Point corner = position(target(h, quads));
        const int face = projector.closest(0.9 * corner + 0.1 * middle).face;
        const Face_location<TriangleMesh> at{mesh->faces[std::size_t(face)],
                                             internal::barycentric_coordinates(mesh->surface, face, corner)};
        put(out, h, internal::attribute_at<Key>(tmesh, in, at));
      }
    }
  }
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_TRANSFER_ATTRIBUTE_H
