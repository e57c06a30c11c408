// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of connectivity textures in a design: points of the surface become places of a chart's texture.
#include "base/segments.h"
#include "edits/steps.h"
#include "textures/observed_edit.h"

#include <CGAL/Reeb_quadrangulation/chart_texture_edit.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>
#include <CGAL/Reeb_quadrangulation/fit_texture.h>
#include <CGAL/Reeb_quadrangulation/texture_operator.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

bool is_of_whole_texture(Texture_operator o) {
  return o == Texture_operator::subdivide || o == Texture_operator::coarsen;
}

bool is_of_polychord(Texture_operator o) {
  return o == Texture_operator::insert_polychord || o == Texture_operator::delete_polychord;
}

bool has_fraction(Texture_operator o) {
  return is_of_polychord(o) || o == Texture_operator::inset_quads || o == Texture_operator::open_quad ||
         o == Texture_operator::close_quad;
}

Result<void> check(const Edit_texture& edit) {
  const Texture_operator o = edit.operation;
  const std::size_t n = edit.points.size();
  const auto impossible = [](const char* message) {
    return make_error(Error_code::impossible_request, message);
  };
  if (o == Texture_operator::open_quad) {
    if (n != 2) return impossible("two points are needed, one for each edge");
  } else if (o == Texture_operator::inset_quads || o == Texture_operator::delete_quads ||
             o == Texture_operator::restore_quads) {
    if (n == 0) return impossible("a point is needed for each quad");
  } else if (n != 1)
    return impossible("exactly one point is needed");
  if (edit.fraction != 0.5 && !has_fraction(o)) return impossible("the operator has no fraction");
  if (edit.scope == Edit_scope::surface && !is_of_whole_texture(o) && !is_of_polychord(o))
    return impossible("the operator works in one chart");
  return {};
}

Texture_edit operator_at(const Edit_texture& edit, const std::vector<Texture_place>& places) {
  const double at = edit.fraction;
  switch (edit.operation) {
  case Texture_operator::subdivide: return Subdivide_texture{};
  case Texture_operator::coarsen: return Coarsen_texture{};
  case Texture_operator::insert_polychord: return Insert_polychord{places[0], at};
  case Texture_operator::delete_polychord: return Delete_polychord{places[0], at};
  case Texture_operator::inset_quads: return Inset_quads{places, at};
  case Texture_operator::open_quad: return Open_quad{places[0], places[1], at};
  case Texture_operator::close_quad: return Close_quad{places[0], at};
  case Texture_operator::rotate_edge: return Rotate_edge{places[0], true};
  case Texture_operator::rotate_edge_back: return Rotate_edge{places[0], false};
  case Texture_operator::rotate_vertex: return Rotate_vertex{places[0]};
  case Texture_operator::insert_doublet: return Insert_doublet{places[0]};
  case Texture_operator::remove_doublet: return Remove_doublet{places[0]};
  case Texture_operator::delete_quads: return Delete_quads{places};
  case Texture_operator::restore_quads: return Restore_quads{places};
  }
  return Subdivide_texture{};
}

} // namespace

Result<Texture_edit> texture_operator(const Edit_texture& edit, const std::vector<Texture_place>& places) {
  CGAL_precondition(places.size() == edit.points.size());
  if (Result<void> checked = check(edit); !checked) return checked.error();
  return operator_at(edit, places);
}

namespace {

constexpr double most_quads = 1e7; // of a texture

// The textures of a design while an edit changes some of them.
class Texturing {
public:
  explicit Texturing(const Draft& draft) : m_draft(draft) {
    for (const auto& chart : draft.before().charts) m_textures.push_back(&chart->texture);
    m_changed.resize(m_textures.size());
  }

  int number_of_charts() const { return int(m_textures.size()); }
  const Design_chart& chart(int c) const { return *m_draft.before().charts[c]; }
  const Placed_texture& texture(int c) const { return *m_textures[c]; }
  const std::vector<const Placed_texture*>& textures() const { return m_textures; }

  Result<int> chart_at(const std::vector<Surface_point>& points) const {
    if (points.empty()) return make_error(Error_code::impossible_request, "no points are given");
    const int c = m_draft.chart_point_at(points[0].point).chart;
    if (c < 0) return refuse("there is no chart");
    return c;
  }

