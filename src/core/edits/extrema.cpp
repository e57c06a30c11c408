// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas/chart_lines.h"
#include "base/segments.h"
#include "edits/steps.h"

#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/suggest_extrema.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

std::vector<int> vertices_of(const std::vector<Design_extremum>& extrema, bool maxima) {
  std::vector<int> vertices;
  for (const Design_extremum& e : extrema)
    if (e.is_maximum == maxima) vertices.push_back(e.vertex);
  return vertices;
}

Result<Reeb_layout> layout_with_any_extrema(const Draft& draft, const Designed_field& field) {
  Result<Reeb_layout> layout = make_layout(draft.surface(), field, int(draft.network.edges.size()));
  if (!layout && layout.error().code == Error_code::internal_error)
    return refuse("the field has no layout", layout.error().message);
  return layout;
}

bool is_boundary_vertex(const Triangle_surface& s, int v) {
  return s.is_boundary(s.outgoing[v]);
}

// What becomes of an extremum that the field turns out not to have.
enum class Lost_extrema { are_refused, are_left_out };

// Cuts the whole surface along the contours of a field.
Result<void> cut_along_field(Draft& draft, const Designed_field& field, std::vector<Design_extremum> extrema,
                             Lost_extrema lost) {
  if (Result<void> going_on = draft.begin("layout"); !going_on) return going_on;
  Result<Reeb_layout> layout =
      lost == Lost_extrema::are_refused ? layout_of(draft, field) : layout_with_any_extrema(draft, field);
  if (!layout) return layout.error();
  for (int v : layout->lost_extrema)
    extrema.erase(std::remove_if(extrema.begin(), extrema.end(),
                                 [&](const Design_extremum& e) { return e.vertex == v; }),
                  extrema.end());
  draft.adopt(std::move(*layout));
  draft.extrema = std::move(extrema);
  if (!field.boundary_values.empty()) {
    auto known = std::make_shared<Surface_field>(*draft.field);
    known->boundary_values = field.boundary_values;
    draft.field = std::move(known);
  }
  return {};
}

// What boundary loops are, in the order of `boundary_loops()`.
struct Loop_values {
  std::vector<bool> is_maximum;
  std::map<int, double> given; // see `Designed_field::boundary_values`
};

// Solves the field on the whole surface and cuts it along its own contours.
Result<void> design_surface(Draft& draft, std::vector<Design_extremum> extrema, const Loop_values& loops,
                            Lost_extrema lost = Lost_extrema::are_refused) {
  const Triangle_surface& s = draft.surface();
  sort_by_vertex(extrema);
  for (std::size_t i = 0; i < extrema.size(); ++i) {
    extrema[i].pole = Pole_kind::quarter;
    extrema[i].segment = -1;
    if (i > 0 && extrema[i].vertex == extrema[i - 1].vertex)
      return refuse("two extrema at one vertex", {}, Element_kind::vertex, extrema[i].vertex);
    if (is_boundary_vertex(s, extrema[i].vertex))
      return refuse("an extremum on the boundary", {}, Element_kind::vertex, extrema[i].vertex);
  }
  Designed_field field{{}, vertices_of(extrema, false), vertices_of(extrema, true), loops.is_maximum};
  field.boundary_values = loops.given;
  for (const Design_extremum& e : extrema) field.extremal_values[e.vertex] = e.value;
  if (Result<void> going_on = draft.begin("field"); !going_on) return going_on;
  if (Result<void> solved = draft.solver().solve(field); !solved)
    return refuse("the field cannot be solved", solved.error().message);
  return cut_along_field(draft, field, std::move(extrema), lost);
}

} // namespace

std::vector<bool> present_boundary_kinds(const Draft& draft) {
  std::map<int, bool>
      is_maximum; // of boundary vertices that contours know; a maximum has its chart on the right
  for (std::size_t e = 0; e < draft.atlas().charts_of_edge.size(); ++e) {
    const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
    const Contour_edge& edge = draft.network.edges[e];
    if (!draft.network.is_removed(edge) && (sides[0] < 0 || sides[1] < 0))
      for (int v : edge.vertices) is_maximum[v] = sides[0] < 0;
  }
  std::vector<bool> kinds;
  if (is_maximum.empty()) return kinds;
  for (const std::vector<int>& loop : boundary_loops(draft.surface()))
    kinds.push_back(is_maximum.at(draft.surface().source(loop[0])));
  return kinds;
}

