// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a torus by planes: all decisions are exact, also where a plane goes through vertices and along edges.
#include <CGAL/Reeb_quadrangulation/plane_contour.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  const RQ::Result<RQ::Triangle_surface> torus = RQ::make_shape("torus", 4000);
  if (!torus) {
    std::cerr << torus.error().message << '\n';
    return 1;
  }

  // Across both tubes, through one side, and through the three corners of a triangle.
  const RQ::Triangle& t = torus->triangles[1000];
  const RQ::Cutting_plane planes[] = {
      RQ::Cutting_plane::at(RQ::Point(0, 0, 0), Eigen::Vector3d(1, 0, 0)),
      RQ::Cutting_plane::at(RQ::Point(1.2, 0, 0), Eigen::Vector3d(1, 0, 0)),
      RQ::Cutting_plane::through(torus->points[t[0]], torus->points[t[1]], torus->points[t[2]])};
  for (const RQ::Cutting_plane& plane : planes) {
    const RQ::Result<RQ::Plane_curves> cut = RQ::plane_curves(*torus, plane);
    if (!cut) {
      std::cerr << cut.error().message << '\n';
      return 1;
    }
    std::cout << cut->curves.size() << " closed curves:";
    for (const RQ::Plane_curve& curve : cut->curves) {
      double length = 0;
      const std::vector<RQ::Point> points = RQ::curve_points(*torus, curve);
      for (std::size_t i = 0; i < points.size(); ++i)
        length += (points[(i + 1) % points.size()] - points[i]).norm();
      std::cout << "  " << curve.crossings.size() << " edges, length " << length;
    }
    const int nearest = RQ::nearest_curve(*torus, cut->curves, RQ::Point(0, -1, 0));
    std::cout << "; nearest to (0, -1, 0): " << nearest << '\n';
  }
}
