// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind.h"
#include "failure.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of reebquad; the package wraps it.";
  module.attr("version") = REEBQUAD_VERSION;
  reebquad::python::translate_failures();
  reebquad::python::bind_editor(module);
  reebquad::python::bind_meshes(module);
  reebquad::python::bind_quadrangulate(module);
  reebquad::python::bind_reeb_graph(module);
}
