// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/suggest_edits.h>

#include "editor/hint_measures.h"
#include "editor/lost_features.h"
#include "editor/surface_ways.h"

#include <CGAL/Reeb_quadrangulation/feature_edges.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <tuple>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", std::abs(x) < 1e-12 ? 0.0 : x);
  return buffer;
}

std::string text(const Point& p) {
  return "(" + text(p.x()) + ", " + text(p.y()) + ", " + text(p.z()) + ")";
}

Result<void> check_options(const Hint_options& o) {
  for (double length : {o.limb, o.thin, o.snap, o.room, o.lost})
    if (!(length >= 0) || !std::isfinite(length))
      return make_error(Error_code::impossible_request, "the lengths that hints ask for are not negative");
  if (!(o.feature_angle > 0 && o.feature_angle < 180))
    return make_error(Error_code::impossible_request, "the feature angle is between 0 and 180 degrees");
  return {};
}

// Where the surface protrudes: vertices. They depend on the surface alone.
Result<std::vector<int>> tips_of(const Editor& editor, const Hint_options& options, Observer* observer) {
  std::vector<int> tips;
  if (!options.limbs || editor.design().charts.empty()) return tips;
  Suggestion_options suggestion;
  suggestion.persistence = options.persistence;
  const Result<Suggestion> extrema = suggest_extrema(editor.working_surface(), suggestion, observer);
  if (!extrema) return extrema.error();
  for (const Suggested_extremum& e : extrema->extrema) tips.push_back(e.vertex);
  return tips;
}

// A place where an edit may be worth while.
struct Candidate {
  Hint_kind kind;
  double before;
  Point place;
  int element; // a vertex, chart, contour or node
};

class Hint_search {
public:
  Hint_search(const Editor& editor, const Hint_options& options, const std::vector<int>& tips,
              Observer* observer)
      : m_editor(editor), m_options(options), m_tips(tips), m_observer(observer),
        m_surface(editor.working_surface()), m_design(editor.design()), m_h(editor.design().edge_length) {}

