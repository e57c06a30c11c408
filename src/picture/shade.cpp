// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/shade.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {
namespace {

using Vec = Eigen::Vector3f;

constexpr int table_size = 1024;

Vec displayed(const Colour& c) {
  return Vec(c.r, c.g, c.b) / 255.0f;
}

// Light is added up with a gamma of 2, near enough to sRGB, because squares and square roots are exact on
// every machine.
Vec linear(const Colour& c) {
  return displayed(c).cwiseAbs2();
}
Vec displayed(const Vec& light) {
  return light.cwiseSqrt().cwiseMin(1.0f);
}

float clamped(float v, float low, float high) {
  return std::min(std::max(v, low), high);
}

/// Light that a surface of colour `base` (linear) sends to the eye. `n` is a unit vector in the eye's frame.
Vec lit(const Vec& base, const Vec& n, float gloss) {
  static const Vec key = Vec(-0.50f, 0.62f, 0.60f).normalized();
  static const Vec half = (key + Vec(0, 0, 1)).normalized();
  static const Vec fill = Vec(0.75f, -0.15f, 0.45f).normalized();
  static const Vec key_colour(1.02f, 0.99f, 0.93f), sky_colour(0.98f, 0.99f, 1.02f),
      fill_colour(1.0f, 0.95f, 0.90f);
  const float wrapped = clamped((n.dot(key) + 0.2f) / 1.2f, 0, 1);
  const float sky = 0.25f + 0.09f * n.y();
  const float head = clamped(n.z(), 0, 1);
  const float light = 0.54f * wrapped * wrapped;
  Vec result = base.cwiseProduct(light * key_colour + (sky + 0.27f * head) * sky_colour);
  result += 0.14f * clamped(n.dot(fill), 0, 1) * base.cwiseProduct(fill_colour);
  float s = clamped(n.dot(half), 0, 1);
  s *= s, s *= s, s *= s, s *= s, s *= s; // 32nd power
  return result + Vec::Constant(gloss * s);
}

/// A normal that faces the eye: silhouettes of interpolated normals may look away by a few degrees.
Vec facing(Vec n) {
  if (!(n.squaredNorm() > 1e-20f)) return Vec(0, 0, 1);
  n.normalize();
  if (n.z() < 0.03f) {
    n.z() = 0.03f;
    n.normalize();
  }
  return n;
}

float squared_distance(const Eigen::Vector2f& a, const Eigen::Vector2f& b, float x, float y) {
  const float dx = b.x() - a.x(), dy = b.y() - a.y(), px = x - a.x(), py = y - a.y();
  const float length = dx * dx + dy * dy;
  const float t = length > 0 ? clamped((px * dx + py * dy) / length, 0, 1) : 0;
  const float ex = px - t * dx, ey = py - t * dy;
  return ex * ex + ey * ey;
}

Eigen::Vector2f in_samples(const Grid_point& p) {
  return Eigen::Vector2f(float(p.x), float(p.y)) / float(grid_unit);
}

} // namespace

Shader::Shader(const Scene& scene, const Projected_scene& projected, const Projection& projection)
    : m_scene(scene), m_projected(projected), m_projection(projection) {
  if (scene.scalar.empty() || scene.scalar_colours.empty()) return;
  m_scalar_colours.reserve(table_size + 1);
  for (int i = 0; i <= table_size; ++i)
    m_scalar_colours.push_back(linear(colour_at(scene.scalar_colours, double(i) / table_size)));
}

Eigen::Vector3f Shader::face_normal(const Scene::Face& face) const {
  const Point& a = m_scene.points[face[0]];
  const Point& b = m_scene.points[face[1]];
  const Point& c = m_scene.points[face[2]];
  const Point d = face[3] < 0 ? a : m_scene.points[face[3]];
  // The diagonals' product is the mean normal of a quad, and twice the normal of a triangle whose fourth
  // corner is the first.
  const Point n = (c - a).stableNormalized().cross((d - b).stableNormalized()).stableNormalized();
  return n.cast<float>();
}

