// SPDX-License-Identifier: GPL-3.0-or-later
// Edit one patch of a quad mesh of any origin on the surface that it stands for: everything else keeps its
// bits.
#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

int main() {
  // Any oriented manifold quad mesh will do.
  const Triangle_surface surface = *make_shape("ellipsoid", 4000);
  Quadrangulation_options options;
  options.quads = 300;
  const Result<Quadrangulation> made = quadrangulate(surface, options);
  if (!made) return 1;
  const Quad_mesh& quads = made->mesh;

  const Result<Base_domain> domain = base_domain(quads);
  if (!domain) return 1;
  std::cout << quads.quads.size() << " quads in " << domain->patches.size() << " patches\n";

  // Twice as fine around the point of the surface that lies furthest along x, with a box in the middle of it.
  const Base_locator::Place place = Base_locator(quads, *domain).locate(Point(1, 0, 0));
  Result<Patch_texture> texture = patch_texture(domain->patches[place.patch]);
  for (const Texture_edit& edit :
       {Texture_edit(Subdivide_texture{}), Texture_edit(Inset_quads{{{place.v, place.u}}, 0.5})}) {
    texture = edit_texture(*texture, edit);
    if (!texture) {
      std::cerr << texture.error().message << "\n";
      return 1;
    }
  }
  const Result<Textured_base> result =
      apply_textures(quads, *domain, {{place.patch, *texture}}, Surface_projector(surface));
  if (!result) return 1;
  std::cout << result->mesh.quads.size() << " quads, " << result->t_junctions << " T-junctions taken away, "
            << result->extraordinary.size() << " new extraordinary vertices there\n";
  int moved = 0;
  for (std::size_t v = 0; v < result->mesh.points.size(); ++v)
    if (const int origin = result->vertex_origin[v]; origin >= 0)
      moved += result->mesh.points[v] != quads.points[origin];
  std::cout << moved << " other vertices moved\n";
  return certify({result->mesh, &surface}).passed && moved == 0 ? 0 : 1;
}