  // At most `most` hints, or all of them.
  Result<std::vector<Hint>> run(std::size_t most) {
    find_limbs();
    if (m_options.thin_charts) find_thin_charts();
    if (m_options.sharp_edges) find_contours_beside_features();
    if (m_options.saddles) find_saddles();
    if (m_options.finished && !m_design.charts.empty())
      if (const Result<void> found = find_lost_features(*m_options.finished); !found) return found.error();
    const auto key = [](const Candidate& c) {
      return std::make_tuple(c.kind, -c.before, c.place.x(), c.place.y(), c.place.z(), c.element);
    };
    std::sort(m_candidates.begin(), m_candidates.end(),
              [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
    std::vector<Hint> hints;
    for (std::size_t i = 0; i < m_candidates.size() && hints.size() < most; ++i) {
      if (m_observer) m_observer->progress("suggest edits", double(i) / double(m_candidates.size()));
      std::optional<Hint> hint = tried(m_candidates[i]);
      if (m_observer && m_observer->cancelled())
        return make_error(Error_code::cancelled, "cancelled by the user");
      if (hint && !is_known(*hint, hints)) hints.push_back(std::move(*hint));
    }
    return hints;
  }

private:
  // Several lost lines may lead to the same contour or chart.
  static bool is_known(const Hint& hint, const std::vector<Hint>& hints) {
    return std::any_of(hints.begin(), hints.end(), [&](const Hint& other) {
      return hint.kind == Hint_kind::lost_edge && other.kind == hint.kind &&
             other.edit.index() == hint.edit.index() && other.after == hint.after;
    });
  }

  Surface_point at(int vertex) const { return {m_surface.points[vertex], vertex}; }

  void find_limbs() {
    for (int tip : m_tips) {
      const int chart = m_editor.chart_at(at(tip));
      if (chart < 0) continue;
      const double distance = distance_to_quads(m_surface.points[tip], {m_design.charts[chart].get()}) / m_h;
      if (distance > m_options.limb)
        m_candidates.push_back({Hint_kind::uncovered_limb, distance, m_surface.points[tip], tip});
    }
  }

  // The vertex of the first saddle on a walk, or -1.
  int saddle_on(const Walk& walk) const {
    const Walk_edge& e = walk.edges[0];
    const Contour_edge& edge = m_design.network.edges[e.edge];
    const Contour_node& node = m_design.network.nodes[e.forward ? edge.from : edge.to];
    return node.kind == Node_kind::saddle ? node.vertex : -1;
  }

  void find_thin_charts() {
    for (std::size_t c = 0; c < m_design.charts.size(); ++c) {
      const Design_chart& chart = *m_design.charts[c];
      if (chart.chart->kind != Chart_kind::annulus || !(chart.height < m_options.thin * m_h)) continue;
      const int saddle = saddle_on(chart.chart->walks[0]);
      if (saddle < 0 || saddle_on(chart.chart->walks[1]) < 0) continue;
      m_candidates.push_back(
          {Hint_kind::thin_chart, mean_aspect({&chart}), m_surface.points[saddle], int(c)});
    }
  }

  // All sharp edges, found when they are asked for.
  const Segments& features() {
    if (m_features) return *m_features;
    m_features.emplace();
    for (const Feature_chain& chain : feature_edges(m_surface, m_options.feature_angle).chains)
      if (!chain.boundary)
        for (int h : chain.halfedges)
          m_features->push_back(
              {m_surface.points[m_surface.source(h)], m_surface.points[m_surface.target(h)]});
    return *m_features;
  }

  double distance_to_features(const Contour_network& network, int edge) {
    return mean_distance(contour_points(m_surface, network, edge), features()) / m_h;
  }

  void find_contours_beside_features() {
    const Contour_network& network = m_design.network;
    if (features().empty()) return;
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      if (!is_free_loop(network, int(e))) continue;
      const double distance = distance_to_features(network, int(e));
      if (distance <= m_options.snap && distance > 1e-6)
        m_candidates.push_back({Hint_kind::sharp_edge, distance,
                                network.position(m_surface, network.edges[e].vertices[0]), int(e)});
    }
  }

  void find_saddles() {
    const std::vector<char> is_used = nodes_in_use(m_design.network);
    for (std::size_t i = 0; i < is_used.size(); ++i) {
      const Contour_node& node = m_design.network.nodes[i];
      if (is_used[i] && node.kind == Node_kind::saddle && node.multiplicity == 1)
        m_candidates.push_back({Hint_kind::saddle, 4, m_surface.points[node.vertex], node.vertex});
    }
  }

  // What the finished quads lack; what can be better about it is measured on the design's own quads.
  Result<void> find_lost_features(const Quad_mesh& finished) {
    Deviation_options options;
    options.observer = m_observer;
    Result<Deviation> lost = measure_deviation(finished, m_surface, options);
    if (!lost) return lost.error();
    Result<Deviation> before = deviation_of(m_design, m_surface, m_observer);
    if (!before) return before.error();
    m_before = std::move(*before);
    const auto is_limb = [&](const Point& p) {
      return std::any_of(m_candidates.begin(), m_candidates.end(), [&](const Candidate& c) {
        return c.kind == Hint_kind::uncovered_limb && (c.place - p).norm() < 2 * m_h;
      });
    };
    std::array<int, 3> number{{0, 0, 0}}; // of each kind
    for (const Deviation_place& place : lost->worst)
      if (place.on_surface && place.distance > m_options.lost * m_h && !is_limb(place.point) &&
          number[0]++ < most_lost)
        add_lost_place(nearest_vertex(m_surface, {place.point, -1}));
    for (const Lost_line& line : lost_lines(*lost))
      if (line.length > m_options.lost * m_h && number[1]++ < most_lost)
        m_candidates.push_back({Hint_kind::lost_edge, m_before.lost_sharp_length / m_h, line.middle, 0});
    for (const Point& corner : lost->lost_corners)
      if (number[2]++ < most_lost)
        m_candidates.push_back({Hint_kind::lost_corner, double(m_before.lost_corners.size()), corner, 0});
    return {};
  }

  void add_lost_place(int vertex) {
    const double distance = m_before.of_surface[std::size_t(vertex)] / m_h;
    m_candidates.push_back({Hint_kind::lost_place, distance, m_surface.points[std::size_t(vertex)], vertex});
  }

  std::optional<Hint> tried(const Candidate& c) {
    switch (c.kind) {
    case Hint_kind::uncovered_limb: return try_limb(c);
    case Hint_kind::thin_chart: return try_thin_chart(c);
    case Hint_kind::sharp_edge: return try_sharp_edge(c);
    case Hint_kind::saddle: return try_saddle(c);
    case Hint_kind::lost_place: return try_lost_place(c);
    case Hint_kind::lost_edge: return try_lost_edge(c);
    case Hint_kind::lost_corner: return try_lost_corner(c);
    }
    return std::nullopt;
  }

  // What an edit leads to, if it applies and costs no texture that the user has made.
  std::optional<Design> preview(const Edit& edit) const {
    Result<Design> design = m_editor.preview(edit, m_observer);
    if (!design) return std::nullopt;
    for (const auto& chart : m_design.charts)
      if (chart->edited && design->index_of(chart->id) < 0) return std::nullopt;
    return std::move(*design);
  }

  static Hint hint(const Candidate& c, Edit edit, double after, std::string reason) {
    return {c.kind, std::move(edit), c.place, std::move(reason), c.before, after};
  }

  // Distances, in edge lengths: whether one is so much less than the other that it is worth an edit.
  static bool is_nearer(double after, double before) { return after <= before - 0.5 || after < 0.1 * before; }

  std::optional<Hint> try_limb(const Candidate& c) {
    std::optional<Hint> best;
    for (bool is_maximum : {true, false}) {
      const Edit edit = Add_extremum{at(c.element), is_maximum};
      const std::optional<Design> design = preview(edit);
      if (!design) continue;
      const double after = distance_to_quads(c.place, charts_not_in(*design, m_design)) / m_h;
      if (!is_nearer(after, c.before) || (best && !(after < best->after))) continue;
      best = hint(c, edit, after,
                  "the protrusion at " + text(c.place) + " has no extremum: its tip is " + text(c.before) +
                      " edge lengths away from the quads; with a " + (is_maximum ? "maximum" : "minimum") +
                      " there, " + text(after));
    }
    return best;
  }

  std::optional<Hint> try_thin_chart(const Candidate& c) {
    const Design_chart& chart = *m_design.charts[c.element];
    const Edit edit =
        Align_saddles{at(saddle_on(chart.chart->walks[0])), at(saddle_on(chart.chart->walks[1]))};
    const std::optional<Design> design = preview(edit);
    if (!design || design->index_of(chart.id) >= 0) return std::nullopt;
    const double after = mean_aspect(charts_not_in(*design, m_design));
    if (!(after < c.before)) return std::nullopt;
    return hint(c, edit, after,
                "the chart at the saddle " + text(c.place) + " is " + text(chart.height / m_h) +
                    " edge lengths high: its quads are " + text(c.before) +
                    " times as long as wide; those around the saddles on one contour would be " +
                    text(after) + " times");
  }

  std::optional<Hint> try_sharp_edge(const Candidate& c) {
    const Edit edit = Snap_contour{{c.place, -1}, m_options.feature_angle};
    const std::optional<Design> design = preview(edit);
    if (!design) return std::nullopt;
    const int fresh = int(design->network.edges.size()) - 1;
    const std::vector<Point> old = contour_points(m_surface, m_design.network, c.element);
    const double moved =
        mean_distance(old, segments_of(contour_points(m_surface, design->network, fresh))) / m_h;
    const double after = distance_to_features(design->network, fresh);
    // Not onto another chain, farther away.
    if (moved > 2 * m_options.snap || !is_nearer(after, c.before)) return std::nullopt;
    return hint(c, edit, after,
                "the contour at " + text(c.place) + " is " + text(c.before) +
                    " edge lengths away from sharp edges of more than " + text(m_options.feature_angle) +
                    " degrees; snapped to them, " + text(after));
  }

  bool leaves_room(const std::vector<const Design_chart*>& charts) const {
    return std::none_of(charts.begin(), charts.end(), [&](const Design_chart* chart) {
      return chart->chart->kind == Chart_kind::annulus && chart->height < m_options.room * m_h;
    });
  }

  std::optional<Hint> try_saddle(const Candidate& c) {
    std::optional<Hint> best;
    double most = 0;
    for (Saddle_kind kind : {Saddle_kind::half, Saddle_kind::quarter}) {
      const Edit edit = Split_saddle{at(c.element), kind, {}, 0};
      const std::optional<Design> design = preview(edit);
      if (!design) continue;
      const std::vector<const Design_chart*> gone = charts_not_in(m_design, *design),
                                             fresh = charts_not_in(*design, m_design);
      const double before = mean_scaled_jacobian(gone), after = mean_scaled_jacobian(fresh);
      if (after < before + 1e-3 || !(after > most) || !leaves_room(fresh)) continue;
      most = after;
      const bool halves = kind == Saddle_kind::half;
      best = hint(c, edit, halves ? 2 : 1,
                  "the saddle at " + text(c.place) + " has valence 8, and there is room for " +
                      (halves ? "two half-saddles of valence 6" : "four quarter-saddles of valence 5") +
                      ": the mean scaled Jacobian of the quads around grows from " + text(before) + " to " +
                      text(after));
    }
    return best;
  }

  // What would be lost after an edit, if it applies.
  std::optional<Deviation> lost_after(const Edit& edit) const {
    const std::optional<Design> design = preview(edit);
    if (!design) return std::nullopt;
    Result<Deviation> deviation = deviation_of(*design, m_surface, m_observer);
    return deviation ? std::optional<Deviation>(std::move(*deviation)) : std::nullopt;
  }

  std::optional<Hint> try_lost_place(const Candidate& c) const {
    std::optional<Hint> best;
    for (bool is_maximum : {true, false}) {
      const Edit edit = Add_extremum{at(c.element), is_maximum};
      const std::optional<Deviation> lost = lost_after(edit);
      if (!lost) continue;
      const double after = lost->of_surface[std::size_t(c.element)] / m_h;
      if (!is_nearer(after, c.before) || (best && !(after < best->after))) continue;
      best = hint(c, edit, after,
                  "the quads cut the surface off at " + text(c.place) + ", " + text(c.before) +
                      " edge lengths away from it; with a " + (is_maximum ? "maximum" : "minimum") +
                      " there, " + text(after));
    }
    return best;
  }

  // The free contour that is nearest to a point, by its nearest vertex, if that is at most four edges away.
  std::optional<Point> free_contour_near(const Point& p) const {
    const Contour_network& network = m_design.network;
    std::optional<Point> nearest;
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      if (!is_free_loop(network, int(e))) continue;
      for (const Point& q : contour_points(m_surface, network, int(e)))
        if ((q - p).norm() < (nearest ? (*nearest - p).norm() : 4 * m_h)) nearest = q;
    }
    return nearest;
  }

