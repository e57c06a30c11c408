// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that give way, saddles that move wherever their charts are, and saddles that are split whatever
// contours they share.
#include "editor_sessions.h"
#include "globe.h"
#include "tiny_surfaces.h"

#include "atlas/region_curve.h"

#include <algorithm>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using namespace sessions;

namespace {

using Histogram = std::map<int, int>;
constexpr double pi = 3.14159265358979323846;

// The loops at a node.
std::vector<int> loops_at(const Editor& editor, const Point& node) {
  std::vector<int> loops;
  const Contour_network& network = editor.design().network;
  for (int e : contours_of(editor)) {
    const Contour_edge& edge = network.edges[std::size_t(e)];
    const Point p = network.position(editor.working_surface(), edge.vertices.front());
    if (edge.from == edge.to && (p - node).norm() < 0.2) loops.push_back(e);
  }
  return loops;
}

Editor globe_session(int lobes) {
  return session(tiny::connected(globe::ball(lobes)), extrema({0, 0, -1}, globe::tips(lobes)), 600);
}

// A tube of rings of vertices between two contours: the lower and the upper ring come first.
Open_region tube(int around, int rings) {
  Open_region region;
  Triangle_surface& s = region.chart.mesh;
  const auto index = [&](int ring, int i) {
    const int place = ring == 0 ? 0 : ring == rings - 1 ? 1 : ring + 1;
    return place * around + i % around;
  };
  s.points.resize(std::size_t(around * rings));
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < around; ++i)
      s.points[std::size_t(index(ring, i))] =
          Point(std::cos(2 * pi * i / around), std::sin(2 * pi * i / around), 2.0 * ring / (rings - 1) - 1);
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int i = 0; i < around; ++i) {
      s.triangles.push_back({index(ring, i), index(ring, i + 1), index(ring + 1, i + 1)});
      s.triangles.push_back({index(ring, i), index(ring + 1, i + 1), index(ring + 1, i)});
    }
  s = tiny::connected(std::move(s));
  for (int v = 0; v < 2 * around; ++v) region.walls.push_back({v < around ? 0 : 1, 0});
  return region;
}

int pieces(const Triangle_surface& mesh, const std::vector<signed char>& sides, signed char side) {
  std::vector<int> seen(sides.size(), 0);
  int number = 0;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (sides[first] != side || seen[first]) continue;
    ++number;
    std::vector<int> stack{int(first)};
    seen[first] = 1;
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      for (const Triangle& t : mesh.triangles)
        if (std::find(t.begin(), t.end(), v) != t.end())
          for (int w : t)
            if (sides[std::size_t(w)] == side && !seen[std::size_t(w)]) {
              seen[std::size_t(w)] = 1;
              stack.push_back(w);
            }
    }
  }
  return number;
}

} // namespace

TEST_CASE("whatever the wish, one closed curve parts a tube, and both its ends keep their sides") {
  const Open_region region = tube(12, 9);
  const Triangle_surface& mesh = region.chart.mesh;
  tiny::Random random(5);
  for (int run = 0; run < 100; ++run) {
    Region_sides asked;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      asked.wish.push_back(random.unit() - 0.5);
      asked.home.push_back(static_cast<signed char>(mesh.points[v].z() > 0 ? 1 : -1));
    }
    const Result<std::vector<signed char>> sides = part_region(region, asked);
    REQUIRE(bool(sides));
    CHECK(pieces(mesh, *sides, 1) == 1);
    CHECK(pieces(mesh, *sides, -1) == 1);
    for (std::size_t v = 0; v < region.walls.size(); ++v) CHECK((*sides)[v] == asked.home[v]);
    const Result<Region_curve> curve = curve_between(region, *sides, asked);
    REQUIRE(bool(curve));
    CHECK(curve->exits.size() >= 12);
  }
}

TEST_CASE("where a plane can be followed, the curve in a tube lies in it; where it leaves the tube, it stops "
          "before the end") {
  const Open_region region = tube(24, 17);
  const Triangle_surface& mesh = region.chart.mesh;
  for (const double slope : {0.5, 3.0}) {
    Region_sides asked;
    for (const Point& p : mesh.points) {
      asked.wish.push_back(p.z() - slope * p.x() + 0.01);
      asked.home.push_back(static_cast<signed char>(p.z() > 0 ? 1 : -1));
    }
    const Result<std::vector<signed char>> sides = part_region(region, asked);
    REQUIRE(bool(sides));
    const Result<Region_curve> curve = curve_between(region, *sides, asked);
    REQUIRE(bool(curve));
    for (std::size_t i = 0; i < curve->exits.size(); ++i) {
      const Point &a = mesh.points[std::size_t(mesh.source(curve->exits[i]))],
                  &b = mesh.points[std::size_t(mesh.target(curve->exits[i]))];
      const Point p = a + curve->t[i] * (b - a);
      CHECK(std::abs(p.z()) < 1);
      if (std::abs(slope * p.x() - 0.01) < 0.8) CHECK(std::abs(p.z() - slope * p.x() + 0.01) < 0.05);
    }
  }
}

