// SPDX-License-Identifier: GPL-3.0-or-later
#include "Marks_input.h"

#include "Attributes.h"
#include "Failure.h"
#include "Text_input.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

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

/// The lines of an OBJ file, piece by piece.
Result<Marks> marks_of_obj(const std::vector<Text_line>& lines) {
  const Result<std::vector<std::vector<Point>>> polylines = polylines_of_obj(lines);
  if (!polylines) return polylines.error();
  Marks marks;
  for (const std::vector<Point>& points : *polylines)
    for (std::size_t i = 1; i < points.size(); ++i) marks.marked.push_back({points[i - 1], points[i]});
  return marks;
}

} // namespace

Result<std::vector<std::vector<Point>>> polylines_of_obj(const std::vector<Text_line>& lines) {
  std::vector<Point> points;
  std::vector<std::vector<Point>> polylines;
  for (const Text_line& line : lines) {
    std::istringstream in(line.text);
    std::string word;
    in >> word;
    if (word == "v") {
      const std::optional<std::vector<double>> n = numbers_of(in);
      if (!n || n->size() < 3) return malformed(line, "expected the coordinates of a point");
      points.emplace_back((*n)[0], (*n)[1], (*n)[2]);
    } else if (word == "l") {
      polylines.emplace_back();
      for (std::string corner; in >> corner;) {
        std::istringstream one(corner.substr(0, corner.find('/')));
        double x = 0;
        if (!(one >> x) || !one.eof()) return malformed(line, "expected indices of points");
        const int i =
            x < 0 ? index_of(double(points.size()) + x, 0, points.size()) : index_of(x, 1, points.size());
        if (i < 0) return malformed(line, "there is no such point before, points count from 1");
        polylines.back().push_back(points[std::size_t(i)]);
      }
    }
  }
  return polylines;
}

void declare_marks(Command_line& line) {
  line.options.add_options()("marks", po::value<std::string>()->value_name("FILE"),
                             "edges that quads keep, beside those of --feature-angle: lines 'mark A B' and "
                             "'unmark A B', points of the mesh "
                             "counted from 0 or positions, or an OBJ file with lines")(
      "mark-groups", "mark the borders of groups and materials of the mesh, an OBJ or PLY file")(
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

Marks read_marks(const Marks_request& request, const std::string& input, const Attributed_soup& mesh) {
  Marks marks;
  if (!request.file.empty())
    marks = value_or_fail(
        parse_marks(value_or_fail(read_file(request.file, largest_marks), request.file), mesh.soup),
        request.file);
  if (!request.groups && !request.seams) return marks;
  const std::vector<Mark> borders =
      value_or_fail(borders_of_attributes(mesh, request.groups, request.seams), input);
  marks.marked.insert(marks.marked.end(), borders.begin(), borders.end());
  return marks;
}

namespace {

// What a polygon is on one side of an edge: its names, and the texture coordinates at the edge's lower and
// higher vertex.
struct Edge_side {
  std::vector<int> names;
  std::array<Eigen::Vector2d, 2> uv;
};

// Corners without texture coordinates are alike.
bool is_same(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a == b || (!a.allFinite() && !b.allFinite());
}

bool is_same(const Edge_side& a, const Edge_side& b) {
  return a.names == b.names && is_same(a.uv[0], b.uv[0]) && is_same(a.uv[1], b.uv[1]);
}

} // namespace

Result<std::vector<Mark>> borders_of_attributes(const Attributed_soup& mesh, bool groups, bool seams) {
  const Polygon_soup& soup = mesh.soup;
  std::vector<const Face_labels*> names;
  for (const Face_labels& labels : mesh.attributes.labels)
    if (groups && labels.kind != "chart") names.push_back(&labels);
  const std::vector<Eigen::Vector2d>& uv = mesh.attributes.uv;
  if ((groups && names.empty()) || (seams && uv.empty()))
    return make_error(Error_code::unsupported_format,
                      "it has no groups or materials, or no texture coordinates, as OBJ and PLY files may");
  std::map<std::array<int, 2>, Edge_side> seen;
  std::map<std::array<int, 2>, bool> is_border;
  for (int p = 0; p < soup.number_of_polygons(); ++p) {
    Edge_side side;
    for (const Face_labels* labels : names) side.names.push_back(labels->label[std::size_t(p)]);
    const int size = soup.size_of_polygon(p), begin = soup.begin[std::size_t(p)];
    for (int i = 0; i < size; ++i) {
      std::array<std::size_t, 2> corner{std::size_t(begin + i), std::size_t(begin + (i + 1) % size)};
      if (soup.corner[corner[0]] > soup.corner[corner[1]]) std::swap(corner[0], corner[1]);
      for (std::size_t k = 0; k < 2; ++k) side.uv[k] = seams ? uv[corner[k]] : Eigen::Vector2d(0, 0);
      const std::array<int, 2> ends{soup.corner[corner[0]], soup.corner[corner[1]]};
      const auto [entry, is_new] = seen.emplace(ends, side);
      if (!is_new && !is_same(entry->second, side)) is_border[ends] = true;
    }
  }
  std::vector<Mark> marks;
  for (const auto& [ends, border] : is_border)
    marks.push_back({soup.points[std::size_t(ends[0])], soup.points[std::size_t(ends[1])]});
  return marks;
}

} // namespace reebquad
