// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/open_fillings.h"

#include "base/place.h"
#include "base/quad_connectivity.h"

#include <CGAL/Reeb_quadrangulation/Vertex_constraints.h>
#include <CGAL/Reeb_quadrangulation/feature_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// What a turn of a disc's border costs, in quads that are on the wrong side of the loop.
constexpr double price_of_turn = 0.4;

// Angles of quads at the boundary, in degrees, with which the border itself becomes the boundary.
constexpr double least_angle = 40, largest_angle = 140;

// Points of a quad, along each of its sides, that are looked up where its corners do not agree.
constexpr int samples = 4;

// The boundary loop of a filling.
struct Rim {
  Surface_curve curve;
  std::vector<double> corners, angles; // arc lengths where it turns, and the surface's angle there in radians
  Point middle = Point::Zero();        // of the filling
};

// Arc lengths of points in order around a closed curve, increasing: the nearest ones, moved as little as it
// takes to be in order and apart; evenly by chords where the points do not go around the curve once.
std::vector<double> increasing_on(const Surface_curve& curve, const std::vector<Point>& points) {
  const std::size_t n = points.size();
  const double total = curve.length(), gap = 0.2 * total / double(n);
  std::vector<double> t(n), step(n);
  for (std::size_t i = 0; i < n; ++i) t[i] = curve.nearest(points[i], 0, total);
  double sum = 0, chords = 0;
  for (std::size_t i = 0; i < n; ++i) {
    step[i] = std::remainder(t[i] - t[(i + n - 1) % n], total);
    sum += step[i];
    chords += (points[i] - points[(i + n - 1) % n]).norm();
  }
  const std::size_t first = std::size_t(std::max_element(step.begin(), step.end()) - step.begin());
  if (std::abs(sum - total) > 0.01 * total)
    for (std::size_t i = 0; i < n; ++i)
      step[i] = total * (points[i] - points[(i + n - 1) % n]).norm() / chords;
  // Neighbours out of order share their mean: blocks of values and of how many share it.
  std::vector<std::pair<double, std::size_t>> blocks;
  double at = t[first];
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 0) at += step[(first + k) % n];
    blocks.push_back({at - gap * double(k), 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].first > blocks.back().first) {
      const auto last = blocks.back();
      blocks.pop_back();
      auto& into = blocks.back();
      into.first = (into.first * double(into.second) + last.first * double(last.second)) /
                   double(into.second + last.second);
      into.second += last.second;
    }
  }
  std::vector<double> out(n);
  std::size_t k = 0;
  for (const auto& [value, number] : blocks)
    for (std::size_t i = 0; i < number; ++i, ++k) out[(first + k) % n] = value + gap * double(k);
  // The last one stays behind the first.
  const double begin = out[first], used = out[(first + n - 1) % n] - begin;
  if (used > total - gap)
    for (double& x : out) x = begin + (x - begin) * (total - gap) / used;
  return out;
}

class Opening {
public:
  Opening(const Stitched_mesh& quads, const Surface_projector& filled, const Triangle_surface& surface)
      : m_in(quads), m_filled(filled), m_surface(surface), m_region(quads.mesh.quads.size(), -1),
        m_region_at(quads.mesh.points.size(), -1), m_uses(quads.mesh.points.size(), 0) {}

  Result<Stitched_mesh> run() {
    connect_quads(quads(), int(points().size()), m_opposite);
    m_at.resize(points().size());
    for (int h = 0; h < int(m_opposite.size()); ++h) m_at[std::size_t(source(quads(), h))].push_back(h / 4);
    find_fillings();
    measure_quads();
    for (std::size_t k = 0; k < m_rims.size(); ++k)
      if (Result<void> chosen = choose_disc(int(k)); !chosen) return chosen.error();
    m_out = m_in;
    for (std::size_t k = 0; k < m_rims.size(); ++k) move_border(int(k));
    leave_out();
    return std::move(m_out);
  }

private:
  const std::vector<Quad>& quads() const { return m_in.mesh.quads; }
  const std::vector<Point>& points() const { return m_in.mesh.points; }

