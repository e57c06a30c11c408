// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Result.h>

namespace CGAL {
namespace Reeb_quadrangulation {

const char* description(Error_code code) {
  switch (code) {
  case Error_code::unreadable_file: return "the file cannot be read";
  case Error_code::malformed_file: return "the file contradicts its format";
  case Error_code::unsupported_format: return "the format is not supported";
  case Error_code::unwritable_file: return "the file cannot be written";
  case Error_code::not_a_surface: return "the mesh is not a surface that the method takes";
  case Error_code::impossible_request: return "the request cannot be met";
  case Error_code::refused_edit: return "the edit is refused";
  case Error_code::solver_failure: return "a linear system could not be solved";
  case Error_code::infeasible_sampling: return "no integer sampling exists";
  case Error_code::certificate_failure: return "the certificate failed";
  case Error_code::cancelled: return "cancelled";
  case Error_code::internal_error: return "internal error";
  }
  return "unknown error";
}

const char* name(Element_kind kind) {
  switch (kind) {
  case Element_kind::none: return "";
  case Element_kind::vertex: return "vertex";
  case Element_kind::edge: return "edge";
  case Element_kind::face: return "face";
  case Element_kind::component: return "component";
  case Element_kind::contour: return "contour";
  case Element_kind::chart: return "chart";
  case Element_kind::node: return "node";
  case Element_kind::line: return "line";
  case Element_kind::byte: return "byte";
  }
  return "";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