  std::optional<Hint> try_lost_edge(const Candidate& c) const {
    std::vector<std::pair<Edit, const char*>> edits;
    if (const std::optional<Point> contour = free_contour_near(c.place))
      edits.push_back({Snap_contour{{*contour, -1}, m_options.feature_angle}, "the contour beside on them"});
    edits.push_back(
        {Fit_texture{{c.place, -1}, m_options.feature_angle}, "the texture of the chart fitted to them"});
    std::optional<Hint> best;
    for (const auto& [edit, with] : edits) {
      const std::optional<Deviation> lost = lost_after(edit);
      if (!lost || !(lost->lost_sharp_length < 0.98 * m_before.lost_sharp_length)) continue;
      const double after = lost->lost_sharp_length / m_h;
      if (best && !(after < best->after)) continue;
      best = hint(c, edit, after,
                  "no quads run along the sharp edges at " + text(c.place) + ": " + text(c.before) +
                      " edge lengths of all sharp edges are lost so; with " + with + ", " + text(after));
    }
    return best;
  }

  // The vertex of the quads that is nearest to the corner, put onto it.
  std::optional<Hint> try_lost_corner(const Candidate& c) const {
    Point nearest = Point::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& chart : m_design.charts)
      for (const Chart_location& location : chart->texture.location)
        if (const Point p = position(*chart->chart, location); (p - c.place).norm() < least) {
          least = (p - c.place).norm();
          nearest = p;
        }
    const Edit edit = Snap_vertices{{{nearest, -1}}, m_options.feature_angle};
    const std::optional<Deviation> lost = lost_after(edit);
    if (!lost || !(double(lost->lost_corners.size()) < c.before)) return std::nullopt;
    return hint(c, edit, double(lost->lost_corners.size()),
                "the corner at " + text(c.place) + " has no vertex of the quads, as " + text(c.before) +
                    " corners in all; with the nearest vertex on it, " +
                    text(double(lost->lost_corners.size())));
  }

  static constexpr int most_lost = 4; // hints of each kind about what is lost

  const Editor& m_editor;
  const Hint_options& m_options;
  const std::vector<int>& m_tips;
  Observer* m_observer;
  const Triangle_surface& m_surface;
  const Design& m_design;
  double m_h;
  std::vector<Candidate> m_candidates;
  std::optional<Segments> m_features;
  Deviation m_before; // of the design's own quads, where something is lost
};

} // namespace

Result<std::vector<Hint>> suggest_edits(const Editor& editor, const Hint_options& options,
                                        Observer* observer) {
  if (const Result<void> checked = check_options(options); !checked) return checked.error();
  const Result<std::vector<int>> tips = tips_of(editor, options, observer);
  if (!tips) return tips.error();
  return Hint_search(editor, options, *tips, observer).run(std::size_t(-1));
}

Result<std::vector<Hint>> apply_hints(Editor& editor, const Hint_options& options, Observer* observer) {
  if (const Result<void> checked = check_options(options); !checked) return checked.error();
  const Result<std::vector<int>> tips = tips_of(editor, options, observer);
  if (!tips) return tips.error();
  Hint_options of_designs = options;
  of_designs.finished = nullptr;
  std::vector<Hint> taken;
  for (;;) {
    Result<std::vector<Hint>> hints = Hint_search(editor, of_designs, *tips, observer).run(1);
    if (!hints) return hints.error();
    if (hints->empty()) return taken;
    if (const Result<Edit_report> done = editor.apply(hints->front().edit, observer); !done)
      return done.error();
    taken.push_back(std::move(hints->front()));
  }
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
