// SPDX-License-Identifier: GPL-3.0-or-later
// Whole poles: the quads leave a hole, a fan of triangles fills it, and nothing pretends that the mesh is
// all-quad.
#include "editor_sessions.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include <catch2/catch.hpp>

#include <set>

using namespace sessions;

namespace {

Edit whole(double z) {
  return Split_pole{at(0, 0, z), Pole_kind::whole, {}};
}

// Whether every edge of some polygons has one polygon on each side.
bool is_closed(const Polygon_soup& soup) {
  std::set<std::array<int, 2>> edges;
  for (int p = 0; p < soup.number_of_polygons(); ++p)
    for (int i = soup.begin[p]; i < soup.begin[p + 1]; ++i) {
      const int next = i + 1 < soup.begin[p + 1] ? i + 1 : soup.begin[p];
      if (!edges.insert({soup.corner[i], soup.corner[next]}).second) return false;
    }
  return std::all_of(edges.begin(), edges.end(), [&](const std::array<int, 2>& e) {
    return edges.count({e[1], e[0]}) > 0;
  });
}

int triangles_in(const Polygon_soup& soup) {
  int count = 0;
  for (int p = 0; p < soup.number_of_polygons(); ++p) count += soup.size_of_polygon(p) == 3;
  return count;
}

void check_certified(const Editor& editor, const Stitched_mesh& quads, int poles) {
  const std::vector<Pole_fan> fans = pole_fans(editor.design(), quads);
  REQUIRE(int(fans.size()) == poles);
  const Polygon_soup soup = with_fans(quads.mesh, fans);
  int triangles = 0;
  for (const Pole_fan& fan : fans) triangles += int(fan.ring.size());
  CHECK(triangles_in(soup) == triangles);
  const Stitched_mesh paired = with_paired_fans(quads, fans);
  const Certificate certificate = certify({paired.mesh, &editor.input(), paired.valences, paired.components});
  INFO(to_text(certificate));
  CHECK(certificate.passed);
}

void check_closed(const Editor& editor, const Stitched_mesh& quads, int poles) {
  check_certified(editor, quads, poles);
  CHECK(is_closed(with_fans(quads.mesh, pole_fans(editor.design(), quads))));
}

} // namespace

TEST_CASE("the fan of a whole pole is round") {
  Editor editor = sphere_session();
  REQUIRE(bool(editor.apply(whole(1))));
  const Stitched_mesh quads = editor.quads();
  const Pole_fan fan = pole_fans(editor.design(), quads).at(0);
  double least = 2, largest = 0;
  for (int v : fan.ring) {
    const double radius = (quads.mesh.points[v] - fan.pole).norm();
    least = std::min(least, radius);
    largest = std::max(largest, radius);
  }
  CHECK(largest < 1.2 * least); // a square's corners are 1.41 times as far as its sides
}

TEST_CASE("a sphere with whole poles is closed by two fans, before and after relaxing") {
  Editor editor = sphere_session();
  const Bytes quarter = bytes_of(editor);
  const Design_chart& cap = chart_at(editor, at(0, 0, 1));
  const int around = 2 * (cap.grid[0] + cap.grid[1]);
  REQUIRE(bool(editor.apply(whole(1))));
  check_closed(editor, editor.quads(), 1);
  REQUIRE(bool(editor.apply(whole(-1))));
  check_closed(editor, editor.quads(), 2);
  const std::vector<Pole_fan> fans = pole_fans(editor.design(), editor.quads());
  for (const Pole_fan& fan : fans) CHECK(std::abs(std::abs(fan.pole.z()) - 1) < 0.1);
  CHECK(
      std::any_of(fans.begin(), fans.end(), [&](const Pole_fan& f) { return int(f.ring.size()) == around; }));
  CHECK(fan_sentence(fans).find("in fans at 2 whole poles, asked for by the design") != std::string::npos);

  const Result<Finished_design> finished = editor.finished_quads();
  REQUIRE(bool(finished));
  check_closed(editor, finished->quads, 2);

  SECTION("undone, the quads are what they were") {
    editor.undo();
    editor.undo();
    CHECK(bytes_of(editor) == quarter);
    CHECK(pole_fans(editor.design(), editor.quads()).empty());
    CHECK(fan_sentence({}).empty());
  }
  SECTION("whole poles become quarter-poles and half-poles, and whole ones again") {
    refused(editor, whole(1), "the pole is of this kind already");
    REQUIRE(bool(editor.apply(Split_pole{at(0, 0, 1), Pole_kind::quarter, {}})));
    REQUIRE(bool(editor.apply(Split_pole{at(0, 0, -1), Pole_kind::quarter, {}})));
    CHECK(bytes_of(editor) == quarter);
    applied(editor, Split_pole{at(0, 0, 1), Pole_kind::half, {}});
    REQUIRE(bool(editor.apply(whole(1))));
    check_closed(editor, editor.quads(), 1);
    REQUIRE(bool(editor.apply(Split_pole{at(0, 0, 1), Pole_kind::half, {}})));
    check_closed(editor, editor.quads(), 0);
  }
  SECTION("they stay whole when counts and contours change") {
    REQUIRE(bool(editor.apply(Set_target{900, 0})));
    check_closed(editor, editor.quads(), 2);
    REQUIRE(bool(editor.apply(Move_extremum{at(0, 0, 1), at(0.3, 0, 0.95), Edit_scope::chart})));
    check_closed(editor, editor.quads(), 2);
  }
}

TEST_CASE("the fan of a surface with a boundary leaves this boundary alone open") {
  Editor open = session(shape("cylinder", 1200), extrema({1, 0, 1.5}, {{-1, 0, 1.5}}), 300);
  const Point p = open.working_surface().points[open.design().extrema[0].vertex];
  REQUIRE(bool(open.apply(Split_pole{{p, -1}, Pole_kind::whole, {}})));
  check_certified(open, open.quads(), 1);
  const Result<Finished_design> finished = open.finished_quads();
  REQUIRE(bool(finished));
  check_certified(open, finished->quads, 1);
}

TEST_CASE("a locked cap keeps its pole") {
  Editor editor = sphere_session();
  applied(editor, Lock_chart{at(0, 0, 1), true});
  refused(editor, whole(1), "the edit would change a locked chart");
}
