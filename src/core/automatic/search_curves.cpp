// SPDX-License-Identifier: GPL-3.0-or-later
#include "automatic/search_curves.h"

#include "automatic/search_limit.h"
#include "design/draft.h"
#include "surface/sharp_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

using Kind = Sharp_curve_kind;

// An energy that falls by less is not worth a change.
constexpr double worth_it = 0.003;

// Samples for each quad that is asked for.
constexpr double samples_per_quad = 1.5;

// A curve is at least so many edges of the quads long; a cap as large as so many quads, and at most such a
// part of the surface.
constexpr double shortest = 6, smallest_cap = 4, largest_cap = 0.45;

// How flat a cap is: the length of its mean normal.
constexpr double flat = 0.5;

// Extrema so near to the cap of one more are left out, in edges of the quads.
constexpr double replaced_within = 3;

// Curves that are considered, the longest first.
constexpr std::size_t most_curves = 24;

// Rings whose signs are looked for together.
constexpr std::size_t most_rings = 12;

// A loop that may become a curve.
struct Candidate {
  Set_extrema::Sharp_curve curve; // names it
  std::vector<int> halfedges;     // the patch on the left
  std::vector<int> vertices;      // sorted
  int patch = -1;
  double length = 0, area = 0; // area: of the cap
  bool can_cap = false, is_smooth = false;
};

// What is chosen: a kind for each candidate, or none.
using Choice = std::vector<std::optional<Kind>>;

bool is_high(Kind kind) {
  return kind == Kind::maximum || kind == Kind::cap_of_maximum;
}
Kind kind_of(const Candidate& c, bool high) {
  if (c.can_cap) return high ? Kind::cap_of_maximum : Kind::cap_of_minimum;
  return high ? Kind::maximum : Kind::minimum;
}

double length_of(const Triangle_surface& s, const std::vector<int>& halfedges) {
  double sum = 0;
  for (int h : halfedges) sum += (s.points[s.target(h)] - s.points[s.source(h)]).norm();
  return sum;
}

bool is_disc(const Triangle_surface& s, const Sharp_patch& patch) {
  if (patch.loops.size() != 1) return false;
  std::vector<int> vertices, edges;
  for (int f : patch.faces)
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      vertices.push_back(s.source(h));
      edges.push_back(s.edge(h));
    }
  for (std::vector<int>* list : {&vertices, &edges}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return int(vertices.size()) - int(edges.size()) + int(patch.faces.size()) == 1 &&
         vertices.size() > patch.loops[0].halfedges.size();
}

// The loops of a surface that may become curves.
class Candidates {
public:
  Candidates(const Triangle_surface& surface, double feature_angle, double edge)
      : m_surface(surface), m_patches(sharp_patches(surface, feature_angle)), m_edge(edge),
        m_whole(area(surface)), m_patch_of(std::size_t(surface.number_of_faces()), -1) {
    for (std::size_t p = 0; p < m_patches.size(); ++p)
      for (int f : m_patches[p].faces) m_patch_of[std::size_t(f)] = int(p);
    for (std::size_t p = 0; p < m_patches.size(); ++p) add(int(p), feature_angle);
    std::stable_sort(m_all.begin(), m_all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.length > b.length; });
    if (m_all.size() > most_curves) m_all.resize(most_curves);
  }

  const std::vector<Candidate>& all() const { return m_all; }
  const Candidate& operator[](std::size_t i) const { return m_all[i]; }
  std::size_t size() const { return m_all.size(); }
  int patch_of(int face) const { return m_patch_of[std::size_t(face)]; }
  int number_of_patches() const { return int(m_patches.size()); }

  bool touch(std::size_t i, std::size_t j) const {
    const std::vector<int>&a = m_all[i].vertices, &b = m_all[j].vertices;
    std::size_t k = 0;
    for (int v : a) {
      while (k < b.size() && b[k] < v) ++k;
      if (k < b.size() && b[k] == v) return true;
    }
    return false;
  }

  // The regions that chosen curves leave, as a number for each patch.
  std::vector<int> regions(const Choice& choice) const {
    std::vector<char> is_cut(std::size_t(m_surface.number_of_halfedges()), 0);
    for (std::size_t i = 0; i < size(); ++i)
      if (choice[i])
        for (int h : m_all[i].halfedges) is_cut[h] = is_cut[m_surface.opposite[h]] = 1;
    std::vector<int> region(m_patches.size());
    std::iota(region.begin(), region.end(), 0);
    const auto root = [&](int p) {
      while (region[p] != p) p = region[p] = region[region[p]];
      return p;
    };
    for (const Sharp_patch& patch : m_patches)
      for (const Sharp_loop& loop : patch.loops)
        for (int h : loop.halfedges)
          if (const int o = m_surface.opposite[h]; o >= 0 && !is_cut[h]) {
            const int a = root(patch_of(h / 3)), b = root(patch_of(o / 3));
            region[std::max(a, b)] = std::min(a, b);
          }
    for (int p = 0; p < number_of_patches(); ++p) region[p] = root(p);
    return region;
  }

  // The patches on both sides of a candidate.
  std::array<int, 2> sides(std::size_t i) const {
    const int h = m_all[i].halfedges.front();
    return {patch_of(h / 3), patch_of(m_surface.opposite[h] / 3)};
  }

