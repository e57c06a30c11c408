// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/quad_parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

Quad_parameters corners(const Quad_texture& texture, std::size_t quad, bool is_annulus) {
  Quad_parameters result;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t v = std::size_t(texture.quads[quad][i]);
    result[i] = {texture.v[v], texture.u[v]};
  }
  if (!is_annulus) return result;
  // No quad is half a turn wide: a contour has four samples at least.
  double greatest = result[0].x();
  for (const Eigen::Vector2d& p : result) greatest = std::max(greatest, p.x());
  for (Eigen::Vector2d& p : result)
    if (p.x() < greatest - 0.5) p.x() += 1;
  return result;
}

} // namespace

Result<std::vector<Quad_parameters>> quad_parameters(const Quadrangulation& quads) {
  const auto impossible = [] {
    return make_error(Error_code::impossible_request,
                      "quads that were subdivided or split have no place in the texture of a chart");
  };
  if (quads.subdivided_quads > 0 || quads.t_junctions > 0) return impossible();
  // Quads are stitched chart by chart, those of each in the order of its texture.
  const Design& design = quads.editor.design();
  std::vector<Quad_parameters> result;
  for (const auto& chart : design.charts) {
    const Quad_texture& texture = chart->texture.texture;
    for (std::size_t q = 0; q < texture.quads.size(); ++q)
      if (!texture.is_hole(int(q)))
        result.push_back(corners(texture, q, chart->chart->kind == Chart_kind::annulus));
  }
  if (result.size() != quads.mesh.quads.size()) return impossible();
  // Finishing may begin a quad at another corner than the design does.
  const Quad_mesh stitched = quads.editor.quads().mesh;
  for (std::size_t q = 0; q < result.size(); ++q) {
    const Quad& from = stitched.quads[q];
    const auto begin = std::find(from.begin(), from.end(), quads.mesh.quads[q][0]);
    CGAL_assertion(begin != from.end());
    std::rotate(result[q].begin(), result[q].begin() + (begin - from.begin()), result[q].end());
  }
  return result;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
