// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to the pictures: flat drawing with soft borders, and a stroke font.
#ifndef REEBQUAD_PICTURE_CANVAS_H
#define REEBQUAD_PICTURE_CANVAS_H

#include <CGAL/Reeb_quadrangulation/render.h>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// A stroke of a glyph on the font's grid: capitals stand between y = 2 (the baseline) and y = 8.
using Stroke = std::vector<Eigen::Vector2f>;

/// The colour of texts and axes.
constexpr Colour ink{58, 56, 62};

struct Glyph {
  float width = 4;
  std::vector<Stroke> strokes;
};

/// The glyph of an ASCII character; a hollow box for all others.
const Glyph& glyph(char c);

/// Draws on a picture it does not own. Coordinates are pixels from the upper left corner, pixel centres at
/// halves.
class Canvas {
public:
  explicit Canvas(Image& image) : m_image(image) {}

  void fill(Colour colour);
  void rectangle(double left, double top, double right, double bottom, Colour colour);
  void line(double ax, double ay, double bx, double by, double width, Colour colour);
  void disc(double x, double y, double radius, Colour colour) { line(x, y, x, y, 2 * radius, colour); }
  /// `y` is the baseline; `align` 0 starts at x, 0.5 is centred, 1 ends there. `size` is the height of a line
  /// of text.
  void text(double x, double y, double size, const std::string& text, Colour colour, double align = 0);
  static double text_width(double size, const std::string& text);

private:
  void blend(int x, int y, Colour colour, double opacity);
  Image& m_image;
};

/// A number in at most `digits` significant digits, without trailing zeros.
std::string short_number(double value, int digits = 3);

/// Height that a legend takes on a picture of that size; 0 if there is none.
int legend_height(const Legend& legend, int width, int height);
void draw_legend(const Legend& legend, Image& image, int top, int height);

/// A picture of one colour, opaque or not at all.
Image blank_image(int width, int height, Colour colour, bool transparent);

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_PICTURE_CANVAS_H
