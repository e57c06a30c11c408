// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/offer_after.h>

#include "base/pi.h"
#include "base/segments.h"
#include "editor/hint_measures.h"
#include "editor/surface_ways.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr std::size_t most_tries = 16;

// Parts of a way, of a tilt: what is nearest to the whole comes first.
const std::vector<double> parts{0.875, 0.75, 0.625, 0.5, 0.375, 0.25, 0.125};

std::string digits(double x, int significant) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g", significant, x);
  return buffer;
}

std::string degrees(double radians) {
  const double angle = radians * 180 / pi;
  return digits(angle < 1 ? angle : std::round(angle), 3) + " degrees";
}

std::string percent(double part) {
  return digits(std::round(100 * part), 3) + " %";
}

// The points of a contour or of a part of it, and the plane that fits them best.
struct Plane_of_points {
  Point centre = Point::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // zero if they have none
};

Plane_of_points plane_of(const std::vector<Point>& points) {
  Plane_of_points plane;
  for (const Point& p : points) plane.centre += p / double(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()];
    plane.normal += (p - plane.centre).cross(q - plane.centre);
  }
  if (plane.normal.norm() > 0) plane.normal.normalize();
  return plane;
}

// A turn about a fixed axis that takes one normal to another, whichever way that one points.
struct Turn {
  double angle = 0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX(), from = Eigen::Vector3d::UnitX();

  Turn(const Eigen::Vector3d& begin, Eigen::Vector3d end) : from(begin) {
    end.normalize();
    if (end.dot(begin) < 0) end = -end;
    const Eigen::Vector3d across = begin.cross(end);
    angle = std::atan2(across.norm(), begin.dot(end));
    axis = across.norm() > 0 ? Eigen::Vector3d(across.normalized()) : begin.unitOrthogonal();
  }
  Eigen::Vector3d at(double part) const { return Eigen::AngleAxisd(part * angle, axis) * from; }
};

// Tries edits one after the other until one works.
class Offer_search {
public:
  Offer_search(const Editor& editor, const Error& refusal, Observer* observer)
      : m_editor(editor), m_refusal(refusal), m_observer(observer), m_surface(editor.working_surface()),
        m_design(editor.design()) {}

  Result<std::optional<Offer>> run(const Edit& edit) {
    if (!add_what_comes_first(edit)) std::visit([this](const auto& e) { add(e); }, edit);
    if (m_offers.size() > most_tries) m_offers.resize(most_tries);
    for (Offer& offer : m_offers) {
      if (m_observer && m_observer->cancelled())
        return make_error(Error_code::cancelled, "cancelled by the user");
      const Result<Design> design = m_editor.preview(offer.edit, m_observer);
      if (design) return std::optional<Offer>(std::move(offer));
      if (design.error().code == Error_code::cancelled) return design.error();
    }
    return std::optional<Offer>();
  }

private:
  Surface_point at(int vertex) const { return {m_surface.points[std::size_t(vertex)], vertex}; }
  double length() const { return m_design.edge_length; }
  void offer(Edit edit, std::string words, const Point& place) {
    m_offers.push_back({std::move(edit), std::move(words), place});
  }

  // Edits that an edited texture makes void, so that they are refused.
  static bool needs_regular_texture(const Edit& edit) {
    return std::holds_alternative<Set_columns>(edit) || std::holds_alternative<Set_rows>(edit) ||
           std::holds_alternative<Set_shift>(edit) || std::holds_alternative<Set_grading>(edit) ||
           std::holds_alternative<Move_corner>(edit);
  }

  // The refusal is about a chart that is locked, or whose texture was edited: nothing else helps then.
  bool add_what_comes_first(const Edit& edit) {
    if (m_refusal.element != Element_kind::chart) return false;
    const int c = m_design.index_of(int(m_refusal.index));
    if (c < 0) return false;
    const Design_chart& chart = *m_design.charts[std::size_t(c)];
    const std::optional<Surface_point> inside = point_in(chart);
    if (!inside) return false;
    if (chart.settings.locked)
      offer(Lock_chart{*inside, false}, "Unlock the chart first", inside->point);
    else if (chart.edited && needs_regular_texture(edit))
      offer(Reset_texture{*inside}, "Make the chart's texture regular first", inside->point);
    return !m_offers.empty();
  }

