// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/render.h>

#include <CGAL/assertions.h>

#ifdef REEBQUAD_WITH_PNG
#include <png.h>

#include <stdexcept>
#endif

namespace CGAL {
namespace Reeb_quadrangulation {

#ifndef REEBQUAD_WITH_PNG

bool can_write_png() {
  return false;
}

std::vector<unsigned char> encode_png(const Image&) {
  return {};
}

#else

bool can_write_png() {
  return true;
}

namespace {

/// The picture's bytes without opacity if all of it is opaque, else as they are.
std::vector<unsigned char> packed(const Image& image, bool& opaque) {
  opaque = true;
  for (std::size_t i = 3; i < image.rgba.size() && opaque; i += 4) opaque = image.rgba[i] == 255;
  if (!opaque) return image.rgba;
  std::vector<unsigned char> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), image.rgba.begin() + std::ptrdiff_t(i), image.rgba.begin() + std::ptrdiff_t(i) + 3);
  return rgb;
}

} // namespace

std::vector<unsigned char> encode_png(const Image& image) {
  CGAL_precondition(image.width > 0 && image.height > 0);
  CGAL_precondition(image.rgba.size() == std::size_t(image.width) * image.height * 4);
  bool opaque = true;
  const std::vector<unsigned char> pixels = packed(image, opaque);
  png_image control = {};
  control.version = PNG_IMAGE_VERSION;
  control.width = png_uint_32(image.width);
  control.height = png_uint_32(image.height);
  control.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(control);
  std::vector<unsigned char> out(size);
  // With memory that suffices for every picture of this size only the lack of memory inside libpng is left to
  // fail.
  if (png_image_write_to_memory(&control, out.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(control.message);
  out.resize(size);
  out.shrink_to_fit();
  return out;
}

#endif

} // namespace Reeb_quadrangulation
} // namespace CGAL
