// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad replay INPUT RECIPE -o QUADS: designs a quad mesh by the edits of a recipe.
#include "Attributes.h"
#include "Command.h"
#include "Design_output.h"
#include "Guides_input.h"
#include "Input.h"
#include "Interruption.h"
#include "Marks_input.h"
#include "Outputs.h"
#include "Recipe_input.h"
#include "Solver_options.h"
#include "Terminal_observer.h"

#include "base/parallel_for.h"
#include "domain/mirror_report.h"
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/transfer_mesh_attributes.h>

#include <algorithm>
#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

struct Replay_options {
  std::string input, recipe, output, report, pictures;
  int until = -1;
  int component = 0; ///< 0: as the recipe says
  int threads = 0;
  std::optional<double> feature_angle;  ///< instead of the recipe's
  Marks_request marks;                  ///< instead of the recipe's
  std::string guides;                   ///< a file of guides beside the recipe's; empty: none
  bool feature_lines = false;           ///< also where the recipe has none
  bool relax = true;                    ///< where the recipe relaxes
  std::optional<Boundaries> boundaries; ///< instead of the recipe's
  Solver_options solver;                ///< instead of the recipe's
  bool attributes = true;               ///< carry over what the input tells beside its surface
  bool quiet = false;
};

void declare_replay_options(Command_line& line) {
  line.options.add_options()("output,o", po::value<std::string>()->value_name("FILE"), "the quad mesh")(
      "until", po::value<int>()->value_name("K"), "apply the first K edits only")(
      "component", po::value<int>()->value_name("K"),
      "design the connected component K of INPUT, counted from 1; by default the one that RECIPE names")(
      "report", po::value<std::string>()->value_name("FILE"), "write all numbers as JSON")(
      "pictures", po::value<std::string>()->value_name("DIR"), "write PNG pictures into this folder")(
      "threads", po::value<int>()->value_name("N")->default_value(0),
      "how many threads; 0: as many as there are")("no-relax", "do not relax the quads on the surface")(
      "feature-angle", po::value<double>()->value_name("DEGREES"),
      "quads keep edges whose faces' normals differ by more; 0: none; by default what the recipe says")(
      "feature-lines", "lay whole lines of quads' edges onto sharp edges")(
      "boundaries", po::value<std::string>()->value_name("WAY"),
      "keep or fill boundary loops, instead of what the recipe says")(
      "no-attributes",
      "do not carry over texture coordinates, colours and names of the input")("quiet", "print errors only");
  declare_force(line);
  declare_marks(line);
  declare_guides(line);
  declare_solver(line, "what the recipe says");
  line.take("INPUT");
  line.take("RECIPE");
}

std::optional<Replay_options> parse_replay_options(const Arguments& arguments) {
  Command_line line("replay INPUT RECIPE -o QUADS [options]");
  declare_replay_options(line);
  if (!line.parse(arguments)) return std::nullopt;
  Replay_options options;
  options.input = line.required("INPUT");
  options.recipe = line.required("RECIPE");
  options.output = line.required("output");
  if (line.has("report")) options.report = line.text("report");
  if (line.has("pictures")) options.pictures = line.text("pictures");
  keep_inputs(line, {{options.input, options.recipe, line.has("marks") ? line.text("marks") : "",
                      line.has("guides") ? line.text("guides") : ""},
                     {options.output, options.report},
                     options.pictures});
  if (line.has("until")) {
    options.until = line.values["until"].as<int>();
    if (options.until < 1) throw Usage_error("--until takes the number of edits to apply, 1 or more");
  }
  if (line.has("component")) {
    options.component = line.values["component"].as<int>();
    if (options.component < 1) throw Usage_error("--component takes a number from 1 on");
  }
  options.threads = line.values["threads"].as<int>();
  if (options.threads < 0 || options.threads > 1024) throw Usage_error("--threads lies between 0 and 1024");
  if (line.has("feature-angle")) {
    options.feature_angle = line.values["feature-angle"].as<double>();
    if (!(*options.feature_angle >= 0 && *options.feature_angle <= 180))
      throw Usage_error("--feature-angle lies between 0 and 180");
  }
  options.feature_lines = line.has("feature-lines");
  if (line.has("boundaries")) {
    const std::string way = line.text("boundaries");
    if (way != "keep" && way != "fill")
      throw Usage_error("--boundaries is keep or fill; it got '" + way + "'");
    options.boundaries = way == "fill" ? Boundaries::fill : Boundaries::keep;
  }
  options.marks = marks_request(line);
  if (line.has("guides")) options.guides = line.text("guides");
  options.relax = !line.has("no-relax");
  options.solver = solver_options(line);
  options.attributes = !line.has("no-attributes");
  options.quiet = line.has("quiet");
  return options;
}

