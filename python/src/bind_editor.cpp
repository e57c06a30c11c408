// SPDX-License-Identifier: GPL-3.0-or-later
#include "Python_observer.h"
#include "Session.h"
#include "arrays.h"
#include "bind.h"
#include "options.h"

#include "automatic/components.h"
#include "base/parallel_for.h"
#include <CGAL/Reeb_quadrangulation/IO/hints.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/halve_surface.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/mirror_quads.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

using Session_pointer = std::shared_ptr<Session>;

/// The component of the recipe's number, counted from 1; 0: the only one.
Result<Triangle_surface> surface_of(const Polygon_soup& soup, const Recipe& recipe,
                                    const Mend_options& mending) {
  Mend_options options = mending;
  options.fill_holes = recipe.fill_holes;
  Result<Mended_surface> mended = mend_surface(soup, options);
  if (!mended) return mended.error();
  const int component = recipe.component, number = int(mended->components.size());
  if (component == 0 && number != 1)
    return make_error(Error_code::not_a_surface, "an editor is for one connected surface, this mesh has " +
                                                     std::to_string(number) + "; component says which");
  if (Result<void> left = internal::leave_component(*mended, std::max(component, 1), "mesh"); !left)
    return left.error();
  return std::move(mended->components[0].surface);
}

/// An editor, and with a mirror the surface that it works on a half of.
struct Opened {
  Editor editor;
  Triangle_surface whole;
};

Result<Opened> open(const Polygon_soup& soup, const Recipe& recipe, const Mend_options& mending,
                    Observer& observer) {
  Result<Triangle_surface> surface = surface_of(soup, recipe, mending);
  if (!surface) return surface.error();
  Triangle_surface whole;
  if (recipe.mirror) {
    Result<Surface_half> half = halve_surface(*surface, recipe.mirror->plane);
    if (!half) return half.error();
    whole = std::move(*surface);
    *surface = std::move(half->surface);
  }
  Result<Editor> editor = Editor::create(std::move(*surface), recipe.options, &observer);
  if (!editor) return editor.error();
  return Opened{std::move(*editor), std::move(whole)};
}

/// Applies edits one by one; the error of the first that does not apply says which it is.
Result<void> apply_all(Editor& editor, const std::vector<Edit>& edits, Observer& observer) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Result<Edit_report> done = editor.apply(edits[i], &observer);
    if (done) continue;
    Error error = done.error();
    if (error.code != Error_code::cancelled)
      error.message =
          "edit " + std::to_string(i + 1) + " (" + name(edits[i]) + ") does not apply: " + error.message;
    return error;
  }
  return {};
}

Result<Opened> replayed(const Polygon_soup& soup, const Recipe& recipe, Observer& observer) {
  Result<Opened> opened = open(soup, recipe, {}, observer);
  if (!opened) return opened;
  if (Result<void> applied = apply_all(opened->editor, recipe.edits, observer); !applied)
    return applied.error();
  return opened;
}

Session_pointer open_session(const py::object& vertices, const py::object& faces, const py::dict& given,
                             const py::object& progress) {
  const Polygon_soup soup = soup_from(vertices, faces);
  Keywords keywords(given);
  Recipe recipe;
  Mend_options mending;
  read_mending(keywords, mending);
  read_engine(keywords, recipe.options);
  keywords.read("component", recipe.component);
  if (recipe.component < 0) refuse("component counts from 1; 0 is the only one");
  keywords.end();
  recipe.fill_holes = mending.fill_holes;
  Python_observer observer(progress);
  Opened opened = without_lock(observer, [&] { return open(soup, recipe, mending, observer); });
  return std::make_shared<Session>(std::move(opened.editor), std::move(recipe));
}

Session_pointer replay_session(const py::object& vertices, const py::object& faces, const std::string& text,
                               int threads, const py::object& progress) {
  const Polygon_soup soup = soup_from(vertices, faces);
  Recipe recipe = value_of(recipe_from_json(text));
  recipe.options.threads = threads;
  Python_observer observer(progress);
  Opened opened = without_lock(observer, [&] { return replayed(soup, recipe, observer); });
  return std::make_shared<Session>(std::move(opened.editor), std::move(recipe), std::move(opened.whole));
}

py::dict dictionary(const Edit_report& report) {
  py::dict out;
  out["new_charts"] = report.new_charts;
  out["removed_charts"] = report.removed_charts;
  out["remeshed_charts"] = report.remeshed_charts;
  out["lost_textures"] = report.lost_textures;
  out["new_contours"] = report.new_contours;
  out["removed_contours"] = report.removed_contours;
  out["changed_counts"] = report.changed_counts;
  out["collapsed_charts"] = report.collapsed_charts;
  out["followed"] = report.followed;
  out["seconds"] = report.seconds;
  return out;
}

