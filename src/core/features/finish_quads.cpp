// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/finisher.h"

namespace CGAL {
namespace Reeb_quadrangulation {

Result<Finished_quads> finish_quads(Quad_mesh mesh, const Triangle_surface& input,
                                    const Relax_options& relaxation, const Snap_options& features,
                                    Observer* observer, const std::vector<int>& held) {
  const Surface_projector projector(input);
  return internal::Finisher(projector, relaxation, features, observer, held).run(std::move(mesh));
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
