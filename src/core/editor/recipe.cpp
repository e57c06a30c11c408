// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>
#include <stdexcept>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "reebquad recipe";
constexpr int format_version = 1;

/// \name The fields of each edit, once for reading and writing
/// @{
template <class F> void fields(F& f, Surface_point& p) {
  f("point", p.point);
  f.optional("vertex", p.vertex);
}
template <class F> void fields(F& f, Set_extrema::Extremum& e) {
  f("at", e.at);
  f("maximum", e.is_maximum);
  f.optional("value", e.value);
}
template <class F> void fields(F& f, Set_extrema::Sharp_curve& c) {
  f("face", c.face);
  f("at", c.at);
  f.optional("kind", c.kind);
  f.optional("feature_angle", c.feature_angle);
}
template <class F> void fields(F& f, Boundary_value& b) {
  f("at", b.at);
  f("maximum", b.is_maximum);
  f.optional("value", b.value);
}
template <class F> void fields(F& f, Suggest& e) {
  f.optional("persistence", e.persistence);
  f.optional("axis", e.axis);
  f.optional("collapse_thin", e.collapse_thin);
  f.optional("boundary", e.boundary);
}
template <class F> void fields(F& f, Set_extrema& e) {
  f("extrema", e.extrema);
  f.optional("curves", e.curves);
  f.optional("axis", e.axis);
  f.optional("collapse_thin", e.collapse_thin);
  f.optional("boundary", e.boundary);
}
template <class F> void fields(F& f, Set_field& e) {
  f("values", e.values);
  f.optional("persistence", e.persistence);
  f.optional("collapse_thin", e.collapse_thin);
}
template <class F> void fields(F& f, Add_extremum& e) {
  f("at", e.at);
  f("maximum", e.is_maximum);
  f.optional("scope", e.scope);
  f.optional("strength", e.strength);
}
template <class F> void fields(F& f, Remove_extremum& e) {
  f("at", e.at);
  f.optional("scope", e.scope);
}
template <class F> void fields(F& f, Move_extremum& e) {
  f("from", e.from);
  f("to", e.to);
  f.optional("scope", e.scope);
}
template <class F> void fields(F& f, Change_value& e) {
  f("at", e.at);
  f("value", e.value);
}
template <class F> void fields(F& f, Move_contour& e) {
  f("at", e.at);
  f("plane_point", e.plane_point);
  f("plane_normal", e.plane_normal);
  f.optional("anchors", e.anchors);
  f.optional("enforcement", e.enforcement);
}
template <class F> void fields(F& f, Move_saddle& e) {
  f("at", e.at);
  f("to", e.to);
  f.optional("plane_normal", e.plane_normal);
}
template <class F> void fields(F& f, Drag_contour& e) {
  f("at", e.at);
  f("to", e.to);
}
template <class F> void fields(F& f, Straighten_contour& e) {
  f("at", e.at);
}
template <class F> void fields(F& f, Snap_contour& e) {
  f("at", e.at);
  f.optional("feature_angle", e.feature_angle);
}
template <class F> void fields(F& f, Subdivide_chart& e) {
  f("at", e.at);
}
template <class F> void fields(F& f, Remove_contour& e) {
  f("at", e.at);
}
template <class F> void fields(F& f, Align_saddles& e) {
  f("first", e.first);
  f("second", e.second);
}
template <class F> void fields(F& f, Collapse_chart& e) {
  f("at", e.at);
}
template <class F> void fields(F&, Collapse_thin_charts&) {}
template <class F> void fields(F& f, Split_pole& e) {
  f("at", e.at);
  f("kind", e.kind);
  f.optional("ends", e.ends);
}
template <class F> void fields(F& f, Move_corner& e) {
  f("at", e.at);
  f("to", e.to);
}
template <class F> void fields(F& f, Split_saddle& e) {
  f("at", e.at);
  f("kind", e.kind);
  f.optional("points", e.points);
  f.optional("size", e.size);
}
template <class F> void fields(F& f, Pin_corners& e) {
  f("at", e.at);
}
template <class F> void fields(F& f, Set_target& e) {
  f.optional("quads", e.quads);
  f.optional("edge_length", e.edge_length);
}
template <class F> void fields(F& f, Set_columns& e) {
  f("at", e.at);
  f("columns", e.columns);
  f.optional("side", e.side);
}
template <class F> void fields(F& f, Add_dislocation& e) {
  f("at", e.at);
  f.optional("columns", e.columns);
}
template <class F> void fields(F& f, Balance_columns& e) {
  f.optional("most", e.most);
  f.optional("price", e.price);
}
template <class F> void fields(F& f, Remove_dislocation& e) {
  f("at", e.at);
}
template <class F> void fields(F& f, Set_rows& e) {
  f("at", e.at);
  f("rows", e.rows);
}
template <class F> void fields(F& f, Set_shift& e) {
  f("at", e.at);
  f("shift", e.shift);
}
template <class F> void fields(F& f, Set_grading& e) {
  f("at", e.at);
  f("ratio", e.ratio);
}
template <class F> void fields(F& f, Lock_chart& e) {
  f("at", e.at);
  f.optional("locked", e.locked);
}
template <class F> void fields(F& f, Align_layout& e) {
  f.optional("strength", e.strength);
  f.optional("counts", e.counts);
  f.optional("tries", e.tries);
}
template <class F> void fields(F& f, Edit_texture& e) {
  f("operator", e.operation);
  f("points", e.points);
  f.optional("fraction", e.fraction);
  f.optional("scope", e.scope);
}
template <class F> void fields(F& f, Drag_vertices& e) {
  f("points", e.points);
  f("to", e.to);
  f.optional("radius", e.radius);
  f.optional("falloff", e.falloff);
  f.optional("rings", e.rings);
  f.optional("steps", e.steps);
  f.optional("anchors", e.anchors);
}
template <class F> void fields(F& f, Relax_texture& e) {
  f("at", e.at);
  f.optional("steps", e.steps);
  f.optional("radius", e.radius);
  f.optional("anchors", e.anchors);
  f.optional("scope", e.scope);
}
template <class F> void fields(F& f, Snap_vertices& e) {
  f("points", e.points);
  f.optional("feature_angle", e.feature_angle);
}
template <class F> void fields(F& f, Fit_texture& e) {
  f("at", e.at);
  f.optional("feature_angle", e.feature_angle);
  f.optional("scope", e.scope);
}
template <class F> void fields(F& f, Reset_texture& e) {
  f("at", e.at);
  f.optional("scope", e.scope);
}
template <class F> void fields(F& f, Add_guide& e) {
  f("points", e.guide.points);
  f.optional("closed", e.guide.closed);
  f.optional("strength", e.guide.strength);
  f.optional("way", e.guide.way);
}
template <class F> void fields(F& f, Move_guide& e) {
  f("at", e.at);
  f.optional("points", e.points);
  f.optional("strength", e.strength);
}
template <class F> void fields(F& f, Remove_guide& e) {
  f("at", e.at);
}
template <class F> void fields(F& f, Editor_options& o) {
  f("quads", o.quads);
  f.optional("edge_length", o.edge_length);
  f.if_any("sizes", o.sizes);
  f.optional("prepare", o.prepare);
  f.optional("sample_blend", o.sample_blend);
  f.optional("weights", o.weights);
  f.optional("solver", o.solver);
  f.optional("constraints", o.constraints);
  f.optional("boundaries", o.boundaries);
}
template <class F> void fields(F& f, Mirror& m) {
  f("point", m.plane.point);
  f("normal", m.plane.normal);
  f.optional("positions", m.positions);
}
template <class F> void fields(F& f, Mark& m) {
  f("from", m.from);
  f("to", m.to);
}
template <class F> void fields(F& f, Marks& m) {
  f.optional("marked", m.marked);
  f.optional("unmarked", m.unmarked);
  f.optional("tolerance", m.tolerance);
}
template <class F> void fields(F& f, Finish_options& o) {
  f.optional("relax", o.relax);
  f.optional("feature_angle", o.features.feature_angle);
  f.optional("feature_lines", o.features.lines);
  f.optional("adaptive_ratio", o.adaptive.ratio);
  f.optional("adaptive_quads", o.adaptive.quads);
}
/// @}

