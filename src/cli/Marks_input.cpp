// SPDX-License-Identifier: GPL-3.0-or-later
#include "Marks_input.h"

#include "Failure.h"
#include "Text_input.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

constexpr std::uint64_t largest_marks = std::uint64_t(64) << 20;

Error malformed(const Text_line& line, const std::string& what) {
  return make_error(Error_code::malformed_file, "line " + std::to_string(line.number) + ": " + what);
}

/// The numbers of a line behind its first word; nothing if one is none.
std::optional<std::vector<double>> numbers_of(std::istream& in) {
  std::vector<double> numbers;
  for (std::string word; in >> word;) {
    std::istringstream one(word);
    double x = 0;
    if (!(one >> x) || !one.eof() || !std::isfinite(x)) return std::nullopt;
    numbers.push_back(x);
  }
  return numbers;
}

/// The index that a number counts from `first`, or -1.
int index_of(double x, int first, std::size_t size) {
  const double i = x - first;
  return i == std::floor(i) && i >= 0 && i < double(size) ? int(i) : -1;
}

Result<Mark> mark_of(const Text_line& line, const std::vector<double>& n, const Polygon_soup& soup) {
  if (n.size() == 6) return Mark{Point(n[0], n[1], n[2]), Point(n[3], n[4], n[5])};
  if (n.size() != 2) return malformed(line, "a mark has two points of the mesh, or two positions");
  const int a = index_of(n[0], 0, soup.points.size()), b = index_of(n[1], 0, soup.points.size());
  if (a < 0 || b < 0)
    return malformed(line, "there is no such point, the mesh has " + std::to_string(soup.points.size()) +
                               ", counted from 0");
  return Mark{soup.points[std::size_t(a)], soup.points[std::size_t(b)]};
}

Result<Marks> marks_of_text(const std::vector<Text_line>& lines, const Polygon_soup& soup) {
  Marks marks;
  for (const Text_line& line : lines) {
    std::istringstream in(line.text);
    std::string word;
    in >> word;
    const std::optional<std::vector<double>> numbers = numbers_of(in);
    if ((word != "mark" && word != "unmark") || !numbers)
      return malformed(line, "expected 'mark A B' or 'unmark A B'");
    const Result<Mark> mark = mark_of(line, *numbers, soup);
    if (!mark) return mark.error();
    (word == "mark" ? marks.marked : marks.unmarked).push_back(*mark);
  }
  return marks;
}

/// The polylines of an OBJ file: its own points, and lines through these.
Result<Marks> marks_of_obj(const std::vector<Text_line>& lines) {
  std::vector<Point> points;
  Marks marks;
  for (const Text_line& line : lines) {
    std::istringstream in(line.text);
    std::string word;
    in >> word;
    if (word == "v") {
      const std::optional<std::vector<double>> n = numbers_of(in);
      if (!n || n->size() < 3) return malformed(line, "expected the coordinates of a point");
      points.emplace_back((*n)[0], (*n)[1], (*n)[2]);
    } else if (word == "l") {
      int last = -1;
      for (std::string corner; in >> corner;) {
        std::istringstream one(corner.substr(0, corner.find('/')));
        double x = 0;
        if (!(one >> x) || !one.eof()) return malformed(line, "expected indices of points");
        const int i =
            x < 0 ? index_of(double(points.size()) + x, 0, points.size()) : index_of(x, 1, points.size());
        if (i < 0) return malformed(line, "there is no such point before, points count from 1");
        if (last >= 0) marks.marked.push_back({points[std::size_t(last)], points[std::size_t(i)]});
        last = i;
      }
    }
  }
  return marks;
}

} // namespace

void declare_marks(Command_line& line) {
  line.options.add_options()("marks", po::value<std::string>()->value_name("FILE"),
                             "edges that quads keep, beside those of --feature-angle: lines 'mark A B' and "
                             "'unmark A B', points of the mesh "
                             "counted from 0 or positions, or an OBJ file with lines")(
      "mark-groups", "mark the borders of groups and materials of the mesh, an OBJ file")(
      "mark-seams", "mark its seams of texture coordinates");
}

Marks_request marks_request(const Command_line& line) {
  Marks_request request;
  if (line.has("marks")) request.file = line.text("marks");
  request.groups = line.has("mark-groups");
  request.seams = line.has("mark-seams");
  return request;
}

