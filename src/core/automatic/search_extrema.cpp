// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/search_extrema.h>

#include "automatic/coarse_copy.h"
#include "automatic/search_limit.h"
#include "design/draft.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// An energy that falls by less is not worth a change: it is within what the coarse copy leaves uncertain.
constexpr double worth_it = 0.003;

// A place nearer to the quads, in edges, gets no extremum of its own.
constexpr double far_enough = 1;

// Where an extremum was tried, none is tried again within so many edges.
constexpr double tried_within = 3;

// How far a new extremum goes from the field's value there to the end of its range.
constexpr double strength = 0.9;

// Samples for each quad that is asked for, so that hardly one escapes.
constexpr double samples_per_quad = 1.5;

// Places that get an extremum tried before signs are: what one kind of change spoils the other may mend.
constexpr int places_at_a_time = 3;

// Of suggestions that the search may begin with, relative to that of the first.
constexpr double persistences[] = {1, 0.5, 2};

// Passes on the question whether to stop, but not the progress of the parts.
class Only_cancels : public Observer {
public:
  explicit Only_cancels(Observer* observer) : m_observer(observer) {}
  bool cancelled() const override { return m_observer && m_observer->cancelled(); }

private:
  Observer* m_observer;
};

class Search {
public:
  Search(const Editor& editor, const Search_options& options, Observer* observer)
      : m_editor(editor), m_options(options), m_observer(observer), m_silent(observer),
        m_surface(editor.working_surface()), m_projector(m_surface), m_lazy(m_surface), m_limit(options) {
    const double quads = editor.options().edge_length > 0
                             ? area(m_surface) / (editor.options().edge_length * editor.options().edge_length)
                             : editor.options().quads;
    m_samples = sample_surface(m_surface, int(std::min(2e5, samples_per_quad * quads + 1000)));
  }

  Result<Searched_extrema> run(const Edit& first) {
    Result<Tried> start = try_edit(first);
    if (!start) return start.error();
    m_best = std::move(*start);
    m_found.first_energy = m_best.energy;
    m_most_vertices =
        m_options.extra_vertices < 0 ? -1 : m_best.parts.extraordinary + m_options.extra_vertices;
    const auto remember = [&](const auto& edit) {
      m_edit.collapse_thin = edit.collapse_thin;
      m_edit.axis = edit.axis;
      m_edit.boundary = edit.boundary;
    };
    if (const auto* suggested = std::get_if<Suggest>(&first)) {
      remember(*suggested);
      if (Result<void> begun = begin(*suggested); !begun) return begun.error();
    } else {
      remember(std::get<Set_extrema>(first));
    }
    for (const Design_extremum& e : m_best.design.extrema)
      m_edit.extrema.push_back({{m_surface.points[e.vertex], e.vertex}, e.is_maximum, e.value});
    for (bool again = true; again && tries_left();) {
      again = false;
      for (const auto step : {&Search::add, &Search::change_signs, &Search::remove}) {
        Result<bool> helped = (this->*step)();
        if (!helped) return helped.error();
        again = again || *helped;
      }
    }
    m_found.edit = m_edit;
    m_found.energy = m_best.energy;
    m_found.tries = m_tries;
    return m_found;
  }

private:
  struct Tried {
    Design design;
    Design_energy parts;
    double energy = 0;
    std::vector<Far_sample> far;
  };

  // Single changes do not lead from one suggestion to another: the search begins with the best of some.
  Result<void> begin(const Suggest& suggested) {
    const Point up = suggested.axis.normalized(), side = up.unitOrthogonal();
    for (const Point& axis : {up, side, Point(up.cross(side))})
      for (const double factor : persistences) {
        if ((axis == up && factor == 1) || !tries_left()) continue;
        Suggest other = suggested;
        other.axis = axis;
        other.persistence = std::min(1.0, factor * suggested.persistence);
        Result<std::optional<Tried>> tried = attempt(other, better());
        if (!tried) return tried.error();
        if (!*tried) continue;
        std::ostringstream what;
        what.precision(3);
        what << "suggested anew with the persistence " << other.persistence << " and the axis ("
             << axis.transpose() << ")";
        take(std::move(**tried), m_edit, what.str());
        m_edit.axis = axis; // which also says what boundary loops are
      }
    return {};
  }

