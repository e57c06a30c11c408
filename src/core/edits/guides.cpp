// SPDX-License-Identifier: GPL-3.0-or-later
// Guides: strokes that quads follow. Most of them wait until the quads are finished; a closed one may become
// a contour.
#include "edits/steps.h"

#include "base/segments.h"
#include "design/guide_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// Where contours cross an edge of the surface they keep this part of its length from its ends.
constexpr double crossing_margin = 0.02;

// An annulus beside a guide's contour is at least this part of a quad high.
constexpr double least_height = 0.5;

// A closed stroke of which this part runs across the flow may be a contour.
constexpr double level_enough = 0.5;

// The stroke's crossings, without those where it turns back over the edge that it has just crossed.
std::vector<Stroke_crossing> plain_crossings(const Triangle_surface& s, const Stroke& stroke) {
  std::vector<Stroke_crossing> result;
  const auto turns_back = [&](const Stroke_crossing& a, const Stroke_crossing& b) {
    return s.opposite[std::size_t(a.halfedge)] == b.halfedge;
  };
  for (const Stroke_crossing& c : stroke.crossings)
    if (!result.empty() && turns_back(result.back(), c))
      result.pop_back();
    else
      result.push_back(c);
  while (result.size() > 1 && turns_back(result.back(), result.front())) {
    result.pop_back();
    result.erase(result.begin());
  }
  return result;
}

// A closed stroke as a free loop. Its value and its sense are those of a level line.
Result<Contour_edge> loop_along(Draft& draft, const Stroke& stroke) {
  const Triangle_surface& s = draft.surface();
  const std::vector<Stroke_crossing> crossings = plain_crossings(s, stroke);
  if (crossings.size() < 3) return refuse("the stroke goes around nothing");
  const Chart_point inside = draft.chart_point_at(stroke.curve.points.front());
  if (inside.chart < 0) return refuse("there is no chart");
  const Chart& chart = draft.chart(inside.chart);
  Result<std::vector<double>> field = level_field(draft, inside.chart);
  if (!field) return field.error();
  std::vector<double> level(std::size_t(s.number_of_vertices()), -1);
  for (std::size_t v = 0; v < chart.vertex_origin.size(); ++v)
    if (const int o = chart.vertex_origin[v]; o >= 0 && o < int(level.size()))
      level[std::size_t(o)] = (*field)[v];
  Contour_edge edge;
  double rise = 0, sum = 0;
  int number = 0;
  for (const Stroke_crossing& c : crossings) {
    const int r = s.edge(c.halfedge);
    const double t = std::clamp(c.t, crossing_margin, 1 - crossing_margin);
    edge.vertices.push_back(add_crossing(draft.network, {r, c.halfedge == r ? t : 1 - t}));
    edge.faces.push_back(Triangle_surface::face(s.opposite[std::size_t(c.halfedge)]));
    const double right = level[std::size_t(s.source(c.halfedge))],
                 left = level[std::size_t(s.target(c.halfedge))];
    if (left < 0 || right < 0) continue;
    rise += left - right;
    sum += right + c.t * (left - right);
    ++number;
  }
  edge.vertices.push_back(edge.vertices.front());
  edge.from = edge.to = add_node(draft.network, edge.vertices.front());
  const std::array<double, 2> range = value_range(draft, chart);
  edge.value = range[0] + (number > 0 ? sum / number : 0.5) * (range[1] - range[0]);
  if (rise < 0) reverse(edge);
  return edge;
}

// Fails where an annulus beside a contour is too thin for quads.
Result<void> check_room(Draft& draft, int edge) {
  for (const int c : draft.atlas().charts_of_edge[std::size_t(edge)]) {
    if (c < 0 || draft.chart(c).kind != Chart_kind::annulus) continue;
    const Result<std::shared_ptr<const Chart_parameterization>> map = draft.map(c);
    if (!map) return map.error();
    if ((*map)->profile().total() < least_height * draft.edge_length)
      return refuse("the contours would come too near to each other");
  }
  return {};
}