  // The faces of a filling are connected, and each filling borders on one loop.
  void find_fillings() {
    const Triangle_surface& all = m_filled.surface();
    const int first = m_surface.number_of_faces();
    m_filling_of_face.assign(std::size_t(all.number_of_faces()), -1);
    std::vector<int> loop_at(std::size_t(m_surface.number_of_vertices()), -1);
    const std::vector<std::vector<int>> loops = boundary_loops(m_surface);
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (int h : loops[l]) loop_at[std::size_t(m_surface.source(h))] = int(l);
    for (int f = first; f < all.number_of_faces(); ++f) {
      if (m_filling_of_face[std::size_t(f)] >= 0) continue;
      const int k = int(m_rims.size());
      int loop = -1;
      double area_sum = 0;
      Point middle = Point::Zero();
      std::vector<int> list{f};
      m_filling_of_face[std::size_t(f)] = k;
      for (std::size_t i = 0; i < list.size(); ++i) {
        const double a = area(all, list[i]);
        area_sum += a;
        for (int j = 0; j < 3; ++j) {
          const int v = all.triangles[std::size_t(list[i])][std::size_t(j)];
          middle += a / 3 * all.points[std::size_t(v)];
          if (v < int(loop_at.size()) && loop_at[std::size_t(v)] >= 0) loop = loop_at[std::size_t(v)];
          const int o = all.opposite[std::size_t(3 * list[i] + j)];
          if (o < 3 * first || m_filling_of_face[std::size_t(o / 3)] >= 0) continue;
          m_filling_of_face[std::size_t(o / 3)] = k;
          list.push_back(o / 3);
        }
      }
      m_rims.push_back(rim_of(loops[std::size_t(loop)]));
      m_rims.back().middle = area_sum > 0 ? Point(middle / area_sum) : m_rims.back().curve.points.front();
    }
  }

  Rim rim_of(const std::vector<int>& loop) const {
    Rim rim;
    const std::vector<int> corners = feature_edges(m_surface, 0).corners;
    std::vector<Point> line;
    double arc = 0;
    for (int h : loop) {
      line.push_back(m_surface.points[std::size_t(m_surface.source(h))]);
      if (std::binary_search(corners.begin(), corners.end(), m_surface.source(h))) {
        rim.corners.push_back(arc);
        rim.angles.push_back(angle_at(h));
      }
      arc += (m_surface.points[std::size_t(m_surface.target(h))] - line.back()).norm();
    }
    line.push_back(line.front());
    rim.curve = make_surface_curve(line, true);
    return rim;
  }

