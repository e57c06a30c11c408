// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Editor.h>

#include "atlas/given_field.h"
#include "base/parallel_for.h"
#include "design/pole_texture.h"
#include "domain/open_fillings.h"
#include "edits/steps.h"
#include "mend/loops.h"

#include "surface/lazy_projector.h"
#include "surface/size_at.h"

#include <CGAL/Reeb_quadrangulation/prepare_surface.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// What became of charts, contours and counts between two designs.
Edit_report differences(const Design& from, const Design& to) {
  Edit_report report;
  std::map<int, const Design_chart*> before, after;
  for (const auto& chart : from.charts) before[chart->id] = chart.get();
  for (const auto& chart : to.charts) after[chart->id] = chart.get();
  for (const auto& [id, chart] : after) {
    const auto found = before.find(id);
    if (found == before.end())
      report.new_charts.push_back(id);
    else if (found->second != chart)
      report.remeshed_charts.push_back(id);
  }
  for (const auto& [id, chart] : before) {
    if (after.count(id)) continue;
    report.removed_charts.push_back(id);
    const int texture = chart->texture_id;
    const auto has_it = [&](const auto& entry) { return entry.second->texture_id == texture; };
    if (chart->edited && std::none_of(after.begin(), after.end(), has_it)) report.lost_textures.push_back(id);
  }
  const auto lives = [](const Design& d, std::size_t e) {
    return e < d.network.edges.size() && !d.network.is_removed(d.network.edges[e]);
  };
  for (std::size_t e = 0; e < std::max(from.network.edges.size(), to.network.edges.size()); ++e) {
    const bool was = lives(from, e), is = lives(to, e);
    if (is && !was) report.new_contours.push_back(int(e));
    if (was && !is) report.removed_contours.push_back(int(e));
    if (is && was && from.samples.counts[e] != to.samples.counts[e]) report.changed_counts.push_back(int(e));
  }
  return report;
}

// A design after an edit of a draft.
template <class Edit_kind> Result<Design> next_design(Draft& draft, const Edit_kind& edit) {
  if (Result<void> done = apply_edit(draft, edit); !done) return done.error();
  return complete_design(draft);
}
Result<Design> next_design(Draft& draft, const Edit_texture& edit) {
  return with_texture(draft, edit);
}
Result<Design> next_design(Draft& draft, const Drag_vertices& edit) {
  return with_texture(draft, edit);
}
Result<Design> next_design(Draft& draft, const Relax_texture& edit) {
  return with_texture(draft, edit);
}
Result<Design> next_design(Draft& draft, const Snap_vertices& edit) {
  return with_texture(draft, edit);
}
Result<Design> next_design(Draft& draft, const Fit_texture& edit) {
  return with_texture(draft, edit);
}

// A design, and its quads if they had to be stitched to see that they can be.
struct Changed {
  Design design;
  std::optional<Stitched_mesh> quads;
  int collapsed_charts = 0;
  double followed = 1;
  std::string remark;
};

// Whether charts are filled in a way that neighbours may not meet.
bool has_own_textures(const Texture_maker& maker) {
  return maker.levels || maker.annulus || maker.disc;
}

// A copy of a surface whose boundary loops are filled, or none if it is closed. Its vertices and faces come
// first.
Result<std::optional<Triangle_surface>> filled_copy(const Triangle_surface& surface) {
  const std::vector<std::vector<int>> loops = boundary_loops(surface);
  if (loops.empty()) return std::optional<Triangle_surface>();
  Mended_component component{surface, std::vector<int>(surface.points.size(), 0),
                             std::vector<int>(surface.triangles.size(), 0)};
  if (fill_holes(component, std::numeric_limits<int>::max()) != int(loops.size()) ||
      !component.surface.connect())
    return make_error(Error_code::not_a_surface,
                      "a boundary loop cannot be filled: it bounds a triangle alone");
  return std::optional<Triangle_surface>(std::move(component.surface));
}

