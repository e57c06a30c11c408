// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity textures: charts whose quads are edited like paint, and still close into one mesh of quads.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdlib>
#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;

namespace {

// Applies an edit and says what the mesh is then.
void apply(RQ::Editor& editor, const char* what, const RQ::Edit& edit) {
  const RQ::Result<RQ::Edit_report> done = editor.apply(edit);
  if (!done) {
    std::cerr << what << ": " << done.error().message << '\n';
    std::exit(1);
  }
  const RQ::Stitched_mesh quads = editor.quads();
  std::cout << what << ": " << done->remeshed_charts.size() << " charts changed; " << quads.mesh.quads.size()
            << " quads, " << quads.t_junctions << " T-junctions resolved;";
  for (const auto& [valence, number] : quads.valences)
    std::cout << "  " << number << " of valence " << valence;
  std::cout << '\n';
}

RQ::Surface_point at(double x, double y, double z) {
  return {RQ::Point(x, y, z), -1};
}

// An edge of the chart at a point that runs from row to row: its polychord goes along a row.
RQ::Surface_point edge_between_rows(const RQ::Editor& editor, const RQ::Surface_point& point) {
  const RQ::Design_chart& chart = *editor.design().charts[std::size_t(editor.chart_at(point))];
  const RQ::Quad_texture& t = chart.texture.texture;
  const RQ::Quad& q = t.quads.front();
  return surface_point(chart, edge_place(t, {0, t.u[q[0]] == t.u[q[1]] ? 1 : 0}));
}

RQ::Edit_texture texture(RQ::Texture_operator operation, const RQ::Surface_point& point,
                         RQ::Edit_scope scope = RQ::Edit_scope::chart) {
  return {operation, {point}, 0.5, scope};
}

} // namespace

int main() {
  RQ::Editor_options options;
  options.quads = 200;
  RQ::Result<RQ::Editor> made = RQ::Editor::create(*RQ::make_shape("sphere", 3000), options);
  if (!made) {
    std::cerr << made.error().message << '\n';
    return 1;
  }
  RQ::Editor& editor = *made;
  RQ::Set_extrema poles;
  poles.extrema.push_back({at(0, 0, -1), false, -1});
  poles.extrema.push_back({at(0, 0, 1), true, -1});
  apply(editor, "a regular design", poles);

  // A line of new edges until it closes, a ring around the belt: no extraordinary vertex more.
  apply(editor, "a polychord",
        texture(RQ::Texture_operator::insert_polychord, edge_between_rows(editor, at(1, 0, 0)),
                RQ::Edit_scope::surface));
  // The face of a cube.
  apply(editor, "a cube subdivision", texture(RQ::Texture_operator::inset_quads, at(0, 1, 0)));
  // One vertex of it is moved to a place on the surface.
  apply(editor, "a vertex dragged", RQ::Drag_vertices{{at(0, 1, 0)}, at(0.05, 1, 0.05)});
  // The belt is made denser than the caps: T-junctions are resolved in the caps, whose textures stay as they
  // are.
  apply(editor, "the belt subdivided alone", texture(RQ::Texture_operator::subdivide, at(0, 1, 0)));

  const RQ::Result<RQ::Finished_design> finished = editor.finished_quads();
  if (!finished) {
    std::cerr << finished.error().message << '\n';
    return 1;
  }
  std::cout << "relaxed: " << finished->quads.mesh.quads.size() << " quads\n";
}
