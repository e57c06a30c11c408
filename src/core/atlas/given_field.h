// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that are given, as fields to design with.
#ifndef REEBQUAD_ATLAS_GIVEN_FIELD_H
#define REEBQUAD_ATLAS_GIVEN_FIELD_H

#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The levels and values of a closed surface: loops that are minima lie below everything else, maxima above.
void close_field(const Closed_surface& closed, const std::vector<std::vector<int>>& loops,
                 const Designed_field& field, std::vector<double>& values, std::vector<signed char>& level);

/// A field of `from` on a surface that `prepare_surface()` made of it: its values are interpolated, its
/// extrema and loops go where their vertices have gone. Fails with `impossible_request` where a minimum and a
/// maximum have become one vertex.
Result<Designed_field> carried_field(const Triangle_surface& from, const Surface_projector& on_from,
                                     const Designed_field& field, const Triangle_surface& to,
                                     const std::vector<int>& vertex_in_to);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_ATLAS_GIVEN_FIELD_H
