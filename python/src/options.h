// SPDX-License-Identifier: GPL-3.0-or-later
// The keywords of Python as options of the library.
#ifndef REEBQUAD_PYTHON_OPTIONS_H
#define REEBQUAD_PYTHON_OPTIONS_H

#include "failure.h"

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/suggest_edits.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

namespace reebquad {
namespace python {

/// Reads a dictionary of keywords, whose `None` means the default, and refuses those that nobody has asked
/// for.
class Keywords {
public:
  explicit Keywords(py::dict values) : m_left(std::move(values)) {}

  /// A keyword's value, which stays.
  py::object peek(const char* name) const;
  /// Takes a keyword's value out; `None` where it is not given.
  py::object take(const char* name);
  void read(const char* name, int& option);
  void read(const char* name, double& option);
  void read(const char* name, bool& option);
  /// The value as one of the names.
  template <class T>
  void read(const char* name, T& option, const std::vector<std::pair<const char*, T>>& choices) {
    const std::string text = take_text(name);
    if (text.empty()) return;
    std::string names;
    for (const auto& [choice, value] : choices) {
      if (text == choice) {
        option = value;
        return;
      }
      names += (names.empty() ? "" : ", ") + std::string(choice);
    }
    refuse(std::string(name) + " is one of " + names + "; it got '" + text + "'");
  }
  /// Empty where it is not given.
  std::string take_text(const char* name);
  /// Raises `TypeError` where a keyword is left.
  void end() const;

private:
  py::dict m_left;
};

void read_mending(Keywords& keywords, CGAL::Reeb_quadrangulation::Mend_options& options);
void read_engine(Keywords& keywords, CGAL::Reeb_quadrangulation::Editor_options& options);
void read_finish(Keywords& keywords, CGAL::Reeb_quadrangulation::Finish_options& options);
void read_hints(Keywords& keywords, CGAL::Reeb_quadrangulation::Hint_options& options);

/// All but what needs the mesh: extrema that are given as vertices, features and sizes.
void read_run(Keywords& keywords, CGAL::Reeb_quadrangulation::Quadrangulation_options& options);

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_OPTIONS_H
