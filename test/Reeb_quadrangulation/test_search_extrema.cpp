// SPDX-License-Identifier: GPL-3.0-or-later
// Extrema that are searched keep the shape, within the limits that are set.
#include "automatic/coarse_copy.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/search_extrema.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// A sphere with two horns, which any suggestion finds, and a smaller one, which none of great persistence
// does.
Triangle_surface horned_sphere(int triangles) {
  Result<Triangle_surface> sphere = make_shape("sphere", triangles);
  REQUIRE(bool(sphere));
  const auto grow = [&](const Point& tip, double length) {
    for (Point& p : sphere->points) p += length * std::exp(-(p - tip).squaredNorm() / 0.03) * tip;
  };
  grow({0, 0, 1}, 1.2);
  grow({0, 0, -1}, 1.2);
  grow({0, 1, 0}, 0.8);
  return *sphere;
}

Editor session(const Triangle_surface& surface) {
  Editor_options options;
  options.quads = 600;
  Result<Editor> editor = Editor::create(surface, options);
  REQUIRE(bool(editor));
  return std::move(*editor);
}

const Suggest first{1.0, Eigen::Vector3d(0, 0, 1), true};

Searched_extrema searched(const Triangle_surface& surface, const Search_options& options) {
  const Result<Searched_extrema> found = search_extrema(session(surface), first, options);
  INFO((found ? std::string() : found.error().message));
  REQUIRE(bool(found));
  return *found;
}

Quadrangulation made(const Triangle_surface& surface, Effort effort, int threads = 0) {
  Quadrangulation_options options;
  options.quads = 600;
  options.suggestion.persistence = first.persistence;
  options.effort = effort;
  options.threads = threads;
  Result<Quadrangulation> result = quadrangulate(surface, options);
  REQUIRE(bool(result));
  return std::move(*result);
}

double farthest_from(const Quadrangulation& q, const Triangle_surface& surface) {
  Stitched_mesh quads;
  quads.mesh = q.mesh;
  return design_energy(quads, Surface_projector(surface), sample_surface(surface, 4000)).farthest;
}

} // namespace

TEST_CASE("the search gives a horn that the quads miss an extremum, and says why") {
  const Triangle_surface surface = horned_sphere(8000);
  Search_options options;
  options.tries = 20;
  const Searched_extrema found = searched(surface, options);
  REQUIRE(!found.steps.empty());
  CHECK(found.energy < found.first_energy);
  CHECK(found.energy == found.steps.back().energy);
  CHECK(found.tries <= 20);
  for (std::size_t i = 1; i < found.steps.size(); ++i)
    CHECK(found.steps[i].energy <= found.steps[i - 1].energy);
  const bool at_the_horn = std::any_of(found.edit.extrema.begin(), found.edit.extrema.end(),
                                       [](const Set_extrema::Extremum& e) { return e.at.point.y() > 1.4; });
  CHECK(at_the_horn);
}

TEST_CASE("a run with effort keeps the horn, certified, and its recipe gives the same bytes on any number of "
          "threads") {
  const Triangle_surface surface = horned_sphere(8000);
  const Quadrangulation fast = made(surface, Effort::fast), normal = made(surface, Effort::normal, 1);
  for (const Search_step& step : fast.search) // of the alignment
    CHECK(step.reason.find("extraordinary vertices in line") == 0);
  CHECK(!normal.search.empty());
  CHECK(farthest_from(normal, surface) < 0.5 * farthest_from(fast, surface));
  CHECK(certify({normal.mesh, &surface, normal.valences}).passed);
  CHECK(made(surface, Effort::normal, 2).mesh.points == normal.mesh.points);
  Result<Editor> editor = Editor::create(surface, normal.recipe.options);
  REQUIRE(bool(editor));
  for (const Edit& edit : normal.recipe.edits) REQUIRE(bool(editor->apply(edit)));
  const Result<Finished_design> replayed = editor->finished_quads(normal.recipe.finish);
  REQUIRE(bool(replayed));
  CHECK(replayed->quads.mesh.points == normal.mesh.points);
  CHECK(replayed->quads.mesh.quads == normal.mesh.quads);
}

