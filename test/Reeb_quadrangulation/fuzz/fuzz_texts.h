// SPDX-License-Identifier: GPL-3.0-or-later
// What the program reads beside meshes: recipes, sessions, extrema. What is accepted is written and read
// again to the same.
#ifndef FUZZ_TEXTS_H
#define FUZZ_TEXTS_H

#include "Text_input.h"
#include "fuzz_promise.h"
#include "session/Store.h"

#include <CGAL/Reeb_quadrangulation/IO/hints.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace fuzz {

inline int recipe(const std::uint8_t* data, std::size_t size) {
  using namespace CGAL::Reeb_quadrangulation;
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const Result<Recipe> read = recipe_from_json(text)) {
    const std::string written = to_json(*read);
    const Result<Recipe> again = recipe_from_json(written);
    promise(again && to_json(*again) == written && again->edits.size() == read->edits.size());
  } else {
    promise(!read.error().message.empty());
  }
  if (const Result<Edit> edit = edit_from_json(text)) {
    const Result<Edit> again = edit_from_json(to_json(*edit));
    promise(again && to_json(*again) == to_json(*edit));
  }
  return 0;
}

/// Hints are only written; what they are written of may be any edits.
inline int hints(const std::uint8_t* data, std::size_t size) {
  using namespace CGAL::Reeb_quadrangulation;
  const Result<Recipe> read = recipe_from_json(std::string(reinterpret_cast<const char*>(data), size));
  if (!read) return 0;
  std::vector<Hint> all;
  for (const Edit& edit : read->edits) {
    Hint hint;
    hint.edit = edit;
    hint.kind = Hint_kind(all.size() % 2);
    all.push_back(hint);
  }
  const nlohmann::json json = nlohmann::json::parse(to_json(all));
  promise(json.size() == all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Result<Edit> again = edit_from_json(json[i]["edit"].dump());
    promise(again && to_json(*again) == to_json(all[i].edit));
  }
  return 0;
}

inline int session(const std::uint8_t* data, std::size_t size) {
  using namespace reebquad::studio;
  const std::optional<Saved_session> read =
      session_from_json(std::string(reinterpret_cast<const char*>(data), size));
  if (!read) return 0;
  promise(read->digest.size() == 16 && read->component >= 1);
  for (const Saved_part& part : read->parts)
    promise(part.applied >= 0 && part.applied <= int(part.edits.size()));
  const std::optional<Saved_session> again = session_from_json(to_json(*read));
  promise(again && to_json(*again) == to_json(*read));
  return 0;
}

inline int extrema(const std::uint8_t* data, std::size_t size) {
  const std::vector<reebquad::Text_line> lines =
      reebquad::lines_of(std::string(reinterpret_cast<const char*>(data), size));
  int last = 0;
  for (const reebquad::Text_line& line : lines) {
    promise(line.number > last && line.text.find('\n') == std::string::npos);
    last = line.number;
  }
  if (const auto read = reebquad::parse_extrema(lines)) {
    promise(read->size() == lines.size());
    for (const auto& extremum : *read) promise(extremum.point.allFinite());
  } else {
    promise(!read.error().message.empty());
  }
  return 0;
}

} // namespace fuzz

#endif // FUZZ_TEXTS_H