private:
  void add(int p, double feature_angle) {
    const Sharp_patch& patch = m_patches[std::size_t(p)];
    double whole = 0;
    Point normal = Point::Zero();
    int largest = patch.faces.front();
    for (int f : patch.faces) {
      whole += area(m_surface, f);
      if (area(m_surface, f) > area(m_surface, largest)) largest = f;
      const Triangle& t = m_surface.triangles[f];
      const Point& a = m_surface.points[t[0]];
      normal += 0.5 * Point(m_surface.points[t[1]] - a).cross(Point(m_surface.points[t[2]] - a));
    }
    const Triangle& t = m_surface.triangles[largest];
    const Point inside = (m_surface.points[t[0]] + m_surface.points[t[1]] + m_surface.points[t[2]]) / 3;
    const bool can_cap = whole > smallest_cap * m_edge * m_edge && whole < largest_cap * m_whole &&
                         normal.norm() > flat * whole && is_disc(m_surface, patch);
    for (const Sharp_loop& loop : patch.loops) {
      Candidate c;
      c.length = length_of(m_surface, loop.halfedges);
      if (!loop.is_simple || c.length < shortest * m_edge) continue;
      c.halfedges = loop.halfedges;
      for (int h : loop.halfedges) c.vertices.push_back(m_surface.source(h));
      c.curve.face.point = inside;
      c.curve.at.point = m_surface.points[c.vertices.front()];
      c.curve.feature_angle = feature_angle;
      std::sort(c.vertices.begin(), c.vertices.end());
      c.patch = p;
      c.area = whole;
      c.can_cap = can_cap;
      c.is_smooth = turns_of(m_surface, loop, 50, false).empty();
      const auto same = std::find_if(m_all.begin(), m_all.end(),
                                     [&](const Candidate& o) { return o.vertices == c.vertices; });
      if (same == m_all.end())
        m_all.push_back(std::move(c));
      else if (can_cap && (!same->can_cap || whole < same->area)) // the same line, seen from its other side
        *same = std::move(c);
    }
  }

  const Triangle_surface& m_surface;
  std::vector<Sharp_patch> m_patches;
  double m_edge, m_whole;
  std::vector<int> m_patch_of;
  std::vector<Candidate> m_all;
};

class Curve_search {
public:
  Curve_search(const Editor& editor, double feature_angle, const Search_options& options, Observer* observer)
      : m_editor(editor), m_options(options), m_observer(observer), m_surface(editor.working_surface()),
        m_angle(feature_angle), m_projector(m_surface), m_lazy(m_surface), m_edge(edge_of(editor)),
        m_candidates(m_surface, feature_angle, m_edge), m_is_closed(boundary_loops(m_surface).empty()),
        m_limit(options) {}