  // Of all faces at the boundary vertex where a boundary halfedge begins.
  double angle_at(int h) const {
    double sum = 0;
    for (int g = h; g >= 0; g = m_surface.rotate_ccw(g)) {
      const Point& p = m_surface.points[std::size_t(m_surface.source(g))];
      const Point a = m_surface.points[std::size_t(m_surface.target(g))] - p,
                  b = m_surface.points[std::size_t(m_surface.source(Triangle_surface::previous(g)))] - p;
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum;
  }

  // The filling at a point of a quad, or -1: of the sheets that lie close together that which faces as it
  // does.
  int filling_at(const Point& p, const Point& normal) const {
    Closest_point c = m_filled.closest_compatible(p, normal, 0.1);
    if (c.face < 0) c = m_filled.closest(p);
    return m_filling_of_face[std::size_t(c.face)];
  }

  // Which part of each quad lies in which filling.
  void measure_quads() {
    m_parts.resize(quads().size());
    std::vector<int> at_vertex(points().size(), -2);
    for (std::size_t q = 0; q < quads().size(); ++q) {
      const Quad& v = quads()[q];
      const auto& p = points();
      const Point normal = (p[std::size_t(v[2])] - p[std::size_t(v[0])])
                               .cross(p[std::size_t(v[3])] - p[std::size_t(v[1])])
                               .normalized();
      std::map<int, double> found;
      const auto at = [&](double s, double t) {
        const Point x = (1 - t) * ((1 - s) * p[std::size_t(v[0])] + s * p[std::size_t(v[1])]) +
                        t * ((1 - s) * p[std::size_t(v[3])] + s * p[std::size_t(v[2])]);
        return filling_at(x, normal);
      };
      const int centre = at(0.5, 0.5);
      bool agree = true;
      for (const auto& [s, t] :
           {std::pair(0.05, 0.05), std::pair(0.95, 0.05), std::pair(0.95, 0.95), std::pair(0.05, 0.95)})
        agree = agree && at(s, t) == centre;
      if (agree)
        found[centre] = 1;
      else
        for (int i = 0; i < samples; ++i)
          for (int j = 0; j < samples; ++j)
            found[at((i + 0.5) / samples, (j + 0.5) / samples)] += 1.0 / (samples * samples);
      for (const auto& [k, part] : found)
        if (k >= 0) m_parts[q].push_back({k, part});
    }
  }

  double part(int q, int k) const {
    for (const auto& [filling, part] : m_parts[std::size_t(q)])
      if (filling == k) return part;
    return 0;
  }

  int neighbour(int q, int i) const {
    const int o = m_opposite[std::size_t(4 * q + i)];
    return o < 0 ? -1 : o / 4;
  }

  // Whether the quads of a disc that a quad touches, without itself, touch it along one line of its edges:
  // then the disc stays one with it and without it.
  bool is_simple(int q, int k) const {
    std::array<bool, 4> edge, vertex;
    int edges = 0, runs = 0;
    for (int i = 0; i < 4; ++i) {
      const int n = neighbour(q, i);
      if (n < 0 || n == q) return false;
      edge[std::size_t(i)] = m_region[std::size_t(n)] == k;
      edges += edge[std::size_t(i)];
      const int v = quads()[std::size_t(q)][std::size_t(i)];
      const int uses = m_region_at[std::size_t(v)] == k ? m_uses[std::size_t(v)] : 0;
      vertex[std::size_t(i)] = uses > (m_region[std::size_t(q)] == k ? 1 : 0);
      if (m_region_at[std::size_t(v)] >= 0 && m_region_at[std::size_t(v)] != k) return false;
    }
    for (int i = 0; i < 4; ++i) runs += edge[std::size_t(i)] && !edge[std::size_t((i + 1) % 4)];
    if (edges == 0 || edges == 4 || runs != 1) return false;
    for (int i = 0; i < 4; ++i)
      if (vertex[std::size_t(i)] && !edge[std::size_t(i)] && !edge[std::size_t((i + 3) % 4)]) return false;
    return true;
  }

  void put(int q, int k) {
    const int old = m_region[std::size_t(q)];
    for (int v : quads()[std::size_t(q)]) {
      int& uses = m_uses[std::size_t(v)];
      uses += (k >= 0) - (old >= 0);
      m_region_at[std::size_t(v)] = uses > 0 ? std::max(k, old) : -1;
    }
    m_region[std::size_t(q)] = k;
  }

  // How far a vertex of the border is from two quads outside of the disc.
  double turn_at(int v, int k) const {
    int inside = 0;
    for (int q : m_at[std::size_t(v)]) inside += m_region[std::size_t(q)] == k;
    const int outside = int(m_at[std::size_t(v)].size()) - inside;
    return inside == 0 || outside == 0 ? 0 : std::abs(outside - 2);
  }
  double turns_at(int q, int k) const {
    double sum = 0;
    for (int v : quads()[std::size_t(q)]) sum += turn_at(v, k);
    return sum;
  }

  Result<void> choose_disc(int k) {
    int seed = -1;
    std::pair<double, double> best(0, 0);
    for (int q = 0; q < int(quads().size()); ++q) {
      const double p = part(q, k);
      if (p <= 0 || std::any_of(quads()[std::size_t(q)].begin(), quads()[std::size_t(q)].end(),
                                [&](int v) { return m_region_at[std::size_t(v)] >= 0; }))
        continue;
      Point middle = Point::Zero();
      for (int v : quads()[std::size_t(q)]) middle += points()[std::size_t(v)] / 4;
      const std::pair<double, double> rank(p, -(middle - m_rims[std::size_t(k)].middle).norm());
      if (seed < 0 || rank > best) seed = q, best = rank;
    }
    if (seed < 0)
      return make_error(Error_code::impossible_request,
                        "no quad lies in the filling of the boundary loop at " +
                            place(m_rims[std::size_t(k)].curve.points.front()) +
                            ", or only such as touch another filling: ask for more quads");
    put(seed, k);
    std::vector<int> list{seed};
    for (std::size_t i = 0; i < list.size(); ++i)
      for (int j = 0; j < 4; ++j) {
        const int n = neighbour(list[i], j);
        if (n < 0 || m_region[std::size_t(n)] >= 0 || part(n, k) < 0.5 || !is_simple(n, k)) continue;
        put(n, k);
        list.push_back(n);
        // What was no simple neighbour before may be one now.
        for (int l = 0; l < 4; ++l)
          if (const int m = neighbour(n, l); m >= 0 && m_region[std::size_t(m)] == k) list.push_back(m);
      }
    straighten(k);
    return {};
  }

  // Quads change sides one by one, as long as that pays.
  void straighten(int k) {
    for (int pass = 0; pass < 40; ++pass) {
      bool changed = false;
      for (int q = 0; q < int(quads().size()); ++q) {
        const bool inside = m_region[std::size_t(q)] == k;
        if (!inside && (m_region[std::size_t(q)] >= 0 || part(q, k) <= 0)) {
          bool beside = false;
          for (int i = 0; i < 4; ++i)
            if (const int n = neighbour(q, i); n >= 0) beside = beside || m_region[std::size_t(n)] == k;
          if (!beside || m_region[std::size_t(q)] >= 0) continue;
        }
        if (!is_simple(q, k)) continue;
        const double before = price_of_turn * turns_at(q, k), wrong = inside ? 1 - part(q, k) : part(q, k);
        put(q, inside ? -1 : k);
        const double after = price_of_turn * turns_at(q, k);
        if (after + (1 - wrong) < before + wrong - 1e-9)
          changed = true;
        else
          put(q, inside ? k : -1);
      }
      if (!changed) return;
    }
  }

  // The border of a disc as vertices, with the quads that stay on the left.
  std::vector<int> border_of(int k) const {
    std::map<int, int> next;
    for (int h = 0; h < int(m_opposite.size()); ++h)
      if (m_region[std::size_t(h / 4)] != k && m_opposite[std::size_t(h)] >= 0 &&
          m_region[std::size_t(m_opposite[std::size_t(h)] / 4)] == k)
        next[source(quads(), h)] = target(quads(), h);
    std::vector<int> line;
    for (int v = next.begin()->first; line.empty() || v != line.front(); v = next.at(v)) line.push_back(v);
    return line;
  }

  // Whether the quads that stay at each vertex of the border share the surface's angle there well.
  bool fits(const std::vector<int>& border, const std::vector<double>& t, int k) const {
    const Rim& rim = m_rims[std::size_t(k)];
    std::vector<double> angle(border.size(), std::acos(-1.0));
    for (std::size_t c = 0; c < rim.corners.size(); ++c) {
      const auto gap = [&](std::size_t i) {
        return std::abs(std::remainder(t[i] - rim.corners[c], rim.curve.length()));
      };
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < t.size(); ++i)
        if (gap(i) < gap(nearest)) nearest = i;
      angle[nearest] = rim.angles[c];
    }
    const double degree = std::acos(-1.0) / 180;
    for (std::size_t i = 0; i < border.size(); ++i) {
      int outside = 0;
      for (int q : m_at[std::size_t(border[i])]) outside += m_region[std::size_t(q)] < 0;
      const double each = angle[i] / outside;
      if (each < least_angle * degree || each > largest_angle * degree) return false;
    }
    return true;
  }

