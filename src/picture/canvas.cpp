// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {
namespace {

constexpr double grid_lines = 9.5; ///< units of the font's grid in the height of a line
constexpr double letter_gap = 1.7; ///< units between two letters

/// The pixels whose centres may lie between `low` and `high`, within [0, size).
int first_pixel(double low) {
  return int(std::max(std::floor(low - 0.5), 0.0));
}
int last_pixel(double high, int size) {
  return int(std::min(std::ceil(high + 0.5), double(size - 1)));
}

double overlap(double low, double high, int pixel) {
  return std::max(0.0, std::min(high, pixel + 1.0) - std::max(low, double(pixel)));
}

} // namespace

Image blank_image(int width, int height, Colour colour, bool transparent) {
  Image image;
  image.width = width;
  image.height = height;
  image.rgba.resize(std::size_t(width) * height * 4);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = colour.r;
    image.rgba[i + 1] = colour.g;
    image.rgba[i + 2] = colour.b;
    image.rgba[i + 3] = transparent ? 0 : 255;
  }
  return image;
}

void Canvas::blend(int x, int y, Colour colour, double opacity) {
  if (x < 0 || y < 0 || x >= m_image.width || y >= m_image.height || opacity <= 0) return;
  unsigned char* p = &m_image.rgba[(std::size_t(y) * m_image.width + x) * 4];
  const double below = p[3] / 255.0 * (1 - opacity), total = opacity + below;
  const unsigned char source[3] = {colour.r, colour.g, colour.b};
  for (int i = 0; i < 3; ++i) p[i] = (unsigned char)((source[i] * opacity + p[i] * below) / total + 0.5);
  p[3] = (unsigned char)(total * 255 + 0.5);
}

void Canvas::fill(Colour colour) {
  m_image = blank_image(m_image.width, m_image.height, colour, false);
}

void Canvas::rectangle(double left, double top, double right, double bottom, Colour colour) {
  for (int y = first_pixel(top); y <= last_pixel(bottom, m_image.height); ++y)
    for (int x = first_pixel(left); x <= last_pixel(right, m_image.width); ++x)
      blend(x, y, colour, overlap(left, right, x) * overlap(top, bottom, y));
}

void Canvas::line(double ax, double ay, double bx, double by, double width, Colour colour) {
  const double reach = width / 2 + 0.5, dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
  for (int y = first_pixel(std::min(ay, by) - reach);
       y <= last_pixel(std::max(ay, by) + reach, m_image.height); ++y)
    for (int x = first_pixel(std::min(ax, bx) - reach);
         x <= last_pixel(std::max(ax, bx) + reach, m_image.width); ++x) {
      const double px = x + 0.5 - ax, py = y + 0.5 - ay;
      const double t = length > 0 ? std::min(std::max((px * dx + py * dy) / length, 0.0), 1.0) : 0;
      const double ex = px - t * dx, ey = py - t * dy;
      blend(x, y, colour, std::min(std::max(reach - std::sqrt(ex * ex + ey * ey), 0.0), 1.0));
    }
}

double Canvas::text_width(double size, const std::string& text) {
  double width = 0;
  for (const char c : text) width += glyph(c).width + letter_gap;
  return text.empty() ? 0 : (width - letter_gap) * size / grid_lines;
}

void Canvas::text(double x, double y, double size, const std::string& text, Colour colour, double align) {
  const double unit = size / grid_lines, pen = std::max(size * 0.085, 1.0);
  x -= align * text_width(size, text);
  for (const char c : text) {
    const Glyph& g = glyph(c);
    for (const Stroke& stroke : g.strokes)
      for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
        line(x + stroke[i].x() * unit, y - (stroke[i].y() - 2) * unit, x + stroke[i + 1].x() * unit,
             y - (stroke[i + 1].y() - 2) * unit, pen, colour);
    x += (g.width + letter_gap) * unit;
  }
}

std::string short_number(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

int legend_height(const Legend& legend, int width, int height) {
  if (legend.empty()) return 0;
  return std::min(std::max(std::min(width, height) / 14, 18), 64);
}

namespace {

/// Draws the legend from `x` on, or only measures; returns where it ends.
double lay_out(const Legend& legend, Canvas* canvas, double x, double middle, double size, double bar_width) {
  const double baseline = middle + size * 0.3, gap = size * 1.1;
  const auto word = [&](const std::string& text, double space) {
    if (canvas != nullptr) canvas->text(x, baseline, size, text, ink);
    x += Canvas::text_width(size, text) + space;
  };
  if (!legend.title.empty()) word(legend.title, gap);
  if (!legend.bar.empty()) {
    word(short_number(legend.low), gap / 2);
    const int steps = std::max(int(bar_width), 1);
    x = std::floor(x);
    for (int i = 0; i < steps && canvas != nullptr; ++i)
      canvas->rectangle(x + i, middle - size * 0.55, x + i + 1, middle + size * 0.55,
                        colour_at(legend.bar, (i + 0.5) / steps));
    x += steps + gap / 2;
    word(short_number(legend.high), gap);
  }
  for (const Legend_entry& entry : legend.entries) {
    const double radius = size * 0.36;
    if (canvas != nullptr) canvas->disc(x + radius, middle, radius, entry.colour);
    x += 2 * radius + gap * 0.4;
    word(entry.text, gap);
  }
  return x - gap;
}

} // namespace

void draw_legend(const Legend& legend, Image& image, int top, int height) {
  Canvas canvas(image);
  const double margin = height * 0.5, room = image.width - 2 * margin, bar_width = image.width * 0.22;
  const double size = height * 0.36;
  const double needed = lay_out(legend, nullptr, 0, 0, size, bar_width);
  const double shrink = needed > room && room > 0 ? room / needed : 1;
  lay_out(legend, &canvas, margin, top + height * 0.5, size * shrink, bar_width * shrink);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
