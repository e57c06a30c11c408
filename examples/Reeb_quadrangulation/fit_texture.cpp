// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse quads that keep the sharp edges of a shape: the textures of its charts are fitted to them before
// anything is stitched.
#include "edit_session.h"

#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

namespace RQ = CGAL::Reeb_quadrangulation;

namespace {

// The share of the sharp edges that edges of the finished quads run along.
double covered(const RQ::Editor& editor) {
  const RQ::Result<RQ::Finished_design> quads = editor.finished_quads();
  if (!quads) {
    std::cerr << quads.error().message << '\n';
    std::exit(1);
  }
  const RQ::Mesh_statistics statistics = quad_statistics(quads->quads.mesh, &editor.input());
  std::cout << "  " << statistics.quads << " quads, " << statistics.inverted_quads << " inverted; "
            << 100 * *statistics.covered_sharp_edges << " % of the sharp edges run along edges of quads\n";
  return *statistics.covered_sharp_edges;
}

} // namespace

int main() {
  using namespace edit_session;
  RQ::Editor editor = begin("twisted-bar", 4000, at(0, 0, 0), at(0, 0, 4));
  apply(editor, RQ::Set_target{200, 0});
  const double before = covered(editor);
  apply(editor, RQ::Fit_texture{at(0, 0, 2), 45, RQ::Edit_scope::surface});
  std::cout << "  " << editor.quads().held_vertices.size() << " vertices are held on sharp edges\n";
  return covered(editor) > before ? 0 : 1;
}