void Shader::enter(std::int32_t index) {
  m_piece.index = index;
  const Scene::Face& face = m_scene.faces[index / 2];
  const Corners& corners = m_projected.pieces[index];
  for (int i = 0; i < 3; ++i) m_piece.corner[i] = &m_projected.points[face[corners[i]]];
  const std::int64_t area =
      turn(*m_piece.corner[0], *m_piece.corner[1], m_piece.corner[2]->x, m_piece.corner[2]->y);
  m_piece.inverse_area = float(1.0 / double(area));
  m_piece.inside = area > 0; // clockwise where y points down is counterclockwise seen from behind
  m_piece.flat = m_scene.corner_normals.empty();
  const float sign = m_piece.inside ? -1.0f : 1.0f;
  if (m_piece.flat) {
    m_piece.normal[0] = facing(sign * m_projection.turned(face_normal(face)));
  } else {
    for (int i = 0; i < 3; ++i)
      m_piece.normal[i] = sign * m_projection.turned(m_scene.corner_normals[4 * (index / 2) + corners[i]]);
  }
  m_piece.base =
      linear(m_scene.face_colours.empty() ? m_scene.surface_colour : m_scene.face_colours[index / 2]);
  enter_sides(face);
  if (!m_scalar_colours.empty()) enter_level(face);
}

void Shader::enter_sides(const Scene::Face& face) {
  m_piece.number_of_sides = 0;
  if (m_scene.drawn_sides.empty()) return;
  const unsigned drawn = m_scene.drawn_sides[m_piece.index / 2];
  const int degree = face[3] < 0 ? 3 : 4;
  float area = 0;
  for (int i = 0; i < degree; ++i) {
    const Eigen::Vector2f a = in_samples(m_projected.points[face[i]]);
    const Eigen::Vector2f b = in_samples(m_projected.points[face[(i + 1) % degree]]);
    area += a.x() * b.y() - a.y() * b.x();
    if (drawn >> i & 1) m_piece.sides[m_piece.number_of_sides++] = {a, b};
  }
  const float size = std::sqrt(std::abs(area) / float(degree - 2)); // of a square or half-square of that area
  const float room = clamped(size / (3.5f * float(m_scene.side_width) * m_projected.pixel), 0, 1);
  m_piece.side_opacity = room * (0.35f + 0.65f * room);
}

void Shader::enter_level(const Scene::Face& face) {
  const Corners& corners = m_projected.pieces[m_piece.index];
  const double range = m_scene.scalar_high - m_scene.scalar_low;
  const double factor = range > 0 ? (m_scene.isolines + 1) / range : 0;
  for (int i = 0; i < 3; ++i)
    m_piece.level[i] = float((m_scene.scalar[face[corners[i]]] - m_scene.scalar_low) * factor);
  const Eigen::Vector2f a = in_samples(*m_piece.corner[0]), b = in_samples(*m_piece.corner[1]),
                        c = in_samples(*m_piece.corner[2]);
  const float lb = m_piece.level[1] - m_piece.level[0], lc = m_piece.level[2] - m_piece.level[0];
  const float scale = m_piece.inverse_area * float(grid_unit) * float(grid_unit);
  const Eigen::Vector2f slope((lb * (c.y() - a.y()) - lc * (b.y() - a.y())) * scale,
                              (lc * (b.x() - a.x()) - lb * (c.x() - a.x())) * scale);
  m_piece.level_slope = slope.norm();
}

Eigen::Vector3f Shader::surface_colour(int x, int y) {
  const std::int64_t gx = grid_of_sample(x), gy = grid_of_sample(y);
  const Grid_point &a = *m_piece.corner[0], &b = *m_piece.corner[1], &c = *m_piece.corner[2];
  float wa = float(turn(b, c, gx, gy)) * m_piece.inverse_area * a.q;
  float wb = float(turn(c, a, gx, gy)) * m_piece.inverse_area * b.q;
  float wc = float(turn(a, b, gx, gy)) * m_piece.inverse_area * c.q;
  const float sum = wa + wb + wc;
  wa /= sum, wb /= sum, wc /= sum;

  Vec base = m_piece.base;
  float level = 0;
  if (!m_scalar_colours.empty()) {
    level = wa * m_piece.level[0] + wb * m_piece.level[1] + wc * m_piece.level[2];
    const float t = level / float(m_scene.isolines + 1);
    base = std::isfinite(level) ? m_scalar_colours[int(clamped(t, 0, 1) * table_size + 0.5f)]
                                : Vec::Constant(0.3f);
  }
  if (m_piece.inside) base = 0.45f * base + Vec(0.080f, 0.068f, 0.064f);
  const Vec n = m_piece.flat
                    ? m_piece.normal[0]
                    : facing(wa * m_piece.normal[0] + wb * m_piece.normal[1] + wc * m_piece.normal[2]);
  Vec colour = displayed(lit(base, n, 0.055f));
  if (!m_scalar_colours.empty()) paint_isolines(level, colour);
  if (m_piece.number_of_sides > 0) paint_sides(float(x) + 0.5f, float(y) + 0.5f, colour);
  return colour;
}

