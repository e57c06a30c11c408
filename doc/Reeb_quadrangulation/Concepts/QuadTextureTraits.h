// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgReebQuadrangulationConcepts
\cgalConcept

The concept `QuadTextureTraits` chooses the connectivity textures with which charts are filled:
`place_texture()` takes a model, and so does `quadrangulate()` by the named parameter `texture_traits`.

What a texture must be so that charts can be stitched, is checked by `check_texture()`, and an
`impossible_request` otherwise: a quad mesh of an annulus or a disc whose boundary is its sides, with one side
vertex for each sample of the contours. What it is inside is free: `Stitched_mesh::valences` predicts the
valences of any texture.

Functors are copied, and called by several threads at the same time.

\cgalHasModel `CGAL::Reeb_quadrangulation::Quad_texture_traits` (the default: regular grids)
*/
class QuadTextureTraits {
public:
  /// A functor with `std::vector<double> operator()(const Height_profile& profile, int rows) const`: the U of
  /// the level lines that part the rows of an annulus, strictly increasing from 0 to 1. `rows` is the number
  /// that makes quads square; any other number but one can be stitched too (one row could join two vertices
  /// by two edges).
  typedef unspecified_type Compute_row_levels;

  /// A functor with `Quad_texture operator()(int columns, const std::vector<double>& levels) const`: a
  /// texture of an annulus with `columns` vertices on its LOW and on its HIGH side, vertex i of either at V =
  /// i / columns.
  typedef unspecified_type Make_annulus_texture;

  /// A functor with `Quad_texture operator()(int a, int b, bool clockwise) const`: a texture of the rectangle
  /// [0, a] x [0, b] with 2 (a + b) vertices on its side, which have integral V and U, begin at (0, 0), and
  /// run counterclockwise or clockwise.
  typedef unspecified_type Make_disc_texture;

  Compute_row_levels compute_row_levels_object() const;
  Make_annulus_texture make_annulus_texture_object() const;
  Make_disc_texture make_disc_texture_object() const;
};
