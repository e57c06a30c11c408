// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_files.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/decimate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Counts {
  int minima = 0, maxima = 0;
};

// Counts constraints of both kinds, boundary loops included.
Counts count(const Suggestion& s) {
  Counts n;
  for (const auto& e : s.extrema) ++(e.is_maximum ? n.maxima : n.minima);
  for (bool is_maximum : s.boundary_is_maximum) ++(is_maximum ? n.maxima : n.minima);
  return n;
}

std::vector<int> vertices(const Suggestion& s) {
  std::vector<int> v;
  for (const auto& e : s.extrema) v.push_back(e.vertex);
  return v;
}

Suggestion suggest(const Triangle_surface& surface, const Suggestion_options& options = {}) {
  auto result = suggest_extrema(surface, options);
  REQUIRE(bool(result));
  return *result;
}

Triangle_surface moved(Triangle_surface s, const Eigen::Affine3d& motion) {
  for (Point& p : s.points) p = motion * p;
  return s;
}

Triangle_surface made_shape(const std::string& name, int triangles = 6000) {
  auto result = make_shape(name, triangles);
  REQUIRE(bool(result));
  return *result;
}

} // namespace

TEST_CASE("every surface gets at least one minimum and one maximum") {
  for (const Triangle_surface& s :
       {tiny::tetrahedron(), tiny::octahedron(), tiny::torus(3, 3), tiny::torus(40, 20),
        tiny::open_cylinder(3, 1), tiny::open_cylinder(30, 20)}) {
    const Counts n = count(suggest(s));
    CHECK(n.minima >= 1);
    CHECK(n.maxima >= 1);
  }
}

TEST_CASE("the ends of an open cylinder are its only constraints, one of each kind") {
  const Suggestion s = suggest(tiny::open_cylinder(40, 30, 4));
  CHECK(s.extrema.empty());
  CHECK(s.boundary_is_maximum == std::vector<bool>{false, true});
}

TEST_CASE("turning the axis round turns minima into maxima and keeps the places") {
  const Triangle_surface cylinder = tiny::open_cylinder(40, 30, 4);
  Suggestion_options down;
  down.axis = -down.axis;
  CHECK(suggest(cylinder, down).boundary_is_maximum == std::vector<bool>{true, false});
}

TEST_CASE("extrema are interior vertices, different, and as far apart as asked") {
  const Triangle_surface s = tiny::torus(60, 30);
  const Suggestion found = suggest(s);
  const std::vector<int> v = vertices(found);
  CHECK(std::set<int>(v.begin(), v.end()).size() == v.size());
  const double r = std::sqrt(Suggestion_options().relative_area * area(s));
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK((s.points[v[i]] - s.points[v[j]]).norm() > r / 2);
}

TEST_CASE("a suggestion that cannot be made is refused with a reason") {
  const Triangle_surface good = tiny::octahedron();
  const auto code = [](const Triangle_surface& s, const Suggestion_options& o = {}) {
    const auto result = suggest_extrema(s, o);
    REQUIRE_FALSE(result);
    CHECK_FALSE(result.error().message.empty());
    return result.error().code;
  };
  Suggestion_options o;
  o.persistence = 0;
  CHECK(code(good, o) == Error_code::impossible_request);
  o = {};
  o.axis = Eigen::Vector3d::Zero();
  CHECK(code(good, o) == Error_code::impossible_request);
  o = {};
  o.relative_area = std::nan("");
  CHECK(code(good, o) == Error_code::impossible_request);
  o = {};
  o.working_faces = 7;
  CHECK(code(good, o) == Error_code::impossible_request);

  CHECK(code(Triangle_surface()) == Error_code::not_a_surface);
  CHECK(code(tiny::connected({{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}, {}, {}})) ==
        Error_code::not_a_surface);
  Triangle_surface two = good;
  for (const Point& p : good.points) two.points.push_back(p + Point(5, 0, 0));
  for (const Triangle& t : good.triangles) two.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  CHECK(code(tiny::connected(two)) == Error_code::not_a_surface);
  Triangle_surface flat = good;
  for (Point& p : flat.points) p = Point(1, 2, 3);
  CHECK(code(flat) == Error_code::not_a_surface);
}

TEST_CASE("a cancelled suggestion says so") {
  struct Impatient : Observer {
    bool cancelled() const override { return true; }
  } impatient;
  const auto result = suggest_extrema(tiny::torus(20, 10), {}, &impatient);
  REQUIRE_FALSE(result);
  CHECK(result.error().code == Error_code::cancelled);
}

TEST_CASE("the metric graph keeps area and connection, and its arcs are short and symmetric") {
  for (const Triangle_surface& s : {tiny::octahedron(), tiny::torus(100, 60), tiny::open_cylinder(50, 50)}) {
    const Metric_graph g = decimate(s, 500);
    CHECK(std::accumulate(g.area.begin(), g.area.end(), 0.0) == Approx(area(s)).epsilon(1e-12));
    std::vector<int> stack{0}, seen(g.size(), 0);
    seen[0] = 1;
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      for (int k = g.begin[i]; k < g.begin[i + 1]; ++k) {
        const int j = g.neighbor[k];
        CHECK(std::binary_search(g.neighbor.begin() + g.begin[j], g.neighbor.begin() + g.begin[j + 1], i));
        if (!seen[j]) stack.push_back(j);
        seen[j] = 1;
      }
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == g.size());
  }
}

TEST_CASE("a fine surface is reduced to about the asked number of nodes") {
  const Metric_graph g = decimate(tiny::torus(300, 150), 1000);
  CHECK(g.size() > 700);
  CHECK(g.size() < 1400);
}