  Result<Searched_curves> run(const Edit& first) {
    if (m_candidates.size() == 0) return std::move(m_found);
    m_found.has_faces = true;
    m_samples = sample_surface(
        m_surface, int(std::min(2e5, samples_per_quad * area(m_surface) / (m_edge * m_edge) + 1000)));
    Result<std::optional<Tried>> start = attempt(first);
    if (!start) return start.error();
    if (*start && (*start)->missed < 0.02) return std::move(m_found); // nothing to gain
    remember(first, *start);
    if (*start) m_best = std::move(**start);
    m_choice.assign(m_candidates.size(), std::nullopt);
    m_pure = Set_extrema();
    m_pure.axis = m_edit.axis;
    m_pure.collapse_thin = m_edit.collapse_thin;
    m_pure.boundary = m_edit.boundary;
    for (const auto step : {&Curve_search::rings, &Curve_search::pairs, &Curve_search::change})
      for (bool again = true; again && tries_left();) {
        Result<bool> helped = (this->*step)();
        if (!helped) return helped.error();
        again = *helped && step == &Curve_search::change;
      }
    if (!m_found.steps.empty()) m_found.edit = m_edit;
    return std::move(m_found);
  }

private:
  struct Tried {
    Design design;
    Design_energy parts;
    double missed = 1, energy = 0;
  };

  static double edge_of(const Editor& editor) {
    const Editor_options& o = editor.options();
    return o.edge_length > 0 ? o.edge_length : std::sqrt(area(editor.working_surface()) / o.quads);
  }

  bool tries_left() const { return !m_limit.is_reached(m_found.tries); }

  // Nothing if the edit cannot be made; an error if the search is to stop.
  Result<std::optional<Tried>> attempt(const Edit& edit) {
    if (m_observer) {
      m_observer->progress("search", m_limit.done(m_found.tries));
      if (m_observer->cancelled()) return make_error(Error_code::cancelled, "cancelled by the user");
    }
    ++m_found.tries;
    Result<Design> design = m_editor.preview(edit, nullptr);
    if (!design) return std::optional<Tried>();
    Result<Stitched_mesh> quads = stitch_design(m_surface, m_lazy, *design);
    if (!quads) return std::optional<Tried>();
    Tried tried;
    tried.missed = missed_features(quads->mesh, m_surface, m_angle);
    tried.parts = design_energy(std::move(*quads), m_projector, m_samples);
    tried.energy = tried.parts.total(m_options.weights) + m_options.weights.features * tried.missed;
    tried.design = std::move(*design);
    return std::optional<Tried>(std::move(tried));
  }

  // The first design's extrema, as they are to be asked for.
  void remember(const Edit& first, const std::optional<Tried>& start) {
    if (const auto* set = std::get_if<Set_extrema>(&first)) {
      m_edit = *set;
    } else if (const auto* suggest = std::get_if<Suggest>(&first)) {
      m_edit.axis = suggest->axis;
      m_edit.collapse_thin = suggest->collapse_thin;
      m_edit.boundary = suggest->boundary;
      if (start)
        for (const Design_extremum& e : start->design.extrema)
          m_edit.extrema.push_back({{m_surface.points[e.vertex], e.vertex}, e.is_maximum, e.value});
    }
  }

  // The edit with other curves: extrema at their caps are left out.
  Set_extrema edited(const Set_extrema& base, const Choice& choice) const {
    Set_extrema edit = base;
    edit.curves.clear();
    for (std::size_t i = 0; i < choice.size(); ++i) {
      if (!choice[i]) continue;
      const Candidate& c = m_candidates[i];
      edit.curves.push_back(c.curve);
      edit.curves.back().kind = *choice[i];
      const auto replaced = [&](const Set_extrema::Extremum& e) { return is_at(e.at.point, c); };
      edit.extrema.erase(std::remove_if(edit.extrema.begin(), edit.extrema.end(), replaced),
                         edit.extrema.end());
    }
    return edit;
  }