  // The place of a point in the texture of a chart that contains it.
  Result<Texture_place> place(int c, const Surface_point& at) const {
    const Chart_point found = m_draft.chart_point_at(at.point, c);
    if (found.chart < 0)
      return refuse("the points lie in different charts", {}, Element_kind::chart, chart(c).id);
    const Eigen::Vector2d p = plane_point(*chart(c).chart, *chart(c).map, found.location);
    const Quad_texture& t = texture(c).texture;
    Texture_place place;
    place.v = t.sides.size() == 2 ? p.x() : clamped(p.x(), t.v);
    place.u = clamped(p.y(), t.u);
    return place;
  }

  Result<std::vector<Texture_place>> places(int c, const std::vector<Surface_point>& points) const {
    std::vector<Texture_place> all;
    for (const Surface_point& p : points) {
      if (m_draft.observer() && m_draft.observer()->cancelled())
        return make_error(Error_code::cancelled, "cancelled by the user");
      const Result<Texture_place> found = place(c, p);
      if (!found) return found.error();
      all.push_back(*found);
    }
    return all;
  }

  Result<void> apply(int c, const std::vector<Texture_edit>& edits) {
    if (chart(c).settings.locked)
      return refuse("the edit would change a locked chart", {}, Element_kind::chart, chart(c).id);
    if (std::holds_alternative<Subdivide_texture>(edits.front()) &&
        4.0 * double(texture(c).texture.quads.size()) > most_quads)
      return refuse("the texture would have too many quads", {}, Element_kind::chart, chart(c).id);
    Result<Placed_texture> edited = internal::edit_observed(
        texture(c), *chart(c).chart, *chart(c).map, m_draft.before().samples, edits, m_draft.observer());
    if (!edited) return in_chart(edited.error(), c);
    m_changed[c] = std::make_unique<Placed_texture>(std::move(*edited));
    m_textures[c] = m_changed[c].get();
    return {};
  }

  // False if no vertex comes to lie on the sharp edges that does not already.
  Result<bool> fit(int c, const Feature_edges& features) {
    if (chart(c).settings.locked)
      return refuse("the edit would change a locked chart", {}, Element_kind::chart, chart(c).id);
    Fitted_texture fitted = fit_texture(texture(c), *chart(c).chart, *chart(c).map, features);
    if (fitted.corners + fitted.vertices == 0) return false;
    m_changed[c] = std::make_unique<Placed_texture>(std::move(fitted.texture));
    m_textures[c] = m_changed[c].get();
    return true;
  }

  // The final relaxation leaves a vertex where it has been put.
  void anchor(int c, const Quad_corner& corner) {
    const Quad_texture& t = m_changed[c]->texture;
    const std::size_t v = std::size_t(t.quads[corner.quad][corner.corner]);
    m_changed[c]->anchors.emplace_back(t.v[v], t.u[v]);
  }

  // The vertex of a place, and where it lies.
  Result<Quad_corner> vertex(int c, const Texture_place& place) const {
    const Result<Quad_corner> found = find_vertex(texture(c).texture, place);
    if (!found) return in_chart(found.error(), c);
    return found;
  }

  // Elements of textures have numbers that nobody sees: an error names the chart, and the number in its text.
  Error in_chart(Error error, int c) const {
    if (error.element == Element_kind::face || error.element == Element_kind::vertex)
      error.message += std::string(": ") + (error.element == Element_kind::face ? "quad " : "vertex ") +
                       std::to_string(error.index) + " of the chart's texture";
    error.element = Element_kind::chart;
    error.index = chart(c).id;
    return error;
  }

  Design finish() {
    Design design = m_draft.before();
    for (int c = 0; c < number_of_charts(); ++c) {
      if (!m_changed[c]) continue;
      auto made = std::make_shared<Design_chart>(chart(c));
      made->texture = std::move(*m_changed[c]);
      if (!made->edited) made->texture_id = made->id;
      made->edited = true;
      design.charts[c] = std::move(made);
    }
    return design;
  }

private:
  static double clamped(double x, const std::vector<double>& all) {
    const auto [low, high] = std::minmax_element(all.begin(), all.end());
    return std::min(std::max(x, *low), *high);
  }