template <class E> struct Names;
template <> struct Names<Edit_scope> { static constexpr const char* of[] = {"chart", "surface"}; };
template <> struct Names<Chart_side> { static constexpr const char* of[] = {"both", "low", "high"}; };
template <> struct Names<Enforcement> { static constexpr const char* of[] = {"contour", "field"}; };
template <> struct Names<Pole_kind> { static constexpr const char* of[] = {"whole", "half", "quarter"}; };
template <> struct Names<Saddle_kind> { static constexpr const char* of[] = {"half", "quarter"}; };
template <> struct Names<Sharp_curve_kind> {
  static constexpr const char* of[] = {"minimum", "maximum", "cap_of_minimum", "cap_of_maximum"};
};
template <> struct Names<Weight_kind> {
  static constexpr const char* of[] = {"cotangent", "clamped_cotangent", "uniform"};
};
template <> struct Names<Constraint_method> {
  static constexpr const char* of[] = {"elimination", "penalty"};
};
template <> struct Names<Boundaries> { static constexpr const char* of[] = {"keep", "fill"}; };
template <> struct Names<Mirror_positions> { static constexpr const char* of[] = {"exact", "projected"}; };
template <> struct Names<Guide_way> { static constexpr const char* of[] = {"nearer", "level", "flow"}; };
template <> struct Names<Falloff> { static constexpr const char* of[] = {"constant", "linear", "smooth"}; };
template <> struct Names<Texture_operator> {
  static constexpr const char* of[] = {
      "subdivide",      "coarsen",        "insert_polychord", "delete_polychord", "inset_quads",
      "open_quad",      "close_quad",     "rotate_edge",      "rotate_edge_back", "rotate_vertex",
      "insert_doublet", "remove_doublet", "delete_quads",     "restore_quads"};
};

