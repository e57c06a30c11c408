// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mirror_output.h"
#include "Session.h"
#include "arrays.h"
#include "bind.h"
#include "options.h"
#include "run.h"

#include <pybind11/stl.h>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// Minima or maxima: an integer array of vertices, or points of shape (k, 3).
void read_extrema(Keywords& keywords, const Polygon_soup& soup, const char* name, bool is_maximum,
                  std::vector<Placed_extremum>& extrema) {
  const py::object given = keywords.take(name);
  if (given.is_none()) return;
  const py::array array = py::array::ensure(given);
  if (!array) throw py::type_error(std::string(name) + " are vertices or points");
  if (array.ndim() == 1) {
    for (const int v : indices_from(given, name, 1, soup.number_of_points()))
      extrema.push_back({soup.points[std::size_t(v)], is_maximum});
  } else {
    for (const Point& point : points_from(given, name)) extrema.push_back({point, is_maximum});
  }
}

void read_features(Keywords& keywords, const Polygon_soup& soup, Request& request) {
  if (const py::object edges = keywords.take("features"); !edges.is_none()) {
    const std::vector<int> ends = indices_from(edges, "the features", 2, soup.number_of_points());
    for (std::size_t i = 0; i < ends.size(); i += 2) request.feature_edges.push_back({ends[i], ends[i + 1]});
  }
  if (const py::object points = keywords.take("feature_points"); !points.is_none())
    request.feature_points = indices_from(points, "the features' points", 1, soup.number_of_points());
}

void read_sizes(Keywords& keywords, const Polygon_soup& soup, Request& request) {
  const py::object sizes = keywords.take("sizes");
  if (sizes.is_none()) return;
  if (!keywords.peek("quads").is_none() || !keywords.peek("edge_length").is_none())
    refuse("sizes exclude quads and edge_length");
  request.sizes = numbers_from(sizes, "the sizes");
  if (request.sizes.size() != soup.points.size())
    refuse("there is one size a vertex; got " + std::to_string(request.sizes.size()) + " for " +
           std::to_string(soup.points.size()) + " vertices");
  for (std::size_t v = 0; v < request.sizes.size(); ++v)
    if (!(request.sizes[v] > 0))
      refuse("the size at vertex " + std::to_string(v) + " is not positive", Element_kind::vertex,
             std::int64_t(v));
}

/// The plane is written as the program's `--mirror` is.
void read_mirror(Keywords& keywords, Quadrangulation_options& options) {
  const std::string plane = keywords.take_text("mirror");
  Mirror_request asked;
  keywords.read("mirror_positions", asked.positions,
                {{"exact", Mirror_positions::exact}, {"projected", Mirror_positions::projected}});
  keywords.read("mirror_tolerance", asked.tolerance);
  if (!(asked.tolerance >= 0 && asked.tolerance <= 1)) refuse("mirror_tolerance lies between 0 and 1");
  if (plane.empty()) return;
  try {
    options.mirror = mirror_request(plane);
  } catch (const Failure&) {
    refuse("mirror is auto, x, y, z, -x, -y, -z, none, or a point and a normal as 0,0,0,1,0,0; it got '" +
           plane + "'");
  }
  if (!options.mirror) return;
  options.mirror->positions = asked.positions;
  options.mirror->tolerance = asked.tolerance;
}

Request read_request(const py::dict& given, const Polygon_soup& soup) {
  Keywords keywords(given);
  Request request;
  read_sizes(keywords, soup, request);
  read_features(keywords, soup, request);
  Run_options& options = request.options;
  read_extrema(keywords, soup, "minima", false, options.pipeline.extrema);
  read_extrema(keywords, soup, "maxima", true, options.pipeline.extrema);
  read_mirror(keywords, options.pipeline);
  read_mending(keywords, options.mending);
  read_run(keywords, options.pipeline);
  keywords.read("component", options.component);
  if (options.component < 0) refuse("component counts from 1; 0 takes all");
  keywords.read("all_or_nothing", options.all_or_nothing);
  keywords.read("certify", request.certify);
  keywords.read("validate", options.validate);
  keywords.read("strict", options.strict);
  if (!request.certify && (options.validate || options.strict))
    refuse("validate and strict need the certificate");
  keywords.end();
  return request;
}

py::object uv_array(const std::vector<std::array<double, 8>>& uv, std::size_t quads) {
  if (uv.size() != quads) return py::none();
  py::array_t<double> array({py::ssize_t(quads), py::ssize_t(4), py::ssize_t(2)});
  std::copy_n(uv.empty() ? nullptr : uv[0].data(), 8 * quads, array.mutable_data());
  return std::move(array);
}

/// The sessions of the components that were meshed, and their recipes.
void add_editors(Outcome& outcome, const Request& request, py::dict& out) {
  py::list editors, recipes;
  Run& run = outcome.run;
  for (std::size_t c = 0; c < run.components.size(); ++c) {
    Component_run& component = run.components[c];
    if (!component.result) continue;
    Recipe recipe = component.result->recipe;
    recipe.component = outcome.component_number[c];
    recipe.fill_holes = request.options.mending.fill_holes;
    recipes.append(to_json(recipe));
    const Triangle_surface whole = recipe.mirror ? component.surface : Triangle_surface();
    editors.append(std::make_shared<Session>(std::move(component.result->editor), std::move(recipe), whole));
  }
  out["editors"] = editors;
  out["recipes"] = recipes;
}

py::dict dictionary(Outcome outcome, const Request& request) {
  Run& run = outcome.run;
  py::dict out;
  out["vertices"] = to_array(run.quads.points);
  out["quads"] = to_array(run.quads.quads);
  out["component"] = to_array(outcome.component_of_quad);
  out["chart"] = to_array(outcome.chart_of_quad);
  out["uv"] = uv_array(outcome.uv, run.quads.quads.size());
  out["source_face"] = to_array(outcome.places.face);
  out["source_vertices"] = to_array(outcome.places.points);
  out["barycentrics"] = to_array(outcome.places.weights);
  out["certificate"] = run.certificate ? py::object(py::str(to_json(*run.certificate))) : py::none();
  out["certified"] = !run.certificate || run.status != Exit_code::certificate_failed;
  out["report"] = report_json(run, request.options);
  out["warnings"] = outcome.warnings;
  add_editors(outcome, request, out);
  return out;
}

py::dict quadrangulate_arrays(const py::object& vertices, const py::object& faces, const py::dict& given,
                              const py::object& progress) {
  const Polygon_soup soup = soup_from(vertices, faces);
  const Request request = read_request(given, soup);
  Python_observer observer(progress);
  return dictionary(without_lock(observer, [&] { return run(soup, request, observer); }), request);
}

} // namespace

void bind_quadrangulate(py::module_& module) {
  module.def("quadrangulate", &quadrangulate_arrays, py::arg("vertices"), py::arg("faces"),
             py::arg("options"), py::arg("progress"));
}

} // namespace python
} // namespace reebquad