namespace {

// Whether the boundary loops are maxima: as they are now, else as it is suggested.
Result<std::vector<bool>> boundary_kinds(Draft& draft, const Suggestion_options& options) {
  std::vector<bool> present = present_boundary_kinds(draft);
  if (!present.empty() || boundary_loops(draft.surface()).empty()) return present;
  Result<Suggestion> suggestion = suggest_extrema(draft.surface(), options, draft.observer());
  if (!suggestion) return suggestion.error();
  return suggestion->boundary_is_maximum;
}

// The number of the loop that is nearest to a point, or -1 if the surface is closed.
int nearest_loop(const Triangle_surface& surface, const Surface_point& at) {
  int best = -1;
  double least = 0;
  const std::vector<std::vector<int>> loops = boundary_loops(surface);
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (int h : loops[i]) {
      const double d = squared_distance_to_segment(at.point, surface.points[surface.source(h)],
                                                   surface.points[surface.target(h)]);
      if (best < 0 || d < least) best = int(i), least = d;
    }
  return best;
}

// Changes what loops are as it is asked for.
Result<void> set_boundary(const Draft& draft, const std::vector<Boundary_value>& asked, Loop_values& loops) {
  for (const Boundary_value& one : asked) {
    if (!(one.value <= 1))
      return make_error(Error_code::impossible_request, "values of boundary loops are at most 1");
    const int i = nearest_loop(draft.surface(), one.at);
    if (i < 0) return refuse("the surface has no boundary loop");
    loops.is_maximum[std::size_t(i)] = one.is_maximum;
    loops.given.erase(i);
    if (one.value >= 0 && one.value != double(one.is_maximum)) loops.given[i] = one.value;
  }
  return {};
}

// As the loops are now, or as it is suggested, with what is asked for.
Result<Loop_values> loop_values(Draft& draft, const Suggestion_options& options,
                                const std::vector<Boundary_value>& asked = {}) {
  Result<std::vector<bool>> kinds = boundary_kinds(draft, options);
  if (!kinds) return kinds.error();
  Loop_values loops{std::move(*kinds), draft.field ? draft.field->boundary_values : std::map<int, double>()};
  if (Result<void> set = set_boundary(draft, asked, loops); !set) return set.error();
  return loops;
}

Result<void> design_surface(Draft& draft, std::vector<Design_extremum> extrema) {
  Result<Loop_values> loops = loop_values(draft, {});
  if (!loops) return loops.error();
  return design_surface(draft, std::move(extrema), *loops);
}

} // namespace

void sort_by_vertex(std::vector<Design_extremum>& extrema) {
  std::sort(extrema.begin(), extrema.end(),
            [](const Design_extremum& a, const Design_extremum& b) { return a.vertex < b.vertex; });
}

Result<Reeb_layout> layout_of(const Draft& draft, const Designed_field& field) {
  Result<Reeb_layout> layout = layout_with_any_extrema(draft, field);
  if (!layout) return layout;
  if (!layout->lost_extrema.empty())
    return refuse("the field does not have an extremum there", {}, Element_kind::vertex,
                  layout->lost_extrema[0]);
  return layout;
}

Result<void> apply_edit(Draft& draft, const Suggest& edit) {
  Suggestion_options options;
  options.persistence = edit.persistence;
  options.axis = edit.axis;
  if (Result<void> going_on = draft.begin("extrema"); !going_on) return going_on;
  Result<Suggestion> suggestion = suggest_extrema(draft.surface(), options, draft.observer());
  if (!suggestion) return suggestion.error();
  std::vector<Design_extremum> extrema;
  for (const Suggested_extremum& e : suggestion->extrema)
    extrema.push_back({e.vertex, e.is_maximum, e.is_maximum ? 1.0 : 0.0});
  Loop_values loops{suggestion->boundary_is_maximum, {}};
  if (Result<void> set = set_boundary(draft, edit.boundary, loops); !set) return set;
  const Result<void> designed = design_surface(draft, std::move(extrema), loops, Lost_extrema::are_left_out);
  return designed && edit.collapse_thin ? collapse_thin_charts(draft) : designed;
}

