// SPDX-License-Identifier: GPL-3.0-or-later
#include "mend/weld.h"

#include "base/equal_points.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {

double weld_distance(const std::vector<Point>& points, const std::vector<int>& corners, double asked) {
  if (asked >= 0) return asked;
  Eigen::AlignedBox3d box;
  for (int v : corners)
    if (points[v].allFinite()) box.extend(points[v]);
  const double distance = box.isEmpty() ? 0 : 1e-6 * box.diagonal().norm();
  return std::isfinite(distance) ? distance : 0;
}

std::vector<char> border_points(const Corner_mesh& mesh, const Edge_groups& edges, int number_of_points) {
  std::vector<char> border(std::size_t(number_of_points), 0);
  for (int e = 0; e < edges.number_of_edges(); ++e)
    if (edges.size(e) != 2) border[mesh.source[edges.first(e)]] = border[mesh.target(edges.first(e))] = 1;
  return border;
}

namespace {

/// The points near each other among those that are marked.
std::vector<int> near_marked_points(const std::vector<Point>& points, const std::vector<char>& marked,
                                    double distance) {
  std::vector<Point> some;
  std::vector<int> ids, into(points.size());
  std::iota(into.begin(), into.end(), 0);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (marked[v]) {
      some.push_back(points[v]);
      ids.push_back(int(v));
    }
  const std::vector<int> first = first_near_points(some, distance);
  for (std::size_t i = 0; i < ids.size(); ++i) into[ids[i]] = ids[first[i]];
  return into;
}

/// What joining points would do to the edges at them.
struct Effect {
  std::vector<char> useful;  ///< it closes an edge
  std::vector<char> harmful; ///< it gives an edge more than two faces, or a face a repeated corner
};

Effect effect_of(const std::vector<int>& into, const std::vector<Triangle>& triangles) {
  std::vector<Triangle> joined = triangles;
  for (Triangle& t : joined)
    for (int& v : t) v = into[v];
  const Corner_mesh mesh = corner_mesh(joined);
  const Edge_groups edges = group_edges(mesh, int(into.size()));
  Effect effect{std::vector<char>(into.size(), 0), std::vector<char>(into.size(), 0)};
  const auto old_edge = [&](int side) {
    const int a = triangles[side / 3][side % 3], b = triangles[side / 3][(side + 1) % 3];
    return std::make_pair(std::min(a, b), std::max(a, b));
  };
  // Faces that come to lie on each other are one: a copy is dropped later.
  const auto different_faces = [&](int e) {
    std::vector<Triangle> faces;
    for (int i = edges.begin[e]; i < edges.begin[e + 1]; ++i) {
      faces.push_back(joined[edges.side[i] / 3]);
      std::sort(faces.back().begin(), faces.back().end());
    }
    std::sort(faces.begin(), faces.end());
    return std::unique(faces.begin(), faces.end()) - faces.begin();
  };
  for (int e = 0; e < edges.number_of_edges(); ++e) {
    const int first = edges.first(e), a = mesh.source[first], b = mesh.target(first);
    bool changed = a == b;
    for (int i = edges.begin[e] + 1; i < edges.begin[e + 1]; ++i)
      changed |= old_edge(edges.side[i]) != old_edge(first);
    if (!changed) continue;
    std::vector<char>& list = a == b || different_faces(e) > 2 ? effect.harmful : effect.useful;
    list[a] = list[b] = 1;
  }
  return effect;
}

} // namespace

std::vector<int> near_border_points(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                                    double distance) {
  const Corner_mesh mesh = corner_mesh(triangles);
  const Edge_groups edges = group_edges(mesh, int(points.size()));
  std::vector<int> none(points.size());
  std::iota(none.begin(), none.end(), 0);
  std::vector<int> into =
      near_marked_points(points, border_points(mesh, edges, int(points.size())), distance);
  // Taking a point back may open what another one closed: a few rounds, and nothing if they do not end.
  for (int round = 0; round < 16; ++round) {
    if (into == none) return into;
    const Effect effect = effect_of(into, triangles);
    bool changed = false;
    for (int v = 0; v < int(points.size()); ++v)
      if (into[v] != v && (effect.harmful[into[v]] || !effect.useful[into[v]])) {
        into[v] = v;
        changed = true;
      }
    if (!changed) return into;
  }
  return none;
}

namespace {

class Welder {
public:
  Welder(Loose_triangles& soup, double distance, std::vector<char>& merged, std::vector<Mend>& mends)
      : m_soup(soup), m_distance(distance), m_merged(merged), m_mends(mends) {
    m_merged.assign(soup.points.size(), 0);
  }

