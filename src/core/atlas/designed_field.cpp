// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>

#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

Result<void> solve_field(const Triangle_surface& surface, Harmonic_field& harmonic, Designed_field& field) {
  harmonic.clear_constraints();
  std::vector<int> wanted = field.minima;
  wanted.insert(wanted.end(), field.maxima.begin(), field.maxima.end());
  for (const bool is_maximum : {false, true})
    for (int v : is_maximum ? field.maxima : field.minima) {
      const auto value = field.extremal_values.find(v);
      const Result<void> set =
          harmonic.set_constraint(v, value != field.extremal_values.end() ? value->second : is_maximum);
      if (!set) return set;
    }
  for (const auto& [v, value] : field.curve_values)
    if (Result<void> set = harmonic.set_constraint(v, value); !set) return set;
  const std::vector<std::vector<int>> loops = boundary_loops(surface);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto given = field.boundary_values.find(int(i));
    const double value =
        given != field.boundary_values.end() ? given->second : double(field.boundary_is_maximum[i]);
    for (int h : loops[i])
      if (Result<void> set = harmonic.set_constraint(surface.source(h), value); !set) return set;
  }
  Result<Locally_clamped_field> solved = harmonic.solve_with_local_clamping(wanted);
  if (!solved) return solved.error();
  field.values = std::move(solved->values);
  field.elimination_order = harmonic.elimination_order();
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