class Writer {
public:
  explicit Writer(Json& object) : m_object(object) {}
  template <class T> void operator()(const char* key, T& value) { m_object[key] = json(value); }
  template <class T> void optional(const char* key, T& value) { (*this)(key, value); }
  template <class T> void if_any(const char* key, std::vector<T>& list) {
    if (!list.empty()) (*this)(key, list);
  }

private:
  static Json json(Point& p) { return Json::array({p.x(), p.y(), p.z()}); }
  static Json json(double x) { return x; }
  static Json json(int x) { return x; }
  static Json json(bool x) { return x; }
  static Json json(Linear_solver_factory& x) { return x.name(); }
  template <class T> static Json json(std::vector<T>& list) {
    Json array = Json::array();
    for (T& x : list) array.push_back(json(x));
    return array;
  }
  template <class T> static Json json(T& value) {
    if constexpr (std::is_enum_v<T>) {
      return Names<T>::of[int(value)];
    } else {
      Json object = Json::object();
      Writer writer(object);
      fields(writer, value);
      return object;
    }
  }
  Json& m_object;
};

// What is wrong with a recipe; becomes a Result at the border of this file.
struct Malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Reader {
public:
  Reader(const Json& object, std::string where) : m_object(object), m_where(std::move(where)) {
    if (!object.is_object()) throw Malformed(m_where + " is not an object");
  }
  template <class T> void operator()(const char* key, T& value) {
    if (!m_object.contains(key)) throw Malformed(m_where + " has no field \"" + key + "\"");
    optional(key, value);
  }
  template <class T> void optional(const char* key, T& value) {
    m_known.insert(key);
    if (m_object.contains(key)) read(m_object[key], value, m_where + ": \"" + key + "\"");
  }
  template <class T> void if_any(const char* key, std::vector<T>& list) { optional(key, list); }
  void know(const char* key) { m_known.insert(key); }
  void finish() const {
    for (const auto& entry : m_object.items())
      if (!m_known.count(entry.key()))
        throw Malformed(m_where + " has an unknown field \"" + entry.key() + "\"");
  }

private:
  static void read(const Json& json, double& value, const std::string& where) {
    if (!json.is_number() || !std::isfinite(json.get<double>()))
      throw Malformed(where + " is not a finite number");
    value = json.get<double>();
  }
  static void read(const Json& json, int& value, const std::string& where) {
    if (!json.is_number_integer() || json.get<double>() < -1e9 || json.get<double>() > 1e9)
      throw Malformed(where + " is not an integer of at most nine digits");
    value = json.get<int>();
  }
  static void read(const Json& json, bool& value, const std::string& where) {
    if (!json.is_boolean()) throw Malformed(where + " is neither true nor false");
    value = json.get<bool>();
  }
  static void read(const Json& json, Linear_solver_factory& value, const std::string& where) {
    if (!json.is_string()) throw Malformed(where + " is not a name");
    Result<Linear_solver_factory> found = linear_solver_named(json.get<std::string>());
    if (!found) throw Malformed(where + ": " + found.error().message);
    value = std::move(*found);
  }
  static void read(const Json& json, Point& value, const std::string& where) {
    if (!json.is_array() || json.size() != 3) throw Malformed(where + " is not a list of three numbers");
    for (int i = 0; i < 3; ++i) read(json[i], value[i], where);
  }
  template <class T> static void read(const Json& json, std::vector<T>& value, const std::string& where) {
    if (!json.is_array()) throw Malformed(where + " is not a list");
    value.clear();
    for (std::size_t i = 0; i < json.size(); ++i) {
      value.emplace_back();
      read(json[i], value.back(), where + "[" + std::to_string(i) + "]");
    }
  }
  template <class T> static void read(const Json& json, T& value, const std::string& where) {
    if constexpr (std::is_enum_v<T>) {
      if (json.is_string())
        for (std::size_t i = 0; i < std::size(Names<T>::of); ++i)
          if (json.get<std::string>() == Names<T>::of[i]) {
            value = T(i);
            return;
          }
      std::string names;
      for (const char* name : Names<T>::of) names += std::string(names.empty() ? "" : ", ") + name;
      throw Malformed(where + " is none of " + names);
    } else {
      Reader reader(json, where);
      fields(reader, value);
      reader.finish();
    }
  }