Result<void> apply_edit(Draft& draft, const Set_extrema& edit) {
  std::vector<Design_extremum> extrema;
  for (const Set_extrema::Extremum& e : edit.extrema) {
    if (e.value > 1) return make_error(Error_code::impossible_request, "values of extrema are at most 1");
    extrema.push_back({draft.inner_vertex_at(e.at), e.is_maximum,
                       e.value >= 0   ? e.value
                       : e.is_maximum ? 1.0
                                      : 0.0});
  }
  Suggestion_options options;
  options.axis = edit.axis;
  Result<Loop_values> loops = loop_values(draft, options, edit.boundary);
  if (!loops) return loops.error();
  if (!edit.curves.empty() && !loops->given.empty())
    return make_error(Error_code::impossible_request,
                      "beside lines of sharp edges as contours, boundary loops are minima or maxima alone");
  const Result<void> designed =
      edit.curves.empty() ? design_surface(draft, std::move(extrema), *loops)
                          : design_on_curves(draft, std::move(extrema), edit.curves, loops->is_maximum);
  return designed && edit.collapse_thin ? collapse_thin_charts(draft) : designed;
}

Result<void> apply_edit(Draft& draft, const Set_field& edit) {
  const Designed_field& field = *draft.given_field;
  std::vector<Design_extremum> extrema;
  for (const bool is_maximum : {false, true})
    for (int v : is_maximum ? field.maxima : field.minima) {
      if (is_boundary_vertex(draft.surface(), v))
        return refuse("an extremum on the boundary", {}, Element_kind::vertex, v);
      extrema.push_back({v, is_maximum, field.values[std::size_t(v)]});
    }
  sort_by_vertex(extrema);
  if (Result<void> cut = cut_along_field(draft, field, std::move(extrema), Lost_extrema::are_left_out); !cut)
    return cut;
  return edit.collapse_thin ? collapse_thin_charts(draft) : Result<void>();
}

Result<void> apply_edit(Draft& draft, const Change_value& edit) {
  if (!(edit.value >= 0 && edit.value <= 1))
    return make_error(Error_code::impossible_request, "the value of an extremum is between 0 and 1");
  if (const int v = draft.vertex_at(edit.at); is_boundary_vertex(draft.surface(), v)) {
    Result<Loop_values> loops = loop_values(draft, {});
    if (!loops) return loops.error();
    const int loop = nearest_loop(draft.surface(), edit.at);
    const bool is_maximum = edit.value == 1 || (edit.value > 0 && loops->is_maximum[std::size_t(loop)]);
    const Boundary_value asked{edit.at, is_maximum, edit.value};
    if (Result<void> set = set_boundary(draft, {asked}, *loops); !set) return set;
    return design_surface(draft, draft.extrema, *loops);
  }
  const int i = draft.extremum_at(edit.at.point);
  if (i < 0) return refuse("there is no extremum");
  std::vector<Design_extremum> extrema = draft.extrema;
  extrema[i].value = edit.value;
  return design_surface(draft, std::move(extrema));
}