py::dict apply(Session& session, const std::string& text, const py::object& progress) {
  const Edit edit = value_of(edit_from_json(text));
  Session::Hold hold(session);
  Python_observer observer(progress);
  return dictionary(without_lock(observer, [&] { return hold.editor().apply(edit, &observer); }));
}

py::dict undo(Session& session) {
  Session::Hold hold(session);
  if (!hold.editor().can_undo()) refuse("there is nothing to undo");
  return dictionary(hold.editor().undo());
}

py::dict redo(Session& session) {
  Session::Hold hold(session);
  if (!hold.editor().can_redo()) refuse("there is nothing to redo");
  return dictionary(hold.editor().redo());
}

std::string recipe_text(Session& session) {
  Session::Hold hold(session);
  Recipe recipe = recipe_of(hold.editor());
  recipe.component = hold.recipe().component;
  recipe.fill_holes = hold.recipe().fill_holes;
  recipe.mirror = hold.recipe().mirror;
  recipe.finish = hold.recipe().finish;
  return to_json(recipe);
}

std::vector<std::string> edit_texts(Session& session) {
  Session::Hold hold(session);
  std::vector<std::string> texts;
  for (const Edit& edit : hold.editor().edits()) texts.push_back(to_json(edit));
  return texts;
}

Hint_options hint_options(const py::dict& given) {
  Keywords keywords(given);
  Hint_options options;
  read_hints(keywords, options);
  keywords.end();
  return options;
}

std::string hints(Session& session, const py::dict& given, const py::object& progress) {
  const Hint_options options = hint_options(given);
  Session::Hold hold(session);
  Python_observer observer(progress);
  return to_json(without_lock(observer, [&] { return suggest_edits(hold.editor(), options, &observer); }));
}

std::string take_hints(Session& session, const py::dict& given, const py::object& progress) {
  const Hint_options options = hint_options(given);
  Session::Hold hold(session);
  Python_observer observer(progress);
  return to_json(without_lock(observer, [&] { return apply_hints(hold.editor(), options, &observer); }));
}

/// The quads of a design with what is told of them.
struct Made_quads {
  Stitched_mesh quads;
  Polygon_soup polygons; ///< with the fans of whole poles
  Certificate certificate;
  Mesh_statistics statistics;
};

/// The quads of both sides of a mirror, and the fans.
Result<Stitched_mesh> doubled(Session::Hold& hold, Finished_design design, Finish_options finish,
                              std::vector<Pole_fan>& fans, Observer& observer) {
  const Mirror& mirror = *hold.recipe().mirror;
  const Result<Surface_half> half = halve_surface(hold.whole(), mirror.plane);
  if (!half) return half.error();
  finish.relaxation.threads =
      CGAL::Reeb_quadrangulation::internal::number_of_threads(hold.editor().options().threads);
  const Surface_projector whole(hold.whole());
  Result<Mirrored_design> both =
      mirror_design(std::move(design), *half, whole, mirror.positions, finish, &observer);
  if (!both) return both.error();
  fans = with_mirrored_fans(std::move(fans), both->image, half->plane);
  return std::move(both->whole.quads);
}

/// Stitched only, or finished.
Result<Finished_design> design_quads(const Editor& editor, const Finish_options* finish, Observer& observer) {
  if (finish) return editor.finished_quads(*finish, &observer);
  if (editor.design().charts.empty())
    return make_error(Error_code::refused_edit, "the design has no charts yet; place extrema first");
  Finished_design design;
  design.quads = editor.quads();
  return design;
}

Result<Made_quads> make_quads(Session::Hold& hold, const Finish_options* finish, Observer& observer) {
  const Editor& editor = hold.editor();
  Result<Finished_design> design = design_quads(editor, finish, observer);
  if (!design) return design.error();
  Made_quads made;
  std::vector<Pole_fan> fans = pole_fans(editor.design(), design->quads);
  const bool is_mirrored = hold.recipe().mirror.has_value();
  if (is_mirrored) {
    Finish_options unmoved;
    unmoved.relax = false;
    Result<Stitched_mesh> both =
        doubled(hold, std::move(*design), finish ? *finish : unmoved, fans, observer);
    if (!both) return both.error();
    made.quads = std::move(*both);
  } else {
    made.quads = std::move(design->quads);
  }
  const Triangle_surface& input = is_mirrored ? hold.whole() : editor.input();
  made.polygons = with_fans(made.quads.mesh, fans);
  const Stitched_mesh closed = with_paired_fans(made.quads, fans);
  Certificate_options options;
  options.observer = &observer;
  made.certificate = certify({closed.mesh, &input, closed.valences, closed.components}, options);
  made.statistics = quad_statistics(made.quads.mesh, &input);
  if (observer.cancelled()) return make_error(Error_code::cancelled, "cancelled");
  return made;
}