  const Json& m_object;
  std::string m_where;
  std::set<std::string> m_known;
};

Json edit_json(Edit edit) {
  Json object = Json::object();
  object["edit"] = name(edit);
  Writer writer(object);
  std::visit([&](auto& e) { fields(writer, e); }, edit);
  return object;
}

// Each alternative of the variant is tried by its name.
template <std::size_t I = 0>
Edit read_edit(const Json& object, const std::string& wanted, const std::string& where) {
  if constexpr (I == std::variant_size_v<Edit>) {
    throw Malformed(where + ": there is no edit \"" + wanted + "\"");
  } else {
    std::variant_alternative_t<I, Edit> edit;
    if (edit.edit_name != wanted) return read_edit<I + 1>(object, wanted, where);
    Reader reader(object, where + " (" + wanted + ")");
    reader.know("edit");
    fields(reader, edit);
    reader.finish();
    return edit;
  }
}

Edit edit_of(const Json& object, const std::string& where) {
  if (!object.is_object() || !object.contains("edit") || !object["edit"].is_string())
    throw Malformed(where + " has no field \"edit\" with its name");
  return read_edit(object, object["edit"].get<std::string>(), where);
}

// Deeper nesting than any recipe has, or an unreasonable size, is refused before it is parsed.
Json parse(const std::string& text) {
  constexpr std::size_t most_bytes = 256u << 20;
  if (text.size() > most_bytes) throw Malformed("the recipe is larger than 256 MB");
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > 32) throw Malformed("the recipe is nested too deeply");
  }
  return Json::parse(text);
}

template <class Work> auto guarded(const Work& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const Malformed& e) {
    return make_error(Error_code::malformed_file, e.what());
  } catch (const Json::exception& e) {
    return make_error(Error_code::malformed_file, std::string("not valid JSON: ") + e.what());
  }
}

} // namespace

std::string to_json(const Edit& edit) {
  return edit_json(edit).dump();
}

Result<Edit> edit_from_json(const std::string& text) {
  return guarded([&] { return edit_of(parse(text), "the edit"); });
}