// The values of a function with those of more vertices: each has the mean of its neighbours that have one.
std::vector<double> extended(std::vector<double> values, const Triangle_surface& surface) {
  std::vector<double> sum(surface.points.size(), 0), number(sum);
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const std::size_t v = std::size_t(surface.source(h)), w = std::size_t(surface.target(h));
    if (w >= values.size()) continue;
    sum[v] += values[w];
    ++number[v];
  }
  for (std::size_t v = values.size(); v < sum.size(); ++v) values.push_back(sum[v] / number[v]);
  return values;
}

bool has_whole_pole(const Design& design) {
  return std::any_of(design.extrema.begin(), design.extrema.end(),
                     [](const Design_extremum& e) { return e.pole == Pole_kind::whole; });
}

// How much shorter than in the mean edges shall be at each vertex of a surface near the projector's: so that
// as many quads of these sizes cover it as of the mean one.
std::vector<double> density_of(const Triangle_surface& surface, const Surface_projector& projector,
                               const std::vector<double>& sizes) {
  const internal::Size_at size(projector, sizes);
  std::vector<double> density;
  for (const Point& p : surface.points) density.push_back(1 / size(p));
  double whole = 0, quads = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const Triangle& t = surface.triangles[f];
    const double mean = (density[t[0]] + density[t[1]] + density[t[2]]) / 3, part = area(surface, f);
    whole += part;
    quads += mean * mean * part;
  }
  const double scale = quads > 0 ? std::sqrt(whole / quads) : 1;
  for (double& d : density) d *= scale;
  return density;
}

} // namespace

struct Editor::Implementation {
  Implementation(Triangle_surface surface, const Editor_options& editor_options)
      : input(std::move(surface)), options(editor_options) {}

  const Design& design() const { return *states[position]; }
  Result<Changed> changed(const Edit& edit, Observer* observer) const {
    if (design().charts.empty() && !std::holds_alternative<Suggest>(edit) &&
        !std::holds_alternative<Set_extrema>(edit) && !std::holds_alternative<Set_field>(edit))
      return refuse("the design is empty", "place extrema first");
    Draft draft(working, projector, solver, design(), options, observer);
    if (!density.empty()) draft.density = &density;
    if (const Set_field* given = std::get_if<Set_field>(&edit)) {
      Result<Designed_field> field = field_on_working_surface(*given);
      if (!field) return field.error();
      draft.given_field = std::move(*field);
    }
    Edit applied = edit;
    if (Set_target* target = std::get_if<Set_target>(&applied)) target->quads = with_fillings(target->quads);
    Result<Design> next = std::visit([&](const auto& e) { return next_design(draft, e); }, applied);
    if (!next) return next.error();
    const int collapsed = draft.collapsed_charts;
    const double followed = draft.followed;
    const std::string& remark = draft.remark;
    const bool may_fail =
        has_irregular_texture(*next) || has_whole_pole(*next) || has_own_textures(options.textures);
    if (!may_fail) return Changed{std::move(*next), {}, collapsed, followed, remark};
    Result<Stitched_mesh> stitched = stitch_design(working, projector, *next);
    if (!stitched) return stitched.error();
    if (has_whole_pole(*next) && !has_all_fans(*next, *stitched))
      return refuse("the ring around a whole pole is none that a fan could fill");
    return Changed{std::move(*next), std::move(*stitched), collapsed, followed, remark};
  }

  // A function on the input as it is on the working copy: its extrema are those of the input, though flips
  // and collapses may have made others between the new vertices.
  Result<Designed_field> field_on_working_surface(const Set_field& given) const {
    const bool fits = given.values.size() == input.points.size();
    Result<Designed_field> field = design_function(
        ground(), filled && fits ? extended(given.values, *filled) : given.values, given.persistence);
    if (!field || working_vertex.empty()) return field;
    const Surface_projector& on_ground = filled ? **filled_projector : *input_projector;
    return carried_field(ground(), on_ground, *field, working, working_vertex);
  }