TEST_CASE("a saddle's loop turns to planes that would cut its sibling, and the saddle stays") {
  Editor editor = torus_session();
  const Point saddle(-0.6, 0, 0);
  const Histogram before = valences(editor);
  const std::vector<int> loops = loops_at(editor, saddle);
  REQUIRE(loops.size() == 2);
  const std::vector<Point> loop = points_of(editor, loops[0]);
  for (const double degrees : {-60.0, -30.0, 30.0, 60.0}) {
    const Eigen::Vector3d normal =
        Eigen::AngleAxisd(degrees * pi / 180, Eigen::Vector3d(0, 0, 1)) * Eigen::Vector3d(0, 1, 0);
    const Edit_report report = applied(editor, Move_contour{{loop[loop.size() / 2], -1}, saddle, normal, {}});
    CHECK(report.followed >= 0.2);
    CHECK(valences(editor) == before);
    CHECK(loops_at(editor, saddle).size() == 2);
    editor.undo();
  }
}

TEST_CASE("a plain contour follows a plane as far as its extrema allow") {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  const Edit_report report = applied(editor, Move_contour{at(1, 0, 0), {0, 0, 0}, {1, 0, 0}, {}});
  CHECK(report.followed > 0.3);
  CHECK(report.followed < 1);
  CHECK(valences(editor) == Histogram{{3, 8}});
}

TEST_CASE("a saddle moves to any vertex of its charts where a plane does not take it") {
  Editor editor = torus_session();
  const Histogram before = valences(editor);
  for (const Point& to : {Point(-0.7, 0.1, 0.28), Point(-0.62, -0.3, 0.2), Point(-0.75, 0.2, -0.3)}) {
    applied(editor, Move_saddle{at(-0.6, 0, 0), {to, -1}, {0.2, 1, 0.3}});
    CHECK(valences(editor) == before);
    editor.undo();
  }
}

TEST_CASE("a saddle's loop is straightened between the contours beside it") {
  Editor editor = torus_session();
  const Point saddle(-0.6, 0, 0);
  const std::vector<Point> loop = points_of(editor, loops_at(editor, saddle)[0]);
  applied(editor, Move_contour{{loop[loop.size() / 2], -1}, saddle, {0.9, 1, 0}, {}});
  const std::vector<int> loops = loops_at(editor, saddle);
  const int moved = loops.back();
  const std::vector<Point> loose = points_of(editor, moved);
  const Edit_report report = applied(editor, Straighten_contour{{loose[loose.size() / 2], -1}});
  REQUIRE(report.new_contours.size() == 1);
  const std::vector<Point> tight = points_of(editor, report.new_contours[0]);
  CHECK(length(tight) < length(loose));
  CHECK(tight.front() == loose.front()); // the saddle
  CHECK(tight.back() == loose.back());
}

TEST_CASE("the field alone moves a ring towards a plane") {
  Editor editor = session(shape("torus", 3000), extrema({-1.4, 0, 0}, {{1.4, 0, 0}}), 500);
  const Edit_report ring = applied(editor, Subdivide_chart{at(0, 1.4, 0)});
  REQUIRE(ring.new_contours.size() == 1);
  const Eigen::Vector3d normal = Eigen::Vector3d(1, 0.3, 0).normalized();
  const auto off = [&](int contour) {
    const std::vector<Point> points = points_of(editor, contour);
    double sum = 0;
    for (const Point& p : points) sum += std::abs((p - Point(0, 1, 0)).dot(normal)) / double(points.size());
    return sum;
  };
  const double before = off(ring.new_contours[0]);
  applied(editor, Move_contour{at(0, 1.4, 0), {0, 1, 0}, normal, {}, Enforcement::field});
  double after = before;
  for (int e : contours_of(editor)) {
    const std::vector<Point> points = points_of(editor, e);
    const bool is_ring = std::all_of(points.begin(), points.end(),
                                     [](const Point& p) { return p.y() > 0.4 && std::abs(p.x()) < 0.5; });
    if (is_ring) after = std::min(after, off(e));
  }
  CHECK(after < 0.6 * before);
}