TEST_CASE("the chosen places do not depend on where the surface lies in space") {
  // A bent, lopsided tube without symmetries: a torus with unequal thickness, moved along itself.
  Triangle_surface s = tiny::torus(80, 40);
  for (Point& p : s.points)
    p = Point(2.5 * p.x() + 0.3 * p.y(), p.y() + 0.2 * p.x() * p.x(),
              p.z() * (1.5 + 0.4 * p.x()) + 0.5 * p.x());
  const std::vector<int> places = vertices(suggest(s));
  REQUIRE(places.size() >= 2);
  for (double angle : {0.3, 1.1, 2.9}) {
    const Eigen::Affine3d turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    const Suggestion turned = suggest(moved(s, turn));
    CHECK(vertices(turned) == places);
    Suggestion_options options;
    const Eigen::Affine3d tilt(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -0.5).normalized()));
    options.axis = tilt.linear() * options.axis;
    const Suggestion tilted = suggest(moved(s, tilt), options), plain = suggest(s);
    REQUIRE(vertices(tilted) == places);
    for (std::size_t i = 0; i < places.size(); ++i)
      CHECK(tilted.extrema[i].is_maximum == plain.extrema[i].is_maximum);
  }
  CHECK(vertices(suggest(moved(s, Eigen::Affine3d(Eigen::Scaling(1e-3))))) == places);
  CHECK(vertices(suggest(moved(s, Eigen::Affine3d(Eigen::Scaling(100.0))))) == places);
}

TEST_CASE("an ellipsoid gets its two ends, the lower a minimum and the upper a maximum") {
  const Triangle_surface s = made_shape("ellipsoid");
  const Suggestion found = suggest(s);
  REQUIRE(found.extrema.size() == 2);
  for (const auto& e : found.extrema) CHECK(s.points[e.vertex].z() * (e.is_maximum ? 1 : -1) > 1.97);
}

TEST_CASE("a hand gets five fingertips and the wrist's end, at every resolution") {
  for (int triangles : {1500, 8000, 60000}) {
    const Triangle_surface s = made_shape("hand", triangles);
    const Suggestion found = suggest(s);
    const Counts n = count(found);
    CHECK(n.maxima == 5);
    CHECK(n.minima == 1);
    for (const auto& e : found.extrema)
      if (!e.is_maximum) CHECK(s.points[e.vertex].z() < -0.9);
  }
}

TEST_CASE("round shapes get one minimum and one maximum, far apart") {
  for (const char* name : {"sphere", "torus"}) {
    const Triangle_surface s = made_shape(name);
    const Suggestion found = suggest(s);
    REQUIRE(found.extrema.size() == 2);
    const Counts n = count(found);
    CHECK(n.minima == 1);
    CHECK((s.points[found.extrema[0].vertex] - s.points[found.extrema[1].vertex]).norm() > 1.9);
  }
}

TEST_CASE("a smaller persistence only adds extrema") {
  for (const char* name : {"hand", "genus-5", "l-shape", "cube"}) {
    const Triangle_surface s = made_shape(name);
    std::set<int> larger;
    for (double p : {0.9, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01}) {
      Suggestion_options options;
      options.persistence = p;
      const Suggestion found = suggest(s, options);
      std::set<int> chosen;
      for (const auto& e : found.extrema)
        if (e.prominence > 0)
          chosen.insert(e.vertex); // the point added for want of a second one is no feature
      CHECK(std::includes(chosen.begin(), chosen.end(), larger.begin(), larger.end()));
      larger = chosen;
    }
  }
}

TEST_CASE("boundary loops keep extrema at a distance") {
  // The hand cut open at the wrist: the opening is a constraint of its own, the fingertips stay.
  Triangle_surface s = made_shape("hand", 8000);
  const Triangle_surface whole = s;
  s.triangles.clear();
  for (const Triangle& t : whole.triangles)
    if (whole.points[t[0]].z() + whole.points[t[1]].z() + whole.points[t[2]].z() > -2.4)
      s.triangles.push_back(t);
  s = tiny::connected(std::move(s));
  REQUIRE(boundary_loops(s).size() == 1);
  const Suggestion found = suggest(s);
  CHECK(found.boundary_is_maximum == std::vector<bool>{false});
  CHECK(found.extrema.size() == 5);
  const double r = std::sqrt(Suggestion_options().relative_area * area(s));
  for (const auto& e : found.extrema) {
    CHECK(e.is_maximum);
    CHECK(s.points[e.vertex].z() + 0.8 > r / 2);
  }
}

TEST_CASE("a coarse mesh of a solid gets extrema that are not adjacent") {
  const Triangle_surface s = made_shape("cube", 400);
  const std::vector<int> v = vertices(suggest(s));
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    CHECK_FALSE((std::count(v.begin(), v.end(), s.source(h)) && std::count(v.begin(), v.end(), s.target(h))));
}

TEST_CASE("scanned and modelled shapes get one extremum for each limb", "[models]") {
  struct Expected {
    const char* file;
    std::size_t extrema; // at a persistence of a tenth
  };
  // Octopus: eight arms and the head. Camel: four feet, snout and rump. Hand: five fingers and the wrist's
  // end.
  for (const Expected& expected : {Expected{"octopus.obj", 9},
                                   {"camel.off", 6},
                                   {"hand.obj", 6},
                                   {"bunny.obj", 4},
                                   {"rocker_arm.obj", 2}}) {
    INFO(expected.file);
    const std::optional<Triangle_surface> surface = model(expected.file);
    if (!surface) continue;
    Suggestion_options options;
    options.persistence = 0.1;
    CHECK(suggest(*surface, options).extrema.size() == expected.extrema);
  }
}
