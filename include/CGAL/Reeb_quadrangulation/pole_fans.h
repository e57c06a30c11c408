// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_POLE_FANS_H
#define CGAL_REEB_QUADRANGULATION_POLE_FANS_H

#include <CGAL/Reeb_quadrangulation/Design.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/Mirror_plane.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

#include <string>
#include <vector>

/// \file
/// Whole poles (paper, section 6.3): one vertex in a fan of triangles. A quad mesh cannot hold a fan, so the
/// quads of a design leave a hole there, and what fills it is told apart from them.

namespace CGAL {
namespace Reeb_quadrangulation {

/// What fills the hole of a whole pole: a triangle from the pole to each pair of neighbours on the ring, the
/// last and the first included.
struct Pole_fan {
  int extremum = -1;          ///< index into `Design::extrema`
  Point pole = Point::Zero(); ///< on the surface
  int holes = 0;              ///< quads of the chart's texture that are left out for the fan
  std::vector<int> ring;      ///< vertices of the quads, counterclockwise seen from outside; an even number
};

/// The fans of a design's quads, relaxed or not, in the order of the extrema; none if it has no whole poles.
/// Where the user has edited the cap's texture, its holes are the user's, and there is no fan. O(quads). \pre
/// `quads` is stitched from `design`.
std::vector<Pole_fan> pole_fans(const Design& design, const Stitched_mesh& quads);

/// The quads, then the fans' triangles; the poles are the last points.
Polygon_soup with_fans(const Quad_mesh& quads, const std::vector<Pole_fan>& fans);

/// The quads with every two neighbouring triangles of a fan as one quad: what can be certified as a quad
/// mesh. It is closed, manifold and oriented exactly if the quads with the fans are, since no edge is left
/// out but those between two triangles. The valences, and the holes and components that are left, are those
/// of this mesh.
Stitched_mesh with_paired_fans(Stitched_mesh quads, const std::vector<Pole_fan>& fans);

/// The fans of a half, then their images in a mirror; `image` as in `Mirrored_design`.
std::vector<Pole_fan> with_mirrored_fans(std::vector<Pole_fan> fans, const std::vector<int>& image,
                                         const Mirror_plane& plane);

/// "not all-quad: 24 triangles in fans at 1 whole pole, asked for by the design"; empty without fans.
std::string fan_sentence(const std::vector<Pole_fan>& fans);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_POLE_FANS_H
