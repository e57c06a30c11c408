// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_H
#define CGAL_REEB_QUADRANGULATION_H

/// \file
/// Includes every public header of the package.

#include <CGAL/Reeb_quadrangulation/Atlas.h>
#include <CGAL/Reeb_quadrangulation/Chart_locator.h>
#include <CGAL/Reeb_quadrangulation/Chart_parameterization.h>
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Contour_network.h>
#include <CGAL/Reeb_quadrangulation/Design.h>
#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>
#include <CGAL/Reeb_quadrangulation/Edit.h>
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/Embedding.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/hints.h>
#include <CGAL/Reeb_quadrangulation/IO/mesh_format.h>
#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Quad_texture.h>
#include <CGAL/Reeb_quadrangulation/Quad_texture_traits.h>
#include <CGAL/Reeb_quadrangulation/Reeb_chart_traits.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>
#include <CGAL/Reeb_quadrangulation/Texture_place.h>
#include <CGAL/Reeb_quadrangulation/Triangle_surface.h>
#include <CGAL/Reeb_quadrangulation/Vertex_order.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>
#include <CGAL/Reeb_quadrangulation/constrained_field.h>
#include <CGAL/Reeb_quadrangulation/decimate.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>
#include <CGAL/Reeb_quadrangulation/linear_solver.h>
#include <CGAL/Reeb_quadrangulation/merge_patches.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/parameters.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/plane_contour.h>
#include <CGAL/Reeb_quadrangulation/prepare_surface.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>
#include <CGAL/Reeb_quadrangulation/render.h>
#include <CGAL/Reeb_quadrangulation/sampling.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/snap_to_features.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>
#include <CGAL/Reeb_quadrangulation/suggest_edits.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>
#include <CGAL/Reeb_quadrangulation/thin_charts.h>

#endif // CGAL_REEB_QUADRANGULATION_H