  // What the working surface is a copy of.
  const Triangle_surface& ground() const { return filled ? *filled : input; }
  // As many quads more as there are in fillings.
  int with_fillings(int quads) const {
    return filled ? int(std::lround(quads * area(*filled) / area(input))) : quads;
  }
  void fill(Triangle_surface surface) {
    filled = std::move(surface);
    filled_projector.emplace(*filled);
  }

  Triangle_surface input, working;
  std::optional<Triangle_surface> filled; // if loops are filled; the input's faces come first
  std::optional<internal::Lazy_projector> filled_projector;
  std::vector<int> working_vertex; // of each vertex of the input; empty: both surfaces are the same
  Editor_options options;
  std::vector<double> density; // per vertex of the working copy, if there are sizes: see `density_of()`
  Prepare_report preparation;
  internal::Lazy_projector projector{working}, input_projector{input};
  mutable Surface_solver solver{working, options};
  std::vector<std::shared_ptr<const Design>> states;
  std::vector<Edit> edits; // edit i leads from state i to state i + 1
  int position = 0;
  std::shared_ptr<const Design> stitched_design; // whose quads the last edit had to stitch, or null
  Stitched_mesh stitched_quads;
};

Editor::Editor(std::unique_ptr<Implementation> implementation)
    : m_implementation(std::move(implementation)) {}
Editor::~Editor() = default;
Editor::Editor(Editor&&) noexcept = default;
Editor& Editor::operator=(Editor&&) noexcept = default;

Result<Editor> Editor::create(Triangle_surface surface, const Editor_options& options, Observer* observer) {
  if (surface.number_of_faces() == 0)
    return make_error(Error_code::not_a_surface, "the surface has no faces");
  if (connected_components(surface).second != 1)
    return make_error(Error_code::not_a_surface, "the surface has several components: edit them one by one");
  if (!(options.edge_length >= 0) || !std::isfinite(options.edge_length) ||
      (options.edge_length == 0 && options.quads < 1))
    return make_error(Error_code::impossible_request,
                      "the number of quads or the edge length must be positive");
  if (!options.sizes.empty())
    if (Result<void> fine = internal::check_sizes(surface, options.sizes); !fine) return fine.error();
  auto editor = std::make_unique<Implementation>(std::move(surface), options);
  const double h =
      options.edge_length > 0 ? options.edge_length : std::sqrt(area(editor->input) / options.quads);
  if (options.boundaries == Boundaries::fill) {
    Result<std::optional<Triangle_surface>> filled = filled_copy(editor->input);
    if (!filled) return filled.error();
    if (*filled) editor->fill(std::move(**filled));
  }
  if (options.prepare) {
    if (observer) observer->progress("prepare", 0);
    Prepare_options prepare;
    prepare.max_edge = h;
    prepare.min_edge = 1e-3 * h;
    Result<Prepared_surface> prepared = prepare_surface(editor->ground(), prepare, observer);
    if (!prepared) return prepared.error();
    editor->working = std::move(prepared->surface);
    editor->working_vertex = std::move(prepared->working_vertex);
    editor->preparation = prepared->report;
  } else {
    editor->working = editor->ground();
  }
  if (!options.sizes.empty())
    editor->density = density_of(editor->working, *editor->input_projector, options.sizes);
  Design first;
  first.network.surface_vertices = editor->working.number_of_vertices();
  first.target_quads = options.edge_length > 0 ? 0 : editor->with_fillings(options.quads);
  first.edge_length = h;
  editor->states.push_back(std::make_shared<const Design>(std::move(first)));
  return Editor(std::move(editor));
}