/// The triangles behind the quads.
std::vector<Triangle> fan_triangles(const Polygon_soup& polygons, std::size_t quads) {
  std::vector<Triangle> triangles;
  for (int p = int(quads); p < polygons.number_of_polygons(); ++p) {
    const int* corner = polygons.corner.data() + polygons.begin[std::size_t(p)];
    triangles.push_back({corner[0], corner[1], corner[2]});
  }
  return triangles;
}

py::dict quads(Session& session, bool finish, const py::dict& given, const py::object& progress) {
  Session::Hold hold(session);
  Finish_options options = hold.recipe().finish;
  Keywords keywords(given);
  read_finish(keywords, options);
  keywords.end();
  Python_observer observer(progress);
  const Made_quads made =
      without_lock(observer, [&] { return make_quads(hold, finish ? &options : nullptr, observer); });
  if (finish) hold.recipe().finish = options;
  py::dict out;
  out["vertices"] = to_array(made.polygons.points);
  out["quads"] = to_array(made.quads.mesh.quads);
  out["triangles"] = to_array(fan_triangles(made.polygons, made.quads.mesh.quads.size()));
  out["chart"] = to_array(made.quads.chart_of_quad);
  out["certificate"] = to_json(made.certificate);
  out["certified"] = made.certificate.passed;
  out["statistics"] = to_json(made.statistics);
  return out;
}

py::list extrema(const Editor& editor) {
  py::list list;
  for (const Design_extremum& e : editor.design().extrema) {
    const Point& p = editor.working_surface().points[std::size_t(e.vertex)];
    py::dict out;
    out["point"] = py::make_tuple(p.x(), p.y(), p.z());
    out["maximum"] = e.is_maximum;
    out["value"] = e.value;
    out["pole"] = name(e.pole);
    list.append(out);
  }
  return list;
}

py::list charts(const Design& design) {
  py::list list;
  for (const auto& chart : design.charts) {
    py::dict out;
    out["id"] = chart->id;
    out["kind"] = chart->chart->kind == Chart_kind::disc ? "disc" : "annulus";
    out["columns"] = chart->grid[0];
    out["rows"] = chart->grid[1];
    out["height"] = chart->height;
    out["edited"] = chart->edited;
    out["locked"] = chart->settings.locked;
    list.append(out);
  }
  return list;
}

py::dict design(Session& session) {
  Session::Hold hold(session);
  const Design& design = hold.editor().design();
  py::dict out;
  out["extrema"] = extrema(hold.editor());
  out["charts"] = charts(design);
  out["edge_length"] = design.edge_length;
  out["quads"] = design.counts.quads;
  out["target_met"] = design.counts.target_met;
  return out;
}

py::object chart_at(Session& session, const py::object& point) {
  const Point at = point_from(point, "a point");
  Session::Hold hold(session);
  const int chart = hold.editor().chart_at({at, -1});
  if (chart < 0) return py::none();
  return py::int_(hold.editor().design().charts[std::size_t(chart)]->id);
}

py::tuple working_surface(Session& session) {
  Session::Hold hold(session);
  const Triangle_surface& surface = hold.editor().working_surface();
  return py::make_tuple(to_array(surface.points), to_array(surface.triangles));
}

} // namespace

void bind_editor(py::module_& module) {
  py::class_<Session, Session_pointer>(module, "Session")
      .def("apply", &apply, py::arg("edit"), py::arg("progress"))
      .def("undo", &undo)
      .def("redo", &redo)
      .def("can_undo", [](Session& session) { return Session::Hold(session).editor().can_undo(); })
      .def("can_redo", [](Session& session) { return Session::Hold(session).editor().can_redo(); })
      .def("position", [](Session& session) { return Session::Hold(session).editor().position(); })
      .def("edits", &edit_texts)
      .def("recipe", &recipe_text)
      .def("hints", &hints, py::arg("options"), py::arg("progress"))
      .def("take_hints", &take_hints, py::arg("options"), py::arg("progress"))
      .def("quads", &quads, py::arg("finish"), py::arg("options"), py::arg("progress"))
      .def("design", &design)
      .def("chart_at", &chart_at, py::arg("point"))
      .def("working_surface", &working_surface);
  module.def("open_session", &open_session, py::arg("vertices"), py::arg("faces"), py::arg("options"),
             py::arg("progress"));
  module.def("replay_session", &replay_session, py::arg("vertices"), py::arg("faces"), py::arg("recipe"),
             py::arg("threads"), py::arg("progress"));
}

} // namespace python
} // namespace reebquad
