// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_RENDER_H
#define CGAL_REEB_QUADRANGULATION_RENDER_H

#include <CGAL/Reeb_quadrangulation/Result.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A picture: `width * height` pixels, row by row from the top, four bytes each (red, green, blue, opacity;
/// not premultiplied).
struct Image {
  int width = 0, height = 0;
  std::vector<unsigned char> rgba;
};

/// Where the eye is. The distance and the magnification follow from the scene: everything is seen, with a
/// margin.
struct Camera {
  Point direction{0, 0, -1}; ///< from the eye into the scene
  Point up{0, 1,
           0}; ///< this direction points up on the picture; replaced by an axis if parallel to `direction`
  double field_of_view = 20; ///< degrees, up to 90; 0 is an orthographic view
  double zoom = 1;           ///< above 1 the middle of the scene fills more than the picture
};

/// The axis that points up in the model.
enum class Up_axis { x, y, z };

/// Named views of a model. For `front` the eye stands on the positive z, x or y axis where y, z or x is up;
/// for `side` to the right of that.
enum class View { three_quarter, front, side, back };

Camera camera(View view, Up_axis up = Up_axis::y);

/// The same where any direction points up: the views of the axis nearest to it, turned the shortest way; of
/// the opposite axis, upside down. \pre `up` is finite and not zero
Camera camera(View view, const Point& up);

struct Render_options {
  int samples = 3; ///< each pixel is the mean of samples x samples colours; 1 to 8
  Colour background{255, 255, 255};
  bool transparent = false; ///< no background; the opacity is the part of the pixel that is covered
  double occlusion = 0.5;   ///< darkening of hollows, 0 (none) to 1, from the depths of neighbouring pixels
};

/// Renders with a z-buffer of exact integer coverage and a headlight, a key light from the upper left and a
/// sky. The same scene gives the same bytes. An empty scene gives the background. O(points + faces +
/// samples), memory O(points + pixels): the samples are held for a band of the picture only. \pre positive
/// sizes; the scene's arrays have the sizes that `Scene` names and indices in range
Image render(const Scene& scene, const Camera& camera, int width, int height,
             const Render_options& options = {});

/// Four named views (three-quarter, front, side, back) on one sheet, with the scene's legend once.
Image contact_sheet(const Scene& scene, Up_axis up, int width, int height,
                    const Render_options& options = {});
Image contact_sheet(const Scene& scene, const Point& up, int width, int height,
                    const Render_options& options = {});

/// Pictures side by side, row by row, in `columns` columns of equal cells, centred in their cells.
Image compose(const std::vector<Image>& images, int columns, int gap = 8,
              Colour background = {255, 255, 255});

/// What a bar chart shows.
struct Histogram {
  std::vector<double> bins; ///< height of each bar, from `low` to `high` in equal steps
  double low = 0, high = 1;
  std::string title, x_label, note; ///< `note` stands in the upper left corner, lines separated by '\n'
  Colour_map colours;               ///< along the axis; one blue if empty
};

/// A bar chart with axes, ticks and texts. Bins that are negative or not finite count as zero.
Image histogram_image(const Histogram& histogram, int width = 640, int height = 400);

/// Whether the library was built with libpng. Without it pictures are drawn, but not written.
bool can_write_png();

/// The picture as a PNG file in memory, without time stamps: the same picture gives the same bytes; no
/// bytes if not `can_write_png()`. \pre `rgba` has its size
std::vector<unsigned char> encode_png(const Image& image);

/// Writes the picture as a PNG file, whole or not at all. Fails with `unwritable_file`, and with
/// `unsupported_format` if not `can_write_png()`.
Result<void> write_png(const Image& image, const std::string& path);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_RENDER_H
