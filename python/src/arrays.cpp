// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <algorithm>
#include <cmath>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

std::string shape_of(const py::array& array) {
  return py::str(array.attr("shape"));
}

/// Anything that NumPy takes for an array of one of these kinds ('f': floating, 'i' and 'u': integers).
/// Nothing is rounded.
py::array array_of(const py::object& object, const char* name, const std::string& kinds, const char* wanted) {
  const py::array array = py::array::ensure(object);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " is " + wanted);
  }
  const bool is_empty = array.size() == 0; // of no kind: [] is an array of floating numbers
  if (kinds.find(array.dtype().kind()) == std::string::npos && !is_empty)
    throw py::type_error(std::string(name) + " is " + wanted + "; its type is " +
                         std::string(py::str(array.dtype())));
  return array;
}

py::array doubles_of(const py::object& object, const char* name) {
  return array_of(object, name, "fiu", "an array of numbers");
}

py::array indices_of(const py::object& object, const char* name) {
  return array_of(object, name, "iu", "an array of integers");
}

int index_below(std::int64_t index, int end, const char* name, std::int64_t row, Element_kind kind) {
  if (index < 0 || index >= end)
    refuse("row " + std::to_string(row) + " of " + name + " names vertex " + std::to_string(index) +
               ", there are " + std::to_string(end),
           kind, row);
  return int(index);
}

void append_rows(const py::array& array, int points, Polygon_soup& soup) {
  const Indices indices(array);
  const auto rows = indices.unchecked<2>();
  for (py::ssize_t f = 0; f < rows.shape(0); ++f) {
    for (py::ssize_t i = 0; i < rows.shape(1); ++i)
      soup.corner.push_back(index_below(rows(f, i), points, "the faces", f, Element_kind::face));
    soup.close_polygon();
  }
}

/// Rows of several lengths, which NumPy has no array for.
void append_sequence(const py::sequence& faces, int points, Polygon_soup& soup) {
  std::int64_t f = 0;
  for (const py::handle& face : faces) {
    const Indices row(indices_of(py::reinterpret_borrow<py::object>(face), "a face"));
    if (row.ndim() != 1)
      refuse("face " + std::to_string(f) + " is no list of vertices", Element_kind::face, f);
    for (py::ssize_t i = 0; i < row.shape(0); ++i)
      soup.corner.push_back(index_below(row.data()[i], points, "the faces", f, Element_kind::face));
    soup.close_polygon();
    ++f;
  }
}

bool is_ragged(const py::object& faces) {
  if (!py::isinstance<py::list>(faces) && !py::isinstance<py::tuple>(faces)) return false;
  py::ssize_t length = -1;
  for (const py::handle& face : py::sequence(faces)) {
    if (!py::isinstance<py::sequence>(face)) return false;
    const py::ssize_t size = py::ssize_t(py::len(face));
    if (length >= 0 && size != length) return true;
    length = size;
  }
  return false;
}

template <std::size_t N>
std::vector<std::array<int, N>> rows_of(const Polygon_soup& soup, const char* sentence) {
  std::vector<std::array<int, N>> rows{std::size_t(soup.number_of_polygons())};
  for (int p = 0; p < soup.number_of_polygons(); ++p) {
    if (soup.size_of_polygon(p) != int(N)) refuse(sentence, Element_kind::face, p);
    std::copy_n(soup.corner.data() + soup.begin[std::size_t(p)], N, rows[std::size_t(p)].data());
  }
  return rows;
}

} // namespace

std::vector<Point> points_from(const py::object& object, const char* name, Coordinates allowed) {
  const py::array array = doubles_of(object, name);
  if (array.size() == 0) return {};
  if (array.ndim() != 2 || array.shape(1) != 3)
    refuse(std::string(name) + " has shape (n, 3), one row a point; its shape is " + shape_of(array));
  const Doubles numbers(array);
  std::vector<Point> points;
  points.reserve(std::size_t(numbers.shape(0)));
  const double* at = numbers.data();
  for (py::ssize_t p = 0; p < numbers.shape(0); ++p, at += 3) {
    points.emplace_back(at[0], at[1], at[2]);
    if (allowed == Coordinates::finite && !points.back().allFinite())
      refuse("row " + std::to_string(p) + " of " + name + " has a coordinate that is NaN or infinite",
             Element_kind::vertex, p);
  }
  return points;
}

