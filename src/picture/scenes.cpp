// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/picture_scene.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace {

int degree(const Scene::Face& face) {
  return face[3] < 0 ? 3 : 4;
}

/// The faces around each point, as corner numbers 4 f + i, in ascending order.
struct Corners_of_points {
  std::vector<int> start, corners;
  explicit Corners_of_points(const Scene& scene) : start(scene.points.size() + 1, 0) {
    for (const Scene::Face& face : scene.faces)
      for (int i = 0; i < degree(face); ++i) ++start[face[i] + 1];
    for (std::size_t v = 0; v + 1 < start.size(); ++v) start[v + 1] += start[v];
    corners.resize(start.back());
    std::vector<int> next(start.begin(), start.end() - 1);
    for (std::size_t f = 0; f < scene.faces.size(); ++f)
      for (int i = 0; i < degree(scene.faces[f]); ++i) corners[next[scene.faces[f][i]]++] = int(4 * f) + i;
  }
};

Eigen::Vector3f as_direction(const Point& p) {
  const Point n = p.stableNormalized();
  return n.allFinite() ? Eigen::Vector3f(n.cast<float>()) : Eigen::Vector3f(0, 0, 0);
}

Eigen::Vector3f face_normal(const Scene& scene, const Scene::Face& face) {
  const Point &a = scene.points[face[0]], &b = scene.points[face[1]], &c = scene.points[face[2]];
  const Point& d = face[3] < 0 ? a : scene.points[face[3]];
  return as_direction((c - a).stableNormalized().cross((d - b).stableNormalized()));
}

/// A weight that grows with the corner's angle: twice the sine of its half; 0 if it is degenerate.
float corner_weight(const Scene& scene, const Scene::Face& face, int i) {
  const int n = degree(face);
  const Point& p = scene.points[face[i]];
  const Eigen::Vector3f a = as_direction(scene.points[face[(i + 1) % n]] - p),
                        b = as_direction(scene.points[face[(i + n - 1) % n]] - p);
  return (a - b).norm();
}

/// Valences from 8 on share an entry, as they share a colour.
Legend_entry valence_entry(int valence, int count) {
  const std::string name = "valence " + std::to_string(valence) + (valence == 8 ? " or more" : "");
  return {valence_colour(valence), name + ": " + std::to_string(count)};
}

Scene unshaded_scene(const Polygon_soup& mesh, const std::vector<Colour>& colours) {
  Scene scene;
  scene.points = mesh.points;
  const auto add = [&](int polygon, const Scene::Face& face, int sides) {
    scene.faces.push_back(face);
    scene.drawn_sides.push_back(static_cast<unsigned char>(sides));
    if (!colours.empty()) scene.face_colours.push_back(colours[polygon]);
  };
  for (int p = 0; p < mesh.number_of_polygons(); ++p) {
    const int n = mesh.size_of_polygon(p), *corner = mesh.corner.data() + mesh.begin[p];
    CGAL_precondition(n >= 3);
    if (n == 4) {
      add(p, {corner[0], corner[1], corner[2], corner[3]}, 15);
      continue;
    }
    for (int i = 1; i + 1 < n; ++i)
      add(p, {corner[0], corner[i], corner[i + 1], -1}, (i == 1 ? 1 : 0) | 2 | (i + 2 == n ? 4 : 0));
  }
  return scene;
}

} // namespace

void shade_smoothly(Scene& scene, double crease_angle) {
  const float least_cosine = float(std::cos(crease_angle * std::acos(-1.0) / 180));
  std::vector<Eigen::Vector3f> normal(scene.faces.size());
  for (std::size_t f = 0; f < scene.faces.size(); ++f) normal[f] = face_normal(scene, scene.faces[f]);
  scene.corner_normals.assign(4 * scene.faces.size(), Eigen::Vector3f::Zero());
  std::vector<float> weight(4 * scene.faces.size(), 0.0f);
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
    for (int i = 0; i < 4; ++i) {
      scene.corner_normals[4 * f + i] = normal[f];
      if (i < degree(scene.faces[f])) weight[4 * f + i] = corner_weight(scene, scene.faces[f], i);
    }
  if (!(crease_angle > 0)) return;
  const Corners_of_points around(scene);
  for (std::size_t v = 0; v < scene.points.size(); ++v)
    for (int i = around.start[v]; i < around.start[v + 1]; ++i) {
      const Eigen::Vector3f& own = normal[around.corners[i] / 4];
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int j = around.start[v]; j < around.start[v + 1]; ++j) {
        const Eigen::Vector3f& other = normal[around.corners[j] / 4];
        if (own.dot(other) >= least_cosine) sum += weight[around.corners[j]] * other;
      }
      if (sum.squaredNorm() > 0) scene.corner_normals[around.corners[i]] = sum.normalized();
    }
}

