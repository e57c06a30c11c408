// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever solves the systems and meets the constraints: the same combinatorics, and fields that differ by
// rounding or by what penalties leave. From the library, the editor, recipes and the command line.
#include "cli_process.h"
#include "editor_sessions.h"

#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/create_editor.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>

using namespace CGAL::Reeb_quadrangulation;
using sessions::shape;

namespace {

const std::vector<std::string> solvers{"multifrontal", "cholmod", "eigen"};
const std::vector<Constraint_method> methods{Constraint_method::elimination, Constraint_method::penalty};

std::string name_of(Constraint_method method) {
  return method == Constraint_method::penalty ? "penalty" : "elimination";
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double d = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

double largest_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  REQUIRE(a.size() == b.size());
  double d = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, (a[i] - b[i]).norm());
  return d;
}

bool same_bytes(const Quad_mesh& a, const Quad_mesh& b) {
  return a.points == b.points && a.quads == b.quads;
}

} // namespace

TEST_CASE("every solver with either method makes the same quads of the same field") {
  for (const char* name : {"hand", "bitorus", "genus-3", "ellipsoid", "cylinder"}) {
    INFO(name);
    const Triangle_surface surface = shape(name, 4000);
    Quadrangulation_options options;
    options.quads = 600;
    options.relax = false;
    std::optional<Quadrangulation> first;
    std::vector<double> field;
    for (const Constraint_method method : methods)
      for (const std::string& solver : solvers) {
        INFO(solver + ", " + name_of(method));
        options.solver = *linear_solver_named(solver);
        options.constraints = method;
        Result<Designed_field> designed = choose_extrema(surface, options);
        REQUIRE(bool(designed));
        REQUIRE(bool(solve_field(surface, options, *designed)));
        Result<Quadrangulation> made = quadrangulate(surface, options);
        REQUIRE(bool(made));
        CHECK(made->flipped_triangles == 0);
        if (!first) {
          field = designed->values;
          first.emplace(std::move(*made));
          continue;
        }
        CHECK(largest_difference(designed->values, field) < 1e-6);
        CHECK(made->mesh.quads == first->mesh.quads);
        CHECK(made->chart_of_quad == first->chart_of_quad);
        CHECK(made->valences == first->valences);
        CHECK(largest_distance(made->mesh.points, first->mesh.points) < 1e-5);
        if (solver == solvers.front())
          CHECK(!same_bytes(made->mesh, first->mesh)); // the method is not ignored
      }
  }
}

TEST_CASE("every solver with either method leads through the same edits, and undone ones leave no trace") {
  std::vector<Quad> expected;
  for (const Constraint_method method : methods)
    for (const std::string& solver : solvers) {
      INFO(solver + ", " + name_of(method));
      Editor_options options;
      options.quads = 400;
      options.prepare = false;
      options.solver = *linear_solver_named(solver);
      options.constraints = method;
      const Triangle_surface surface = shape("hand", 5000);
      const auto begin = [&] {
        Result<Editor> editor = Editor::create(surface, options);
        REQUIRE(bool(editor));
        return std::move(*editor);
      };
      Editor straight = begin(), detour = begin();
      const auto must = [](Editor& editor, const Edit& edit) {
        const Result<Edit_report> done = editor.apply(edit);
        INFO((done ? "" : done.error().message));
        REQUIRE(bool(done));
      };
      for (Editor* editor : {&detour, &straight}) {
        must(*editor, Suggest{});
        const Design_extremum extremum = editor->design().extrema.back();
        const Point at = editor->working_surface().points[extremum.vertex];
        if (editor == &detour) {
          must(*editor, Remove_extremum{{at, extremum.vertex}, Edit_scope::surface});
          editor->undo();
          editor->undo();
          must(*editor, Suggest{});
        }
        must(*editor, Remove_extremum{{at, extremum.vertex}, Edit_scope::surface});
        editor->undo();
        must(*editor, Set_target{500});
      }
      const Quad_mesh quads = straight.quads().mesh;
      CHECK(same_bytes(quads, detour.quads().mesh));
      if (expected.empty()) expected = quads.quads;
      CHECK(quads.quads == expected);
    }
}

TEST_CASE("a recipe keeps the solver by its name and refuses one that it does not know") {
  Recipe recipe;
  recipe.options.solver = *linear_solver_named("cholmod");
  recipe.options.constraints = Constraint_method::penalty;
  recipe.edits.push_back(Suggest{});
  const Result<Recipe> read = recipe_from_json(to_json(recipe));
  REQUIRE(bool(read));
  CHECK(read->options.solver.name() == "cholmod");
  CHECK(read->options.constraints == Constraint_method::penalty);
  CHECK(read->options.solver().can_update());

  recipe.options.solver = Linear_solver_factory("mine", [] { return Any_linear_solver(); });
  const Result<Recipe> refused = recipe_from_json(to_json(recipe));
  REQUIRE(!refused);
  CHECK(refused.error().code == Error_code::malformed_file);
  for (const char* word : {"solver", "mine", "multifrontal"})
    CHECK(refused.error().message.find(word) != std::string::npos);
}

TEST_CASE(
    "the command line chooses solver and method, its recipe keeps them, and replay makes the same bytes") {
  const Temporary_folder folder;
  const std::string input = folder.path("hand.off"), recipe = folder.path("recipe.json"),
                    quads = folder.path("quads.obj"), again = folder.path("again.obj");
  REQUIRE(reebquad({"shape", "hand", "-o", input, "--triangles", "4000"}).code == 0);
  std::vector<std::string> bytes;
  for (const std::string& solver : solvers)
    for (const Constraint_method method : methods) {
      INFO(solver + ", " + name_of(method));
      REQUIRE(reebquad({"run", input, "-o", quads, "--quads", "500", "--solver", solver, "--constraints",
                        name_of(method), "--write-recipe", recipe})
                  .code == 0);
      const std::string text = contents(recipe);
      CHECK(text.find("\"solver\":\"" + solver + "\"") != std::string::npos);
      CHECK(text.find("\"constraints\":\"" + name_of(method) + "\"") != std::string::npos);
      REQUIRE(reebquad({"replay", input, recipe, "-o", again}).code == 0);
      CHECK(contents(again) == contents(quads));
      bytes.push_back(contents(quads));
      // Of the last recipe, by the first choice.
      REQUIRE(reebquad({"replay", input, recipe, "-o", again, "--solver", "multifrontal", "--constraints",
                        "elimination"})
                  .code == 0);
      CHECK(contents(again) == bytes.front());
    }
  const Outcome unknown = reebquad({"run", input, "-o", quads, "--solver", "gauss"});
  CHECK(unknown.code != 0);
  for (const char* word : {"--solver", "gauss", "multifrontal", "cholmod", "eigen"})
    CHECK(unknown.err.find(word) != std::string::npos);
  const Outcome method = reebquad({"replay", input, recipe, "-o", again, "--constraints", "hope"});
  CHECK(method.code != 0);
  CHECK(method.err.find("elimination, penalty") != std::string::npos);
}
