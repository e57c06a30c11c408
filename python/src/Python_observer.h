// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_PYTHON_PYTHON_OBSERVER_H
#define REEBQUAD_PYTHON_PYTHON_OBSERVER_H

#include "failure.h"

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

namespace reebquad {
namespace python {

/// Tells a Python function of the progress, and stops where that raises or returns `False`, or where a
/// signal's handler raises, as
/// that of Ctrl-C does. Only the thread that made it asks Python, which it does with the interpreter's lock.
class Python_observer : public CGAL::Reeb_quadrangulation::Observer {
public:
  /// `callback` is `None` or is called with the stage and the fraction.
  explicit Python_observer(py::object callback);

  void progress(const std::string& stage, double fraction) override;
  bool cancelled() const override;

  /// Raises what the callback or the signal's handler has raised, if one has. Needs the interpreter's lock.
  void raise() const;

private:
  py::object m_callback;
  std::thread::id m_owner = std::this_thread::get_id();
  mutable std::chrono::steady_clock::time_point m_asked = std::chrono::steady_clock::now();
  mutable std::atomic<bool> m_stopped{false};
  mutable std::optional<py::error_already_set> m_error; ///< written by the owner
};

/// Calls `work`, which returns a `Result`, without the interpreter's lock, and returns its value or raises
/// its error.
template <class Work> auto without_lock(const Python_observer& observer, const Work& work) {
  auto result = [&] {
    const py::gil_scoped_release unlocked;
    return work();
  }();
  observer.raise();
  return value_of(std::move(result));
}

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_PYTHON_OBSERVER_H
