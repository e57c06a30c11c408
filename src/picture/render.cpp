// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/render.h>

#include "picture/canvas.h"
#include "picture/raster.h"
#include "picture/shade.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace {

using namespace internal;

constexpr int band_pixels = 16; ///< rows of pixels that are rendered together

[[maybe_unused]] bool is_consistent(const Scene& scene) {
  const std::size_t f = scene.faces.size();
  const auto fits = [](std::size_t size, std::size_t expected) { return size == 0 || size == expected; };
  if (!fits(scene.face_colours.size(), f) || !fits(scene.corner_normals.size(), 4 * f) ||
      !fits(scene.drawn_sides.size(), f) || !fits(scene.scalar.size(), scene.points.size()))
    return false;
  const int n = int(scene.points.size());
  return std::all_of(scene.faces.begin(), scene.faces.end(), [n](const Scene::Face& face) {
    for (int i = 0; i < 4; ++i)
      if (face[i] >= n || (face[i] < 0 && (i < 3 || face[i] != -1))) return false;
    return true;
  });
}

/// Premultiplied colours of all pixels, and the distance from the eye, in pixels, of what their middle sees
/// (infinity: nothing).
struct Exposure {
  int width = 0, height = 0;
  std::vector<Sample_colour> pixels;
  std::vector<float> depth;
};

void expose_band(const Band& band, int samples, Shader& shader, Exposure& out) {
  const float weight = 1.0f / float(samples * samples);
  for (int row = band.first / samples; row < band.last / samples; ++row)
    for (int column = 0; column < out.width; ++column) {
      Sample_colour mean;
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const Sample_colour s = shader(band, column * samples + i, row * samples + j);
          mean.rgb += s.rgb;
          mean.opacity += s.opacity;
        }
      const std::size_t at = std::size_t(row) * out.width + column;
      out.pixels[at].rgb = mean.rgb * weight;
      out.pixels[at].opacity = mean.opacity * weight;
      const std::size_t middle = std::size_t(row * samples + samples / 2 - band.first) * band.columns +
                                 column * samples + samples / 2;
      out.depth[at] = band.depth[middle] / float(samples);
    }
}

Exposure expose(const Scene& scene, const Projection& projection, int width, int height, int samples) {
  Exposure out;
  out.width = width;
  out.height = height;
  out.pixels.resize(std::size_t(width) * height);
  out.depth.assign(std::size_t(width) * height, std::numeric_limits<float>::infinity());
  const Projected_scene projected = project(scene, projection, width * samples, height * samples, samples);
  const int band_rows = band_pixels * samples;
  const Bins pieces = bin_pieces(projected, scene, band_rows), rods = bin_rods(projected, band_rows);
  Shader shader(scene, projected, projection);
  Band band;
  for (int b = 0; b * band_rows < projected.rows; ++b) {
    const bool with_rods = rods.start[b] < rods.start[b + 1];
    if (!with_rods && pieces.start[b] == pieces.start[b + 1]) continue;
    band.start(b * band_rows, std::min((b + 1) * band_rows, projected.rows), projected.columns, with_rods);
    for (int i = pieces.start[b]; i < pieces.start[b + 1]; ++i)
      rasterize_piece(projected, scene, pieces.items[i], band);
    for (int i = rods.start[b]; i < rods.start[b + 1]; ++i) rasterize_rod(projected, rods.items[i], band);
    expose_band(band, samples, shader, out);
  }
  return out;
}

/// How much a pixel lies below the mean of two opposite neighbours, over eight lines and three distances: 0
/// on planes and ridges whatever their slope, up to 1 in hollows. A neighbour that is much nearer belongs to
/// another part and counts less the further it stands off.
class Hollowness {
public:
  explicit Hollowness(const Exposure& exposure) : m_exposure(exposure) {
    const double size = std::min(exposure.width, exposure.height);
    const double radii[3] = {0.004 * size, 0.010 * size, 0.022 * size};
    for (int ring = 0; ring < 3; ++ring)
      for (int line = 0; line < 8; ++line) {
        const double angle = std::acos(-1.0) * (line + ring / 3.0) / 8; // turned from ring to ring
        const double r = std::max(radii[ring], 1.5);
        const int dx = int(std::lround(r * std::cos(angle))), dy = int(std::lround(r * std::sin(angle)));
        m_taps.push_back({dx, dy, 1 / std::sqrt(float(dx * dx + dy * dy))});
      }
  }

  float operator()(int x, int y) const {
    const float z = m_exposure.depth[std::size_t(y) * m_exposure.width + x];
    float sum = 0;
    for (const Tap& tap : m_taps) {
      const float a = limited((z - depth(x + tap.dx, y + tap.dy)) * tap.inverse_radius);
      const float b = limited((z - depth(x - tap.dx, y - tap.dy)) * tap.inverse_radius);
      sum += std::min(std::max((a + b) / 2, 0.0f), 1.0f);
    }
    return std::min(2.0f * sum / float(m_taps.size()), 1.0f);
  }

private:
  struct Tap {
    int dx, dy;
    float inverse_radius;
  };

