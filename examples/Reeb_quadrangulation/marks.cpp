// SPDX-License-Identifier: GPL-3.0-or-later
// Quads keep edges that the user marks: here a line on a smooth sphere, which no angle finds. The run tells
// how much of it edges of quads lie on.
#include <CGAL/Reeb_quadrangulation/kept_features.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <iostream>
#include <vector>

using namespace CGAL::Reeb_quadrangulation;

// The edges between the faces left and right of a plane.
Marks marks_across(const Triangle_surface& surface, const Point& normal) {
  std::vector<int> group;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const Triangle& t = surface.triangles[f];
    group.push_back(normal.dot(surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) > 0);
  }
  Marks marks;
  marks.marked = borders_of_groups(surface, group);
  return marks;
}

int main() {
  Result<Triangle_surface> sphere = make_shape("sphere", 4000);
  if (!sphere || !sphere->connect()) return 1;
  Quadrangulation_options options;
  options.quads = 1000;
  options.marks = marks_across(*sphere, Point(0.2, 0.1, 1));
  const Result<Quadrangulation> result = quadrangulate(*sphere, options);
  if (!result) {
    std::cerr << result.error().message << '\n';
    return 1;
  }
  const Result<Marked_features> marked = marked_features(*sphere, options.marks, 45);
  if (!marked) return 1;
  double on = 0, length = 0;
  for (const Kept_chain& chain : kept_chains(result->mesh, *sphere, marked->features.edges)) {
    on += chain.on;
    length += chain.length;
  }
  std::cout << "marks of length " << length << ", of which " << on << " lies on edges of quads\n";
  return result->relaxation.inverted_after == 0 ? 0 : 1;
}