Scene surface_scene(const Triangle_surface& surface) {
  Scene scene;
  scene.points = surface.points;
  scene.faces.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) scene.faces.push_back({t[0], t[1], t[2], -1});
  shade_smoothly(scene);
  return scene;
}

Scene scalar_scene(const Triangle_surface& surface, const std::vector<double>& field, int isolines) {
  CGAL_precondition(field.size() == surface.points.size());
  Scene scene = surface_scene(surface);
  scene.scalar = field;
  scene.scalar_colours = field_colours();
  scene.isolines = std::max(isolines, 0);
  bool first = true;
  for (const double value : field) {
    if (!std::isfinite(value)) continue;
    scene.scalar_low = first ? value : std::min(scene.scalar_low, value);
    scene.scalar_high = first ? value : std::max(scene.scalar_high, value);
    first = false;
  }
  scene.legend.title = "field";
  scene.legend.bar = scene.scalar_colours;
  scene.legend.low = scene.scalar_low;
  scene.legend.high = scene.scalar_high;
  return scene;
}

Scene face_colour_scene(const Triangle_surface& surface, const std::vector<int>& region) {
  CGAL_precondition(region.size() == surface.triangles.size());
  const std::vector<Colour> palette = chart_palette();
  const int colours = int(palette.size());
  std::map<int, std::set<int>> neighbours; // ordered, so that the choice below is
  for (int f = 0; f < int(region.size()); ++f) {
    if (region[f] < 0) continue;
    std::set<int>& mine = neighbours[region[f]];
    for (int h = 3 * f; h < 3 * f + 3 && !surface.opposite.empty(); ++h)
      if (surface.opposite[h] >= 0 && region[surface.opposite[h] / 3] >= 0 &&
          region[surface.opposite[h] / 3] != region[f])
        mine.insert(region[surface.opposite[h] / 3]);
  }
  std::map<int, int> chosen;
  std::vector<int> uses(colours, 0);
  for (const auto& entry : neighbours) {
    std::vector<int> clashes(colours, 0);
    for (const int other : entry.second) {
      const auto found = chosen.find(other);
      if (found != chosen.end()) ++clashes[found->second];
    }
    int best = 0;
    for (int c = 1; c < colours; ++c)
      if (std::make_pair(clashes[c], uses[c]) < std::make_pair(clashes[best], uses[best])) best = c;
    chosen[entry.first] = best;
    ++uses[best];
  }
  Scene scene = surface_scene(surface);
  scene.face_colours.reserve(region.size());
  for (const int r : region) scene.face_colours.push_back(r < 0 ? scene.surface_colour : palette[chosen[r]]);
  return scene;
}

Scene polygon_scene(const Polygon_soup& mesh, const std::vector<Colour>& colours) {
  CGAL_precondition(colours.empty() || int(colours.size()) == mesh.number_of_polygons());
  Scene scene = unshaded_scene(mesh, colours);
  shade_smoothly(scene);
  return scene;
}

std::vector<int> vertex_valences(const Quad_mesh& mesh) {
  return vertex_valences(polygon_soup(mesh));
}