  // A vertex of the surface that lies inside a chart, if it has one.
  std::optional<Surface_point> point_in(const Design_chart& chart) const {
    const Chart& c = *chart.chart;
    std::vector<char> on_walk(c.vertex_origin.size(), 0);
    for (const Walk& walk : c.walks)
      for (int v : walk.vertices) on_walk[std::size_t(v)] = 1;
    for (std::size_t v = 0; v < on_walk.size(); ++v)
      if (const int o = c.vertex_origin[v]; !on_walk[v] && o >= 0 && o < m_surface.number_of_vertices())
        return at(o);
    return std::nullopt;
  }

  // What can be less of a plane: its tilt, and how far it lies from where the contour is.
  void add(const Move_contour& edit) {
    const int e = contour_at(edit.at.point);
    if (e < 0 || !(edit.plane_normal.norm() > 0)) return;
    const std::vector<Point> points = contour_points(m_surface, m_design.network, e);
    if (edit.enforcement == Enforcement::field) {
      Move_contour by_contour = edit;
      by_contour.enforcement = Enforcement::contour;
      offer(by_contour, "Cut the contour into the surface instead", edit.at.point);
    }
    add_smaller_tilts(edit, plane_of(edit.anchors.size() == 2 ? part_of(points, edit) : points),
                      is_free_loop(m_design.network, e) && edit.anchors.empty());
    if (edit.enforcement == Enforcement::field) return;
    Move_contour other = edit;
    other.anchors.clear();
    if (!edit.anchors.empty()) return offer(other, "Move the whole contour instead", edit.at.point);
    other.enforcement = Enforcement::field;
    offer(other, "Let the field follow the plane instead", edit.at.point);
    offer(Straighten_contour{edit.at}, "Straighten the contour instead", edit.at.point);
  }

  // A plane of a saddle's loop or between anchors goes through these: it only turns. Other planes move, too.
  void add_smaller_tilts(const Move_contour& edit, const Plane_of_points& old, bool moves) {
    if (!(old.normal.norm() > 0)) return;
    const Turn turn(old.normal, edit.plane_normal);
    const Point begin = edit.plane_point - old.normal * old.normal.dot(edit.plane_point - old.centre);
    const bool goes_far = moves && (edit.plane_point - begin).norm() > 0.05 * length();
    if (turn.angle < 1e-3 && !goes_far) return;
    for (const double part : parts) {
      Move_contour less = edit;
      less.plane_normal = turn.at(part);
      if (moves) less.plane_point = begin + part * (edit.plane_point - begin);
      offer(less,
            goes_far ? "Move it " + percent(part) + " of the way instead"
                     : "Tilt by " + degrees(part * turn.angle) + " instead",
            edit.at.point);
    }
  }

  // The part of a contour between two anchors that is nearest to the point that moves.
  static std::vector<Point> part_of(const std::vector<Point>& contour, const Move_contour& edit) {
    const auto nearest = [&](const Point& p) {
      const auto nearer = [&](const Point& a, const Point& b) {
        return (a - p).squaredNorm() < (b - p).squaredNorm();
      };
      return std::min_element(contour.begin(), contour.end(), nearer) - contour.begin();
    };
    const auto one = nearest(edit.anchors[0].point), other = nearest(edit.anchors[1].point);
    const auto first = std::min(one, other), last = std::max(one, other);
    const auto at = nearest(edit.at.point);
    if (at >= first && at <= last) return {contour.begin() + first, contour.begin() + last + 1};
    std::vector<Point> rest(contour.begin() + last, contour.end());
    rest.insert(rest.end(), contour.begin(), contour.begin() + first + 1);
    return rest;
  }