  void run() {
    merge_equal();
    if (m_distance > 0) merge_near();
    if (std::find(m_merged.begin(), m_merged.end(), 1) != m_merged.end()) merge_double_sheets();
    drop_repeated_corners();
  }

private:
  void drop_repeated_corners() {
    say(m_mends, m_soup.drop_repeated_corners(), "face whose corners were merged was dropped",
        "faces whose corners were merged were dropped");
  }

  int number_of_points() const { return m_soup.number_of_points(); }

  std::int64_t merge(const std::vector<int>& into) {
    std::int64_t merged = 0;
    for (int v = 0; v < number_of_points(); ++v)
      if (into[v] != v) {
        ++merged;
        m_merged[v] = 1;
      }
    if (merged > 0)
      for (Triangle& t : m_soup.triangles)
        for (int& v : t) v = into[v];
    return merged;
  }

  void merge_equal() {
    const Corner_mesh mesh = corner_mesh(m_soup.triangles);
    const std::vector<char> border =
        border_points(mesh, group_edges(mesh, number_of_points()), number_of_points());
    say(m_mends, merge(near_marked_points(m_soup.points, border, 0)),
        "point was merged with one of equal coordinates",
        "points were merged with others of equal coordinates");
    drop_repeated_corners();
  }

  void merge_near() {
    const std::vector<int> into = near_border_points(m_soup.points, m_soup.triangles, m_distance);
    double farthest = 0;
    for (int v = 0; v < number_of_points(); ++v)
      farthest = std::max(farthest, (m_soup.points[v] - m_soup.points[into[v]]).norm());
    const std::int64_t welded = merge(into);
    char far[32];
    std::snprintf(far, sizeof far, "%.2g", farthest);
    if (welded > 0)
      m_mends.push_back({welded, text_of_count(welded, "point was", "points were") +
                                     " welded with others that lay at most " + far + " away"});
  }

  // The front and the back of a panel, each with points of its own: after the rims are one, all its faces
  // lie on others, but the points inside are apart still.
  void merge_double_sheets() {
    const int n = m_soup.number_of_triangles();
    const std::vector<int> component = components();
    const std::vector<int> into =
        near_marked_points(m_soup.points, std::vector<char>(m_soup.points.size(), 1), m_distance);
    const auto place = [&](int f) {
      Triangle t = m_soup.triangles[f];
      for (int& v : t) v = into[v];
      std::sort(t.begin(), t.end());
      return t;
    };
    std::vector<std::array<int, 5>> faces; // component, place, face
    for (int f = 0; f < n; ++f) {
      const Triangle t = place(f);
      faces.push_back({component[f], t[0], t[1], t[2], f});
    }
    std::sort(faces.begin(), faces.end());
    const auto same = [&](std::size_t i, std::size_t j) {
      return i < faces.size() && j < faces.size() &&
             std::equal(faces[i].begin(), faces[i].begin() + 4, faces[j].begin());
    };
    std::vector<char> is_double(std::size_t(n), 1); // per component, by its smallest face
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (!same(i, i + 1) && !(i > 0 && same(i, i - 1))) is_double[faces[i][0]] = 0;
    std::vector<int> joined(m_soup.points.size());
    std::iota(joined.begin(), joined.end(), 0);
    for (int f = 0; f < n; ++f)
      if (is_double[component[f]])
        for (int v : m_soup.triangles[f]) joined[v] = into[v];
    say(m_mends, merge(joined), "point was merged between the two sides of a double sheet",
        "points were merged between the two sides of double sheets");
  }

  std::vector<int> components() const {
    const Corner_mesh mesh = corner_mesh(m_soup.triangles);
    const Edge_groups edges = group_edges(mesh, number_of_points());
    Disjoint_sets sets(m_soup.number_of_triangles());
    for (int e = 0; e < edges.number_of_edges(); ++e)
      for (int i = edges.begin[e] + 1; i < edges.begin[e + 1]; ++i)
        sets.join(edges.first(e) / 3, edges.side[i] / 3);
    std::vector<int> component;
    for (int f = 0; f < m_soup.number_of_triangles(); ++f) component.push_back(sets.find(f));
    return component;
  }

  Loose_triangles& m_soup;
  const double m_distance;
  std::vector<char>& m_merged;
  std::vector<Mend>& m_mends;
};

} // namespace

void weld(Loose_triangles& soup, double distance, std::vector<char>& merged, std::vector<Mend>& mends) {
  Welder(soup, distance, merged, mends).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
