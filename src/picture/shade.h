// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to the renderer: the colour of a sample.
#ifndef REEBQUAD_PICTURE_SHADE_H
#define REEBQUAD_PICTURE_SHADE_H

#include "picture/raster.h"

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// Red, green, blue between 0 and 1 as displayed, already multiplied by the opacity.
struct Sample_colour {
  Eigen::Vector3f rgb = Eigen::Vector3f::Zero();
  float opacity = 0;
};

/// Colours samples. Remembers the last face, because neighbouring samples mostly see the same.
class Shader {
public:
  Shader(const Scene& scene, const Projected_scene& projected, const Projection& projection);

  /// The colour of sample (x, y) of the picture. \pre the row lies in the band
  Sample_colour operator()(const Band& band, int x, int y);

private:
  struct Side {
    Eigen::Vector2f a, b;
  };
  /// What all samples of a piece share.
  struct Piece {
    std::int32_t index = -1;
    const Grid_point* corner[3] = {nullptr, nullptr, nullptr};
    float inverse_area = 0;
    Eigen::Vector3f normal[3]; // in the eye's frame
    bool flat = true, inside = false;
    Eigen::Vector3f base; // linear
    Side sides[4];
    int number_of_sides = 0;
    float side_opacity = 1;
    float level[3] = {0, 0, 0}; // isoline number at the corners
    float level_slope = 0;      // isolines a sample
  };

  void enter(std::int32_t piece);
  void enter_sides(const Scene::Face& face);
  void enter_level(const Scene::Face& face);
  Eigen::Vector3f face_normal(const Scene::Face& face) const;
  Eigen::Vector3f surface_colour(int x, int y);
  void paint_isolines(float level, Eigen::Vector3f& colour) const;
  void paint_sides(float x, float y, Eigen::Vector3f& colour) const;
  void paint_rod(std::int32_t rod, float x, float y, bool hidden, Sample_colour& colour) const;

  const Scene& m_scene;
  const Projected_scene& m_projected;
  const Projection& m_projection;
  std::vector<Eigen::Vector3f> m_scalar_colours; // linear, a fine table
  Piece m_piece;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_PICTURE_SHADE_H