  // As a draft finds it.
  int contour_at(const Point& point) const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < m_design.network.edges.size(); ++e)
      for (const auto& [a, b] : segments_of(contour_points(m_surface, m_design.network, int(e))))
        if (const double d = squared_distance_to_segment(point, a, b); d < least) {
          least = d;
          best = int(e);
        }
    return best;
  }

  // Parts of the way on the surface. Elements that lie on contours begin at their nearest vertex.
  template <class Kind, class Set>
  void add_parts_of_way(const Kind& edit, const Surface_point& from, const Surface_point& to,
                        const Set& set) {
    const int begin = nearest_vertex(m_surface, from), end = nearest_vertex(m_surface, to);
    const std::vector<int> way = vertices_on_way(m_surface, begin, end, parts);
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (way[i] < 0) continue;
      Kind less = edit;
      set(less, at(way[i]));
      offer(less, "Move it " + percent(parts[i]) + " of the way instead", at(way[i]).point);
    }
  }

  void add(const Move_saddle& edit) {
    if (!edit.plane_normal.isZero(0))
      offer(Move_saddle{edit.at, edit.to}, "Let its contours find their own planes instead", edit.to.point);
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    const std::vector<char> used = nodes_in_use(m_design.network);
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Contour_node& node = m_design.network.nodes[i];
      if (!used[i] || node.kind != Node_kind::saddle) continue;
      const double d = (m_design.network.position(m_surface, node.vertex) - edit.at.point).squaredNorm();
      if (d < least) {
        least = d;
        best = node.vertex;
      }
    }
    if (best < 0) return;
    const Point saddle = m_design.network.position(m_surface, best);
    add_parts_of_way(edit, {saddle, -1}, edit.to,
                     [](Move_saddle& less, const Surface_point& to) { less.to = to; });
  }

  void add(const Drag_contour& edit) {
    const int e = contour_at(edit.at.point);
    if (e < 0) return;
    const std::vector<Point> points = contour_points(m_surface, m_design.network, e);
    const auto nearer = [&](const Point& a, const Point& b) {
      return (a - edit.to.point).squaredNorm() < (b - edit.to.point).squaredNorm();
    };
    add_parts_of_way(edit, {*std::min_element(points.begin(), points.end(), nearer), -1}, edit.to,
                     [](Drag_contour& less, const Surface_point& to) { less.to = to; });
  }

  void add(const Move_corner& edit) {
    add_parts_of_way(edit, edit.at, edit.to,
                     [](Move_corner& less, const Surface_point& to) { less.to = to; });
  }

  void add(const Move_extremum& edit) {
    if (edit.scope == Edit_scope::surface) return;
    const auto set = [](Move_extremum& less, const Surface_point& to) { less.to = to; };
    add_parts_of_way(edit, edit.from, edit.to, set);
    // Half of the way is more like what was asked for than another field.
    const auto half = std::min(m_offers.size(), std::size_t(4));
    Move_extremum wide = edit;
    wide.scope = Edit_scope::surface;
    m_offers.insert(m_offers.begin() + std::ptrdiff_t(half),
                    {wide, "Move it on the whole surface instead", edit.to.point});
  }

  // Places around one, the nearest first: some at each of a few distances.
  template <class Kind> void add_places_beside(const Kind& edit, const char* verb) {
    const int centre = nearest_vertex(m_surface, edit.at);
    const std::vector<double> rings{0.5, 1, 1.5, 2, 3, 4};
    const std::vector<std::pair<double, int>> around =
        vertices_within(m_surface, centre, (rings.back() + 1) * length());
    const auto first_beyond = [&](double distance) {
      return std::lower_bound(around.begin(), around.end(), std::make_pair(distance, -1)) - around.begin();
    };
    for (const double ring : rings) {
      const auto first = first_beyond(ring * length()), last = first_beyond((ring + 0.5) * length());
      for (const auto i : {first, first + (last - first) / 2}) {
        if (i >= last) break;
        Kind beside = edit;
        beside.at = at(around[std::size_t(i)].second);
        const double far = around[std::size_t(i)].first / length();
        offer(beside, std::string(verb) + " it " + digits(far, 2) + " edge lengths beside instead",
              beside.at.point);
        if (last - first == 1) break;
      }
    }
  }

  void add(const Add_extremum& edit) {
    if (edit.scope == Edit_scope::surface) return add_places_beside(edit, "Add");
    add_places_beside(edit, "Add");
    Add_extremum wide = edit;
    wide.scope = Edit_scope::surface;
    offer(wide, "Add it on the whole surface instead", edit.at.point);
  }

  void add(const Subdivide_chart& edit) { add_places_beside(edit, "Draw"); }

  void add(const Remove_extremum& edit) {
    Remove_extremum wide = edit;
    wide.scope = edit.scope == Edit_scope::chart ? Edit_scope::surface : Edit_scope::chart;
    offer(wide,
          edit.scope == Edit_scope::chart ? "Delete it on the whole surface instead"
                                          : "Delete it in its charts instead",
          edit.at.point);
  }

  void add(const Split_saddle& edit) {
    const double size = edit.size > 0 ? edit.size : length();
    if (!edit.points.empty())
      offer(Split_saddle{edit.at, edit.kind, {}, edit.size}, "Split it where there is room instead",
            edit.at.point);
    for (const double part : {0.5, 0.25})
      offer(Split_saddle{edit.at, edit.kind, {}, part * size},
            "Split it " + percent(part) + " as wide instead", edit.at.point);
    const bool halves = edit.kind == Saddle_kind::half;
    offer(Split_saddle{edit.at, halves ? Saddle_kind::quarter : Saddle_kind::half, {}, edit.size},
          halves ? "Split it in quarters instead" : "Split it in halves instead", edit.at.point);
  }

  void add(const Straighten_contour& edit) {
    const int e = contour_at(edit.at.point);
    if (e < 0) return;
    const Plane_of_points own = plane_of(contour_points(m_surface, m_design.network, e));
    if (own.normal.norm() > 0)
      offer(Move_contour{edit.at, own.centre, own.normal, {}}, "Lay it into a plane instead", edit.at.point);
  }

  void add(const Snap_contour& edit) {
    for (const double angle : {30.0, 20.0, 10.0})
      if (angle < edit.feature_angle)
        offer(Snap_contour{edit.at, angle}, "Snap to edges from " + digits(angle, 2) + " degrees on instead",
              edit.at.point);
  }

  void add(const Set_columns& edit) {
    for (const int off : {2, -2, 4, -4, 6, -6, 8, -8})
      if (edit.columns > 0 && edit.columns + off >= 4)
        offer(Set_columns{edit.at, edit.columns + off}, take(edit.columns + off), edit.at.point);
  }
  void add(const Set_rows& edit) {
    for (const int off : {1, -1, 2, -2, 3, -3, 4, -4})
      if (edit.rows > 0 && edit.rows + off >= 1)
        offer(Set_rows{edit.at, edit.rows + off}, take(edit.rows + off), edit.at.point);
  }
  void add(const Set_target& edit) {
    for (const double factor : {1.1, 1.25, 1.5, 2.0, 3.0})
      if (edit.quads > 0 && factor * edit.quads < 1e8) {
        const int quads = int(std::lround(factor * edit.quads));
        offer(Set_target{quads, 0}, take(quads), m_surface.points[0]);
      }
  }
  static std::string take(int number) { return "Take " + std::to_string(number) + " instead"; }

  // Nothing is like these but nearer.
  template <class Kind> void add(const Kind&) {}

  const Editor& m_editor;
  const Error& m_refusal;
  Observer* m_observer;
  const Triangle_surface& m_surface;
  const Design& m_design;
  std::vector<Offer> m_offers; // not yet tried
};

} // namespace

Result<std::optional<Offer>> offer_after(const Editor& editor, const Edit& edit, const Error& refusal,
                                         Observer* observer) {
  const bool is_refusal =
      refusal.code == Error_code::refused_edit || refusal.code == Error_code::infeasible_sampling;
  if (!is_refusal || editor.design().charts.empty()) return std::optional<Offer>();
  return Offer_search(editor, refusal, observer).run(edit);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
