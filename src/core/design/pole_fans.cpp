// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include "design/pole_texture.h"

#include "base/quad_connectivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {

Quad_texture pole_texture(int a, int b, bool clockwise) {
  const Quad_texture square = regular_disc_texture(a, b, false);
  const std::vector<int>& border = square.sides[0];
  const int n = int(border.size()), rows = std::max(2, (std::min(a, b) + 1) / 2); // the fan is the last row
  Quad_texture texture;
  for (int v : border) {
    texture.v.push_back(square.v[v]);
    texture.u.push_back(square.u[v]);
  }
  for (int ring = 1; ring < rows; ++ring) {
    const double t = double(rows - ring) / rows;
    for (int v : border) { // rings turn from squares to circles on the way in, along the same rays
      const double x = 2 * square.v[v] / a - 1, y = 2 * square.u[v] / b - 1;
      const double scale = t * (t + (1 - t) / std::hypot(x, y));
      texture.v.push_back(0.5 * a * (1 + scale * x));
      texture.u.push_back(0.5 * b * (1 + scale * y));
    }
  }
  const int pole = n * rows;
  texture.v.push_back(0.5 * a);
  texture.u.push_back(0.5 * b);
  for (int ring = 0; ring + 1 < rows; ++ring)
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      texture.quads.push_back({ring * n + i, ring * n + next, (ring + 1) * n + next, (ring + 1) * n + i});
    }
  texture.holes.assign(texture.quads.size(), 0);
  const int first = n * (rows - 1);
  for (int i = 0; i < n; i += 2)
    texture.quads.push_back({pole, first + i, first + i + 1, first + (i + 2) % n});
  texture.holes.resize(texture.quads.size(), 1);
  texture.sides.emplace_back();
  for (int i = 0; i < n; ++i) texture.sides[0].push_back(i);
  if (clockwise) std::reverse(texture.sides[0].begin() + 1, texture.sides[0].end());
  return texture;
}

namespace {

// The holes inside the quads of a chart, as lists of vertices, counterclockwise seen from outside.
std::vector<std::vector<int>> holes_in(const Stitched_mesh& quads, int chart) {
  std::set<std::array<int, 2>> edges;
  for (const Quad& q : quads.mesh.quads)
    for (int i = 0; i < 4; ++i) edges.insert({q[i], q[(i + 1) % 4]});
  std::map<int, int> next;
  for (std::size_t f = 0; f < quads.mesh.quads.size(); ++f) {
    if (quads.chart_of_quad[f] != chart) continue;
    const Quad& q = quads.mesh.quads[f];
    for (int i = 0; i < 4; ++i)
      if (!edges.count({q[(i + 1) % 4], q[i]})) next[q[(i + 1) % 4]] = q[i];
  }
  std::vector<std::vector<int>> holes;
  while (!next.empty()) {
    std::vector<int> hole;
    for (auto at = next.begin(); at != next.end(); at = next.find(hole.back())) {
      if (hole.empty()) hole.push_back(at->first);
      hole.push_back(at->second);
      next.erase(at);
    }
    if (hole.front() == hole.back()) { // else it goes on in another chart
      hole.pop_back();
      holes.push_back(std::move(hole));
    }
  }
  return holes;
}

// The chart around an extremum, or -1.
int chart_of_pole(const Design& design, const Design_extremum& extremum) {
  for (std::size_t c = 0; c < design.charts.size(); ++c) {
    const Chart& chart = *design.charts[c]->chart;
    if (chart.extremum >= 0 && chart.vertex_origin[chart.extremum] == extremum.vertex) return int(c);
  }
  return -1;
}

// Where most of a texture's holes meet.
Point middle_of_holes(const Design_chart& chart) {
  const Quad_texture& texture = chart.texture.texture;
  std::vector<int> holes(texture.v.size(), 0);
  for (std::size_t q = 0; q < texture.quads.size(); ++q)
    if (texture.is_hole(int(q)))
      for (int v : texture.quads[q]) ++holes[v];
  const std::size_t pole = std::size_t(std::max_element(holes.begin(), holes.end()) - holes.begin());
  return position(*chart.chart, chart.texture.location[pole]);
}

} // namespace

