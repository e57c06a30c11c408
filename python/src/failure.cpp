// SPDX-License-Identifier: GPL-3.0-or-later
#include "failure.h"

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

void refuse(const std::string& sentence, Element_kind element, std::int64_t index) {
  throw Failed(make_error(Error_code::impossible_request, sentence, element, index));
}

const char* code_name(Error_code code) {
  switch (code) {
  case Error_code::unreadable_file: return "unreadable_file";
  case Error_code::malformed_file: return "malformed_file";
  case Error_code::unsupported_format: return "unsupported_format";
  case Error_code::unwritable_file: return "unwritable_file";
  case Error_code::not_a_surface: return "not_a_surface";
  case Error_code::impossible_request: return "impossible_request";
  case Error_code::refused_edit: return "refused_edit";
  case Error_code::solver_failure: return "solver_failure";
  case Error_code::infeasible_sampling: return "infeasible_sampling";
  case Error_code::certificate_failure: return "certificate_failure";
  case Error_code::cancelled: return "cancelled";
  case Error_code::internal_error: break;
  }
  return "internal_error";
}

namespace {

void raise(const Error& error) {
  const bool has_element = error.element != Element_kind::none;
  const py::object element = has_element ? py::object(py::str(name(error.element))) : py::object(py::none());
  const py::object index = has_element ? py::object(py::int_(error.index)) : py::object(py::none());
  const py::object exception = py::module_::import("reebquad.errors")
                                   .attr("error_of")(code_name(error.code), error.message, element, index);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

} // namespace

void translate_failures() {
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const Failed& failed) {
      raise(failed.error());
    }
  });
}

} // namespace python
} // namespace reebquad
