// SPDX-License-Identifier: GPL-3.0-or-later
// Columns that end or begin inside of annuli: their textures, and the edits that make them.
#include <CGAL/Reeb_quadrangulation/dislocations.h>

#include "editor_sessions.h"
#include "tiny_textures.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using Catch::Contains;
using sessions::applied;
using sessions::at;
using sessions::chart_at;
using sessions::refused;

namespace {

std::vector<double> levels(int rows) {
  std::vector<double> u;
  for (int r = 0; r <= rows; ++r) u.push_back(double(r) / rows);
  return u;
}

Dislocated_texture made(int columns, int rows, const std::vector<Dislocation>& list) {
  Result<Dislocated_texture> texture = dislocated_annulus_texture(columns, levels(rows), list);
  INFO((texture ? "" : texture.error().message));
  REQUIRE(bool(texture));
  CHECK(tiny::is_sound(texture->texture));
  return std::move(*texture);
}

/// The numbers of quads around the vertices, two more on sides, as if the texture went on regularly there.
std::vector<int> valences_of(const Quad_texture& texture) {
  std::vector<int> valence(texture.v.size(), 0);
  for (const Quad& q : texture.quads)
    for (int v : q) ++valence[std::size_t(v)];
  for (const std::vector<int>& side : texture.sides)
    for (int v : side) valence[std::size_t(v)] += 2;
  return valence;
}

/// The ends are exactly the vertices that are not regular.
void check_ends(const Dislocated_texture& texture) {
  std::vector<int> expected(texture.texture.v.size(), 4);
  for (const auto& [three, five] : texture.ends) {
    expected[std::size_t(three)] = 3;
    expected[std::size_t(five)] = 5;
  }
  CHECK(valences_of(texture.texture) == expected);
}

int opposite_corner(const Quad_texture& texture, int vertex) {
  for (const Quad& q : texture.quads)
    for (std::size_t i = 0; i < 4; ++i)
      if (q[i] == vertex && valences_of(texture)[std::size_t(q[(i + 2) % 4])] == 5) return q[(i + 2) % 4];
  return -1;
}

int quads_of(const Editor& editor) {
  return int(editor.quads().mesh.quads.size());
}

// The sum of 4 - valence over all vertices: four times the Euler characteristic of a closed surface.
int sum_of_indices(const Editor& editor) {
  int sum = 0;
  for (const auto& [valence, number] : editor.quads().valences) sum += (4 - valence) * number;
  return sum;
}

int high_columns(const Design_chart& chart) {
  return int(chart.texture.texture.sides[1].size());
}

} // namespace

TEST_CASE(
    "where two columns end, a quad has a vertex of valence 3 and one of valence 5 at opposite corners") {
  for (int columns : {6, 7, 12})
    for (int rows : {2, 3, 7})
      for (double v : {0.0, 0.31, 0.99})
        for (double u : {0.0, 0.5, 1.0})
          for (int change : {-2, 2}) {
            const Dislocated_texture t = made(columns, rows, {{v, u, change}});
            CHECK(t.texture.sides[0].size() == std::size_t(columns));
            CHECK(t.texture.sides[1].size() == std::size_t(columns + change));
            check_ends(t);
            CHECK(opposite_corner(t.texture, t.ends[0][0]) == t.ends[0][1]);
          }
}

TEST_CASE("pairs that follow each other end all their columns with two extraordinary vertices") {
  for (int change : {-6, -4, 4, 6}) {
    const Dislocated_texture t = made(12, 6, {{0.4, 0.5, change}});
    CHECK(t.texture.sides[1].size() == std::size_t(12 + change));
    check_ends(t);
    CHECK(tiny::inner_valences(t.texture).at(3) == 1);
    CHECK(tiny::inner_valences(t.texture).at(5) == 1);
  }
}

TEST_CASE("dislocations lie as near to their places as rows and columns permit, and off the sides") {
  const Dislocated_texture t = made(16, 8, {{0.5, 0.4, -2}, {0.1, 0.9, 2}});
  const auto near = [&](int vertex, double v, double u) {
    CHECK(std::abs(std::remainder(t.texture.v[std::size_t(vertex)] - v, 1.0)) < 1.0 / 16);
    CHECK(std::abs(t.texture.u[std::size_t(vertex)] - u) < 1.5 / 8);
  };
  for (int end : t.ends[0]) near(end, 0.5, 0.4);
  for (int end : t.ends[1]) near(end, 0.1, 0.8);
  for (const auto& pair : t.ends)
    for (int end : pair) {
      CHECK(t.texture.u[std::size_t(end)] > 0);
      CHECK(t.texture.u[std::size_t(end)] < 1);
    }
}

