// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module `reebquad._core`.
#ifndef REEBQUAD_PYTHON_BIND_H
#define REEBQUAD_PYTHON_BIND_H

#include <pybind11/pybind11.h>

namespace reebquad {
namespace python {

void bind_editor(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_quadrangulate(pybind11::module_& module);
void bind_reeb_graph(pybind11::module_& module);

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_BIND_H