Result<Marks> parse_marks(const std::string& text, const Polygon_soup& soup) {
  const std::vector<Text_line> lines = lines_of(text);
  const bool is_obj = std::any_of(lines.begin(), lines.end(), [](const Text_line& line) {
    return line.text.compare(0, 2, "v ") == 0 || line.text.compare(0, 2, "l ") == 0;
  });
  Result<Marks> marks = is_obj ? marks_of_obj(lines) : marks_of_text(lines, soup);
  if (marks && marks->empty()) return make_error(Error_code::malformed_file, "it marks no edge");
  return marks;
}

Marks read_marks(const Marks_request& request, const std::string& input, const Polygon_soup& soup) {
  Marks marks;
  if (!request.file.empty())
    marks = value_or_fail(
        parse_marks(value_or_fail(read_file(request.file, largest_marks), request.file), soup), request.file);
  if (!request.groups && !request.seams) return marks;
  const std::string text = value_or_fail(read_file(input, largest_mesh_file), input);
  const std::vector<Mark> borders =
      value_or_fail(borders_in_obj(text, soup, request.groups, request.seams), input);
  marks.marked.insert(marks.marked.end(), borders.begin(), borders.end());
  return marks;
}

namespace {

/// What the polygons of an OBJ text have besides points: a number for the group, object and material of each,
/// and the texture coordinates of each corner, 0: none.
struct Obj_attributes {
  std::vector<int> group;
  std::vector<std::vector<long>> texture;
};

Obj_attributes attributes_of(const std::string& text) {
  Obj_attributes result;
  std::map<std::array<std::string, 3>, int> numbers;
  std::array<std::string, 3> now; // object, group, material
  const std::map<std::string, std::size_t> kinds = {{"o", 0}, {"g", 1}, {"usemtl", 2}};
  long textures = 0;
  std::string joined = text;
  for (std::size_t at = 0; (at = joined.find("\\\n", at)) != std::string::npos;) joined.replace(at, 2, "  ");
  std::istringstream lines(joined);
  for (std::string line; std::getline(lines, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    std::istringstream in(line);
    std::string word;
    if (!(in >> word)) continue;
    if (word == "vt") ++textures;
    if (const auto kind = kinds.find(word); kind != kinds.end()) std::getline(in, now[kind->second]);
    if (word != "f" && word != "fo") continue;
    result.group.push_back(numbers.emplace(now, int(numbers.size())).first->second);
    result.texture.emplace_back();
    for (std::string corner; in >> corner;) {
      const std::size_t slash = corner.find('/');
      const long index =
          slash == std::string::npos ? 0 : std::strtol(corner.c_str() + slash + 1, nullptr, 10);
      result.texture.back().push_back(index < 0 ? textures + index + 1 : index);
    }
  }
  return result;
}

} // namespace

Result<std::vector<Mark>> borders_in_obj(const std::string& text, const Polygon_soup& soup, bool groups,
                                         bool seams) {
  const Obj_attributes attributes = attributes_of(text);
  const std::size_t n = std::size_t(soup.number_of_polygons());
  if (attributes.group.size() != n)
    return make_error(Error_code::unsupported_format,
                      "groups, materials and seams are read of OBJ files, which this is not");
  // Of each edge, from its smaller point: the group, and the texture coordinates at both ends.
  std::map<std::array<int, 2>, std::array<long, 3>> seen;
  std::map<std::array<int, 2>, bool> is_border;
  for (std::size_t p = 0; p < n; ++p) {
    const int size = soup.size_of_polygon(int(p)), begin = soup.begin[p];
    const std::vector<long>& texture = attributes.texture[p];
    if (int(texture.size()) != size) continue;
    for (int i = 0; i < size; ++i) {
      const int j = (i + 1) % size;
      std::array<int, 2> ends{soup.corner[std::size_t(begin + i)], soup.corner[std::size_t(begin + j)]};
      std::array<long, 3> at{groups ? attributes.group[p] : 0, seams ? texture[std::size_t(i)] : 0,
                             seams ? texture[std::size_t(j)] : 0};
      if (ends[0] > ends[1]) {
        std::swap(ends[0], ends[1]);
        std::swap(at[1], at[2]);
      }
      if (const auto [entry, is_new] = seen.emplace(ends, at); !is_new && entry->second != at)
        is_border[ends] = true;
    }
  }
  std::vector<Mark> marks;
  for (const auto& [ends, border] : is_border)
    marks.push_back({soup.points[std::size_t(ends[0])], soup.points[std::size_t(ends[1])]});
  return marks;
}

} // namespace reebquad
