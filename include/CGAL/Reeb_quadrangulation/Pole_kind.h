// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_POLE_KIND_H
#define CGAL_REEB_QUADRANGULATION_POLE_KIND_H

namespace CGAL {
namespace Reeb_quadrangulation {

/// How an extremum becomes quads (paper, section 6.3).
enum class Pole_kind : signed char {
  whole,  ///< one vertex in a fan of triangles: not all-quad
  half,   ///< the two ends of a segment, of valence 2
  quarter ///< four vertices of valence 3 (default)
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_POLE_KIND_H