  /// The background lies infinitely far, which makes no hollow.
  float depth(int x, int y) const {
    if (x < 0 || y < 0 || x >= m_exposure.width || y >= m_exposure.height)
      return std::numeric_limits<float>::infinity();
    return m_exposure.depth[std::size_t(y) * m_exposure.width + x];
  }
  static float limited(float rise) { return rise > 2 ? 4 / rise : rise; }

  const Exposure& m_exposure;
  std::vector<Tap> m_taps;
};

/// The mean of `value` over a square of 5 x 5 pixels, of those whose depth is alike.
float smoothed(const Exposure& exposure, const std::vector<float>& value, int x, int y) {
  const float z = exposure.depth[std::size_t(y) * exposure.width + x];
  float sum = 0, number = 0;
  for (int j = std::max(y - 2, 0); j <= std::min(y + 2, exposure.height - 1); ++j)
    for (int i = std::max(x - 2, 0); i <= std::min(x + 2, exposure.width - 1); ++i) {
      const std::size_t at = std::size_t(j) * exposure.width + i;
      if (!(std::abs(exposure.depth[at] - z) < 8)) continue;
      sum += value[at];
      ++number;
    }
  return sum / number;
}

void darken_hollows(double strength, Exposure& exposure) {
  const Hollowness hollowness(exposure);
  std::vector<float> hollow(exposure.depth.size(), 0.0f);
  const auto for_each_face_pixel = [&](auto visit) {
    for (int y = 0; y < exposure.height; ++y)
      for (int x = 0; x < exposure.width; ++x) {
        const std::size_t at = std::size_t(y) * exposure.width + x;
        if (std::isfinite(exposure.depth[at])) visit(x, y, at);
      }
  };
  for_each_face_pixel([&](int x, int y, std::size_t at) { hollow[at] = hollowness(x, y); });
  for_each_face_pixel([&](int x, int y, std::size_t at) {
    exposure.pixels[at].rgb *= 1 - float(strength) * smoothed(exposure, hollow, x, y);
  });
}

void develop(const Exposure& exposure, const Render_options& options, Image& image) {
  const Eigen::Vector3f background(options.background.r, options.background.g, options.background.b);
  for (std::size_t i = 0; i < exposure.pixels.size(); ++i) {
    const Sample_colour& s = exposure.pixels[i];
    if (s.opacity <= 0) continue; // keeps the background of the blank image
    Eigen::Vector3f rgb = 255 * s.rgb;
    if (options.transparent)
      rgb /= s.opacity;
    else
      rgb += (1 - s.opacity) * background;
    for (int k = 0; k < 3; ++k)
      image.rgba[4 * i + k] = (unsigned char)(std::min(std::max(rgb[k], 0.0f), 255.0f) + 0.5f);
    image.rgba[4 * i + 3] =
        options.transparent ? (unsigned char)(std::min(s.opacity, 1.0f) * 255 + 0.5f) : 255;
  }
}

} // namespace

Camera camera(View view, Up_axis up) {
  return camera(view, Point(Point::Unit(up == Up_axis::x ? 0 : up == Up_axis::y ? 1 : 2)));
}

Camera camera(View view, const Point& up) {
  CGAL_precondition(up.allFinite() && !up.isZero(0));
  const Point up_direction = up.stableNormalized();
  Point::Index u = 0;
  up_direction.cwiseAbs().maxCoeff(&u);
  const double sign = up_direction[u] < 0 ? -1 : 1;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(sign * Point::Unit(u), up_direction);
  const Point side = turn * Point(sign * Point::Unit((u + 2) % 3)),
              front = turn * Point(Point::Unit((u + 1) % 3));
  Camera c;
  c.up = up_direction;
  switch (view) {
  case View::front: c.direction = -front; break;
  case View::back: c.direction = front; break;
  case View::side: c.direction = -side; break;
  case View::three_quarter: c.direction = -(0.80 * front + 0.55 * side + 0.34 * up_direction); break;
  }
  return c;
}

Image render(const Scene& scene, const Camera& camera, int width, int height, const Render_options& options) {
  CGAL_precondition(width > 0 && height > 0 && width <= 32768 && height <= 32768);
  CGAL_precondition(is_consistent(scene));
  Image image = blank_image(width, height, options.background, options.transparent);
  const int samples = std::min(std::max(options.samples, 1), 8);
  const int legend = legend_height(scene.legend, width, height);
  const double margin = 0.035 * std::min(width, height);
  const Viewport viewport{margin * samples, margin * samples, std::max(width - 2 * margin, 1.0) * samples,
                          std::max(height - legend - 2 * margin, 1.0) * samples};
  const Projection projection(scene, camera, viewport);
  if (projection.sees_something()) {
    Exposure exposure = expose(scene, projection, width, height, samples);
    if (options.occlusion > 0) darken_hollows(std::min(options.occlusion, 1.0), exposure);
    develop(exposure, options, image);
  }
  if (legend > 0) draw_legend(scene.legend, image, height - legend, legend);
  return image;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