std::vector<Pole_fan> pole_fans(const Design& design, const Stitched_mesh& quads) {
  std::vector<Pole_fan> fans;
  for (std::size_t i = 0; i < design.extrema.size(); ++i) {
    if (design.extrema[i].pole != Pole_kind::whole) continue;
    const int c = chart_of_pole(design, design.extrema[i]);
    if (c < 0 || design.charts[c]->edited) continue;
    Pole_fan fan;
    fan.extremum = int(i);
    fan.pole = middle_of_holes(*design.charts[c]);
    const std::vector<char>& holes = design.charts[c]->texture.texture.holes;
    fan.holes = int(std::count_if(holes.begin(), holes.end(), [](char hole) { return hole != 0; }));
    double least = std::numeric_limits<double>::infinity();
    for (std::vector<int>& hole : holes_in(quads, c)) {
      if (hole.size() % 2 != 0) continue;
      Point mean = Point::Zero();
      for (int v : hole) mean += quads.mesh.points[v] / double(hole.size());
      if (const double d = (mean - fan.pole).norm(); d < least) {
        least = d;
        fan.ring = std::move(hole);
      }
    }
    if (!fan.ring.empty()) fans.push_back(std::move(fan));
  }
  return fans;
}

bool has_all_fans(const Design& design, const Stitched_mesh& quads) {
  const std::vector<Pole_fan> fans = pole_fans(design, quads);
  for (std::size_t i = 0; i < design.extrema.size(); ++i) {
    if (design.extrema[i].pole != Pole_kind::whole) continue;
    const int c = chart_of_pole(design, design.extrema[i]);
    if (c >= 0 && design.charts[c]->edited) continue;
    if (std::none_of(fans.begin(), fans.end(), [&](const Pole_fan& fan) { return fan.extremum == int(i); }))
      return false;
  }
  return true;
}

Polygon_soup with_fans(const Quad_mesh& quads, const std::vector<Pole_fan>& fans) {
  Polygon_soup soup = polygon_soup(quads);
  for (const Pole_fan& fan : fans) {
    const int pole = soup.number_of_points();
    soup.points.push_back(fan.pole);
    for (std::size_t i = 0; i < fan.ring.size(); ++i) {
      for (int v : {pole, fan.ring[i], fan.ring[(i + 1) % fan.ring.size()]}) soup.corner.push_back(v);
      soup.close_polygon();
    }
  }
  return soup;
}

Stitched_mesh with_paired_fans(Stitched_mesh quads, const std::vector<Pole_fan>& fans) {
  if (fans.empty()) return quads;
  std::vector<int> quads_at(quads.mesh.points.size(), 0);
  for (const Quad& q : quads.mesh.quads)
    for (int v : q) ++quads_at[v];
  for (const Pole_fan& fan : fans) {
    const int pole = int(quads.mesh.points.size()), n = int(fan.ring.size());
    quads.mesh.points.push_back(fan.pole);
    for (int i = 0; i < n; i += 2) {
      quads.mesh.quads.push_back({pole, fan.ring[i], fan.ring[i + 1], fan.ring[(i + 2) % n]});
      quads.chart_of_quad.push_back(-1);
    }
    ++quads.valences[n / 2];
    for (int i = 0; i < n; ++i) // the edges of the quads there, and every second time the one to the pole
      ++quads.valences[quads_at[fan.ring[i]] + 1 + (i % 2 == 0)];
    quads.holes -= fan.holes;
  }
  quads.components.clear(); // without other holes they are the surface's
  if (quads.holes != 0)     // or T-junctions changed the ring
    quads.components = internal::quad_components(quads.mesh.quads, int(quads.mesh.points.size()));
  return quads;
}

std::vector<Pole_fan> with_mirrored_fans(std::vector<Pole_fan> fans, const std::vector<int>& image,
                                         const Mirror_plane& plane) {
  const std::size_t half = fans.size();
  for (std::size_t i = 0; i < half; ++i) {
    Pole_fan fan = fans[i];
    fan.pole = plane.reflected(fan.pole);
    for (int& v : fan.ring) v = image[std::size_t(v)];
    std::reverse(fan.ring.begin(), fan.ring.end());
    fans.push_back(std::move(fan));
  }
  return fans;
}

std::string fan_sentence(const std::vector<Pole_fan>& fans) {
  if (fans.empty()) return {};
  std::size_t triangles = 0;
  for (const Pole_fan& fan : fans) triangles += fan.ring.size();
  return "not all-quad: " + std::to_string(triangles) + " triangles in fans at " +
         std::to_string(fans.size()) + (fans.size() == 1 ? " whole pole" : " whole poles") +
         ", asked for by the design";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