namespace {

// The region between contours as a surface of its own, and the field on it.
struct Region {
  Chart chart;
  std::vector<Design_extremum> extrema; // local vertices
  Designed_field field;
};

double value_of(const Contour_network& network, const Walk& walk) {
  return network.edges[walk.edges[0].edge].value;
}

// The system of the region with its walks and extrema fixed.
Result<Dirichlet_problem> region_problem(const Draft& draft, const Region& region) {
  const Triangle_surface& mesh = region.chart.mesh;
  std::vector<char> is_fixed(mesh.number_of_vertices(), 0);
  for (const Walk& walk : region.chart.walks)
    for (int v : walk.vertices) is_fixed[v] = 1;
  for (const Design_extremum& e : region.extrema) is_fixed[e.vertex] = 1;
  return Dirichlet_problem::factorize(mesh, clamped_cotangent_weights(mesh), is_fixed,
                                      draft.order_of(region.chart), draft.field_solver());
}

// The field with the contours' and the extrema's values.
Result<std::vector<double>> region_field(const Draft& draft, const Region& region,
                                         const Dirichlet_problem& problem) {
  std::vector<double> values(region.chart.mesh.number_of_vertices(), 0.0);
  for (const Walk& walk : region.chart.walks)
    for (int v : walk.vertices) values[v] = value_of(draft.network, walk);
  for (const Design_extremum& e : region.extrema) values[e.vertex] = e.value;
  if (Result<void> solved = problem.solve(region.chart.mesh, values); !solved) return solved.error();
  return values;
}

// What the field lacks at a vertex to be harmonic there.
double flux_at(const Triangle_surface& mesh, const Edge_weights& weights, const std::vector<double>& values,
               int v) {
  double flux = 0;
  const int first = mesh.outgoing[v];
  int h = first;
  do {
    flux += weights.of_halfedge[h] * (values[v] - values[mesh.target(h)]);
    h = mesh.rotate_ccw(h);
  } while (h != first);
  return flux;
}

// How far the field may be lifted at a vertex until a neighbour of a walk or of an extremum reaches its value
// (METHOD: q_max).
double largest_lift(const Draft& draft, const Region& region, const std::vector<double>& u,
                    const std::vector<double>& green, double sign) {
  const Triangle_surface& mesh = region.chart.mesh;
  double largest = std::numeric_limits<double>::infinity();
  const auto bound = [&](int v, double value, bool is_maximum) {
    if (is_maximum != (sign > 0)) return; // the lift only makes this one more pronounced
    const int first = mesh.outgoing[v];
    int h = first;
    do {
      const int w = mesh.target(h);
      if (green[w] > 0) largest = std::min(largest, std::abs(value - u[w]) / green[w]);
      h = mesh.rotate_ccw(h);
    } while (h >= 0 && h != first);
  };
  for (const Walk& walk : region.chart.walks)
    for (int v : walk.vertices) bound(v, value_of(draft.network, walk), walk.side == Side::high);
  for (const Design_extremum& e : region.extrema) bound(e.vertex, e.value, e.is_maximum);
  return largest;
}

// Sets the value of a new extremum, and with it the field.
Result<void> lift(Draft& draft, Region& region, int added, double strength) {
  const Triangle_surface& mesh = region.chart.mesh;
  const auto extremum = std::find_if(region.extrema.begin(), region.extrema.end(),
                                     [&](const Design_extremum& e) { return e.vertex == added; });
  Result<Dirichlet_problem> problem = region_problem(draft, region);
  if (!problem) return refuse("the field cannot be solved", problem.error().message);
  // The response to 1 at the new extremum, and the field as it is without it: with the multiple of the
  // response that leaves no flux.
  std::vector<double> green(mesh.number_of_vertices(), 0.0);
  green[added] = 1;
  if (Result<void> solved = problem->solve(mesh, green); !solved) return solved;
  extremum->value = 0;
  Result<std::vector<double>> u = region_field(draft, region, *problem);
  if (!u) return u.error();
  const double level =
      -flux_at(mesh, problem->weights(), *u, added) / flux_at(mesh, problem->weights(), green, added);
  for (std::size_t v = 0; v < u->size(); ++v) (*u)[v] += level * green[v];
  const Design_extremum mine = *extremum;
  region.extrema.erase(extremum); // it bounds no lift of its own
  const double sign = mine.is_maximum ? 1 : -1, q = largest_lift(draft, region, *u, green, sign);
  if (!std::isfinite(q) || !(q > 0))
    return refuse("there is no room for another extremum", {}, Element_kind::vertex,
                  region.chart.vertex_origin[std::size_t(added)]);
  region.field.values = std::move(*u);
  for (std::size_t v = 0; v < region.field.values.size(); ++v)
    region.field.values[v] += sign * strength * q * green[v];
  region.extrema.push_back(mine);
  region.extrema.back().value = region.field.values[added];
  return {};
}

Result<Region> cut_out(Draft& draft, const std::set<int>& charts, int inside) {
  const Atlas& atlas = draft.atlas();
  std::vector<int> inner;
  for (std::size_t e = 0; e < atlas.charts_of_edge.size(); ++e) {
    const std::array<int, 2> sides = atlas.charts_of_edge[e];
    if (sides[0] != sides[1] && charts.count(sides[0]) && charts.count(sides[1])) inner.push_back(int(e));
  }
  for (int e : inner) remove_edge(draft.network, e);
  const std::vector<int> faces =
      faces_of_charts(draft.surface(), atlas, std::vector<int>(charts.begin(), charts.end()));
  const Result<Embedding> embedding = embed(draft.surface(), draft.network, faces);
  if (!embedding) // without those inside, contours that were told apart may be too near for a double
    return refuse("the contours are too near to each other there", embedding.error().message,
                  Element_kind::face, int(embedding.error().index));
  const std::vector<Triangle>& triangles = embedding->surface.triangles;
  const auto around = std::find_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::find(t.begin(), t.end(), inside) != t.end();
  });
  CGAL_assertion(around != triangles.end());
  Region region;
  Result<Chart> chart =
      cut_region(*embedding, draft.network, draft.extremal_vertices(), int(around - triangles.begin()));
  if (!chart)
    return refuse("the regions between the contours would not all be charts", chart.error().message);
  region.chart = std::move(*chart);
  std::vector<int> local(draft.surface().number_of_vertices(), -1);
  for (std::size_t v = 0; v < region.chart.vertex_origin.size(); ++v)
    if (const int o = region.chart.vertex_origin[v]; o >= 0 && o < int(local.size())) local[o] = int(v);
  for (const Design_extremum& e : draft.extrema)
    if (e.segment < 0 && local[e.vertex] >= 0) {
      region.extrema.push_back(e);
      region.extrema.back().vertex = local[e.vertex];
    }
  return region;
}

