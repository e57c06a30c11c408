// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/picture_scene.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace CGAL {
namespace Reeb_quadrangulation {

Colour colour_at(const Colour_map& map, double t) {
  CGAL_precondition(!map.empty());
  if (std::isnan(t)) return {150, 150, 150};
  const double place = std::min(std::max(t, 0.0), 1.0) * double(map.size() - 1);
  const std::size_t i = std::min(std::size_t(place), map.size() - 1), j = std::min(i + 1, map.size() - 1);
  const double f = place - double(i);
  const auto mix = [f](unsigned char a, unsigned char b) { return (unsigned char)(a + f * (b - a) + 0.5); };
  return {mix(map[i].r, map[j].r), mix(map[i].g, map[j].g), mix(map[i].b, map[j].b)};
}

Colour_map field_colours() {
  return {{42, 60, 130},   {52, 104, 174}, {82, 154, 196}, {150, 200, 208}, {238, 230, 210},
          {243, 196, 138}, {230, 146, 90}, {204, 88, 66},  {146, 36, 52}};
}

Colour_map quality_colours() {
  return {{120, 18, 38},   {196, 52, 48},   {234, 120, 66}, {246, 186, 96},
          {236, 224, 150}, {168, 212, 158}, {104, 184, 164}};
}

std::vector<Colour> chart_palette() {
  return {{112, 164, 204}, {236, 164, 92},  {132, 190, 124}, {216, 110, 108},
          {172, 142, 204}, {238, 208, 110}, {96, 182, 178},  {228, 150, 186},
          {176, 142, 114}, {158, 172, 84},  {120, 128, 186}, {190, 196, 202}};
}

Colour valence_colour(int valence) {
  CGAL_precondition(valence != 4);
  static const Colour above[] = {{84, 156, 232}, {36, 104, 208}, {24, 64, 164}, {16, 30, 108}};
  static const Colour below[] = {{104, 196, 92}, {32, 138, 68}, {14, 84, 50}};
  if (valence > 4) return above[std::min(valence - 5, 3)];
  return below[std::min(3 - valence, 2)];
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
