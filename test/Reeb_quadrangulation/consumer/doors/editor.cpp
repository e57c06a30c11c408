// SPDX-License-Identifier: GPL-3.0-or-later
// An editing session on the consumer's mesh: two extrema at its vertices, then undo; the quads come back as a
// mesh.
#include "torus.h"

#include <CGAL/Reeb_quadrangulation/create_editor.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

int main() {
  const Mesh mesh = torus();
  auto editor = RQ::create_editor(mesh, RQ::parameters::number_of_quads(800));
  if (!editor) return std::cerr << editor.error().message << '\n', 1;
  RQ::Set_extrema edit;
  edit.extrema.push_back({RQ::surface_point(mesh, Mesh::Vertex_index(0)), false});
  edit.extrema.push_back({RQ::surface_point(mesh, Mesh::Vertex_index(30 * 30)), true});
  if (const auto done = editor->apply(edit); !done) return std::cerr << done.error().message << '\n', 1;
  Mesh quads;
  const auto added = RQ::to_face_graph(editor->quads().mesh, quads);
  if (!added) return std::cerr << added.error().message << '\n', 1;
  std::cout << quads.number_of_faces() << " quads in " << editor->design().charts.size() << " charts\n";
  editor->undo();
  return CGAL::is_closed(quads) && editor->design().charts.empty() && quads.number_of_faces() > 700 ? 0 : 1;
}