  const Draft& m_draft;
  std::vector<const Placed_texture*> m_textures;
  std::vector<std::unique_ptr<Placed_texture>> m_changed;
};

// The polychord goes on across the contours; what is inserted or deleted in one chart leaves the places in
// others alone.
Result<void> apply_through_charts(Texturing& textures, const Draft& draft, int c, const Texture_place& place,
                                  const Edit_texture& edit) {
  const bool inserts = edit.operation == Texture_operator::insert_polychord;
  const Result<std::vector<Chart_polychord>> all =
      polychord_through_charts(draft.atlas(), draft.before().samples, textures.textures(),
                               {c, Insert_polychord{place, inserts ? edit.fraction : 0.5}});
  if (!all) return textures.in_chart(all.error(), c);
  std::map<int, std::vector<Texture_edit>> steps;
  for (const Chart_polychord& part : *all)
    steps[part.chart].push_back(inserts ? Texture_edit(part.edit)
                                        : Delete_polychord{part.edit.edge, edit.fraction});
  for (const auto& [chart, edits] : steps)
    if (Result<void> done = textures.apply(chart, edits); !done) return done;
  return {};
}

} // namespace

Result<Design> with_texture(const Draft& draft, const Edit_texture& edit) {
  if (Result<void> checked = check(edit); !checked) return checked.error();
  Texturing textures(draft);
  const Result<int> chart = textures.chart_at(edit.points);
  if (!chart) return chart.error();
  const Result<std::vector<Texture_place>> places = textures.places(*chart, edit.points);
  if (!places) return places.error();
  const Result<Texture_edit> operation = texture_operator(edit, *places);
  if (!operation) return operation.error();
  if (edit.scope == Edit_scope::surface && is_of_polychord(edit.operation)) {
    if (Result<void> done = apply_through_charts(textures, draft, *chart, places->front(), edit); !done)
      return done.error();
    return textures.finish();
  }
  const bool all = edit.scope == Edit_scope::surface;
  for (int c = all ? 0 : *chart; c < (all ? textures.number_of_charts() : *chart + 1); ++c)
    if (Result<void> done = textures.apply(c, {*operation}); !done) return done.error();
  return textures.finish();
}

Result<Design> with_texture(const Draft& draft, const Drag_vertices& edit) {
  Texturing textures(draft);
  const Result<int> found = textures.chart_at(edit.points);
  if (!found) return found.error();
  const int c = *found;
  const Result<std::vector<Texture_place>> places = textures.places(c, edit.points),
                                           anchors = textures.places(c, edit.anchors);
  if (!places) return places.error();
  if (!anchors) return anchors.error();
  const Result<Quad_corner> first = textures.vertex(c, places->front());
  if (!first) return first.error();
  const Design_chart& chart = textures.chart(c);
  const Quad_texture& texture = textures.texture(c).texture;
  const int vertex = texture.quads[first->quad][first->corner];
  const Chart_location& location = textures.texture(c).location[vertex];
  const Eigen::Vector2d lengths = parameter_lengths(*chart.chart, *chart.map, location);
  if (!(lengths.minCoeff() > 0))
    return refuse("the chart's map is degenerate at the vertex", {}, Element_kind::chart, chart.id);
  Move_vertices move;
  move.vertices = *places;
  move.anchors = *anchors;
  move.radius = edit.radius / lengths.y();
  move.aspect = lengths.x() / lengths.y();
  move.falloff = edit.falloff;
  move.rings = edit.rings;
  move.steps = edit.steps;
  // Exactly to a point in the same chart; else in its direction.
  const Chart_point to = draft.chart_point_at(edit.to.point);
  Eigen::Vector2d way = to.chart == c
                            ? Eigen::Vector2d(plane_point(*chart.chart, *chart.map, to.location) -
                                              Eigen::Vector2d(texture.v[vertex], texture.u[vertex]))
                            : parameter_displacement(*chart.chart, *chart.map, location,
                                                     edit.to.point - position(*chart.chart, location));
  if (texture.sides.size() == 2) way.x() = std::remainder(way.x(), 1.0);
  move.dv = way.x();
  move.du = way.y();
  std::vector<Quad_corner> corners; // found before any of them moves
  for (const Texture_place& place : *places)
    if (const Result<Quad_corner> corner = textures.vertex(c, place)) corners.push_back(*corner);
  if (Result<void> done = textures.apply(c, {move}); !done) return done.error();
  for (const Quad_corner& corner : corners) textures.anchor(c, corner);
  return textures.finish();
}