  bool is_at(const Point& p, const Candidate& c) const {
    if (c.can_cap && m_candidates.patch_of(m_projector.closest(p).face) == c.patch) return true;
    const double reach = replaced_within * m_edge;
    return std::any_of(c.vertices.begin(), c.vertices.end(),
                       [&](int v) { return (m_surface.points[v] - p).squaredNorm() < reach * reach; });
  }

  // Tries curves with some extrema, and keeps both if that is better by enough.
  Result<bool> consider(const Set_extrema& base, const Choice& choice, const std::string& what) {
    Set_extrema edit = edited(base, choice);
    // With a boundary its loops may be what a region needs.
    if (m_is_closed && !has_both(choice, edit.extrema)) return false;
    Result<std::optional<Tried>> tried = attempt(edit);
    if (!tried) return tried.error();
    if (!*tried || (m_best && (*tried)->energy > m_best->energy - worth_it)) return false;
    take(std::move(**tried), std::move(edit), choice, what);
    return true;
  }

  void take(Tried tried, Set_extrema edit, const Choice& choice, const std::string& what) {
    std::ostringstream reason;
    reason.precision(3);
    reason << what;
    if (m_best)
      reason << ": sharp edges that quads cross obliquely from " << 100 * m_best->missed << " to "
             << 100 * tried.missed << " %, the farthest place from " << m_best->parts.farthest << " to "
             << tried.parts.farthest << " edges, the mean scaled Jacobian from " << 1 - m_best->parts.angle
             << " to " << 1 - tried.parts.angle << ", extraordinary vertices from "
             << m_best->parts.extraordinary << " to " << tried.parts.extraordinary;
    m_found.steps.push_back({reason.str(), tried.energy});
    m_best = std::move(tried);
    m_edit = std::move(edit);
    m_choice = choice;
  }

  std::string text(std::size_t i, Kind kind) const {
    const Candidate& c = m_candidates[i];
    const Point& p = c.can_cap ? c.curve.face.point : c.curve.at.point;
    std::ostringstream out;
    out.precision(4);
    out << (c.can_cap ? "a cap" : "a ring") << (is_high(kind) ? " above" : " below") << " the sharp edges "
        << (c.can_cap ? "around" : "through") << " (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
    return out.str();
  }

  bool fits(const Choice& choice, std::size_t i) const {
    for (std::size_t j = 0; j < choice.size(); ++j)
      if (j != i && choice[j] && m_candidates.touch(i, j)) return false;
    return true;
  }

  // Whether each region that curves bound has something below and something above: curves or extrema. A cap
  // has.
  bool has_both(const Choice& choice, const std::vector<Set_extrema::Extremum>& extrema) const {
    const std::vector<int> region = m_candidates.regions(choice);
    std::vector<int> found(region.size(), 0);
    const auto note = [&](int patch, int what) { found[std::size_t(region[std::size_t(patch)])] |= what; };
    for (const Set_extrema::Extremum& e : extrema)
      note(m_candidates.patch_of(m_projector.closest(e.at.point).face), e.is_maximum ? 2 : 1);
    for (std::size_t i = 0; i < choice.size(); ++i) {
      if (!choice[i]) continue;
      for (int p : m_candidates.sides(i)) {
        const bool own = m_candidates[i].can_cap && p == m_candidates[i].patch;
        note(p, own ? 3 : is_high(*choice[i]) ? 2 : 1);
      }
    }
    return std::all_of(found.begin(), found.end(), [](int f) { return f == 0 || f == 3; });
  }