  void move_border(int k) {
    const std::vector<int> border = border_of(k);
    const Surface_curve& curve = m_rims[std::size_t(k)].curve;
    std::vector<Point> line;
    for (int v : border) line.push_back(points()[std::size_t(v)]);
    const std::vector<double> t = increasing_on(curve, line);
    const int n = int(border.size()), first = int(m_out.mesh.points.size());
    if (fits(border, t, k)) {
      for (int i = 0; i < n; ++i)
        m_out.mesh.points[std::size_t(border[std::size_t(i)])] = curve.at(t[std::size_t(i)]);
      return;
    }
    // A ring: the border stays inside, its image lies on the loop.
    for (double arc : t) m_out.mesh.points.push_back(curve.at(arc));
    std::map<std::pair<int, int>, int> chart;
    for (int h = 0; h < int(m_opposite.size()); ++h)
      if (m_opposite[std::size_t(h)] >= 0 && m_region[std::size_t(m_opposite[std::size_t(h)] / 4)] == k)
        chart[{source(quads(), h), target(quads(), h)}] = m_in.chart_of_quad[std::size_t(h / 4)];
    for (int i = 0; i < n; ++i) {
      const int a = border[std::size_t(i)], b = border[std::size_t((i + 1) % n)];
      m_ring.push_back({first + i, first + (i + 1) % n, b, a});
      m_ring_chart.push_back(chart.at({a, b}));
      m_out.mesh.points[std::size_t(a)] = inward(a, m_out.mesh.points[std::size_t(first + i)]);
    }
  }