TEST_CASE("the search keeps to its limits") {
  const Triangle_surface surface = horned_sphere(4000);
  Search_options options;
  options.tries = 1;
  CHECK(searched(surface, options).steps.empty());
  options.tries = 20;
  options.extra_vertices = 0;
  const Searched_extrema found = searched(surface, options);
  CHECK(found.edit.extrema.size() <= 2); // each has four extraordinary vertices
  options = {};
  options.seconds = 1e-9;
  CHECK(searched(surface, options).tries == 1); // the first design is always made
  options.tries = 0;
  const Result<Searched_extrema> none = search_extrema(session(surface), first, options);
  REQUIRE(!none);
  CHECK(none.error().code == Error_code::impossible_request);
}

TEST_CASE("what the search looks for is what its weights say") {
  const Triangle_surface surface = horned_sphere(4000);
  Search_options options;
  options.tries = 12;
  options.weights = Energy_weights();
  options.weights.vertices = 1;
  CHECK(searched(surface, options).edit.extrema.size() <= 2); // no horn is worth four vertices
  options.weights.vertices = 0;
  CHECK(searched(surface, options).edit.extrema.size() > 2);
}

TEST_CASE("a budget is refused where nothing is searched, and where it is no number of seconds") {
  Quadrangulation_options options;
  options.budget = 1;
  for (const Effort effort : {Effort::fast, Effort::normal}) {
    options.effort = effort;
    CHECK(bool(automatic_recipe(options)) == (effort == Effort::normal));
  }
  for (const double budget : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    options.budget = budget;
    const Result<Recipe> refused = automatic_recipe(options);
    REQUIRE(!refused);
    CHECK(refused.error().code == Error_code::impossible_request);
  }
}

TEST_CASE("the search stops when it is told to") {
  class Impatient : public Observer {
  public:
    void progress(const std::string& stage, double fraction) override {
      m_stop = m_stop || (stage == "search" && fraction > 0);
    }
    bool cancelled() const override { return m_stop; }

  private:
    bool m_stop = false;
  } observer;
  const Result<Searched_extrema> found = search_extrema(session(horned_sphere(4000)), first, {}, &observer);
  REQUIRE(!found);
  CHECK(found.error().code == Error_code::cancelled);
}

TEST_CASE("a coarse copy has the surface's topology and about as many triangles as asked") {
  for (const char* name : {"torus", "genus-2", "genus-5"}) {
    INFO(name);
    const Result<Triangle_surface> surface = make_shape(name, 30000);
    REQUIRE(bool(surface));
    const auto copy = internal::coarse_copy(*surface, 3000);
    REQUIRE(copy);
    CHECK(euler_characteristic(*copy) == euler_characteristic(*surface));
    CHECK(boundary_loops(*copy).size() == boundary_loops(*surface).size());
    CHECK(copy->number_of_faces() > 1500);
    CHECK(3 * copy->number_of_faces() < surface->number_of_faces());
    CHECK(std::abs(area(*copy) / area(*surface) - 1) < 0.05);
  }
  CHECK(!internal::coarse_copy(tiny::torus(16, 12), 3000));
}

TEST_CASE("samples lie on their faces, each for the same area") {
  const Triangle_surface surface = horned_sphere(2000);
  const Surface_samples samples = sample_surface(surface, 5000);
  CHECK(std::abs(int(samples.points.size()) - 5000) <= 1);
  CHECK(samples.area == Approx(area(surface)));
  const Surface_projector projector(surface);
  double in_front = 0, area_in_front = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    CHECK(projector.closest(samples.points[i]).squared_distance < 1e-18);
    in_front += surface.points[surface.triangles[samples.faces[i]][0]].x() > 0;
  }
  for (int f = 0; f < surface.number_of_faces(); ++f)
    if (surface.points[surface.triangles[f][0]].x() > 0) area_in_front += area(surface, f);
  CHECK(in_front / double(samples.points.size()) == Approx(area_in_front / samples.area).epsilon(0.01));
}
