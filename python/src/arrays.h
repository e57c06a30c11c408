// SPDX-License-Identifier: GPL-3.0-or-later
// NumPy arrays as the library's arrays, and back. What does not fit is refused with a sentence.
#ifndef REEBQUAD_PYTHON_ARRAYS_H
#define REEBQUAD_PYTHON_ARRAYS_H

#include "failure.h"

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <pybind11/numpy.h>

#include <array>
#include <vector>

namespace reebquad {
namespace python {

using CGAL::Reeb_quadrangulation::Point;
using CGAL::Reeb_quadrangulation::Polygon_soup;

/// Whether coordinates may be NaN or infinite.
enum class Coordinates { finite, any };

/// An array of shape (n, 3). `name` is what messages call it.
std::vector<Point> points_from(const py::object& array, const char* name,
                               Coordinates allowed = Coordinates::finite);
/// Three numbers.
Point point_from(const py::object& array, const char* name);
/// An array of shape (n,), finite.
std::vector<double> numbers_from(const py::object& array, const char* name);
/// Indices below `end` in an array of shape (n, columns), or (n,) where `columns` is 1.
std::vector<int> indices_from(const py::object& array, const char* name, int columns, int end);
/// Points and faces: an integer array of shape (m, k), or a sequence of rows of any lengths.
Polygon_soup soup_from(const py::object& vertices, const py::object& faces,
                       Coordinates allowed = Coordinates::finite);
/// The rows of a soup as triangles. Refuses others.
std::vector<CGAL::Reeb_quadrangulation::Triangle> triangles_of(const Polygon_soup& soup);
/// The rows of a soup as quads. Refuses others.
std::vector<CGAL::Reeb_quadrangulation::Quad> quads_of(const Polygon_soup& soup);

py::array to_array(const std::vector<Point>& points);
py::array to_array(const std::vector<int>& numbers);
py::array to_array(const std::vector<double>& numbers);
/// One array of shape (m, k) where all faces have k corners, else a list of arrays.
py::object faces_of(const Polygon_soup& soup);

template <std::size_t N> py::array to_array(const std::vector<std::array<int, N>>& rows) {
  py::array_t<int> array({py::ssize_t(rows.size()), py::ssize_t(N)});
  std::copy_n(rows.empty() ? nullptr : rows[0].data(), rows.size() * N, array.mutable_data());
  return std::move(array);
}

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_ARRAYS_H
