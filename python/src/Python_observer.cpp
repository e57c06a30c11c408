// SPDX-License-Identifier: GPL-3.0-or-later
#include "Python_observer.h"

namespace reebquad {
namespace python {

Python_observer::Python_observer(py::object callback) : m_callback(std::move(callback)) {
  if (!m_callback.is_none() && !PyCallable_Check(m_callback.ptr()))
    throw py::type_error("progress is a function of a stage and a fraction, or None");
}

void Python_observer::progress(const std::string& stage, double fraction) {
  if (m_callback.is_none() || m_stopped) return;
  const py::gil_scoped_acquire locked;
  try {
    if (m_callback(stage, fraction).is(py::bool_(false))) m_stopped = true;
  } catch (py::error_already_set& error) {
    m_error.emplace(error);
    m_stopped = true;
  }
}

bool Python_observer::cancelled() const {
  constexpr auto pause = std::chrono::milliseconds(50);
  if (m_stopped || std::this_thread::get_id() != m_owner) return m_stopped;
  const auto now = std::chrono::steady_clock::now();
  if (now - m_asked < pause) return false;
  m_asked = now;
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) {
    m_error.emplace();
    m_stopped = true;
  }
  return m_stopped;
}

void Python_observer::raise() const {
  if (m_error) throw py::error_already_set(*m_error);
}

} // namespace python
} // namespace reebquad
