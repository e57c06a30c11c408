// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_TRANSFER_MESH_ATTRIBUTES_H
#define CGAL_REEB_QUADRANGULATION_TRANSFER_MESH_ATTRIBUTES_H

#include <CGAL/Reeb_quadrangulation/IO/mesh_attributes.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The attributes of a mesh as it was read, carried over to a mesh on or near its surface, by nearest points:
/// - a point gets the colour of its nearest point, mixed from the corners there;
/// - a polygon gets of each kind of names the one that most of its middle and points near its corners find,
/// the middle's if none
///   is found more often;
/// - a corner gets the texture coordinates found a tenth of the way to the polygon's middle. Where they jump
/// away from what the middle
///   tells, as at a seam, it gets those that the map at the middle, extended, has there: no polygon is torn.
///
/// `others` and `material_library` are taken over. Polygons that are not finite are passed over; nothing
/// comes out if no polygon has three corners. O((F + Q) log F). \pre corners are indices of points;
/// attributes have the sizes of `from`
Mesh_attributes transfer_mesh_attributes(const Polygon_soup& from, const Mesh_attributes& attributes,
                                         const Polygon_soup& to);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_TRANSFER_MESH_ATTRIBUTES_H