  // Curves on all closed lines without a corner, or on all, minima and maxima in turn.
  Result<bool> rings() {
    bool any = false;
    for (const bool with_corners : {false, true}) {
      Choice choice(m_candidates.size());
      std::vector<std::size_t> chosen;
      for (std::size_t i = 0; i < choice.size() && chosen.size() < most_rings; ++i)
        if ((with_corners || m_candidates[i].is_smooth) && fits(choice, i)) {
          choice[i] = kind_of(m_candidates[i], false);
          chosen.push_back(i);
        }
      if (chosen.size() < 2 || !tries_left() || !give_signs(chosen, choice)) continue;
      Result<bool> helped =
          consider(m_pure, choice, std::to_string(chosen.size()) + " closed lines of sharp edges");
      if (!helped) return helped;
      any = any || *helped;
    }
    m_has_rings = any;
    return any;
  }

  // The first signs with which each region can have a field; the last curve is a minimum.
  bool give_signs(const std::vector<std::size_t>& chosen, Choice& choice) const {
    for (unsigned signs = 0; signs < 1u << (chosen.size() - 1); ++signs) {
      for (std::size_t k = 0; k < chosen.size(); ++k)
        choice[chosen[k]] = kind_of(m_candidates[chosen[k]], (signs >> k & 1u) != 0);
      if (has_both(choice, {})) return true;
    }
    return false;
  }

  // Caps on two faces that do not touch, the largest first.
  Result<bool> pairs() {
    std::vector<std::size_t> caps;
    for (std::size_t i = 0; i < m_candidates.size(); ++i)
      if (m_candidates[i].can_cap) caps.push_back(i);
    bool any = false;
    int left = m_options.tries / (m_has_rings ? 4 : 2);
    for (std::size_t b = 1; b < caps.size(); ++b)
      for (std::size_t a = 0; a < b && left > 0 && tries_left(); ++a) {
        if (m_candidates.touch(caps[a], caps[b])) continue;
        Choice choice(m_candidates.size());
        choice[caps[a]] = Kind::cap_of_minimum;
        choice[caps[b]] = Kind::cap_of_maximum;
        --left;
        Result<bool> helped =
            consider(m_pure, choice,
                     text(caps[a], Kind::cap_of_minimum) + " and " + text(caps[b], Kind::cap_of_maximum));
        if (!helped) return helped;
        any = any || *helped;
      }
    return any;
  }

  // One curve more, one less, or another sign of one.
  Result<bool> change() {
    bool any = false;
    for (std::size_t i = 0; i < m_candidates.size() && tries_left(); ++i) {
      std::vector<std::optional<Kind>> others;
      const Kind low = kind_of(m_candidates[i], false), high = kind_of(m_candidates[i], true);
      if (!m_choice[i] && fits(m_choice, i))
        others = {low, high};
      else if (m_choice[i])
        others = {is_high(*m_choice[i]) ? low : high, std::nullopt};
      for (const std::optional<Kind>& kind : others) {
        if (!tries_left()) break;
        Choice choice = m_choice;
        choice[i] = kind;
        const std::string what = kind ? text(i, *kind) : "without " + text(i, *m_choice[i]);
        Result<bool> helped = consider(m_edit, choice, what);
        if (!helped) return helped;
        any = any || *helped;
        if (*helped) break;
      }
    }
    return any;
  }

  const Editor& m_editor;
  const Search_options& m_options;
  Observer* m_observer;
  const Triangle_surface& m_surface;
  double m_angle;
  Surface_projector m_projector;
  Lazy_projector m_lazy;
  double m_edge;
  Candidates m_candidates;
  bool m_is_closed;
  Surface_samples m_samples;
  Set_extrema m_edit, m_pure; // leads to the best design; without extrema
  Choice m_choice;
  bool m_has_rings = false;
  std::optional<Tried> m_best;
  Searched_curves m_found;
  Search_limit m_limit;
};

} // namespace

Result<Searched_curves> search_curves(const Editor& session, const Edit& first, double feature_angle,
                                      const Search_options& options, Observer* observer) {
  if (!(feature_angle > 0) || options.tries < 1) return Searched_curves();
  return Curve_search(session, feature_angle, options, observer).run(first);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