std::vector<int> vertex_valences(const Polygon_soup& mesh) {
  std::vector<int> valence(mesh.points.size(), 0);
  std::vector<std::array<int, 2>> sides;
  sides.reserve(mesh.corner.size());
  for (int p = 0; p < mesh.number_of_polygons(); ++p)
    for (int i = mesh.begin[p]; i < mesh.begin[p + 1]; ++i) {
      const int a = mesh.corner[i], b = mesh.corner[i + 1 < mesh.begin[p + 1] ? i + 1 : mesh.begin[p]];
      ++valence[a];
      sides.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<char> at_boundary(mesh.points.size(), 0);
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    for (j = i; j < sides.size() && sides[j] == sides[i];) ++j;
    if (j == i + 1) at_boundary[sides[i][0]] = at_boundary[sides[i][1]] = 1;
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
    if (at_boundary[v]) valence[v] += 2;
  return valence;
}

Scene quad_scene(const Quad_mesh& mesh, const Quad_scene_options& options) {
  return quad_scene(polygon_soup(mesh), options);
}

Scene quad_scene(const Polygon_soup& mesh, const Quad_scene_options& options) {
  Scene scene = unshaded_scene(mesh, {});
  shade_smoothly(scene, options.smooth ? 40 : 0);
  const std::vector<int> valence = vertex_valences(mesh);
  std::map<int, int> count;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 4 || valence[v] == 0) continue;
    ++count[std::min(valence[v], 8)];
    if (options.dot_radius > 0)
      scene.dots.push_back(
          {mesh.points[v], valence_colour(valence[v]), options.dot_radius, options.dot_xray});
  }
  if (options.legend) {
    std::map<int, int> sizes{{4, 0}};
    for (int p = 0; p < mesh.number_of_polygons(); ++p) ++sizes[mesh.size_of_polygon(p)];
    scene.legend.title = std::to_string(sizes[4]) + " quads";
    for (const auto& [sides, number] : sizes)
      if (sides != 4)
        scene.legend.title += ", " + std::to_string(number) +
                              (sides == 3 ? " triangles" : " of " + std::to_string(sides) + " sides");
    for (const auto& entry : count) scene.legend.entries.push_back(valence_entry(entry.first, entry.second));
  }
  return scene;
}

std::vector<double> scaled_jacobians(const Quad_mesh& mesh) {
  std::vector<double> result;
  result.reserve(mesh.quads.size());
  for (const Quad& quad : mesh.quads) {
    const Point* p[4] = {&mesh.points[quad[0]], &mesh.points[quad[1]], &mesh.points[quad[2]],
                         &mesh.points[quad[3]]};
    const Point normal =
        (*p[2] - *p[0]).stableNormalized().cross((*p[3] - *p[1]).stableNormalized()).stableNormalized();
    double least = 1;
    for (int i = 0; i < 4; ++i) {
      const Point a = (*p[(i + 1) % 4] - *p[i]).stableNormalized(),
                  b = (*p[(i + 3) % 4] - *p[i]).stableNormalized();
      const double sine = a.cross(b).dot(normal);
      least = std::isfinite(sine) ? std::min(least, sine) : std::min(least, 0.0);
    }
    result.push_back(least);
  }
  return result;
}

Scene quality_scene(const Quad_mesh& mesh) {
  Scene scene = polygon_scene(polygon_soup(mesh));
  const Colour_map colours = quality_colours();
  const Colour inverted{214, 0, 160};
  int number_inverted = 0;
  for (const double jacobian : scaled_jacobians(mesh)) {
    number_inverted += jacobian <= 0;
    scene.face_colours.push_back(jacobian <= 0 ? inverted : colour_at(colours, jacobian));
  }
  scene.legend.title = "scaled Jacobian";
  scene.legend.bar = colours;
  if (number_inverted > 0)
    scene.legend.entries.push_back({inverted, "inverted or degenerate: " + std::to_string(number_inverted)});
  return scene;
}

void add_polyline(Scene& scene, const std::vector<Point>& points, Colour colour, double width, bool closed,
                  double xray) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    scene.lines.push_back({points[i], points[i + 1], colour, width, xray, width + 1});
  if (closed && points.size() > 2)
    scene.lines.push_back({points.back(), points.front(), colour, width, xray, width + 1});
}

void add_graph(Scene& scene, const std::vector<Point>& nodes, const std::vector<std::vector<Point>>& arcs,
               const std::vector<Colour>& node_colours, const std::vector<Colour>& arc_colours) {
  CGAL_precondition(node_colours.empty() || node_colours.size() == nodes.size());
  CGAL_precondition(arc_colours.empty() || arc_colours.size() == arcs.size());
  const Colour grey{70, 72, 80};
  const double shown_through = 0.9, rod_width = 5, ball_radius = 7;
  for (std::size_t a = 0; a < arcs.size(); ++a)
    add_polyline(scene, arcs[a], arc_colours.empty() ? grey : arc_colours[a], rod_width, false,
                 shown_through);
  for (std::size_t n = 0; n < nodes.size(); ++n) // lifted over the ends of the rods
    scene.dots.push_back(
        {nodes[n], node_colours.empty() ? grey : node_colours[n], ball_radius, shown_through, rod_width + 2});
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
