// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_PYTHON_FAILURE_H
#define REEBQUAD_PYTHON_FAILURE_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace reebquad {
namespace python {

namespace py = pybind11;

/// An error of the library on its way to Python, where it becomes the class of its code.
class Failed : public std::runtime_error {
public:
  explicit Failed(CGAL::Reeb_quadrangulation::Error error)
      : std::runtime_error(error.message), m_error(std::move(error)) {}
  const CGAL::Reeb_quadrangulation::Error& error() const { return m_error; }

private:
  CGAL::Reeb_quadrangulation::Error m_error;
};

/// Throws `impossible_request` with a sentence.
[[noreturn]] void
refuse(const std::string& sentence,
       CGAL::Reeb_quadrangulation::Element_kind element = CGAL::Reeb_quadrangulation::Element_kind::none,
       std::int64_t index = -1);

/// The name of an error's code in Python: "refused_edit".
const char* code_name(CGAL::Reeb_quadrangulation::Error_code code);

/// Makes `Failed` an exception of `reebquad`.
void translate_failures();

template <class T> T value_of(CGAL::Reeb_quadrangulation::Result<T> result) {
  if (!result) throw Failed(result.error());
  return std::move(*result);
}
inline void value_of(const CGAL::Reeb_quadrangulation::Result<void>& result) {
  if (!result) throw Failed(result.error());
}

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_FAILURE_H
