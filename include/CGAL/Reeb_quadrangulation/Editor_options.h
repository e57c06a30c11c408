// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_EDITOR_OPTIONS_H
#define CGAL_REEB_QUADRANGULATION_EDITOR_OPTIONS_H

namespace CGAL {
namespace Reeb_quadrangulation {

/// Options of an editing session. They are part of what a recipe depends on.
struct Editor_options {
  int quads = 3000;       ///< of the first design; later `Set_target` edits change it
  double edge_length = 0; ///< used instead if positive
  bool prepare = true;    ///< work on a refined copy where the surface is coarse; see `prepare_surface()`
  double sample_blend = 0.5;
  int threads = 0; ///< charts solved at once; 0 = as many as the machine has. Results do not depend on it
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_EDITOR_OPTIONS_H
