// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_H
#define CGAL_REEB_QUADRANGULATION_H

/// \file
/// Includes every public header of the package.

#include <CGAL/Reeb_quadrangulation/Contour_network.h>
#include <CGAL/Reeb_quadrangulation/Embedding.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/Vertex_order.h>
#include <CGAL/Reeb_quadrangulation/decimate.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>
#include <CGAL/Reeb_quadrangulation/linear_solver.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#endif // CGAL_REEB_QUADRANGULATION_H