// As many of the edits as are asked for.
Recipe read_recipe_until(const Replay_options& options) {
  Recipe recipe = read_recipe(options.recipe);
  const std::size_t last = options.until < 0 ? recipe.edits.size() : std::size_t(options.until);
  if (last > recipe.edits.size())
    throw Usage_error("--until " + std::to_string(last) + ": the recipe has " +
                      std::to_string(recipe.edits.size()) + " edits");
  recipe.edits.resize(last);
  recipe.options.threads = options.threads;
  options.solver.apply_to(recipe.options);
  if (options.component > 0) recipe.component = options.component;
  if (options.feature_angle) recipe.finish.features.feature_angle = *options.feature_angle;
  if (options.feature_lines) recipe.finish.features.lines = true;
  if (options.boundaries) recipe.options.boundaries = *options.boundaries;
  if (recipe.mirror && recipe.options.boundaries == Boundaries::fill)
    throw Usage_error("--boundaries fill and the recipe's mirror exclude each other");
  if (!options.relax) recipe.finish.relax = false;
  if (options.marks.any()) {
    std::vector<std::string> told_later;
    recipe.finish.marks =
        read_marks(options.marks, options.input, read_attributed_soup(options.input, &told_later));
    recipe.finish.features.lines = true;
  }
  if (!options.guides.empty()) {
    std::vector<std::string> told_later;
    const Attributed_soup mesh = read_attributed_soup(options.input, &told_later);
    for (Guide& guide : read_guides(options.guides, mesh.soup))
      recipe.edits.push_back(Add_guide{std::move(guide)});
  }
  return recipe;
}

Design_quads finished(const Replayed_recipe& replayed, const Recipe& recipe, const std::string& input,
                      Terminal_observer& observer) {
  Finished_design design = value_or_fail(replayed.editor.finished_quads(recipe.finish, &observer), input);
  std::vector<Pole_fan> fans = pole_fans(replayed.editor.design(), design.quads);
  if (!replayed.half)
    return {std::move(design.quads), std::move(fans), std::nullopt, std::move(design.guides)};
  Finish_options finish = recipe.finish;
  finish.relaxation.threads = CGAL::Reeb_quadrangulation::internal::number_of_threads(recipe.options.threads);
  const Surface_projector whole(replayed.whole);
  const Mirror mirror{replayed.half->plane, recipe.mirror->positions};
  Mirrored_design mirrored = value_or_fail(
      mirror_design(std::move(design), *replayed.half, whole, mirror.positions, finish, &observer), input);
  fans = with_mirrored_fans(std::move(fans), mirrored.image, mirror.plane);
  Mirror_report report = mirror_report(mirror, mirror_deviation(whole, mirror.plane), mirrored);
  return {std::move(mirrored.whole.quads), std::move(fans), std::move(report),
          std::move(mirrored.whole.guides)};
}

} // namespace

Exit_code execute_replay(const Arguments& arguments) {
  const std::optional<Replay_options> options = parse_replay_options(arguments);
  if (!options) return Exit_code::success;
  require_writable_format(options->output);
  watch_for_interruption();
  Terminal_observer observer(options->quiet);
  const Recipe recipe = read_recipe_until(*options);
  const Replayed_recipe replayed = replay_recipe(options->input, recipe, options->recipe, observer);
  const Design_quads quads = finished(replayed, recipe, options->input, observer);
  const Design_output output(replayed.editor, quads, replayed.input());
  observer.clear();
  const bool passed = output.passed();
  if (passed && !options->pictures.empty()) output.write_pictures(options->pictures);
  Mesh_attributes attributes;
  if (passed && options->attributes) {
    std::vector<std::string> told_before;
    const Attributed_soup input = read_attributed_soup(options->input, &told_before);
    attributes = transfer_mesh_attributes(input.soup, input.attributes, output.polygons());
  }
  {
    const Uninterruptible whole;
    if (passed) write_quads(options->output, output.polygons(), attributes, options->quiet);
    if (!options->report.empty())
      succeed_or_fail(write_file_atomically(options->report,
                                            output.report(options->input, passed ? options->output : "")),
                      options->report);
  }
  if (!options->quiet) std::cout << output.text();
  if (!passed) {
    std::cerr << "reebquad: the certificate failed; nothing is written to " << options->output << '\n';
    return Exit_code::certificate_failed;
  }
  if (!options->quiet) std::cout << "\ncertified: " << options->output << '\n';
  return Exit_code::success;
}

} // namespace reebquad