TEST_CASE("random dislocations make sound textures, or have no room") {
  tiny::Random random(7);
  int placed = 0, without_room = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int columns = 4 + random.below(20), rows = 2 + random.below(10);
    std::vector<Dislocation> list;
    for (int i = 1 + random.below(6); i > 0; --i)
      list.push_back({random.unit(), random.unit(), (random.below(2) == 0 ? -2 : 2) * (1 + random.below(3))});
    const Result<Dislocated_texture> t = dislocated_annulus_texture(columns, levels(rows), list);
    INFO(trial << ": " << columns << " x " << rows);
    if (!t) {
      CHECK_THAT(t.error().message, Contains("has no room for its dislocations"));
      ++without_room;
      continue;
    }
    int gained = 0;
    for (const Dislocation& d : list) gained += d.columns;
    CHECK(tiny::is_sound(t->texture));
    CHECK(int(t->texture.sides[1].size()) == columns + gained);
    // Ends on the high side may meet there; all others are as predicted.
    if (rows > 5) check_ends(*t);
    ++placed;
  }
  CHECK(placed > 60);
  CHECK(without_room > 20);
}

TEST_CASE("an annulus that gains columns has them at its high walk, and quads in proportion") {
  Sampling_problem problem;
  problem.edges = {{1.0, 4, 2, 0}, {0.5, 4, 2, 0}};
  Sampling_chart low, tube, high;
  low.kind = high.kind = Sampling_chart::Kind::disc;
  low.high = {0};
  tube.low = {0};
  tube.high = {1};
  tube.height = 0.5;
  high.low = {1};
  tube.columns_gained = -10;
  problem.charts = {low, tube, high};
  const Result<Sampling> s = sample_layout(problem, 0.05);
  REQUIRE(bool(s));
  CHECK(s->counts == std::vector<int>{20, 10});
  CHECK(s->grid[1] == std::array<int, 2>{{20, 10}});
  CHECK(s->quads == 25 + 150 + 6);
  problem.charts[1].locked_columns = 16;
  CHECK(sample_layout(problem, 0.05)->counts == std::vector<int>{16, 6});
  problem.charts[1].locked_columns = 12;
  CHECK(!sample_layout(problem, 0.05)); // two columns are fewer than a contour has
}

TEST_CASE("columns end where an edit says, the indices' sum stays, and undo gives the same bytes") {
  Editor editor = sessions::sphere_session();
  const Surface_point belt = at(1, 0, 0);
  const std::map<int, int> before = sessions::valences(editor);
  CHECK(sum_of_indices(editor) == 8);
  applied(editor, Add_dislocation{belt, -2});
  std::map<int, int> after = before;
  ++after[3];
  ++after[5];
  CHECK(sessions::valences(editor) == after);
  CHECK(sum_of_indices(editor) == 8);
  const Design_chart& chart = chart_at(editor, belt);
  CHECK(high_columns(chart) == chart.grid[0] - 2);
  applied(editor, Add_dislocation{at(-1, 0, 0.2), 4});
  ++after[3];
  ++after[5];
  CHECK(sessions::valences(editor) == after);
  CHECK(high_columns(chart_at(editor, belt)) == chart_at(editor, belt).grid[0] + 2);
}

TEST_CASE("opposite dislocations annihilate where they meet") {
  Editor editor = sessions::torus_session();
  const std::map<int, int> before = sessions::valences(editor);
  const Surface_point place = at(0, 1.4, 0);
  applied(editor, Add_dislocation{place, -4});
  applied(editor, Add_dislocation{place, 2});
  REQUIRE(chart_at(editor, place).settings.dislocations.size() == 1);
  CHECK(chart_at(editor, place).settings.columns_gained() == -2);
  applied(editor, Add_dislocation{place, 6});
  CHECK(chart_at(editor, place).settings.columns_gained() == 4);
  applied(editor, Add_dislocation{place, -4});
  CHECK(chart_at(editor, place).settings.dislocations.empty());
  CHECK(sessions::valences(editor) == before);
  CHECK(sum_of_indices(editor) == 0);
  applied(editor, Add_dislocation{place, 2});
  applied(editor, Remove_dislocation{place});
  CHECK(sessions::valences(editor) == before);
}

TEST_CASE("either side of an annulus gets the columns that are asked for") {
  Editor editor = sessions::sphere_session();
  const Surface_point belt = at(1, 0, 0);
  const int low = chart_at(editor, belt).grid[0];
  applied(editor, Set_columns{belt, low - 8, Chart_side::high});
  CHECK(chart_at(editor, belt).grid[0] == low);
  CHECK(high_columns(chart_at(editor, belt)) == low - 8);
  CHECK(sessions::valences(editor).at(5) == 2); // two dislocations of two pairs
  applied(editor, Set_columns{belt, low + 2, Chart_side::low});
  CHECK(chart_at(editor, belt).grid[0] == low + 2);
  CHECK(high_columns(chart_at(editor, belt)) == low - 8);
  applied(editor, Set_columns{belt, 0, Chart_side::high});
  CHECK(chart_at(editor, belt).settings.dislocations.empty());
  CHECK(sessions::valences(editor).count(5) == 0);
}

