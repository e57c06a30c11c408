// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_PYTHON_SESSION_H
#define REEBQUAD_PYTHON_SESSION_H

#include "failure.h"

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>

#include <mutex>

namespace reebquad {
namespace python {

/// An editor for Python, with what its recipe says beside the edits. It works for one thread at a time.
class Session {
public:
  /// `recipe` has the component, the holes, the mirror and the finish; its edits are not read. With a mirror,
  /// the editor works on a half of `whole`.
  Session(CGAL::Reeb_quadrangulation::Editor editor, CGAL::Reeb_quadrangulation::Recipe recipe,
          CGAL::Reeb_quadrangulation::Triangle_surface whole = {})
      : m_editor(std::move(editor)), m_recipe(std::move(recipe)), m_whole(std::move(whole)) {}

  /// Holds the session; an error where another thread, or a progress function, is at it.
  class Hold {
  public:
    explicit Hold(Session& session) : m_lock(session.m_mutex, std::try_to_lock), m_session(session) {
      if (!m_lock) refuse("the editor is at work already, in another thread or around a progress function");
    }
    CGAL::Reeb_quadrangulation::Editor& editor() { return m_session.m_editor; }
    CGAL::Reeb_quadrangulation::Recipe& recipe() { return m_session.m_recipe; }
    const CGAL::Reeb_quadrangulation::Triangle_surface& whole() const { return m_session.m_whole; }

  private:
    std::unique_lock<std::mutex> m_lock;
    Session& m_session;
  };

private:
  std::mutex m_mutex;
  CGAL::Reeb_quadrangulation::Editor m_editor;
  CGAL::Reeb_quadrangulation::Recipe m_recipe;
  CGAL::Reeb_quadrangulation::Triangle_surface m_whole; ///< empty without a mirror
};

} // namespace python
} // namespace reebquad

#endif // REEBQUAD_PYTHON_SESSION_H
