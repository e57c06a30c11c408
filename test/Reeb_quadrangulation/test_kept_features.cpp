// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include "features/blame.h"
#include "features/snap_to_chains.h"

#include <CGAL/Reeb_quadrangulation/kept_features.h>

#include <algorithm>
#include <cmath>

using namespace CGAL::Reeb_quadrangulation;

namespace {

int id(int n, int x, int y) {
  return y * (n + 1) + x;
}

// The square [0, n]^2 folded along x = n / 2 by a right angle.
Point folded(int n, double x, double y) {
  const double over = std::max(0.0, x - 0.5 * n);
  return Point(x - over, y, -over);
}

Triangle_surface folded_sheet(int n) {
  Triangle_surface s;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) s.points.push_back(folded(n, x, y));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      s.triangles.push_back({id(n, x, y), id(n, x + 1, y), id(n, x + 1, y + 1)});
      s.triangles.push_back({id(n, x, y), id(n, x + 1, y + 1), id(n, x, y + 1)});
    }
  return tiny::connected(std::move(s));
}

// A grid of quads on it, whose line number n / 2 is `shift(y)` away from the fold.
template <class Shift> Quad_mesh grid(int n, const Shift& shift) {
  Quad_mesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) mesh.points.push_back(folded(n, x == 0 || x == n ? x : x + shift(y), y));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      mesh.quads.push_back({id(n, x, y), id(n, x + 1, y), id(n, x + 1, y + 1), id(n, x, y + 1)});
  return mesh;
}

// The fold alone.
Kept_chain kept(const Quad_mesh& mesh, const Triangle_surface& surface) {
  Feature_edges features = feature_edges(surface, 45);
  features.chains.erase(std::remove_if(features.chains.begin(), features.chains.end(),
                                       [](const Feature_chain& c) { return c.boundary; }),
                        features.chains.end());
  REQUIRE(features.chains.size() == 1);
  return kept_chains(mesh, surface, features)[0];
}

} // namespace

TEST_CASE("a chain is on edges of quads, near them or lost, and these are its length") {
  const int n = 8;
  const Triangle_surface surface = folded_sheet(n);
  const Kept_chain on = kept(grid(n, [](int) { return 0.0; }), surface);
  CHECK(on.length == Approx(n));
  CHECK(on.on == Approx(n));
  CHECK(on.missed == 0);
  const Kept_chain near = kept(grid(n, [](int) { return 0.3; }), surface);
  CHECK(near.on == 0);
  CHECK(near.near == Approx(n));
  CHECK(near.missed == Approx(n));
  // Across the fold: the grid's lines leave it by an edge and a half for each that they follow it.
  const Kept_chain lost = kept(grid(n, [](int y) { return y % 2 == 0 ? -0.75 : 0.75; }), surface);
  CHECK(lost.lost() > 0.5 * n);
  for (const Kept_chain& chain : {on, near, lost})
    CHECK(chain.on + chain.near + chain.lost() == Approx(chain.length));
}

TEST_CASE("the place of the longest stretch that is missed is its middle") {
  const int n = 8;
  const Triangle_surface surface = folded_sheet(n);
  const Kept_chain chain = kept(grid(n, [](int y) { return y < 4 ? 0.0 : 0.3; }), surface);
  CHECK(chain.on == Approx(3).margin(0.3));
  CHECK(chain.missed == Approx(5).margin(0.3));
  CHECK((chain.missed_at - Point(0.5 * n, 5.5, 0)).norm() < 0.5);
}

TEST_CASE("where the kept part is counted, chains count by their length, and none is all") {
  CHECK(kept_part({}) == 1);
  Kept_chain one, two;
  one.length = one.on = 1;
  two.length = 3;
  CHECK(kept_part({one, two}) == Approx(0.25));
}

TEST_CASE("bad quads are blamed on the nearest chain, and the costliest chains come first") {
  const int n = 12;
  const Quad_mesh before = grid(n, [](int) { return 0.0; });
  Vertex_constraints onto;
  onto.fixed.assign(before.points.size(), 0);
  for (int x : {2, 10}) {
    onto.curves.push_back(make_surface_curve({folded(n, x, 0), folded(n, x, n)}, false));
    for (int y = 1; y < n; ++y) onto.places.push_back({id(n, x, y), int(onto.curves.size()) - 1, double(y)});
  }
  const std::vector<int> chain = internal::chains_around(before, onto, {7, 3});
  CHECK(chain[std::size_t(id(n, 2, 5))] == 7);
  CHECK(chain[std::size_t(id(n, 0, 5))] == 7);
  CHECK(chain[std::size_t(id(n, 11, 5))] == 3);
  const int quad = 5 * n + 1, other = 5 * n + 10;
  CHECK(internal::chains_at(before, {quad}, chain) == std::vector<int>{7});
  CHECK(internal::chains_at(before, {quad, other}, chain) == std::vector<int>{3, 7});
  Quad_mesh after = before;
  after.points[std::size_t(id(n, 1, 5))].y() += 0.5;  // spoils quads at chain 7
  after.points[std::size_t(id(n, 11, 5))].y() += 0.1; // and a little at chain 3
  CHECK(internal::costliest_chains(before, after, chain, 0.05) == std::vector<int>{7});
  CHECK(internal::costliest_chains(before, after, chain, 100) == std::vector<int>{3, 7});
  CHECK(internal::costliest_chains(before, before, chain, 1).empty());
}

TEST_CASE("a line that is laid first takes its ends to the corners, and they are held there") {
  const int n = 10;
  Triangle_surface surface = folded_sheet(n);
  // Of the fold, only a part inside is a feature.
  std::vector<char> sharp(std::size_t(surface.number_of_halfedges()), 0);
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const Point &a = surface.points[surface.source(h)], &b = surface.points[surface.target(h)];
    sharp[std::size_t(h)] = a.x() == 0.5 * n && b.x() == 0.5 * n && a.z() == 0 && b.z() == 0 &&
                            std::min(a.y(), b.y()) >= 2 && std::max(a.y(), b.y()) <= 8;
  }
  const Given_features features = given_features(surface, sharp, {});
  Quad_mesh mesh = grid(n, [](int) { return 0.4; });
  Snap_options options;
  options.lines = true;
  options.shortest_chain = 0;
  Vertex_constraints found;
  std::vector<int> chain_of_curve;
  const internal::Chosen_features all(features);
  const Snap_report report = internal::snap_to_chains(mesh, Surface_projector(surface), all, options,
                                                      {true, {}}, found, chain_of_curve);
  CHECK(report.missed_corners == 0);
  for (int y : {2, 8}) {
    const std::size_t v = std::size_t(id(n, n / 2, y));
    CHECK(mesh.points[v] == Point(0.5 * n, y, 0));
    CHECK(found.fixed[v]);
  }
  for (const Vertex_constraints::Place& place : found.places)
    CHECK_FALSE(found.fixed[std::size_t(place.vertex)]);
}