void Shader::paint_isolines(float level, Vec& colour) const {
  if (m_scene.isolines <= 0 || !std::isfinite(level) || !(m_piece.level_slope > 0)) return;
  const float nearest = clamped(std::floor(level + 0.5f), 1, float(m_scene.isolines));
  const float distance = std::abs(level - nearest) / m_piece.level_slope;
  const float half_width = float(m_scene.isoline_width) * m_projected.pixel / 2;
  const float crowding =
      clamped(1 / (m_piece.level_slope * 6 * half_width), 0.15f, 1); // dense lines turn grey, not black
  const float opacity = clamped(half_width + 0.5f - distance, 0, 1) * crowding * 0.85f;
  colour += opacity * (displayed(m_scene.isoline_colour) - colour);
}

void Shader::paint_sides(float x, float y, Vec& colour) const {
  float nearest = std::numeric_limits<float>::infinity();
  for (int i = 0; i < m_piece.number_of_sides; ++i)
    nearest = std::min(nearest, squared_distance(m_piece.sides[i].a, m_piece.sides[i].b, x, y));
  const float half_width = float(m_scene.side_width) * m_projected.pixel / 2;
  const float opacity = clamped(half_width + 0.5f - std::sqrt(nearest), 0, 1) * m_piece.side_opacity;
  colour += opacity * (displayed(m_scene.side_colour) - colour);
}

void Shader::paint_rod(std::int32_t index, float x, float y, bool hidden, Sample_colour& sample) const {
  const Rod& rod = m_projected.rods[index];
  float t = 0;
  const float d2 = internal::squared_distance(rod, x, y, t);
  const float distance = std::sqrt(d2);
  const float opacity = clamped(rod.radius + 0.5f - distance, 0, 1) * (hidden ? rod.xray : 1.0f);
  if (opacity <= 0) return;
  const bool dot = std::size_t(index) >= m_projected.first_dot;
  const float ex = x - (rod.ax + t * (rod.bx - rod.ax)), ey = y - (rod.ay + t * (rod.by - rod.ay));
  const float rise = std::sqrt(std::max(rod.radius * rod.radius - d2, 0.0f));
  const Vec n = facing(Vec(ex, -ey, rise));
  // Thin lines keep their colour; only rods of several pixels look round.
  const float roundness = dot ? 1.0f : clamped((rod.radius / m_projected.pixel - 1) / 2, 0, 1);
  const Vec plain = displayed(rod.colour);
  Vec colour =
      plain + roundness * (displayed(Vec(lit(linear(rod.colour) * 1.15f, n, dot ? 0.25f : 0.1f))) - plain);
  if (dot) { // a thin dark rim sets the ball off the surface
    const float rim = clamped(distance - (rod.radius - 1.0f * m_projected.pixel), 0, 1);
    colour *= 1 - 0.45f * rim;
  }
  sample.rgb = opacity * colour + (1 - opacity) * sample.rgb;
  sample.opacity = opacity + (1 - opacity) * sample.opacity;
}

Sample_colour Shader::operator()(const Band& band, int x, int y) {
  const std::size_t at = std::size_t(y - band.first) * band.columns + x;
  Sample_colour sample;
  if (band.piece[at] >= 0) {
    if (band.piece[at] != m_piece.index) enter(band.piece[at]);
    sample.rgb = surface_colour(x, y);
    sample.opacity = 1;
  }
  if (!band.rod.empty() && band.rod[at] >= 0)
    paint_rod(band.rod[at], float(x) + 0.5f, float(y) + 0.5f, band.rod_depth[at] > band.depth[at], sample);
  return sample;
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
