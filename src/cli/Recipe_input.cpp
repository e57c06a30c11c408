// SPDX-License-Identifier: GPL-3.0-or-later
#include "Recipe_input.h"

#include "Failure.h"
#include "Input.h"
#include "Interruption.h"

#include "automatic/components.h"
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>
#include <CGAL/Reeb_quadrangulation/offer_after.h>

#include <algorithm>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr std::uint64_t largest_recipe = std::uint64_t(256) << 20;

/// The component of the recipe's number, counted from 1; 0: the only one.
Triangle_surface read_component(const std::string& file, const Recipe& recipe) {
  Mend_options options;
  options.fill_holes = recipe.fill_holes;
  Mended_surface mended = value_or_fail(mend_surface(read_soup(file), options), file);
  const int component = recipe.component;
  const std::size_t number = mended.components.size();
  if (component == 0 && number != 1)
    throw Failure(Exit_code::not_a_surface, file + ": a recipe is for one connected surface, this file has " +
                                                std::to_string(number) +
                                                "; the recipe's \"component\" says which, or --component");
  succeed_or_fail(internal::leave_component(mended, std::max(component, 1), "file"), file);
  return std::move(mended.components[0].surface);
}

/// What works in place of an edit that was refused, for the end of the sentence that says so; or nothing.
std::string instead(const Editor& editor, const Edit& edit, const Error& refusal,
                    Terminal_observer& observer) {
  const Result<std::optional<Offer>> offer = offer_after(editor, edit, refusal, &observer);
  if (!offer || !*offer) return "";
  return "; what works: " + (*offer)->words + ", " + to_json((*offer)->edit);
}

} // namespace

Recipe read_recipe(const std::string& file) {
  return value_or_fail(recipe_from_json(value_or_fail(read_file(file, largest_recipe), file)), file);
}

Replayed_recipe replay_recipe(const std::string& input, const Recipe& recipe, const std::string& recipe_name,
                              Terminal_observer& observer) {
  Triangle_surface whole = read_component(input, recipe);
  std::optional<Surface_half> half;
  if (recipe.mirror) half = value_or_fail(halve_surface(whole, recipe.mirror->plane), input);
  Triangle_surface worked_on = half ? half->surface : std::move(whole);
  Replayed_recipe replayed{
      value_or_fail(Editor::create(std::move(worked_on), recipe.options, &observer), input),
      std::move(half),
      {}};
  if (replayed.half) replayed.whole = std::move(whole);
  for (std::size_t i = 0; i < recipe.edits.size(); ++i) {
    const Result<Edit_report> done = replayed.editor.apply(recipe.edits[i], &observer);
    if (interrupted()) throw Failure(Exit_code::interrupted, "interrupted; nothing is written");
    if (!done) {
      const std::string works = instead(replayed.editor, recipe.edits[i], done.error(), observer);
      throw Failure(exit_code(done.error().code), recipe_name + ": edit " + std::to_string(i + 1) + " (" +
                                                      name(recipe.edits[i]) +
                                                      ") does not apply: " + done.error().message + works);
    }
  }
  return replayed;
}

} // namespace reebquad