namespace {

// The inner vertices of a texture within a distance of a point, as corners of quads.
std::vector<Texture_place> vertices_within(const Texturing& textures, int c, const Point& at, double radius) {
  const Placed_texture& placed = textures.texture(c);
  std::vector<char> taken(placed.location.size(), 0);
  for (const std::vector<int>& side : placed.texture.sides)
    for (int v : side) taken[v] = 1;
  std::vector<Texture_place> found;
  for (std::size_t f = 0; f < placed.texture.quads.size(); ++f)
    for (int i = 0; i < 4; ++i) {
      const int v = placed.texture.quads[f][i];
      if (taken[v]) continue;
      taken[v] = 1;
      if ((position(*textures.chart(c).chart, placed.location[v]) - at).norm() <= radius)
        found.push_back({0, 0, int(f), i});
    }
  return found;
}

} // namespace

Result<Design> with_texture(const Draft& draft, const Relax_texture& edit) {
  if (!(edit.radius >= 0) || edit.steps < 1 || edit.steps > internal::most_relaxing_steps)
    return make_error(Error_code::impossible_request,
                      "the radius is not negative, and the steps are 1 to 1000");
  const bool all = edit.scope == Edit_scope::surface;
  if (all && (edit.radius > 0 || !edit.anchors.empty()))
    return make_error(Error_code::impossible_request, "a radius and anchors are for one chart");
  Texturing textures(draft);
  const Result<int> chart = textures.chart_at({edit.at});
  if (!chart) return chart.error();
  const Result<std::vector<Texture_place>> anchors = textures.places(*chart, edit.anchors);
  if (!anchors) return anchors.error();
  Relax_vertices relax{{}, edit.steps, *anchors};
  if (edit.radius > 0) {
    relax.vertices = vertices_within(textures, *chart, edit.at.point, edit.radius);
    if (relax.vertices.empty()) return refuse("no vertex inside the chart's texture is within the radius");
  }
  for (int c = all ? 0 : *chart; c < (all ? textures.number_of_charts() : *chart + 1); ++c)
    if (Result<void> done = textures.apply(c, {relax}); !done) return done.error();
  return textures.finish();
}

namespace {

Result<void> check_feature_angle(double angle) {
  if (angle > 0 && angle <= 180) return {};
  return make_error(Error_code::impossible_request, "the feature angle lies between 0 and 180 degrees");
}

// An angle for a sentence: "45", "22.5".
std::string degrees(double angle) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << angle;
  return text.str();
}

// The sharp edges' corner within `reach`, else their nearest point.
Result<Point> nearest_feature(const Triangle_surface& surface, const Feature_edges& features, const Point& p,
                              double reach) {
  Point best = p;
  double least = reach * reach;
  bool found = false;
  const auto take = [&](const Point& q) {
    if (const double d = (q - p).squaredNorm(); d < least) {
      best = q;
      least = d;
      found = true;
    }
  };
  for (int v : features.corners) take(surface.points[v]);
  if (found) return best;
  least = std::numeric_limits<double>::infinity();
  for (const Feature_chain& chain : features.chains)
    if (!chain.boundary)
      for (int h : chain.halfedges)
        take(nearest_on_segment(p, surface.points[surface.source(h)], surface.points[surface.target(h)]));
  if (!found) return refuse("the surface has no sharp edges");
  return best;
}

// The length of the shortest edge at a texture's vertex, in space.
double shortest_edge(const Texturing& textures, int c, int vertex) {
  const Placed_texture& placed = textures.texture(c);
  const Chart& chart = *textures.chart(c).chart;
  const Point p = position(chart, placed.location[vertex]);
  double least = std::numeric_limits<double>::infinity();
  for (const Quad& q : placed.texture.quads)
    for (int i = 0; i < 4; ++i)
      if (q[i] == vertex)
        for (int j : {1, 3})
          least = std::min(least, (position(chart, placed.location[q[(i + j) % 4]]) - p).norm());
  return least;
}

} // namespace