TEST_CASE("a monkey saddle moves, splits to four 6s, and to eight 5s") {
  Editor editor = globe_session(3);
  REQUIRE(valences(editor) == Histogram{{3, 16}, {12, 1}});
  const Surface_point saddle = at(0, 0, 1);
  applied(editor, Move_saddle{saddle, at(0.25, 0.1, 0.9)});
  CHECK(valences(editor) == Histogram{{3, 16}, {12, 1}});
  editor.undo();
  applied(editor, Split_saddle{saddle, Saddle_kind::half, {}, 0});
  CHECK(valences(editor) == Histogram{{3, 16}, {6, 4}});
  editor.undo();
  applied(editor, Split_saddle{saddle, Saddle_kind::quarter, {}, 0});
  CHECK(valences(editor) == Histogram{{3, 16}, {5, 8}});
}

TEST_CASE("a saddle of four loops is unfolded: six 6s, or twelve 5s") {
  Editor editor = globe_session(4);
  REQUIRE(valences(editor) == Histogram{{3, 20}, {16, 1}});
  applied(editor, Split_saddle{at(0, 0, 1), Saddle_kind::half, {}, 0.2});
  CHECK(valences(editor) == Histogram{{3, 20}, {6, 6}});
  editor.undo();
  applied(editor, Split_saddle{at(0, 0, 1), Saddle_kind::quarter, {}, 0.2});
  CHECK(valences(editor) == Histogram{{3, 20}, {5, 12}});
}

TEST_CASE("aligned saddles are split in either order, or the refusal says why", "[slow]") {
  enum Step { align, half_first, half_second, quarter_first, move_second, pin };
  // Of a contour, a chart or a saddle that an earlier step has taken away.
  const std::set<std::string> theorems{"two saddles are needed",
                                       "no chart lies between the saddles",
                                       "there is no saddle",
                                       "the chart cannot be collapsed",
                                       "the saddle would leave its charts",
                                       "the contour around the cap does not pass half-saddles four times"};
  const std::vector<std::vector<Step>> sets{{align, half_first, half_second},
                                            {align, quarter_first, half_second},
                                            {align, half_first, move_second, pin}};
  int applied_steps = 0, refused_steps = 0, split_after_align = 0;
  for (std::vector<Step> order : sets) {
    std::sort(order.begin(), order.end());
    do {
      Editor editor = session(shape("bitorus", 2500), extrema({-1.35, 0, 0}, {{3.35, 0, 0}}), 500);
      std::vector<Point> saddles;
      for (const Contour_node& node : editor.design().network.nodes)
        if (node.kind == Node_kind::saddle)
          saddles.push_back(editor.design().network.position(editor.working_surface(), node.vertex));
      REQUIRE(saddles.size() == 4);
      std::sort(saddles.begin(), saddles.end(), [](const Point& a, const Point& b) { return a.x() < b.x(); });
      const Surface_point a{saddles[1], -1}, b{saddles[2], -1};
      bool is_aligned = false;
      for (const Step step : order) {
        Edit edit = Align_saddles{a, b};
        if (step == half_first) edit = Split_saddle{a, Saddle_kind::half, {}, 0.1};
        if (step == half_second) edit = Split_saddle{b, Saddle_kind::half, {}, 0.1};
        if (step == quarter_first) edit = Split_saddle{a, Saddle_kind::quarter, {}, 0.1};
        if (step == move_second) edit = Move_saddle{b, {b.point + Point(0.05, 0.05, 0), -1}};
        if (step == pin) edit = Pin_corners{at(-1.35, 0, 0)};
        const Result<Edit_report> done = editor.apply(edit);
        INFO(to_json(edit) << (done ? "" : done.error().message));
        if (done) {
          ++applied_steps;
          is_aligned = is_aligned || step == align;
          split_after_align +=
              is_aligned && (step == half_first || step == half_second || step == quarter_first);
          const Stitched_mesh quads = editor.quads();
          CHECK(stages::faults(quads.mesh, editor.working_surface(), quads.valences, quads.components) == "");
          continue;
        }
        ++refused_steps;
        const std::string sentence = done.error().message.substr(0, done.error().message.find(':'));
        INFO(sentence);
        CHECK(theorems.count(sentence) == 1);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  CHECK(split_after_align >= 12);
  CHECK(applied_steps > refused_steps);
}
