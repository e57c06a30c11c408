// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/canvas.h"

#include <array>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {
namespace {

/// A character's width and strokes. A point is two digits, x and y; strokes are separated by spaces. A stroke
/// that begins with '~' is the control polygon of a smooth curve, one that begins with 'o' that of a closed
/// smooth curve.
struct Glyph_source {
  char character;
  int width;
  const char* strokes;
};

constexpr Glyph_source glyphs[] = {
    {' ', 2, ""},
    {'!', 0, "0804 0202"},
    {'"', 1, "0807 1817"},
    {'#', 4, "1218 3238 0343 0747"},
    {'%', 5, "0258 o06081816 o42445452"},
    {'\'', 0, "0806"},
    {'(', 2, "~29070220"},
    {')', 2, "~09272200"},
    {'*', 4, "2723 0644 0446"},
    {'+', 4, "0444 2622"},
    {',', 1, "1211 1100"},
    {'-', 3, "0434"},
    {'.', 0, "0202"},
    {'/', 3, "0138"},
    {'0', 4, "o02084842"},
    {'1', 2, "0628 2822"},
    {'2', 4, "~0608484602 0242"},
    {'3', 4, "~0708484515 ~1545420203"},
    {'4', 4, "38044438 3832"},
    {'5', 4, "480805 ~0545420203"},
    {'6', 4, "~4748080242450503"},
    {'7', 4, "084812"},
    {'8', 4, "o08484505 o05454202"},
    {'9', 4, "~0302424808054547"},
    {':', 0, "0202 0505"},
    {';', 1, "1211 1100 1515"},
    {'<', 4, "460442"},
    {'=', 4, "0343 0545"},
    {'>', 4, "064402"},
    {'?', 4, "~0708484624 2423 2222"},
    {'A', 6, "023862 1454"},
    {'B', 4, "0208 ~08484505 ~05454202"},
    {'C', 4, "~474808024243"},
    {'D', 4, "0208 ~082848422202"},
    {'E', 4, "48080242 0535"},
    {'F', 4, "480802 0535"},
    {'G', 4, "~474808024244 4424"},
    {'H', 4, "0802 4842 0545"},
    {'I', 0, "0802"},
    {'J', 3, "3834 ~34320203"},
    {'K', 4, "0802 4804 1542"},
    {'L', 4, "080242"},
    {'M', 6, "0208346862"},
    {'N', 4, "02084248"},
    {'O', 5, "o02085852"},
    {'P', 4, "0208 ~08484404"},
    {'Q', 5, "o02085852 3451"},
    {'R', 4, "0208 ~08484404 2442"},
    {'S', 4, "~4748080545420203"},
    {'T', 4, "0848 2822"},
    {'U', 4, "~080502424548"},
    {'V', 4, "082248"},
    {'W', 6, "0812375268"},
    {'X', 4, "0842 0248"},
    {'Y', 4, "082548 2522"},
    {'Z', 4, "08480242"},
    {'[', 2, "28080020"},
    {']', 2, "08282000"},
    {'_', 4, "0141"},
    {'a', 4, "o02064642 4642"},
    {'b', 4, "0802 o02064642"},
    {'c', 4, "~454606024243"},
    {'d', 4, "4842 o02064642"},
    {'e', 4, "0444 ~444606024243"},
    {'f', 3, "~38181612 0636"},
    {'g', 4, "o02064642 4642 ~42400001"},
    {'h', 4, "0802 ~0406464442"},
    {'i', 0, "0602 0808"},
    {'j', 1, "1612 ~121000 1818"},
    {'k', 3, "0802 3603 1432"},
    {'l', 0, "0802"},
    {'m', 6, "0602 ~0406363432 ~3436666462"},
    {'n', 4, "0602 ~0406464442"},
    {'o', 4, "o02064642"},
    {'p', 4, "0600 o02064642"},
    {'q', 4, "4640 o02064642"},
    {'r', 3, "0602 ~04063635"},
    {'s', 3, "~3536060434320203"},
    {'t', 3, "1814 ~141232 0636"},
    {'u', 4, "~0604024244 4642"},
    {'v', 4, "062246"},
    {'w', 6, "0612365266"},
    {'x', 4, "0642 0246"},
    {'y', 4, "0622 4610"},
    {'z', 4, "06460242"},
    {'|', 0, "0900"},
};

constexpr const char* box = "0208484202";

/// Corner cutting: three rounds come close to the quadratic spline of the polygon.
Stroke smoothed(Stroke polygon, bool closed) {
  for (int round = 0; round < 3; ++round) {
    Stroke next;
    const std::size_t n = polygon.size(), sides = closed ? n : n - 1;
    if (!closed) next.push_back(polygon.front());
    for (std::size_t i = 0; i < sides; ++i) {
      const Eigen::Vector2f &a = polygon[i], &b = polygon[(i + 1) % n];
      // The outer quarters of an open curve's first and last side stay, so that its ends do.
      if (closed || i > 0) next.push_back(0.75f * a + 0.25f * b);
      if (closed || i + 1 < sides) next.push_back(0.25f * a + 0.75f * b);
    }
    if (!closed) next.push_back(polygon.back());
    polygon = std::move(next);
  }
  if (closed) polygon.push_back(polygon.front());
  return polygon;
}

Glyph parse(int width, const char* text) {
  Glyph result;
  result.width = float(width);
  while (*text != 0) {
    const bool open = *text == '~', closed = *text == 'o';
    if (open || closed) ++text;
    Stroke stroke;
    for (; text[0] != 0 && text[0] != ' '; text += 2)
      stroke.emplace_back(float(text[0] - '0'), float(text[1] - '0'));
    while (*text == ' ') ++text;
    result.strokes.push_back(open || closed ? smoothed(std::move(stroke), closed) : std::move(stroke));
  }
  return result;
}

std::array<Glyph, 128> parse_all() {
  std::array<Glyph, 128> table;
  table.fill(parse(4, box));
  for (const Glyph_source& source : glyphs)
    table[std::size_t(source.character)] = parse(source.width, source.strokes);
  return table;
}

} // namespace

const Glyph& glyph(char c) {
  static const std::array<Glyph, 128> table = parse_all();
  const auto code = static_cast<unsigned char>(c);
  return table[code < 128 ? code : 127];
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