std::vector<bool> boundary_kinds(const Region& region) {
  std::vector<bool> high(region.chart.mesh.number_of_vertices(), false), kinds;
  for (const Walk& walk : region.chart.walks)
    for (int v : walk.vertices) high[v] = walk.side == Side::high;
  for (const std::vector<int>& loop : boundary_loops(region.chart.mesh))
    kinds.push_back(high[region.chart.mesh.source(loop[0])]);
  return kinds;
}

/// Whether the field has an extremum or a boundary loop of that kind.
bool has_end(const Designed_field& field, bool is_maximum) {
  const std::vector<bool>& loops = field.boundary_is_maximum;
  return !(is_maximum ? field.maxima : field.minima).empty() ||
         std::find(loops.begin(), loops.end(), is_maximum) != loops.end();
}

} // namespace

Result<void> redesign_region(Draft& draft, const std::set<int>& charts, int inside, int added,
                             double strength) {
  Result<Region> region = cut_out(draft, charts, inside);
  if (!region) return region.error();
  const std::vector<int>& origin = region->chart.vertex_origin;
  if (added >= 0) {
    const int local = int(std::find(origin.begin(), origin.end(), added) - origin.begin());
    if (Result<void> lifted = lift(draft, *region, local, strength); !lifted) return lifted;
  } else {
    Result<Dirichlet_problem> problem = region_problem(draft, *region);
    if (!problem) return refuse("the field cannot be solved", problem.error().message);
    Result<std::vector<double>> values = region_field(draft, *region, *problem);
    if (!values) return values.error();
    region->field.values = std::move(*values);
  }
  region->field.minima = vertices_of(region->extrema, false);
  region->field.maxima = vertices_of(region->extrema, true);
  region->field.boundary_is_maximum = boundary_kinds(*region);
  for (std::vector<int>* list : {&region->field.minima, &region->field.maxima})
    std::sort(list->begin(), list->end());
  for (const bool is_maximum : {false, true}) {
    if (has_end(region->field, is_maximum)) continue;
    const bool is_left = std::any_of(draft.extrema.begin(), draft.extrema.end(),
                                     [&](const Design_extremum& e) { return e.is_maximum == is_maximum; });
    if (!is_left && boundary_loops(draft.surface()).empty())
      return refuse(is_maximum ? "the field needs at least one maximum"
                               : "the field needs at least one minimum",
                    {}, Element_kind::vertex, inside);
    return refuse(std::string("in the charts around nothing would be a ") +
                      (is_maximum ? "maximum" : "minimum"),
                  "change it on the whole surface", Element_kind::vertex, inside);
  }
  const Result<Reeb_layout> layout = make_layout(region->chart.mesh, region->field);
  if (!layout && layout.error().code == Error_code::impossible_request) return refuse(layout.error().message);
  if (!layout) return refuse("too near to another contour", layout.error().message);
  if (!layout->lost_extrema.empty())
    return refuse("there is no room for another extremum", {}, Element_kind::vertex,
                  origin[std::size_t(layout->lost_extrema[0])]);
  std::vector<int> fresh;
  for (std::size_t e = 0; e < layout->network.edges.size(); ++e)
    if (layout->network.nodes[layout->network.edges[e].from].kind != Node_kind::boundary)
      fresh.push_back(int(e));
  Result<std::vector<int>> transferred =
      transfer_contours(draft.surface(), region->chart, layout->network, fresh, draft.network);
  if (!transferred) return transferred.error();
  for (const Design_extremum& e : region->extrema)
    for (Design_extremum& mine : draft.extrema)
      if (mine.vertex == origin[e.vertex]) mine.value = e.value;
  return draft.cut();
}