  bool tries_left() const { return !m_limit.is_reached(m_tries); }
  double edge() const {
    return std::sqrt(m_samples.area / double(std::max<std::int64_t>(1, m_best.design.counts.quads)));
  }

  // Of a design whose energy is above `most`, the energy may be told as anything above it.
  Result<Tried> try_edit(const Edit& edit, double most = std::numeric_limits<double>::infinity()) {
    if (m_observer) m_observer->progress("search", m_limit.done(m_tries));
    ++m_tries;
    Result<Design> design = m_editor.preview(edit, &m_silent);
    if (!design) return design.error();
    Result<Stitched_mesh> quads = stitch_design(m_surface, m_lazy, *design);
    if (!quads) return quads.error();
    Tried tried;
    const Energy_bound bound{m_options.weights, most};
    tried.parts = design_energy(std::move(*quads), m_projector, m_samples, &tried.far,
                                m_options.tried ? nullptr : &bound);
    if (m_options.tried) m_options.tried(edit, tried.parts);
    tried.energy = tried.parts.total(m_options.weights);
    tried.design = std::move(*design);
    return tried;
  }

  // Nothing if the edit cannot be made, has too many extraordinary vertices or an energy above `most`; an
  // error if the search is to stop.
  Result<std::optional<Tried>> attempt(const Edit& edit, double most) {
    Result<Tried> tried = try_edit(edit, most);
    if (!tried && tried.error().code == Error_code::cancelled) return tried.error();
    if (!tried || tried->energy > most ||
        (m_most_vertices >= 0 && tried->parts.extraordinary > m_most_vertices))
      return std::optional<Tried>();
    return std::optional<Tried>(std::move(*tried));
  }

  // The energy from which on a design is worth a change.
  double better() const { return m_best.energy - worth_it; }

  void take(Tried tried, Set_extrema edit, const std::string& what) {
    std::ostringstream reason;
    reason.precision(3);
    reason << what << ": the farthest place comes from " << m_best.parts.farthest << " to "
           << tried.parts.farthest << " edges, the mean scaled Jacobian from " << 1 - m_best.parts.angle
           << " to " << 1 - tried.parts.angle << ", extraordinary vertices from "
           << m_best.parts.extraordinary << " to " << tried.parts.extraordinary;
    m_best = std::move(tried);
    m_edit = std::move(edit);
    m_found.steps.push_back({reason.str(), m_best.energy});
  }

  static std::string at(const Point& p) {
    std::ostringstream text;
    text.precision(4);
    text << " at (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
    return text.str();
  }

  // The inner vertex of a face, nearest to a point in it, or -1.
  int vertex_at(const Far_sample& place) const {
    int best = -1;
    for (int v : m_surface.triangles[place.face])
      if (!m_surface.is_boundary(m_surface.outgoing[v]) &&
          (best < 0 || (m_surface.points[v] - place.point).squaredNorm() <
                           (m_surface.points[best] - place.point).squaredNorm()))
        best = v;
    return best;
  }

  bool was_tried(const Point& p) const {
    return std::any_of(m_places.begin(), m_places.end(),
                       [&](const Point& q) { return (p - q).norm() < tried_within * edge(); });
  }

  // The farthest places get a minimum or a maximum, whichever is better.
  Result<bool> add() {
    bool helped = false;
    int places = 0;
    for (std::size_t i = 0; i < m_best.far.size() && places < places_at_a_time && tries_left();) {
      const Far_sample place = m_best.far[i++];
      const int vertex = vertex_at(place);
      if (place.distance < far_enough || vertex < 0 || was_tried(place.point)) continue;
      m_places.push_back(place.point);
      ++places;
      Result<bool> added = add_at(vertex, place.distance);
      if (!added) return added;
      if (!*added) continue;
      helped = true;
      i = 0;
    }
    return helped || places == places_at_a_time; // there may be more of them
  }