std::string to_json(const Recipe& recipe) {
  std::string text = "{\n  \"format\": \"" + std::string(format_name) +
                     "\",\n  \"version\": " + std::to_string(format_version) + ",\n";
  Json options = Json::object();
  Writer writer(options);
  Editor_options copy = recipe.options;
  fields(writer, copy);
  Json finish = Json::object();
  Writer finish_writer(finish);
  Finish_options finish_copy = recipe.finish;
  fields(finish_writer, finish_copy);
  if (recipe.component > 0) text += "  \"component\": " + std::to_string(recipe.component) + ",\n";
  if (recipe.fill_holes > 0) text += "  \"fill_holes\": " + std::to_string(recipe.fill_holes) + ",\n";
  if (recipe.mirror) {
    Json mirror = Json::object();
    Writer mirror_writer(mirror);
    Mirror mirror_copy = *recipe.mirror;
    fields(mirror_writer, mirror_copy);
    text += "  \"mirror\": " + mirror.dump() + ",\n";
  }
  if (!recipe.finish.marks.empty()) {
    Json marks = Json::object();
    Writer marks_writer(marks);
    Marks marks_copy = recipe.finish.marks;
    fields(marks_writer, marks_copy);
    text += "  \"marks\": " + marks.dump() + ",\n";
  }
  text += "  \"options\": " + options.dump() + ",\n  \"finish\": " + finish.dump() + ",\n  \"edits\": [";
  for (std::size_t i = 0; i < recipe.edits.size(); ++i)
    text += (i == 0 ? "\n    " : ",\n    ") + to_json(recipe.edits[i]);
  return text + (recipe.edits.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

Result<Recipe> recipe_from_json(const std::string& text) {
  return guarded([&] {
    const Json json = parse(text);
    if (!json.is_object() || !json.contains("format") || json["format"] != format_name)
      throw Malformed(std::string("not a recipe: there is no \"format\": \"") + format_name + "\"");
    if (!json.contains("version") || json["version"] != format_version)
      throw Malformed("the recipe's version is not " + std::to_string(format_version));
    Recipe recipe;
    for (const auto& entry : json.items()) {
      const std::string& key = entry.key();
      if (key != "format" && key != "version" && key != "options" && key != "edits" && key != "comment" &&
          key != "component" && key != "fill_holes" && key != "finish" && key != "mirror" && key != "marks")
        throw Malformed("the recipe has an unknown field \"" + key + "\"");
    }
    if (json.contains("component")) {
      const Json& component = json["component"];
      if (!component.is_number_integer() || component < 1 || component > 1000000000)
        throw Malformed("\"component\" is not an integer of at least 1 and at most nine digits");
      recipe.component = component.get<int>();
    }
    if (json.contains("fill_holes")) {
      const Json& edges = json["fill_holes"];
      if (!edges.is_number_integer() || edges < 3 || edges > 1000000000)
        throw Malformed("\"fill_holes\" is not an integer of at least 3 and at most nine digits");
      recipe.fill_holes = edges.get<int>();
    }
    if (json.contains("mirror")) {
      Reader reader(json["mirror"], "\"mirror\"");
      fields(reader, recipe.mirror.emplace());
      reader.finish();
      if (recipe.mirror->plane.normal.isZero(0)) throw Malformed("\"mirror\": the normal is zero");
    }
    if (json.contains("marks")) {
      Reader reader(json["marks"], "\"marks\"");
      fields(reader, recipe.finish.marks);
      reader.finish();
    }
    if (json.contains("options")) {
      Reader reader(json["options"], "\"options\"");
      fields(reader, recipe.options);
      reader.finish();
    }
    if (json.contains("finish")) {
      Reader reader(json["finish"], "\"finish\"");
      fields(reader, recipe.finish);
      reader.finish();
    }
    if (recipe.mirror && recipe.options.boundaries == Boundaries::fill)
      throw Malformed("\"mirror\" and \"boundaries\": \"fill\" exclude each other");
    if (!json.contains("edits") || !json["edits"].is_array())
      throw Malformed("the recipe has no list \"edits\"");
    for (std::size_t i = 0; i < json["edits"].size(); ++i)
      recipe.edits.push_back(edit_of(json["edits"][i], "edit " + std::to_string(i + 1)));
    return recipe;
  });
}

const char* name(Pole_kind kind) {
  return Names<Pole_kind>::of[int(kind)];
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