int cap_contour(const Draft& draft, int chart) {
  const Chart& c = draft.chart(chart);
  if (c.kind != Chart_kind::disc || c.walks[0].edges.size() != 1) return -1;
  const int e = c.walks[0].edges[0].edge;
  const std::array<int, 2> sides = draft.atlas().charts_of_edge[e];
  return draft.is_free_loop(e) && sides[0] >= 0 && sides[1] >= 0 ? e : -1;
}

namespace {

// The charts around a disc's extremum that its cap only divides: the disc, and the annulus (or disc) beyond
// the cap.
std::set<int> polar_charts(const Draft& draft, int disc) {
  std::set<int> charts{disc};
  if (const int cap = cap_contour(draft, disc); cap >= 0)
    charts.insert(chart_across(draft.atlas(), Contour_id(cap), Chart_index(disc)));
  return charts;
}

// And those that meet their contours, or the saddles on them.
std::set<int> with_charts_around(const Draft& draft, const std::set<int>& charts) {
  std::set<int> wider = charts;
  for (int c : charts)
    for (const Walk& walk : draft.chart(c).walks)
      for (const Walk_edge& e : walk.edges) {
        const Contour_edge& edge = draft.network.edges[e.edge];
        for (int node : {edge.from, edge.to})
          for (int around : draft.edges_at(node))
            for (int side : draft.atlas().charts_of_edge[around])
              if (side >= 0) wider.insert(side);
      }
  return wider;
}

// Whether the field on some charts, as one region, has a contour around it or an extremum of each kind.
bool has_both_ends(const Draft& draft, const std::set<int>& charts) {
  std::array<bool, 2> ends{{false, false}};
  for (int c : charts) {
    const Chart& chart = draft.chart(c);
    for (const Walk& walk : chart.walks)
      for (const Walk_edge& e : walk.edges) {
        const std::array<int, 2>& sides = draft.atlas().charts_of_edge[e.edge];
        const bool is_inside = charts.count(sides[0]) && charts.count(sides[1]) && sides[0] != sides[1];
        if (!is_inside) ends[walk.side == Side::high ? 1 : 0] = true;
      }
    for (const Design_extremum& e : draft.extrema)
      if (chart.extremum >= 0 && chart.vertex_origin[chart.extremum] == e.vertex)
        ends[e.is_maximum ? 1 : 0] = true;
  }
  return ends[0] && ends[1];
}

void insert_extremum(Draft& draft, const Design_extremum& e) {
  draft.extrema.push_back(e);
  sort_by_vertex(draft.extrema);
}

Result<void> check_free(const Draft& draft, int vertex) {
  if (is_boundary_vertex(draft.surface(), vertex) || draft.chart_of_vertex(vertex) < 0)
    return refuse("the vertex lies on a contour", {}, Element_kind::vertex, vertex);
  for (const Design_extremum& e : draft.extrema)
    if (e.vertex == vertex) return refuse("two extrema at one vertex", {}, Element_kind::vertex, vertex);
  return {};
}

} // namespace

