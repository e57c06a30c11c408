// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/kept_features.h>
#include <CGAL/Reeb_quadrangulation/marks.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// A flat square [0, n]^2.
Triangle_surface square(int n) {
  Triangle_surface s;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) s.points.emplace_back(x, y, 0);
  const auto id = [&](int x, int y) { return y * (n + 1) + x; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      s.triangles.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1)});
      s.triangles.push_back({id(x, y), id(x + 1, y + 1), id(x, y + 1)});
    }
  return tiny::connected(std::move(s));
}

double inner_length(const Triangle_surface& s, const Feature_edges& edges) {
  double sum = 0;
  for (const Feature_chain& chain : edges.chains)
    for (int h : chain.halfedges)
      if (!chain.boundary) sum += (s.points[s.target(h)] - s.points[s.source(h)]).norm();
  return sum;
}

} // namespace

TEST_CASE("a mark covers the edges in a line below it, and no others, whatever their angle") {
  const Triangle_surface s = square(8);
  Marks marks;
  marks.marked = {{Point(2, 3, 0), Point(6, 3, 0)}};
  const Result<Marked_features> found = marked_features(s, marks, 45);
  REQUIRE(found);
  CHECK(found->found == std::vector<double>{1});
  CHECK(inner_length(s, found->features.edges) == Approx(4));
}

TEST_CASE("marks that are pieces of edges find these, and marks beside the surface find nothing and say so") {
  const Triangle_surface s = square(8);
  Marks pieces;
  for (int i = 0; i < 8; ++i) pieces.marked.push_back({Point(2 + 0.5 * i, 3, 0), Point(2.5 + 0.5 * i, 3, 0)});
  const Result<Marked_features> found = marked_features(s, pieces, 0);
  REQUIRE(found);
  CHECK(inner_length(s, found->features.edges) == Approx(4));
  Marks beside;
  beside.marked = {{Point(2, 3, 1), Point(6, 3, 1)}, {Point(2.5, 3, 0), Point(2.5, 6, 0)}};
  const Result<Marked_features> none = marked_features(s, beside, 0);
  REQUIRE(none);
  CHECK(none->found == std::vector<double>{0, 0});
  CHECK(inner_length(s, none->features.edges) == 0);
}

TEST_CASE("marks within the tolerance are found, and what is unmarked is no feature though it is sharp") {
  const Triangle_surface cube = tiny::connected(*make_shape("l-shape", 800));
  const double all = inner_length(cube, marked_features(cube, {}, 45)->features.edges);
  REQUIRE(all > 0);
  Marks marks;
  const Feature_edges sharp = feature_edges(cube, 45);
  const Feature_chain& chain = sharp.chains.front();
  double length = 0;
  for (int h : chain.halfedges) {
    const Point &a = cube.points[cube.source(h)], &b = cube.points[cube.target(h)];
    marks.unmarked.push_back({a, b});
    length += (b - a).norm();
  }
  CHECK(inner_length(cube, marked_features(cube, marks, 45)->features.edges) == Approx(all - length));
  marks.marked = marks.unmarked; // marked too: it counts
  CHECK(inner_length(cube, marked_features(cube, marks, 45)->features.edges) == Approx(all));
  const Mark& first = marks.unmarked.front();
  const Point aside = 1e-4 * (first.to - first.from).unitOrthogonal();
  for (Mark& mark : marks.marked) mark = {mark.from + aside, mark.to + aside};
  CHECK(inner_length(cube, marked_features(cube, marks, 45)->features.edges) == Approx(all - length));
  marks.tolerance = 1e-3;
  CHECK(inner_length(cube, marked_features(cube, marks, 0)->features.edges) >= length - 1e-9);
}

TEST_CASE("the borders of groups are the edges between them") {
  const int n = 6;
  const Triangle_surface s = square(n);
  std::vector<int> group(std::size_t(s.number_of_faces()), 0);
  for (int f = 0; f < s.number_of_faces(); ++f) group[std::size_t(f)] = f / (2 * n) < 2 ? 5 : 7;
  Marks marks;
  marks.marked = borders_of_groups(s, group);
  CHECK(marks.marked.size() == std::size_t(n));
  const Result<Marked_features> found = marked_features(s, marks, 0);
  REQUIRE(found);
  CHECK(inner_length(s, found->features.edges) == Approx(n));
  CHECK(borders_of_groups(s, std::vector<int>(group.size(), 1)).empty());
}

TEST_CASE("what is not finite or out of range is refused, and names the mark") {
  const Triangle_surface s = square(2);
  Marks marks;
  marks.marked = {{Point(0, 1, 0), Point(1, 1, 0)}, {Point(0, 1, 0), Point(std::nan(""), 1, 0)}};
  const Result<Marked_features> refused = marked_features(s, marks, 45);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == Error_code::impossible_request);
  CHECK(refused.error().message.find("mark 2") != std::string::npos);
  marks.marked.pop_back();
  marks.tolerance = -1;
  CHECK_FALSE(marked_features(s, marks, 45));
  CHECK_FALSE(marked_features(s, {}, 200));
}

TEST_CASE("a run keeps marked edges that no angle finds, and its recipe has the marks") {
  const Triangle_surface bar = tiny::connected(*make_shape("twisted-bar", 2000));
  Quadrangulation_options options;
  options.quads = 500;
  options.keep_features = false;
  const Feature_edges sharp = feature_edges(bar, 45);
  for (const Feature_chain& chain : sharp.chains)
    for (int h : chain.halfedges)
      options.marks.marked.push_back({bar.points[bar.source(h)], bar.points[bar.target(h)]});
  const Result<Quadrangulation> marked = quadrangulate(bar, options);
  REQUIRE(marked);
  options.marks = {};
  const Result<Quadrangulation> plain = quadrangulate(bar, options);
  REQUIRE(plain);
  const double before = kept_part(kept_chains(plain->mesh, bar, sharp));
  const double after = kept_part(kept_chains(marked->mesh, bar, sharp));
  CHECK(after > before + 0.2);
  CHECK(marked->relaxation.inverted_after == 0);
  const Result<Recipe> again = recipe_from_json(to_json(marked->recipe));
  REQUIRE(again);
  REQUIRE(again->finish.marks.marked.size() == marked->recipe.finish.marks.marked.size());
  CHECK(to_json(*again) == to_json(marked->recipe));
  const Result<Finished_design> replayed = marked->editor.finished_quads(again->finish);
  REQUIRE(replayed);
  CHECK(replayed->quads.mesh.points == marked->mesh.points);
}