  Result<bool> add_at(int vertex, double distance) {
    std::optional<Tried> best;
    Set_extrema best_edit;
    const double value = m_best.design.field->values[std::size_t(vertex)];
    for (const bool is_maximum : {true, false}) {
      Set_extrema edit = m_edit;
      const double to = is_maximum ? value + strength * (1 - value) : (1 - strength) * value;
      edit.extrema.push_back({{m_surface.points[vertex], vertex}, is_maximum, std::clamp(to, 0.0, 1.0)});
      Result<std::optional<Tried>> tried = attempt(edit, better());
      if (!tried) return tried.error();
      if (!*tried || (best && (*tried)->energy >= best->energy)) continue;
      best = std::move(**tried);
      best_edit = std::move(edit);
    }
    if (!best) return false;
    std::ostringstream what;
    what.precision(3);
    what << (best_edit.extrema.back().is_maximum ? "a maximum" : "a minimum") << at(m_surface.points[vertex])
         << ", " << distance << " edges away from the quads";
    take(std::move(*best), std::move(best_edit), what.str());
    return true;
  }

  bool is_last_of_its_kind(std::size_t i) const {
    const bool kind = m_edit.extrema[i].is_maximum;
    return std::count_if(m_edit.extrema.begin(), m_edit.extrema.end(),
                         [&](const Set_extrema::Extremum& e) { return e.is_maximum == kind; }) < 2;
  }

  Result<bool> change_signs() {
    bool helped = false;
    for (std::size_t i = 0; i < m_edit.extrema.size() && tries_left(); ++i) {
      if (is_last_of_its_kind(i)) continue;
      Set_extrema edit = m_edit;
      edit.extrema[i].is_maximum = !edit.extrema[i].is_maximum;
      edit.extrema[i].value = -1;
      const std::string what = (edit.extrema[i].is_maximum ? "a maximum instead of the minimum"
                                                           : "a minimum instead of the maximum") +
                               at(edit.extrema[i].at.point);
      Result<std::optional<Tried>> tried = attempt(edit, better());
      if (!tried) return tried.error();
      if (!*tried) continue;
      take(std::move(**tried), std::move(edit), what);
      helped = true;
    }
    return helped;
  }

  // What the energy does not miss goes.
  Result<bool> remove() {
    bool helped = false;
    for (std::size_t i = 0; i < m_edit.extrema.size() && tries_left();) {
      if (is_last_of_its_kind(i)) {
        ++i;
        continue;
      }
      Set_extrema edit = m_edit;
      edit.extrema.erase(edit.extrema.begin() + std::ptrdiff_t(i));
      const std::string what = "without the extremum" + at(m_edit.extrema[i].at.point);
      Result<std::optional<Tried>> tried = attempt(edit, m_best.energy);
      if (!tried) return tried.error();
      if (!*tried) {
        ++i;
        continue;
      }
      take(std::move(**tried), std::move(edit), what);
      helped = true;
    }
    return helped;
  }

  const Editor& m_editor;
  const Search_options& m_options;
  Observer* m_observer;
  Only_cancels m_silent;
  const Triangle_surface& m_surface;
  Surface_projector m_projector;
  internal::Lazy_projector m_lazy;
  Surface_samples m_samples;
  Set_extrema m_edit; // leads to the best design
  Tried m_best;
  std::vector<Point> m_places; // where extrema were tried
  Searched_extrema m_found;
  internal::Search_limit m_limit;
  int m_tries = 0, m_most_vertices = -1;
};

} // namespace

Result<Searched_extrema> search_extrema(const Editor& session, const Edit& first,
                                        const Search_options& options, Observer* observer) {
  CGAL_precondition(session.design().charts.empty());
  if (options.tries < 1 || options.copy_triangles < 200)
    return make_error(Error_code::impossible_request,
                      "a search tries one design at least, on a copy of 200 triangles at least");
  const std::optional<Triangle_surface> copy =
      internal::coarse_copy(session.working_surface(), options.copy_triangles);
  if (!copy) return Search(session, options, observer).run(first);
  Editor_options coarse = session.options();
  coarse.keep_factorization = true;
  coarse.sizes.clear(); // extrema are where the shape asks for them
  Result<Editor> editor = Editor::create(*copy, coarse, observer);
  if (!editor) return editor.error();
  Result<Searched_extrema> found = Search(*editor, options, observer).run(first);
  if (!found) return found;
  // They are numbered otherwise on the surface, and found by their places.
  for (Set_extrema::Extremum& e : found->edit.extrema) e.at.vertex = -1;
  return found;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
