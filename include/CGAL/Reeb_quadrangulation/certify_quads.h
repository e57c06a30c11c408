// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_CERTIFY_QUADS_H
#define CGAL_REEB_QUADRANGULATION_CERTIFY_QUADS_H

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quad_face_graph.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Certifies a quad mesh against the triangle mesh that it was made from; \sa `certify(const
/// Certificate_input&, const Certificate_options&)`. Fails with `not_a_surface` if a face of `quads` is not a
/// quad, or as `to_triangle_surface()` does. Named parameters: of the quads `vertex_point_map`,
/// `geom_traits`, `options` (a `Certificate_options`); of the triangles `vertex_point_map`, `geom_traits`.
template <class QuadMesh, class TriangleMesh,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_same<QuadMesh, Certificate_input>::value>>
Result<Certificate> certify(const QuadMesh& quads, const TriangleMesh& tmesh,
                            const NamedParameters1& np1 = CGAL::parameters::default_values(),
                            const NamedParameters2& np2 = CGAL::parameters::default_values()) {
  using Tags = parameters::Tag_list<parameters::options_t>;
  static_assert(parameters::reads_all<NamedParameters1>(parameters::Point_tags() + Tags()));
  static_assert(parameters::reads_all<NamedParameters2>(parameters::Point_tags()));
  const auto mesh = internal::quad_mesh(quads, np1);
  if (!mesh) return mesh.error();
  const auto input = internal::triangle_surface(tmesh, np2);
  if (!input) return input.error();
  return certify({mesh->mesh, &input->surface},
                 parameters::parameter_or<parameters::options_t>(np1, Certificate_options()));
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_CERTIFY_QUADS_H
