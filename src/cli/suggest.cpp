// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad suggest INPUT [RECIPE]: lists edits that are worth while, or takes them.
#include "Command.h"
#include "Interruption.h"
#include "Outputs.h"
#include "Recipe_input.h"
#include "Terminal_observer.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/hints.h>

#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

struct Suggest_options {
  std::string input, recipe, output;
  Recipe design; ///< that hints are for
  Hint_options hints;
  bool apply = false, json = false, quiet = false;
};

// Some kinds of hints, separated by commas.
Hint_options parse_kinds(const std::string& text) {
  Hint_options options;
  options.limbs = options.thin_charts = options.sharp_edges = options.saddles = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string kind = text.substr(begin, end - begin);
    if (kind == "limbs")
      options.limbs = true;
    else if (kind == "thin")
      options.thin_charts = true;
    else if (kind == "sharp")
      options.sharp_edges = true;
    else if (kind == "saddles")
      options.saddles = true;
    else
      throw Usage_error("--kinds takes limbs, thin, sharp, saddles, separated by commas; it got '" + kind +
                        "'");
    begin = end + 1;
  }
  return options;
}

std::optional<Suggest_options> parse_suggest_options(const Arguments& arguments) {
  Command_line line("suggest INPUT [RECIPE] [options]");
  line.options.add_options()("apply", "take the hints, one by one, until there are none")(
      "output,o", po::value<std::string>()->value_name("FILE"), "with --apply: write the longer recipe")(
      "kinds", po::value<std::string>()->value_name("LIST")->default_value("limbs,thin,sharp,saddles"),
      "what hints are about")("quads", po::value<int>()->value_name("N")->default_value(3000),
                              "without a recipe: how many quads")("json", "print the hints as JSON")(
      "threads", po::value<int>()->value_name("N")->default_value(0),
      "how many threads; 0: as many as there are")("quiet", "print errors only");
  declare_force(line);
  line.take("INPUT");
  line.take("RECIPE");
  if (!line.parse(arguments)) return std::nullopt;
  Suggest_options options;
  options.input = line.required("INPUT");
  options.hints = parse_kinds(line.text("kinds"));
  options.apply = line.has("apply");
  options.json = line.has("json");
  options.quiet = line.has("quiet");
  if (line.has("output")) options.output = line.text("output");
  if (options.apply && options.output.empty()) throw Usage_error("--apply needs -o for the recipe it makes");
  if (!options.apply && !options.output.empty()) throw Usage_error("-o is for --apply alone");
  const int quads = line.values["quads"].as<int>(), threads = line.values["threads"].as<int>();
  if (quads < 1 || quads > 100000000) throw Usage_error("--quads lies between 1 and 100000000");
  if (threads < 0 || threads > 1024) throw Usage_error("--threads lies between 0 and 1024");
  if (line.has("RECIPE")) options.recipe = line.text("RECIPE");
  keep_inputs(line, {{options.input, options.recipe}, {options.output}, ""});
  if (line.has("RECIPE")) {
    options.design = read_recipe(options.recipe);
  } else {
    options.design.options.quads = quads;
    options.design.edits.push_back(Suggest{});
  }
  options.design.options.threads = threads;
  return options;
}

void print(const std::vector<Hint>& hints, const Suggest_options& options) {
  if (options.json)
    std::cout << to_json(hints);
  else if (!options.quiet) {
    for (std::size_t i = 0; i < hints.size(); ++i)
      std::cout << i + 1 << ". " << name(hints[i].edit) << ": " << hints[i].reason << '\n';
    if (hints.empty()) std::cout << "no hints\n";
  }
}

} // namespace

Exit_code execute_suggest(const Arguments& arguments) {
  const std::optional<Suggest_options> options = parse_suggest_options(arguments);
  if (!options) return Exit_code::success;
  watch_for_interruption();
  Terminal_observer observer(options->quiet);
  Replayed_recipe replayed = replay_recipe(
      options->input, options->design, options->recipe.empty() ? options->input : options->recipe, observer);
  Editor& editor = replayed.editor;
  const std::vector<Hint> hints =
      value_or_fail(options->apply ? apply_hints(editor, options->hints, &observer)
                                   : suggest_edits(editor, options->hints, &observer),
                    options->input);
  observer.clear();
  if (options->apply) {
    Recipe longer = recipe_of(editor);
    longer.component = options->design.component;
    longer.mirror = options->design.mirror;
    const Uninterruptible whole;
    succeed_or_fail(write_file_atomically(options->output, to_json(longer)), options->output);
  }
  print(hints, *options);
  return Exit_code::success;
}

} // namespace reebquad