Result<Design> with_texture(const Draft& draft, const Snap_vertices& edit) {
  if (Result<void> checked = check_feature_angle(edit.feature_angle); !checked) return checked.error();
  Texturing textures(draft);
  const Result<int> found = textures.chart_at(edit.points);
  if (!found) return found.error();
  const int c = *found;
  const Design_chart& chart = textures.chart(c);
  const Result<std::vector<Texture_place>> places = textures.places(c, edit.points);
  if (!places) return places.error();
  std::vector<Quad_corner> corners; // found before any of them moves
  for (const Texture_place& place : *places) {
    const Result<Quad_corner> corner = textures.vertex(c, place);
    if (!corner) return corner.error();
    corners.push_back(*corner);
  }
  const Feature_edges features = feature_edges(draft.surface(), edit.feature_angle);
  for (const Quad_corner& corner : corners) {
    const Quad_texture& texture = textures.texture(c).texture;
    const int vertex = texture.quads[corner.quad][corner.corner];
    const Point from = position(*chart.chart, textures.texture(c).location[vertex]);
    const Result<Point> to =
        nearest_feature(draft.surface(), features, from, 0.5 * shortest_edge(textures, c, vertex));
    if (!to) return to.error();
    const Chart_point target = draft.chart_point_at(*to, c);
    if (target.chart < 0)
      return refuse("the nearest sharp edge lies in another chart", {}, Element_kind::chart, chart.id);
    const Eigen::Vector2d goal = plane_point(*chart.chart, *chart.map, target.location);
    const auto way = [&] {
      const Quad_texture& t = textures.texture(c).texture;
      const double dv = goal.x() - t.v[vertex];
      return Eigen::Vector2d(t.sides.size() == 2 ? std::remainder(dv, 1.0) : dv, goal.y() - t.u[vertex]);
    };
    Move_vertices move;
    move.vertices = {{0, 0, corner.quad, corner.corner}};
    move.dv = way().x();
    move.du = way().y();
    if (Result<void> done = textures.apply(c, {move}); !done) return done.error();
    if (way().norm() > 1e-9)
      return refuse("a vertex cannot reach the sharp edge without inverting a quad", {}, Element_kind::chart,
                    chart.id);
    textures.anchor(c, corner);
  }
  return textures.finish();
}

Result<Design> with_texture(const Draft& draft, const Fit_texture& edit) {
  if (Result<void> checked = check_feature_angle(edit.feature_angle); !checked) return checked.error();
  Texturing textures(draft);
  const Result<int> at = textures.chart_at({edit.at});
  if (!at) return at.error();
  const bool all = edit.scope == Edit_scope::surface;
  const int id = all ? -1 : textures.chart(*at).id;
  bool has_features = false, fitted = false;
  for (int c = all ? 0 : *at; c < (all ? textures.number_of_charts() : *at + 1); ++c) {
    const Feature_edges features =
        features_inside(*textures.chart(c).chart, draft.surface(), edit.feature_angle);
    if (std::all_of(features.chains.begin(), features.chains.end(),
                    [](const Feature_chain& chain) { return chain.boundary; }))
      continue;
    has_features = true;
    const Result<bool> done = textures.fit(c, features);
    if (!done) return done.error();
    fitted = fitted || *done;
  }
  if (!has_features)
    return refuse(all ? "no sharp edge lies inside a chart" : "no sharp edge lies inside the chart",
                  "none of more than " + degrees(edit.feature_angle) + " degrees",
                  all ? Element_kind::none : Element_kind::chart, id);
  if (!fitted)
    return refuse("no further vertex of the texture can be put onto the sharp edges", {},
                  all ? Element_kind::none : Element_kind::chart, id);
  return textures.finish();
}

Result<void> apply_edit(Draft& draft, const Reset_texture& edit) {
  const int at = draft.chart_at(edit.at);
  if (at < 0) return refuse("there is no chart");
  const bool all = edit.scope == Edit_scope::surface;
  for (int c = all ? 0 : at; c < (all ? int(draft.before().charts.size()) : at + 1); ++c) {
    const Design_chart& chart = *draft.before().charts[c];
    if (!chart.edited) continue;
    if (chart.settings.locked)
      return refuse("the edit would change a locked chart", {}, Element_kind::chart, chart.id);
    draft.reset_textures.insert(chart.id);
  }
  if (draft.reset_textures.empty()) return refuse("the texture is a regular one already");
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