Result<Edit_report> Editor::apply(const Edit& edit, Observer* observer) {
  Implementation& m = *m_implementation;
  const auto begin = std::chrono::steady_clock::now();
  Result<Changed> changed = m.changed(edit, observer);
  if (!changed) return changed.error();
  const auto state = std::make_shared<const Design>(std::move(changed->design));
  Edit_report report = differences(m.design(), *state);
  report.collapsed_charts = changed->collapsed_charts;
  report.followed = changed->followed;
  report.remark = std::move(changed->remark);
  m.states.resize(m.position + 1);
  m.edits.resize(m.position);
  m.states.push_back(state);
  m.edits.push_back(edit);
  m.stitched_design = changed->quads ? state : nullptr;
  m.stitched_quads = changed->quads ? std::move(*changed->quads) : Stitched_mesh();
  ++m.position;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

Result<Design> Editor::preview(const Edit& edit, Observer* observer) const {
  Result<Changed> changed = m_implementation->changed(edit, observer);
  if (!changed) return changed.error();
  return std::move(changed->design);
}

bool Editor::can_undo() const {
  return m_implementation->position > 0;
}

bool Editor::can_redo() const {
  return m_implementation->position + 1 < int(m_implementation->states.size());
}

Edit_report Editor::undo() {
  CGAL_precondition(can_undo());
  Implementation& m = *m_implementation;
  --m.position;
  return differences(*m.states[m.position + 1], *m.states[m.position]);
}

Edit_report Editor::redo() {
  CGAL_precondition(can_redo());
  Implementation& m = *m_implementation;
  ++m.position;
  return differences(*m.states[m.position - 1], *m.states[m.position]);
}

void Editor::forget_undone() {
  Implementation& m = *m_implementation;
  m.states.resize(std::size_t(m.position) + 1);
  m.edits.resize(std::size_t(m.position));
}

const std::vector<Edit>& Editor::edits() const {
  return m_implementation->edits;
}

int Editor::position() const {
  return m_implementation->position;
}

const Design& Editor::design() const {
  return m_implementation->design();
}

const Triangle_surface& Editor::input() const {
  return m_implementation->input;
}

const Triangle_surface& Editor::working_surface() const {
  return m_implementation->working;
}

const Editor_options& Editor::options() const {
  return m_implementation->options;
}

const Prepare_report& Editor::preparation() const {
  return m_implementation->preparation;
}

int Editor::chart_at(const Surface_point& point) const {
  const Implementation& m = *m_implementation;
  return Draft(m.working, m.projector, m.solver, m.design(), m.options, nullptr).chart_at(point);
}

Stitched_mesh Editor::quads() const {
  const Design& d = design();
  if (d.charts.empty()) return {};
  if (m_implementation->stitched_design.get() == &d) return m_implementation->stitched_quads;
  Result<Stitched_mesh> stitched = stitch_design(working_surface(), m_implementation->projector, d);
  CGAL_assertion(bool(stitched)); // else the edit would have been refused
  return std::move(*stitched);
}

Result<Stitched_mesh> Editor::open_quads() const {
  const Implementation& m = *m_implementation;
  Stitched_mesh stitched = quads();
  if (!m.filled || stitched.mesh.quads.empty()) return stitched;
  if (has_whole_pole(m.design()))
    return refuse("a whole pole", "where boundary loops are filled there is none");
  return internal::open_fillings(stitched, **m.filled_projector, m.input);
}

Result<Finished_design> Editor::finished_quads(const Finish_options& options, Observer* observer) const {
  if (observer) observer->progress("stitching", 0);
  Result<Stitched_mesh> stitched = open_quads();
  if (!stitched) return stitched.error();
  if (stitched->mesh.quads.empty()) return refuse("the design is empty", "place extrema first");
  Finish_options with_threads = options;
  with_threads.relaxation.threads = internal::number_of_threads(m_implementation->options.threads);
  if (!with_threads.adaptive.size && with_threads.adaptive.sizes.empty())
    with_threads.adaptive.sizes = m_implementation->options.sizes;
  return finish_design(std::move(*stitched), *m_implementation->input_projector, with_threads, observer);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
