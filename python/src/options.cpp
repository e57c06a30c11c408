// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include "arrays.h"

#include <cmath>
#include <limits>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

std::string type_of(const py::object& value) {
  return py::str(py::type::of(value).attr("__name__"));
}

/// What an automatic run and an editor both have.
template <class Options> void read_shared(Keywords& keywords, Options& options) {
  const bool has_quads = !py::object(keywords.peek("quads")).is_none();
  keywords.read("quads", options.quads);
  keywords.read("edge_length", options.edge_length);
  if (options.edge_length != 0 && has_quads) refuse("quads and edge_length exclude each other");
  if (!(options.edge_length >= 0)) refuse("edge_length is a positive length");
  keywords.read("threads", options.threads);
  keywords.read("prepare", options.prepare);
  keywords.read("sample_blend", options.sample_blend);
  keywords.read("weights", options.weights,
                {{"cotangent", Weight_kind::cotangent},
                 {"clamped_cotangent", Weight_kind::clamped_cotangent},
                 {"uniform", Weight_kind::uniform}});
  keywords.read("constraints", options.constraints,
                {{"elimination", Constraint_method::elimination}, {"penalty", Constraint_method::penalty}});
  const std::string solver = keywords.take_text("solver");
  if (!solver.empty()) options.solver = value_of(linear_solver_named(solver));
}

} // namespace

py::object Keywords::peek(const char* name) const {
  return m_left.contains(name) ? py::object(m_left[name]) : py::object(py::none());
}

py::object Keywords::take(const char* name) {
  const py::object value = peek(name);
  if (m_left.contains(name)) m_left.attr("pop")(name);
  return value;
}

void Keywords::read(const char* name, int& option) {
  const py::object value = take(name);
  if (value.is_none()) return;
  if (py::isinstance<py::bool_>(value) || !PyIndex_Check(value.ptr()))
    throw py::type_error(std::string(name) + " is an integer; its type is " + type_of(value));
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) throw py::error_already_set();
  int overflow = 0;
  const long number = PyLong_AsLongAndOverflow(index.ptr(), &overflow);
  if (overflow != 0 || number > std::numeric_limits<int>::max() || number < std::numeric_limits<int>::min())
    refuse(std::string(name) + " is too large");
  option = int(number);
}

void Keywords::read(const char* name, double& option) {
  const py::object value = take(name);
  if (value.is_none()) return;
  if (py::isinstance<py::bool_>(value) || !PyNumber_Check(value.ptr()) || py::isinstance<py::array>(value))
    throw py::type_error(std::string(name) + " is a number; its type is " + type_of(value));
  option = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred()) throw py::error_already_set();
  if (!std::isfinite(option)) refuse(std::string(name) + " is NaN or infinite");
}

void Keywords::read(const char* name, bool& option) {
  const py::object value = take(name);
  if (value.is_none()) return;
  if (!py::isinstance<py::bool_>(value))
    throw py::type_error(std::string(name) + " is True or False; its type is " + type_of(value));
  option = value.cast<bool>();
}

std::string Keywords::take_text(const char* name) {
  const py::object value = take(name);
  if (value.is_none()) return {};
  if (!py::isinstance<py::str>(value))
    throw py::type_error(std::string(name) + " is a text; its type is " + type_of(value));
  const std::string text = value.cast<std::string>();
  if (text.empty()) refuse(std::string(name) + " is empty");
  return text;
}

void Keywords::end() const {
  for (const auto& item : m_left)
    throw py::type_error("there is no option " + std::string(py::str(item.first)));
}

void read_mending(Keywords& keywords, Mend_options& options) {
  keywords.read("fill_holes", options.fill_holes);
  keywords.read("weld", options.weld);
  keywords.read("cut_non_manifold_edges", options.cut_non_manifold_edges);
  keywords.read("smallest_diagonal", options.smallest_diagonal);
  keywords.read("smallest_part", options.smallest_part);
  keywords.read("fewest_triangles", options.fewest_triangles);
  if (options.fill_holes < 0) refuse("fill_holes is a number of edges, 0 for none");
  if (options.smallest_diagonal < 0 || options.smallest_part < 0 || options.smallest_part > 1 ||
      options.fewest_triangles < 0)
    refuse("the size below which components are dropped is negative, or a part above 1");
}

void read_engine(Keywords& keywords, Editor_options& options) {
  read_shared(keywords, options);
}

void read_finish(Keywords& keywords, Finish_options& options) {
  keywords.read("relax", options.relax);
  keywords.read("feature_angle", options.features.feature_angle);
  keywords.read("feature_lines", options.features.lines);
  keywords.read("adaptive", options.adaptive.ratio);
  keywords.read("adaptive_quads", options.adaptive.quads);
}

void read_hints(Keywords& keywords, Hint_options& options) {
  keywords.read("limbs", options.limbs);
  keywords.read("thin_charts", options.thin_charts);
  keywords.read("sharp_edges", options.sharp_edges);
  keywords.read("saddles", options.saddles);
  keywords.read("limb", options.limb);
  keywords.read("persistence", options.persistence);
  keywords.read("thin", options.thin);
  keywords.read("snap", options.snap);
  keywords.read("feature_angle", options.feature_angle);
  keywords.read("room", options.room);
}

void read_run(Keywords& keywords, Quadrangulation_options& options) {
  options.effort = Effort::normal; // as the program's
  read_shared(keywords, options);
  keywords.read("effort", options.effort,
                {{"fast", Effort::fast}, {"default", Effort::normal}, {"best", Effort::best}});
  keywords.read("extra_vertices", options.extra_vertices);
  keywords.read("budget", options.budget);
  keywords.read("dislocations", options.dislocations);
  keywords.read("persistence", options.suggestion.persistence);
  if (const py::object axis = keywords.take("axis"); !axis.is_none())
    options.suggestion.axis = point_from(axis, "axis");
  if (options.suggestion.axis.isZero()) refuse("axis has no direction");
  keywords.read("align", options.align);
  keywords.read("collapse_thin", options.collapse_thin);
  keywords.read("relax", options.relax);
  keywords.read("feature_angle", options.features.feature_angle);
  keywords.read("feature_lines", options.features.lines);
  options.keep_features = options.features.feature_angle > 0;
  keywords.read("adaptive", options.adaptive.ratio);
}

} // namespace python
} // namespace reebquad
