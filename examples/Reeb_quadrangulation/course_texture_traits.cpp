// SPDX-License-Identifier: GPL-3.0-or-later
// A model of QuadTextureTraits of one's own: charts are studded with quads in quads, and the mesh is as valid
// as any: course_texture_traits [FOLDER OF THE PICTURE].
#include <CGAL/Reeb_quadrangulation/Quad_texture_traits.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/render.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>
#include <string>

namespace RQ = CGAL::Reeb_quadrangulation;

// Regular grids, as by default, but every third quad of every third row of an annulus has another one inside.
// Only what is inside changes: the sides, where charts meet, stay as they are sampled.
struct Studded_traits : RQ::Quad_texture_traits {
  struct Make_annulus_texture {
    RQ::Quad_texture operator()(int columns, const std::vector<double>& levels) const {
      RQ::Quad_texture texture = RQ::regular_annulus_texture(columns, levels);
      for (std::size_t row = 1; row + 1 < levels.size(); row += 3)
        for (int column = 1; column < columns; column += 3) {
          RQ::Inset_quads inset;
          inset.quads = {{(column + 0.5) / columns, 0.5 * (levels[row] + levels[row + 1])}};
          if (const auto edited = RQ::edit_texture(texture, inset)) texture = edited->texture;
        }
      return texture;
    }
  };
  Make_annulus_texture make_annulus_texture_object() const { return {}; }
};

int fail(const RQ::Error& error) {
  std::cerr << error.message << '\n';
  return 1;
}

int main(int argc, char** argv) {
  const auto surface = RQ::make_shape("torus", 4000);
  if (!surface) return fail(surface.error());
  RQ::Quadrangulation_options options;
  options.quads = 600;
  options.textures = RQ::texture_maker(Studded_traits());
  const auto result = RQ::quadrangulate(*surface, options);
  if (!result) return fail(result.error());

  // The valences are predicted from the textures alone, and the certificate counts them in the quads.
  for (const auto& [valence, number] : result->valences)
    std::cout << number << " vertices of valence " << valence << '\n';
  const RQ::Certificate certificate = RQ::certify({result->mesh, &*surface, result->valences});
  std::cout << result->mesh.quads.size() << " quads, certificate "
            << (certificate.passed ? "passed" : "failed") << '\n';

  const RQ::Camera camera = RQ::camera(RQ::View::three_quarter, RQ::Up_axis::z);
  const std::string file = std::string(argc > 1 ? argv[1] : ".") + "/course_texture_traits.png";
  const auto written = RQ::write_png(RQ::render(RQ::quad_scene(result->mesh), camera, 600, 480), file);
  if (!written) return fail(written.error());
  return certificate.passed ? 0 : 1;
}