// Cuts a chart along a stroke; returns the contour edge.
Result<int> draw_stroke(Draft& draft, const Stroke& stroke) {
  Result<Contour_edge> loop = loop_along(draft, stroke);
  if (!loop) return loop.error();
  draft.network.edges.push_back(std::move(*loop));
  const int edge = int(draft.network.edges.size()) - 1;
  draft.has_pushed_contours = true;
  if (Result<void> cut = draft.cut(); !cut) return cut.error();
  if (Result<void> capped = check_caps(draft); !capped) return capped.error();
  if (Result<void> room = check_room(draft, edge); !room) return room.error();
  return edge;
}

// Brings a free loop onto a stroke; returns the new contour edge.
Result<int> bring_onto_stroke(Draft& draft, int old, const Stroke& stroke) {
  Result<Contour_edge> loop = loop_along(draft, stroke);
  if (!loop) return loop.error();
  draft.has_pushed_contours = true;
  if (Result<void> replaced = replace_edge(draft, old, std::move(*loop)); !replaced) return replaced.error();
  const int edge = int(draft.network.edges.size()) - 1;
  if (Result<void> room = check_room(draft, edge); !room) return room.error();
  return edge;
}

// The free loop inside the surface that is nearest to a stroke all along it, or -1.
int nearest_loop(const Draft& draft, const Stroke& stroke) {
  constexpr int places = 32;
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < draft.network.edges.size(); ++e) {
    const Contour_edge& edge = draft.network.edges[e];
    if (draft.network.is_removed(edge) || !draft.is_free_loop(int(e))) continue;
    const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
    if (sides[0] < 0 || sides[1] < 0) continue;
    std::vector<Point> points;
    for (int v : edge.vertices) points.push_back(draft.position(v));
    double sum = 0;
    for (int i = 0; i < places; ++i) {
      double d = std::numeric_limits<double>::infinity();
      for (std::size_t k = 1; k < points.size(); ++k)
        d = std::min(d, squared_distance_to_segment(stroke.curve.at(i * stroke.curve.length() / places),
                                                    points[k - 1], points[k]));
      sum += std::sqrt(d);
    }
    if (sum >= least) continue;
    least = sum;
    best = int(e);
  }
  return best;
}

bool is_contour_of_guide(const Draft& draft, int edge) {
  return std::any_of(draft.guides.begin(), draft.guides.end(),
                     [&](const Design_guide& g) { return g.contour == edge; });
}

// A contour along a closed stroke: `own`, if that is there, else a new one, else the nearest that no guide
// has.
Result<int> contour_along(Draft& draft, const Stroke& stroke, int own) {
  Error reason;
  const auto tried = [&](const auto& work) {
    Draft trial = draft;
    Result<int> edge = work(trial);
    if (edge)
      draft.take(std::move(trial));
    else
      reason = edge.error();
    return edge;
  };
  if (own >= 0) return tried([&](Draft& trial) { return bring_onto_stroke(trial, own, stroke); });
  if (Result<int> drawn = tried([&](Draft& trial) { return draw_stroke(trial, stroke); }); drawn)
    return drawn;
  const Error first = reason;
  const int old = nearest_loop(draft, stroke);
  if (old >= 0 && !is_contour_of_guide(draft, old))
    if (Result<int> moved = tried([&](Draft& trial) { return bring_onto_stroke(trial, old, stroke); }); moved)
      return moved;
  return first;
}

// Whether the contour of a guide is there as a loop of its own.
bool has_contour(const Draft& draft, const Design_guide& guide) {
  return guide.contour >= 0 && !draft.network.is_removed(draft.network.edges[std::size_t(guide.contour)]) &&
         draft.is_free_loop(guide.contour);
}

// Takes the contour of a guide away, if it may go.
void remove_contour_of(Draft& draft, Design_guide& guide) {
  if (has_contour(draft, guide)) {
    Draft trial = draft;
    remove_edge(trial.network, guide.contour);
    if (trial.cut() && check_caps(trial)) draft.take(std::move(trial));
  }
  guide.contour = -1;
}

