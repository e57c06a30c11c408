// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

#include "automatic/mirrored.h"
#include "automatic/search_curves.h"
#include "base/parallel_for.h"
#include "base/stage_recorder.h"
#include "design/layout_lines.h"

#include <CGAL/Reeb_quadrangulation/finish_design_on_features.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// The nearest vertex that is not on the boundary, or -1.
int nearest_vertex(const Triangle_surface& s, const Point& p) {
  int best = -1;
  for (int v = 0; v < s.number_of_vertices(); ++v)
    if (s.outgoing[v] >= 0 && !s.is_boundary(s.outgoing[v]) &&
        (best < 0 || (s.points[v] - p).squaredNorm() < (s.points[best] - p).squaredNorm()))
      best = v;
  return best;
}

} // namespace

Result<Designed_field> choose_extrema(const Triangle_surface& surface, const Quadrangulation_options& options,
                                      Observer* observer) {
  Designed_field field;
  Result<Suggestion> suggested = suggest_extrema(surface, options.suggestion, observer);
  if (!suggested) return suggested.error();
  field.boundary_is_maximum = suggested->boundary_is_maximum;
  if (options.extrema.empty()) {
    for (const Suggested_extremum& e : suggested->extrema)
      (e.is_maximum ? field.maxima : field.minima).push_back(e.vertex);
  } else {
    for (const Placed_extremum& e : options.extrema)
      (e.is_maximum ? field.maxima : field.minima).push_back(nearest_vertex(surface, e.point));
  }
  for (auto* list : {&field.minima, &field.maxima}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  for (int v : field.minima)
    if (std::binary_search(field.maxima.begin(), field.maxima.end(), v))
      return make_error(Error_code::impossible_request, "a vertex is asked to be a minimum and a maximum",
                        Element_kind::vertex, v);
  return field;
}

Result<void> solve_field(const Triangle_surface& surface, const Quadrangulation_options& options,
                         Designed_field& field) {
  Harmonic_field harmonic(surface, {options.solver, options.constraints});
  harmonic.set_weights(options.weights);
  harmonic.set_threads(internal::number_of_threads(options.threads));
  return solve_field(surface, harmonic, field);
}

namespace {

Result<void> check(const Snap_options& options) {
  const auto is_length = [](double x) { return x >= 0 && std::isfinite(x); };
  if (!(options.feature_angle >= 0 && options.feature_angle <= 180))
    return make_error(Error_code::impossible_request,
                      "the angle of sharp edges lies between 0 and 180 degrees");
  if (!is_length(options.reach) || !is_length(options.corner_reach) || !is_length(options.line_reach) ||
      !is_length(options.shortest_chain))
    return make_error(Error_code::impossible_request,
                      "the reaches and the shortest chain of sharp edges are lengths");
  if (!(options.worst_jacobian >= -1 && options.worst_jacobian <= 1))
    return make_error(Error_code::impossible_request, "the worst scaled Jacobian lies between -1 and 1");
  return {};
}

Result<void> check(const Quadrangulation_options& options) {
  const auto impossible = [](const char* sentence) {
    return make_error(Error_code::impossible_request, sentence);
  };
  if (!(options.edge_length >= 0) || !std::isfinite(options.edge_length))
    return impossible("the edge length is not a positive number");
  if (options.edge_length == 0 && options.quads < 1)
    return impossible("the number of quads must be positive");
  if (!(options.sample_blend >= 0 && options.sample_blend <= 1))
    return impossible("the blend of samples lies between 0 and 1");
  if (!(options.suggestion.persistence >= 0 && options.suggestion.persistence <= 1))
    return impossible("the persistence lies between 0 and 1");
  if (!options.suggestion.axis.allFinite() || options.suggestion.axis.isZero())
    return impossible("the axis has no direction");
  for (const Placed_extremum& e : options.extrema)
    if (!e.point.allFinite()) return impossible("a placed extremum is not finite");
  if (Result<void> fine = check(options.features); !fine) return fine;
  if (options.dislocations < 0 || options.dislocations > 10000)
    return impossible("there are 0 to 10,000 dislocations");
  if (options.mirror && options.boundaries == Boundaries::fill)
    return impossible("a mirror and filled boundaries exclude each other");
  if (options.threads < 0) return impossible("the number of threads is negative");
  if (!(options.budget >= 0) || !std::isfinite(options.budget))
    return impossible("the budget of the search is a number of seconds");
  if (options.budget > 0 && options.effort == Effort::fast)
    return impossible("a budget is for a search, and the effort fast has none");
  return {};
}

// Before some quads are subdivided. The coarser these are, the more can be; but quads that are too coarse fit
// the surface badly.
int quads_before_subdivision(const Quadrangulation_options& options) {
  return std::max(1, int(options.quads / std::sqrt(double(std::max(1, options.adaptive.ratio)))));
}

Editor_options editor_options(const Quadrangulation_options& asked) {
  Editor_options options;
  options.quads = quads_before_subdivision(asked);
  options.edge_length = asked.edge_length;
  options.sizes = asked.sizes;
  options.prepare = asked.prepare;
  options.sample_blend = asked.sample_blend;
  options.weights = asked.weights;
  options.solver = asked.solver;
  options.constraints = asked.constraints;
  options.boundaries = asked.boundaries;
  options.chart_weights = asked.chart_weights;
  options.textures = asked.textures;
  options.keep_factorization = false;
  options.threads = asked.threads;
  return options;
}

Finish_options finish_options(const Quadrangulation_options& asked) {
  Finish_options options;
  options.relax = asked.relax;
  options.relaxation = asked.relaxation;
  options.features = asked.features;
  if (!asked.keep_features) options.features.feature_angle = 0;
  options.marks = asked.marks;
  if (!asked.marks.empty()) options.features.lines = true;
  options.adaptive = asked.adaptive;
  if (options.adaptive.ratio != 1 && options.adaptive.quads == 0 && asked.edge_length <= 0)
    options.adaptive.quads = asked.quads;
  return options;
}

// Whether the user says what the extrema are, so that none are searched.
bool has_own_extrema(const Quadrangulation_options& options) {
  return !options.extrema.empty() || !options.field.empty();
}

Edit edit_of_extrema(const Quadrangulation_options& asked) {
  if (!asked.field.empty()) return Set_field{asked.field, asked.field_persistence, asked.collapse_thin};
  if (asked.extrema.empty())
    return Suggest{asked.suggestion.persistence, asked.suggestion.axis, asked.collapse_thin,
                   asked.boundary_values};
  Set_extrema edit;
  for (const Placed_extremum& e : asked.extrema) edit.extrema.push_back({{e.point, -1}, e.is_maximum, -1});
  edit.axis = asked.suggestion.axis;
  edit.collapse_thin = asked.collapse_thin;
  edit.boundary = asked.boundary_values;
  return edit;
}

int flipped_triangles(const Design& design) {
  int flipped = 0;
  for (const auto& chart : design.charts) flipped += chart->map->flipped(*chart->chart);
  return flipped;
}

const std::set<std::string> stages_of_a_run = {"prepare",  "search",    "extrema",     "field",
                                               "layout",   "charts",    "thin charts", "sampling",
                                               "textures", "stitching", "relaxation"};

Result<Finished_design> finished_on(const Given_features& features, const Editor& editor,
                                    const Recipe& recipe, Observer& observer) {
  Finish_options options = recipe.finish;
  options.relaxation.threads = internal::number_of_threads(recipe.options.threads);
  observer.progress("stitching", 0);
  Result<Stitched_mesh> quads = editor.open_quads();
  if (!quads) return quads.error();
  return finish_design(std::move(*quads), Surface_projector(editor.input()), features, options, &observer);
}

// Alignments that are tried, those that find the fewest patches first. A layout takes some 5 to 20
// microseconds.
std::vector<Align_layout> alignments(Effort effort) {
  Align_layout with_counts, turns_alone, careful;
  turns_alone.counts = careful.counts = 1;
  careful.strength = 0.25 * turns_alone.strength;
  with_counts.tries = turns_alone.tries = careful.tries = effort == Effort::fast     ? 2000
                                                          : effort == Effort::normal ? 6000
                                                                                     : 40000;
  if (effort == Effort::fast) return {turns_alone, careful};
  return {with_counts, turns_alone, careful};
}

// Where sizes are asked for, columns that end are a way to give them; else they are a remedy.
constexpr double price_of_column = 8, price_with_sizes = 2;

} // namespace

Result<Recipe> automatic_recipe(const Quadrangulation_options& options) {
  if (const Result<void> fine = check(options); !fine) return fine.error();
  Recipe recipe;
  recipe.options = editor_options(options);
  recipe.edits.push_back(edit_of_extrema(options));
  if (options.dislocations > 0)
    recipe.edits.push_back(
        Balance_columns{options.dislocations, options.sizes.empty() ? price_of_column : price_with_sizes});
  else if (options.align)
    recipe.edits.push_back(alignments(options.effort).front());
  for (const Guide& guide : options.guides) recipe.edits.push_back(Add_guide{guide});
  recipe.finish = finish_options(options);
  return recipe;
}

namespace {

// Designs that are tried: one takes 0.05 to 0.1 s of CPU time on the coarse copy, for 3000 quads.
constexpr int tries_of_normal = 40, tries_of_best = 160;

// More than any search makes that has seconds for it.
constexpr int tries_of_budget = 100000;

// Of the seconds, what the search of extrema takes at most where there are sharp edges to be searched after
// it.
constexpr double part_for_extrema = 0.6;

// Designs with sharp edges as contours that are tried, on the surface itself.
constexpr int curves_of_fast = 6, curves_of_normal = 24, curves_of_best = 120;

bool has_sharp_edges(const Editor& editor, const Quadrangulation_options& options) {
  return options.keep_features &&
         !feature_edges(editor.working_surface(), options.features.feature_angle).chains.empty();
}

// Lets the field follow closed lines of sharp edges, where that keeps them better.
Result<std::vector<Search_step>> search_sharp_curves(const Editor& editor,
                                                     const Quadrangulation_options& options, Recipe& recipe,
                                                     Observer* observer) {
  if (!options.keep_features || has_own_extrema(options)) return std::vector<Search_step>();
  Search_options search;
  search.tries = options.effort == Effort::fast     ? curves_of_fast
                 : options.effort == Effort::normal ? curves_of_normal
                                                    : curves_of_best;
  search.weights = options.energy;
  if (options.budget > 0) {
    search.tries = tries_of_budget;
    search.seconds = (1 - part_for_extrema) * options.budget;
  }
  Result<internal::Searched_curves> found =
      internal::search_curves(editor, recipe.edits[0], options.features.feature_angle, search, observer);
  if (!found) return found.error();
  if (found->edit) recipe.edits[0] = std::move(*found->edit);
  if (found->has_faces) recipe.finish.features.lines = true; // their edges are long: they deserve whole lines
  return std::move(found->steps);
}

// Replaces the recipe's suggestion by better extrema, if some are found.
Result<std::vector<Search_step>> search(const Editor& editor, const Quadrangulation_options& options,
                                        Recipe& recipe, Observer* observer) {
  if (options.effort == Effort::fast || has_own_extrema(options)) return std::vector<Search_step>();
  Search_options search;
  search.tries = options.effort == Effort::normal ? tries_of_normal : tries_of_best;
  search.weights = options.energy;
  search.extra_vertices = options.extra_vertices;
  if (options.budget > 0) {
    search.tries = tries_of_budget;
    search.seconds = (has_sharp_edges(editor, options) ? part_for_extrema : 1) * options.budget;
  }
  Result<Searched_extrema> found = search_extrema(editor, recipe.edits[0], search, observer);
  if (!found) return found.error();
  if (!found->steps.empty()) recipe.edits[0] = std::move(found->edit);
  return std::move(found->steps);
}

struct Made {
  Finished_design finished;
  int collapsed = 0;
  std::array<int, 2> base_patches{{0, 0}};
  std::optional<Search_step> alignment;
  double gain = 0;    // by how much the energy fell
  std::string remark; // on what was asked for and is not there; or empty
};

// 0 where it is not told.
int patches_of(const Design& design) {
  std::optional<Layout_lines> lines = Layout_lines::of(design);
  return lines ? lines->patches() : 0;
}

// What the lines of a design and the shapes of its quads are worth together.
struct Worth {
  int patches = 0;
  double jacobian = 0, energy = 0;
};

Worth worth_of(const Editor& editor, const Surface_projector& projector,
               const Quadrangulation_options& options) {
  Worth worth;
  const Energy_weights& weights = options.energy;
  const Stitched_mesh quads = editor.quads();
  const Design_energy parts = design_energy(quads, projector, Surface_samples());
  worth.patches = patches_of(editor.design());
  worth.jacobian = 1 - parts.angle;
  worth.energy = parts.total(weights) + weights.patches * std::log(double(std::max(1, worth.patches)));
  if (options.keep_features)
    worth.energy += weights.features * internal::missed_features(quads.mesh, editor.working_surface(),
                                                                 options.features.feature_angle);
  return worth;
}

std::string reason_of(const Align_layout& edit, const Worth& before, const Worth& after) {
  std::ostringstream reason;
  reason.precision(3);
  reason << "extraordinary vertices in line, by turns" << (edit.counts > 1 ? " and counts" : "")
         << ": patches of the base complex from " << before.patches << " to " << after.patches
         << ", the mean scaled Jacobian from " << before.jacobian << " to " << after.jacobian;
  return reason.str();
}

// The recipe's last edit brings extraordinary vertices in line, if the lines gain more than the quads lose:
// the first alignment that does, or with the effort `best` that which is worth most.
Result<void> align(Editor& editor, Recipe& recipe, const Quadrangulation_options& options, Made& made,
                   Observer& observer) {
  if (patches_of(editor.design()) < 2) return {};
  const Surface_projector projector(editor.working_surface());
  const Worth plain = worth_of(editor, projector, options);
  Worth best = plain;
  std::optional<Align_layout> found;
  for (const Align_layout& edit : alignments(options.effort)) {
    const Result<Edit_report> done = editor.apply(edit, &observer);
    if (!done && done.error().code == Error_code::cancelled) return done.error();
    if (!done) continue;
    const Worth worth = worth_of(editor, projector, options);
    const bool better = worth.patches < plain.patches && worth.energy < best.energy;
    if (better) {
      best = worth;
      found = edit;
      if (options.effort != Effort::best) break;
    }
    editor.undo();
  }
  made.base_patches = {plain.patches, best.patches};
  if (!found) {
    editor.forget_undone();
    return {};
  }
  if (options.effort == Effort::best)
    if (const Result<Edit_report> done = editor.apply(*found, &observer); !done) return done.error();
  recipe.edits.push_back(*found);
  made.alignment = Search_step{reason_of(*found, plain, best), best.energy};
  made.gain = plain.energy - best.energy;
  return {};
}

// Guides come last, so that extraordinary vertices are in line before contours are drawn.
Result<void> add_guides(Editor& editor, Recipe& recipe, const Quadrangulation_options& options,
                        Observer& observer) {
  for (const Guide& guide : options.guides) {
    const Result<Edit_report> done = editor.apply(Add_guide{guide}, &observer);
    if (!done) return done.error();
    recipe.edits.push_back(Add_guide{guide});
  }
  return {};
}

Result<Made> make(Editor& editor, Recipe& recipe, const Quadrangulation_options& options,
                  Observer& observer) {
  Made made;
  const auto comes_later = [](const Edit& edit) {
    return std::holds_alternative<Align_layout>(edit) || std::holds_alternative<Add_guide>(edit);
  };
  recipe.edits.erase(std::remove_if(recipe.edits.begin(), recipe.edits.end(), comes_later),
                     recipe.edits.end());
  for (std::size_t i = 0; i < recipe.edits.size();) {
    const Result<Edit_report> done = editor.apply(recipe.edits[i], &observer);
    const bool can_do_without = std::holds_alternative<Balance_columns>(recipe.edits[i]);
    if (!done && (!can_do_without || done.error().code == Error_code::cancelled)) return done.error();
    if (done) {
      made.collapsed += done->collapsed_charts;
      ++i;
    } else {
      made.remark = "no columns end inside of charts: " + done.error().message;
      recipe.edits.erase(recipe.edits.begin() + std::ptrdiff_t(i));
    }
  }
  if (options.align && options.dislocations == 0)
    if (Result<void> done = align(editor, recipe, options, made, observer); !done) return done.error();
  if (Result<void> done = add_guides(editor, recipe, options, observer); !done) return done.error();
  Result<Finished_design> finished = options.given_features
                                         ? finished_on(*options.given_features, editor, recipe, observer)
                                         : editor.finished_quads(recipe.finish, &observer);
  if (!finished) return finished.error();
  made.finished = std::move(*finished);
  return made;
}

int defects(const Made& made) {
  return made.finished.relaxation.inverted_after + made.finished.relaxation.intersections_after;
}

// Makes what the recipe says. What the search has found on a coarse copy goes if it cannot be made on the
// surface itself, or gives defects where the suggestion gives less.
Result<Made> make_or_fall_back(Editor& editor, Recipe& recipe, const Edit& suggestion,
                               std::vector<Search_step>& steps, const Quadrangulation_options& options,
                               Observer& observer) {
  Result<Made> made = make(editor, recipe, options, observer);
  const bool failed = !made && made.error().code != Error_code::cancelled;
  if (steps.empty() || !(failed || (made && defects(*made) > 0))) return made;
  while (editor.can_undo()) editor.undo();
  Recipe plain = recipe;
  plain.edits[0] = suggestion;
  Result<Made> other = make(editor, plain, options, observer);
  if (!other && other.error().code == Error_code::cancelled) return other;
  if (other && (failed || defects(*other) < defects(*made))) {
    recipe = std::move(plain);
    steps.clear();
    return other;
  }
  while (editor.can_undo()) editor.undo();
  return make(editor, recipe, options, observer);
}

} // namespace

Result<Quadrangulation> quadrangulate(const Triangle_surface& surface, const Quadrangulation_options& options,
                                      Observer* observer) {
  Result<Recipe> recipe = automatic_recipe(options);
  if (!recipe) return recipe.error();
  if (options.mirror) return internal::quadrangulate_mirrored(surface, options, observer);
  internal::Stage_recorder recorder(observer, stages_of_a_run);
  Result<Editor> editor = Editor::create(surface, recipe->options, &recorder);
  if (!editor) return editor.error();
  const Edit suggestion = recipe->edits[0];
  Result<std::vector<Search_step>> steps = search(*editor, options, *recipe, &recorder);
  if (!steps) return steps.error();
  const Result<std::vector<Search_step>> curves = search_sharp_curves(*editor, options, *recipe, &recorder);
  if (!curves) return curves.error();
  steps->insert(steps->end(), curves->begin(), curves->end());
  Result<Made> made = make_or_fall_back(*editor, *recipe, suggestion, *steps, options, recorder);
  if (!made) return made.error();
  const int genus = (2 - euler_characteristic(surface) - int(boundary_loops(surface).size())) / 2;
  if (made->alignment) {
    if (!steps->empty()) made->alignment->energy = steps->back().energy - made->gain;
    steps->push_back(std::move(*made->alignment));
  }
  if (!made->remark.empty())
    steps->push_back({std::move(made->remark), steps->empty() ? 0 : steps->back().energy});
  const int flipped = flipped_triangles(editor->design());
  Finished_design& finished = made->finished;
  Stitched_mesh& quads = finished.quads;
  return Quadrangulation{std::move(quads.mesh),
                         std::move(quads.valences),
                         std::move(quads.chart_of_quad),
                         std::move(*editor),
                         std::move(*recipe),
                         std::move(finished.relaxation),
                         finished.features,
                         std::move(finished.guides),
                         finished.subdivided_quads,
                         finished.t_junctions + quads.t_junctions,
                         made->collapsed,
                         flipped,
                         genus,
                         made->base_patches,
                         std::move(*steps),
                         recorder.finish()};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
