// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/render.h>

#include "picture/canvas.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace {

using namespace internal;

constexpr Colour grid{226, 226, 230};
constexpr Colour paper{255, 255, 255};

/// A step of 1, 2 or 5 times a power of ten that cuts `range` into about `parts`.
double tick_step(double range, int parts) {
  if (!(range > 0) || !std::isfinite(range)) return 1;
  const double raw = range / parts, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

double height_of(double bin) {
  return std::isfinite(bin) && bin > 0 ? bin : 0;
}

/// The rectangle of a chart's bars, in pixels, and the values at its borders.
struct Plot {
  double left, top, right, bottom, size; // size: of the text
  double low, high, peak;
  double x(double value) const { return left + (right - left) * (value - low) / (high - low); }
  double y(double value) const { return bottom - (bottom - top) * value / peak; }
};

Plot make_plot(const Histogram& h, int width, int height) {
  Plot p;
  p.size = std::min(std::max(height / 20.0, 9.0), 28.0);
  p.low = std::isfinite(h.low) ? h.low : 0;
  p.high = std::isfinite(h.high) && h.high > p.low ? h.high : p.low + 1;
  double peak = 0;
  for (const double bin : h.bins) peak = std::max(peak, height_of(bin));
  p.peak = peak > 0 ? peak * 1.06 : 1;
  p.left = 4.2 * p.size;
  p.right = width - 1.6 * p.size;
  p.top = (h.title.empty() ? 1.0 : 2.8) * p.size;
  p.bottom = height - (h.x_label.empty() ? 2.2 : 3.6) * p.size;
  return p;
}

void draw_axes(const Plot& p, Canvas& canvas) {
  const double rise = tick_step(p.peak, 5);
  for (int i = 0; i * rise <= p.peak; ++i) {
    const double y = std::round(p.y(i * rise));
    canvas.rectangle(p.left, y, p.right, y + 1, i == 0 ? ink : grid);
    canvas.text(p.left - p.size * 0.5, y + p.size * 0.3, p.size * 0.85, short_number(i * rise, 6), ink, 1);
  }
  const double step = tick_step(p.high - p.low, 8);
  for (double i = std::ceil(p.low / step - 1e-9); i * step <= p.high + 1e-9 * step; ++i) {
    const double x = std::round(p.x(i * step));
    canvas.rectangle(x, p.bottom, x + 1, p.bottom + p.size * 0.35, ink);
    canvas.text(x + 0.5, p.bottom + 1.35 * p.size, p.size * 0.85, short_number(i * step + 0.0, 6), ink, 0.5);
  }
}

void draw_bars(const Histogram& h, const Plot& p, Canvas& canvas) {
  const double width = (p.right - p.left) / std::max<std::size_t>(h.bins.size(), 1);
  const double gap = width > 4 ? std::min(width * 0.12, 3.0) : 0;
  for (std::size_t i = 0; i < h.bins.size(); ++i) {
    if (height_of(h.bins[i]) <= 0) continue;
    const double left = p.left + double(i) * width;
    const Colour colour = h.colours.empty() ? Colour{92, 140, 196}
                                            : colour_at(h.colours, (double(i) + 0.5) / double(h.bins.size()));
    canvas.rectangle(left + gap / 2, p.y(height_of(h.bins[i])), left + width - gap / 2, p.bottom, colour);
  }
}

void draw_texts(const Histogram& h, const Plot& p, int height, Canvas& canvas) {
  const double middle = (p.left + p.right) / 2;
  if (!h.title.empty()) canvas.text(middle, 1.7 * p.size, 1.2 * p.size, h.title, ink, 0.5);
  if (!h.x_label.empty()) canvas.text(middle, height - 0.7 * p.size, p.size, h.x_label, ink, 0.5);
  double y = p.top + 1.1 * p.size;
  for (std::size_t start = 0; start < h.note.size(); y += 1.35 * p.size) {
    const std::size_t end = std::min(h.note.find('\n', start), h.note.size());
    const std::string line = h.note.substr(start, end - start);
    const double left = p.left + p.size, size = p.size * 0.9;
    // The grid would cross out the words.
    canvas.rectangle(left - 3, y - size * 0.8, left + Canvas::text_width(size, line) + 3, y + size * 0.35,
                     paper);
    canvas.text(left, y, size, line, ink);
    start = end + 1;
  }
}

void paste(const Image& source, int left, int top, Image& target) {
  for (int y = 0; y < source.height; ++y) {
    const auto row = source.rgba.begin() + std::ptrdiff_t(y) * source.width * 4;
    std::copy(row, row + std::ptrdiff_t(source.width) * 4,
              target.rgba.begin() + (std::ptrdiff_t(top + y) * target.width + left) * 4);
  }
}

} // namespace

Image histogram_image(const Histogram& histogram, int width, int height) {
  CGAL_precondition(width > 0 && height > 0);
  Image image = blank_image(width, height, paper, false);
  Canvas canvas(image);
  const Plot plot = make_plot(histogram, width, height);
  if (plot.right <= plot.left || plot.bottom <= plot.top) return image; // no room for a chart
  draw_axes(plot, canvas);
  draw_bars(histogram, plot, canvas);
  canvas.rectangle(plot.left, std::round(plot.bottom), plot.right, std::round(plot.bottom) + 1, ink);
  draw_texts(histogram, plot, height, canvas);
  return image;
}

Image compose(const std::vector<Image>& images, int columns, int gap, Colour background) {
  CGAL_precondition(columns > 0 && gap >= 0);
  int cell_width = 1, cell_height = 1;
  for (const Image& image : images) {
    cell_width = std::max(cell_width, image.width);
    cell_height = std::max(cell_height, image.height);
  }
  const int number = std::max(int(images.size()), 1), rows = (number + columns - 1) / columns;
  columns = std::min(columns, number);
  Image sheet =
      blank_image(columns * (cell_width + gap) - gap, rows * (cell_height + gap) - gap, background, false);
  for (int i = 0; i < int(images.size()); ++i)
    paste(images[i], i % columns * (cell_width + gap) + (cell_width - images[i].width) / 2,
          i / columns * (cell_height + gap) + (cell_height - images[i].height) / 2, sheet);
  return sheet;
}

Image contact_sheet(const Scene& scene, Up_axis up, int width, int height, const Render_options& options) {
  return contact_sheet(scene, camera(View::front, up).up, width, height, options);
}

Image contact_sheet(const Scene& scene, const Point& up, int width, int height,
                    const Render_options& options) {
  CGAL_precondition(width >= 2 && height >= 4);
  const int legend = std::min(legend_height(scene.legend, width, height), height / 2);
  const int cell_width = width / 2, cell_height = (height - legend) / 2;
  const View views[] = {View::three_quarter, View::front, View::side, View::back};
  const char* names[] = {"three-quarter", "front", "side", "back"};
  Scene bare = scene;
  bare.legend = Legend();
  Image sheet = blank_image(width, height, options.background, options.transparent);
  const double size = std::min(std::max(cell_height / 24.0, 8.0), 22.0);
  for (int i = 0; i < 4; ++i) {
    const int left = i % 2 * cell_width, top = i / 2 * cell_height,
              name_height = std::min(int(2 * size), cell_height - 1);
    paste(render(bare, camera(views[i], up), cell_width, cell_height - name_height, options), left, top,
          sheet);
    Canvas(sheet).text(left + cell_width / 2.0, top + cell_height - 0.8 * size, size, names[i],
                       Colour{140, 138, 144}, 0.5);
  }
  if (legend > 0) draw_legend(scene.legend, sheet, height - legend, legend);
  return sheet;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