bool wants_contour(const Draft& draft, const Guide& guide, const Stroke& stroke) {
  if (!guide.closed || guide.strength < 1 || guide.way == Guide_way::flow) return false;
  return guide.way == Guide_way::level || !draft.field ||
         level_part(draft.surface(), stroke, draft.field->values) >= level_enough;
}

// Draws the contour of a guide, or says why there is none.
void make_contour(Draft& draft, Design_guide& guide, const Stroke& stroke, std::ostringstream& remark) {
  const bool had = has_contour(draft, guide);
  if (!wants_contour(draft, guide.guide, stroke)) {
    if (had) remove_contour_of(draft, guide);
    guide.contour = -1;
    return;
  }
  Result<int> contour = contour_along(draft, stroke, had ? guide.contour : -1);
  if (!contour && had) {
    remove_contour_of(draft, guide);
    contour = contour_along(draft, stroke, -1);
  }
  guide.contour = contour ? *contour : -1;
  if (contour)
    remark << "The stroke becomes a contour.";
  else
    remark << "No contour can follow the stroke (" << contour.error().message
           << "): lines of quads' edges do when the quads are finished.";
}

// What a guide does, or that it hardly does anything.
void tell(const Draft& draft, const Guide& guide, const Stroke& stroke, std::ostringstream& remark) {
  const double edges = stroke.curve.length() / draft.edge_length;
  if (edges < least_guide_length) {
    remark.str("");
    remark.precision(2);
    remark << "The stroke is " << edges << " edges of quads long: shorter than " << least_guide_length
           << ", it hardly matters.";
  } else if (remark.tellp() == 0) {
    const double level = draft.field ? level_part(draft.surface(), stroke, draft.field->values) : 1;
    const bool rows = guide.way == Guide_way::level || (guide.way == Guide_way::nearer && level >= 0.5);
    remark << (rows ? "Rows" : "Columns") << " of quads come onto the stroke when the quads are finished.";
  }
}

// Lays a guide into the draft, in the place of one that is there if `place` says so.
Result<void> lay(Draft& draft, Design_guide guide, std::size_t place) {
  const Result<Stroke> stroke = trace_stroke(draft.projector(), guide.guide);
  if (!stroke) return stroke.error();
  std::ostringstream remark;
  make_contour(draft, guide, *stroke, remark);
  tell(draft, guide.guide, *stroke, remark);
  draft.remark = remark.str();
  if (place < draft.guides.size())
    draft.guides[place] = std::move(guide);
  else
    draft.guides.push_back(std::move(guide));
  return {};
}

Result<std::size_t> guide_at(const Draft& draft, const Point& p) {
  if (draft.guides.empty()) return refuse("there is no guide");
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < draft.guides.size(); ++i) {
    const Guide& guide = draft.guides[i].guide;
    const std::size_t n = guide.points.size(), ways = guide.closed ? n : n - 1;
    for (std::size_t k = 0; k < ways; ++k)
      if (const double d = squared_distance_to_segment(p, guide.points[k], guide.points[(k + 1) % n]);
          d < least) {
        least = d;
        best = i;
      }
  }
  return best;
}

} // namespace

Result<void> apply_edit(Draft& draft, const Add_guide& edit) {
  return lay(draft, {edit.guide, -1}, draft.guides.size());
}

Result<void> apply_edit(Draft& draft, const Move_guide& edit) {
  const Result<std::size_t> at = guide_at(draft, edit.at.point);
  if (!at) return at.error();
  Design_guide guide = draft.guides[*at];
  if (!edit.points.empty()) guide.guide.points = edit.points;
  if (edit.strength != 0) guide.guide.strength = edit.strength;
  return lay(draft, std::move(guide), *at);
}

Result<void> apply_edit(Draft& draft, const Remove_guide& edit) {
  const Result<std::size_t> at = guide_at(draft, edit.at.point);
  if (!at) return at.error();
  Design_guide guide = draft.guides[*at];
  remove_contour_of(draft, guide);
  draft.guides.erase(draft.guides.begin() + std::ptrdiff_t(*at));
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
