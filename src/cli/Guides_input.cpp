// SPDX-License-Identifier: GPL-3.0-or-later
#include "Guides_input.h"

#include "Failure.h"
#include "Marks_input.h"
#include "Text_input.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::uint64_t largest_guides = std::uint64_t(64) << 20;

Error malformed_guide(std::size_t i, const std::string& what) {
  return make_error(Error_code::malformed_file, "guide " + std::to_string(i + 1) + ": " + what);
}

// A guide as the edit that adds it; numbers of points become positions.
Result<Guide> guide_of_json(Json object, std::size_t i, const Polygon_soup& mesh) {
  if (!object.is_object()) return malformed_guide(i, "it is not an object");
  if (object.contains("vertices")) {
    if (object.contains("points") || !object["vertices"].is_array())
      return malformed_guide(i, "it has either a list \"points\" or a list \"vertices\"");
    Json points = Json::array();
    for (const Json& v : object["vertices"]) {
      if (!v.is_number_integer() || v < 0 || v >= mesh.points.size())
        return malformed_guide(i, "there is no point " + v.dump() + ", the mesh has " +
                                      std::to_string(mesh.points.size()) + ", counted from 0");
      const Point& p = mesh.points[v.get<std::size_t>()];
      points.push_back({p.x(), p.y(), p.z()});
    }
    object.erase("vertices");
    object["points"] = std::move(points);
  }
  object["edit"] = Add_guide::edit_name;
  const Result<Edit> edit = edit_from_json(object.dump());
  if (!edit) return malformed_guide(i, edit.error().message);
  return std::get<Add_guide>(*edit).guide;
}

Result<std::vector<Guide>> guides_of_json(const std::string& text, const Polygon_soup& mesh) {
  const auto too_deep = [](int depth, Json::parse_event_t, Json&) { return depth <= 8; };
  const Json json = Json::parse(text, too_deep, false);
  if (!json.is_object() || json.size() != 1 || !json.contains("guides") || !json["guides"].is_array())
    return make_error(Error_code::malformed_file, "it is not JSON with a list \"guides\" alone");
  std::vector<Guide> guides;
  for (const Json& object : json["guides"]) {
    Result<Guide> guide = guide_of_json(object, guides.size(), mesh);
    if (!guide) return guide.error();
    guides.push_back(std::move(*guide));
  }
  return guides;
}

Result<std::vector<Guide>> guides_of_obj(const std::string& text) {
  Result<std::vector<std::vector<Point>>> lines = polylines_of_obj(lines_of(text));
  if (!lines) return lines.error();
  std::vector<Guide> guides;
  for (std::vector<Point>& points : *lines) {
    Guide guide;
    guide.closed = points.size() > 2 && points.front() == points.back();
    guide.points = std::move(points);
    guides.push_back(std::move(guide));
  }
  return guides;
}

} // namespace

void declare_guides(Command_line& line) {
  line.options.add_options()(
      "guides", po::value<std::string>()->value_name("FILE"),
      "strokes on the surface that quads follow: JSON with a list of guides, or an OBJ "
      "file with lines");
}

Result<std::vector<Guide>> parse_guides(const std::string& text, const Polygon_soup& mesh) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_json = first != std::string::npos && text[first] == '{';
  Result<std::vector<Guide>> guides = is_json ? guides_of_json(text, mesh) : guides_of_obj(text);
  if (guides && guides->empty()) return make_error(Error_code::malformed_file, "it has no guides");
  return guides;
}

std::vector<Guide> read_guides(const std::string& file, const Polygon_soup& mesh) {
  return value_or_fail(parse_guides(value_or_fail(read_file(file, largest_guides), file), mesh), file);
}

} // namespace reebquad