Point point_from(const py::object& object, const char* name) {
  const std::vector<double> numbers = numbers_from(object, name);
  if (numbers.size() != 3) refuse(std::string(name) + " is three numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<double> numbers_from(const py::object& object, const char* name) {
  const py::array array = doubles_of(object, name);
  if (array.ndim() != 1) refuse(std::string(name) + " has shape (n,); its shape is " + shape_of(array));
  const Doubles numbers(array);
  std::vector<double> result(numbers.data(), numbers.data() + numbers.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    if (!std::isfinite(result[i]))
      refuse("entry " + std::to_string(i) + " of " + name + " is NaN or infinite", Element_kind::vertex,
             std::int64_t(i));
  return result;
}

std::vector<int> indices_from(const py::object& object, const char* name, int columns, int end) {
  const py::array array = indices_of(object, name);
  if (array.size() == 0) return {};
  const bool fits = columns == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (!fits)
    refuse(std::string(name) + " has shape (n," + (columns == 1 ? "" : " " + std::to_string(columns)) +
           "); its shape is " + shape_of(array));
  const Indices indices(array);
  std::vector<int> result;
  for (py::ssize_t i = 0; i < indices.size(); ++i)
    result.push_back(index_below(indices.data()[i], end, name, i / columns, Element_kind::vertex));
  return result;
}

Polygon_soup soup_from(const py::object& vertices, const py::object& faces, Coordinates allowed) {
  Polygon_soup soup;
  soup.points = points_from(vertices, "the vertices", allowed);
  if (is_ragged(faces)) {
    append_sequence(faces, soup.number_of_points(), soup);
    return soup;
  }
  const py::array array = indices_of(faces, "the faces");
  if (array.size() == 0) return soup;
  if (array.ndim() != 2 || array.shape(1) < 3)
    refuse("the faces have shape (m, 3) or (m, k), one row a polygon; their shape is " + shape_of(array));
  append_rows(array, soup.number_of_points(), soup);
  return soup;
}

std::vector<Triangle> triangles_of(const Polygon_soup& soup) {
  return rows_of<3>(soup, "a face is no triangle; triangles are needed");
}

std::vector<Quad> quads_of(const Polygon_soup& soup) {
  return rows_of<4>(soup, "a face is no quad; quads are needed");
}

py::array to_array(const std::vector<Point>& points) {
  static_assert(sizeof(Point) == 3 * sizeof(double), "points lie without gaps");
  py::array_t<double> array({py::ssize_t(points.size()), py::ssize_t(3)});
  std::copy_n(points.empty() ? nullptr : points[0].data(), 3 * points.size(), array.mutable_data());
  return std::move(array);
}

py::array to_array(const std::vector<int>& numbers) {
  return py::array_t<int>(py::ssize_t(numbers.size()), numbers.data());
}

py::array to_array(const std::vector<double>& numbers) {
  return py::array_t<double>(py::ssize_t(numbers.size()), numbers.data());
}

py::object faces_of(const Polygon_soup& soup) {
  const int faces = soup.number_of_polygons(), size = faces > 0 ? soup.size_of_polygon(0) : 3;
  bool same = true;
  for (int p = 0; p < faces; ++p) same = same && soup.size_of_polygon(p) == size;
  if (same) {
    py::array_t<int> array({py::ssize_t(faces), py::ssize_t(size)});
    std::copy(soup.corner.begin(), soup.corner.end(), array.mutable_data());
    return std::move(array);
  }
  py::list list;
  for (int p = 0; p < faces; ++p)
    list.append(py::array_t<int>(soup.size_of_polygon(p), soup.corner.data() + soup.begin[std::size_t(p)]));
  return std::move(list);
}

} // namespace python
} // namespace reebquad