namespace {

Result<void> add_in_chart(Draft& draft, const Add_extremum& edit, int vertex) {
  if (Result<void> free = check_free(draft, vertex); !free) return free;
  const int chart = draft.chart_of_vertex(vertex);
  insert_extremum(draft, {vertex, edit.is_maximum, 0});
  return redesign_region(draft, polar_charts(draft, chart), vertex, vertex, edit.strength);
}

// A vertex, and some around it at growing distances, at most the length of a quad's edge.
std::vector<int> places_near(const Draft& draft, int vertex) {
  constexpr int rings = 5;
  const Triangle_surface& s = draft.surface();
  std::vector<int> places{vertex};
  for (int v : vertices_around(s, vertex, draft.edge_length)) {
    const double far = (s.points[std::size_t(v)] - s.points[std::size_t(vertex)]).norm();
    if (far >= draft.edge_length * double(places.size()) / rings) places.push_back(v);
  }
  return places;
}

} // namespace

Result<void> apply_edit(Draft& draft, const Add_extremum& edit) {
  if (!(edit.strength > 0 && edit.strength < 1))
    return make_error(Error_code::impossible_request, "the strength of an extremum is between 0 and 1");
  const int vertex = draft.vertex_at(edit.at);
  if (edit.scope == Edit_scope::surface || draft.atlas().charts.empty()) {
    std::vector<Design_extremum> extrema = draft.extrema;
    extrema.push_back({vertex, edit.is_maximum, edit.is_maximum ? 1.0 : 0.0});
    return design_surface(draft, std::move(extrema));
  }
  for (const Design_extremum& e : draft.extrema)
    if (e.vertex == vertex) return refuse("two extrema at one vertex", {}, Element_kind::vertex, vertex);
  Result<void> done;
  for (const int v : places_near(draft, vertex)) {
    Draft trial = draft;
    const Result<void> added = add_in_chart(trial, edit, v);
    if (added) {
      draft.take(std::move(trial));
      return {};
    }
    if (added.error().code != Error_code::refused_edit) return added;
    if (done) done = added;
  }
  return done;
}

Result<void> apply_edit(Draft& draft, const Remove_extremum& edit) {
  const int i = draft.extremum_at(edit.at.point);
  if (i < 0) return refuse("there is no extremum");
  const Design_extremum extremum = draft.extrema[i];
  if (edit.scope == Edit_scope::surface) {
    std::vector<Design_extremum> extrema = draft.extrema;
    extrema.erase(extrema.begin() + i);
    return design_surface(draft, std::move(extrema));
  }
  if (extremum.segment >= 0) return refuse("a half-pole: make it a quarter-pole first");
  const int disc = draft.chart_of_vertex(extremum.vertex);
  draft.extrema.erase(draft.extrema.begin() + i);
  // The charts around the saddle contour that ends the annulus; and more, until the field has both ends.
  std::set<int> charts = with_charts_around(draft, polar_charts(draft, disc));
  while (!has_both_ends(draft, charts)) {
    std::set<int> wider = with_charts_around(draft, charts);
    if (wider.size() == charts.size()) break;
    charts = std::move(wider);
  }
  return redesign_region(draft, charts, extremum.vertex, -1, 0);
}

Result<void> apply_edit(Draft& draft, const Move_extremum& edit) {
  const int i = draft.extremum_at(edit.from.point);
  if (i < 0) return refuse("there is no extremum");
  const int vertex = draft.vertex_at(edit.to);
  Design_extremum extremum = draft.extrema[i];
  if (edit.scope == Edit_scope::surface) {
    std::vector<Design_extremum> extrema = draft.extrema;
    extrema[i].vertex = vertex;
    return design_surface(draft, std::move(extrema));
  }
  if (extremum.segment >= 0) return refuse("a half-pole: make it a quarter-pole first");
  if (Result<void> free = check_free(draft, vertex); !free) return free;
  const std::set<int> charts = polar_charts(draft, draft.chart_of_vertex(extremum.vertex));
  if (!charts.count(draft.chart_of_vertex(vertex)))
    return refuse("the extremum would leave its charts",
                  "remove it and add another, or move it on the whole surface", Element_kind::vertex, vertex);
  draft.extrema.erase(draft.extrema.begin() + i);
  extremum.vertex = vertex;
  insert_extremum(draft, extremum);
  return redesign_region(draft, charts, vertex, -1, 0);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