TEST_CASE("dislocations stay where they are while contours and sizes change around them") {
  Editor editor = sessions::sphere_session();
  const Surface_point place = at(0.9, 0, 0.3);
  applied(editor, Add_dislocation{place, -2});
  applied(editor, Subdivide_chart{at(0, 1, 0)});
  CHECK(chart_at(editor, place).settings.columns_gained() == -2);
  CHECK(chart_at(editor, at(0.9, 0, -0.3)).settings.columns_gained() == 0);
  applied(editor, Drag_contour{at(0, 1, 0), at(0, 0.95, 0.2)});
  CHECK(chart_at(editor, place).settings.columns_gained() == -2);
  applied(editor, Set_target{800, 0});
  CHECK(sessions::valences(editor).at(5) == 1);
  CHECK(std::abs(quads_of(editor) - 800) < 60);
  applied(editor, Remove_contour{at(0, 0.95, 0.2)});
  CHECK(chart_at(editor, at(1, 0, 0.1)).settings.columns_gained() == -2);
  applied(editor, Set_rows{place, 9});
  applied(editor, Set_shift{place, 2});
  CHECK(sessions::valences(editor).at(5) == 1);
}

TEST_CASE("dislocations that cannot be are refused with a reason") {
  Editor editor = sessions::sphere_session();
  const Surface_point belt = at(1, 0, 0);
  refused(editor, Add_dislocation{belt, -3},
          "a dislocation has an even number of columns from -6 to 6, and not 0");
  refused(editor, Add_dislocation{at(0, 0, 1), -2}, "a disc has no columns and rows of its own");
  refused(editor, Remove_dislocation{belt}, "the chart has no dislocations");
  refused(editor, Set_columns{belt, 400, Chart_side::high},
          "the columns of a side are at most five times those of the other");
  applied(editor, Lock_chart{belt});
  refused(editor, Add_dislocation{belt, -2}, "the edit would change a locked chart");
  applied(editor, Lock_chart{belt, false});
  applied(editor, Set_rows{belt, 2});
  const Result<Edit_report> done = editor.apply(Add_dislocation{belt, -4});
  REQUIRE(!done);
  CHECK_THAT(done.error().message, Contains("a chart has no room for its dislocations"));
}

namespace {

// The standard deviation of the quads' areas over their mean.
double variation_of_areas(const Editor& editor) {
  const Quad_mesh mesh = editor.quads().mesh;
  double sum = 0, squares = 0;
  for (const Quad& q : mesh.quads) {
    const auto at = [&](std::size_t i) { return mesh.points[std::size_t(q[i])]; };
    const double area = 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
    sum += area;
    squares += area * area;
  }
  const double n = double(mesh.quads.size()), mean = sum / n;
  return std::sqrt(squares / n - mean * mean) / mean;
}

int dislocations_of(const Editor& editor) {
  int number = 0;
  for (const auto& chart : editor.design().charts) number += int(chart->settings.dislocations.size());
  return number;
}

} // namespace

TEST_CASE("columns that end at a waist and begin again behind it make quads more alike") {
  Triangle_surface waisted = sessions::shape("sphere", 3000);
  for (Point& p : waisted.points) {
    const double thin = 0.25 + 0.75 * p.z() * p.z();
    p = Point(thin * p.x(), thin * p.y(), 2 * p.z());
  }
  Editor editor = sessions::session(waisted, sessions::extrema({0, 0, -2}, {{0, 0, 2}}), 2500);
  const double before = variation_of_areas(editor);
  applied(editor, Balance_columns{6, 0.5});
  CHECK(dislocations_of(editor) > 1);
  CHECK(dislocations_of(editor) <= 6);
  CHECK(sessions::valences(editor).at(5) == dislocations_of(editor));
  CHECK(variation_of_areas(editor) < 0.9 * before);
  CHECK(std::abs(quads_of(editor) - 2500) < 150);
  const int placed = dislocations_of(editor);
  applied(editor, Balance_columns{20, 0.5}); // charts that have dislocations keep theirs
  CHECK(dislocations_of(editor) >= placed);
  refused(editor, Balance_columns{0, 8},
          "1 to 10,000 dislocations are placed, and a column has a positive price");
}

TEST_CASE("with dear dislocations counts are balanced without any") {
  Editor editor = sessions::torus_session();
  const std::map<int, int> before = sessions::valences(editor);
  applied(editor, Balance_columns{4, 1e6});
  CHECK(sessions::valences(editor) == before);
}