  // Halfway from the loop to the vertices that stay.
  Point inward(int v, const Point& on_loop) const {
    Point sum = Point::Zero();
    int number = 0;
    for (int q : m_at[std::size_t(v)]) {
      if (m_region[std::size_t(q)] >= 0) continue;
      for (int w : quads()[std::size_t(q)])
        if (m_region_at[std::size_t(w)] < 0) {
          sum += points()[std::size_t(w)];
          ++number;
        }
    }
    return number > 0 ? Point(0.5 * (on_loop + sum / number)) : points()[std::size_t(v)];
  }

  // Valence -> vertices inside.
  static std::map<int, int> valences_of(const std::vector<Quad>& quads, std::size_t vertices) {
    std::vector<int> opposite, valence(vertices, 0);
    connect_quads(quads, int(vertices), opposite);
    for (int h = 0; h < int(opposite.size()); ++h) ++valence[std::size_t(source(quads, h))];
    for (int h = 0; h < int(opposite.size()); ++h)
      if (opposite[std::size_t(h)] < 0) valence[std::size_t(source(quads, h))] = 0;
    std::map<int, int> out;
    for (int v : valence)
      if (v > 0) ++out[v];
    return out;
  }

  void leave_out() {
    const std::map<int, int> before = valences_of(quads(), points().size());
    std::vector<Quad> kept;
    std::vector<int> charts;
    for (std::size_t q = 0; q < quads().size(); ++q)
      if (m_region[q] < 0) {
        kept.push_back(quads()[q]);
        charts.push_back(m_in.chart_of_quad[q]);
      }
    kept.insert(kept.end(), m_ring.begin(), m_ring.end());
    charts.insert(charts.end(), m_ring_chart.begin(), m_ring_chart.end());
    std::vector<int> number(m_out.mesh.points.size(), -1);
    for (const Quad& q : kept)
      for (int v : q) number[std::size_t(v)] = 0;
    std::vector<Point> places;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (number[v] == 0) {
        number[v] = int(places.size());
        places.push_back(m_out.mesh.points[v]);
      }
    for (Quad& q : kept)
      for (int& v : q) v = number[std::size_t(v)];
    m_out.mesh = {std::move(places), std::move(kept)};
    m_out.chart_of_quad = std::move(charts);
    for (int& v : m_out.node_vertex)
      if (v >= 0) v = number[std::size_t(v)];
    for (std::vector<int>* list : {&m_out.extraordinary, &m_out.interpolated, &m_out.held_vertices}) {
      std::vector<int> left;
      for (int v : *list)
        if (number[std::size_t(v)] >= 0) left.push_back(number[std::size_t(v)]);
      *list = std::move(left);
    }
    if (m_out.holes > 0) m_out.components = quad_components(m_out.mesh.quads, int(m_out.mesh.points.size()));
    std::map<int, int>& predicted = m_out.valences;
    for (const auto& [valence, count] : valences_of(m_out.mesh.quads, m_out.mesh.points.size()))
      if (valence != 4) predicted[valence] += count;
    for (const auto& [valence, count] : before)
      if (valence != 4) predicted[valence] -= count;
    predicted.erase(4); // how many are regular depends on the cut
    for (auto entry = predicted.begin(); entry != predicted.end();)
      entry = entry->second == 0 ? predicted.erase(entry) : std::next(entry);
  }

  const Stitched_mesh& m_in;
  const Surface_projector& m_filled;
  const Triangle_surface& m_surface;
  std::vector<int> m_opposite;
  std::vector<std::vector<int>> m_at; // per vertex: its quads
  std::vector<int> m_filling_of_face;
  std::vector<Rim> m_rims;                                  // per filling
  std::vector<std::vector<std::pair<int, double>>> m_parts; // per quad: fillings and its part in each
  std::vector<int> m_region;                                // per quad: the disc that it is of, or -1
  std::vector<int> m_region_at, m_uses; // per vertex: a disc at it, and how many quads of that
  std::vector<Quad> m_ring;
  std::vector<int> m_ring_chart;
  Stitched_mesh m_out;
};

} // namespace

Result<Stitched_mesh> open_fillings(const Stitched_mesh& quads, const Surface_projector& filled,
                                    const Triangle_surface& surface) {
  return Opening(quads, filled, surface).run();
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
