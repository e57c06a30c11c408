// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_WORKPIECE_H
#define REEBQUAD_SESSION_WORKPIECE_H

#include "view/Design_drawing.h"

#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include <memory>
#include <optional>

namespace reebquad {
namespace studio {

/// A surface and what the user designs on it: an editor, with edits and facts as JSON and geometry as layers.
class Workpiece {
public:
  using Observer = CGAL::Reeb_quadrangulation::Observer;
  template <class T> using Result = CGAL::Reeb_quadrangulation::Result<T>;

  /// Nothing is designed yet; of `base` the options and the finish are used. Layers have their points
  /// relative to `origin`. \pre `surface` is connected by `connect()`
  static Result<std::unique_ptr<Workpiece>> create(CGAL::Reeb_quadrangulation::Triangle_surface surface,
                                                   const CGAL::Reeb_quadrangulation::Point& origin,
                                                   Observer* observer,
                                                   const CGAL::Reeb_quadrangulation::Recipe& base = {});

  /// \name Edits
  /// One that fails leaves everything as it was. Afterwards the quads are as they are stitched, until
  /// `finish()`.
  /// @{
  /// Returns what changed. If it is asked to stop too late, it is taken back, unless it is `live`: another
  /// takes its place anyway.
  Result<Json> apply(const Json& edit, Observer* observer, bool live = false);
  /// Whether the edit would be done, and how many charts there would be.
  Result<Json> preview(const Json& edit, Observer* observer) const;
  /// The nearest edit that works in place of one that is refused: `edit`, `words`, `place` in the file's
  /// coordinates; null if there is none, or if the edit is not refused.
  Result<Json> offer(const Json& edit, Observer* observer) const;
  /// Edits that are worth while, as `to_json()` of hints writes them.
  Result<Json> hints(Observer* observer) const;
  /// Undoes the last edit as if it had not been done: it cannot be redone. \pre there is one
  void take_back();
  /// Edits that were undone cannot be redone.
  void forget_undone() { m_edits.resize(std::size_t(applied())); }
  Result<void> undo();
  Result<void> redo();
  /// Relaxes the quads on the surface, as `reebquad replay` ends.
  Result<void> finish(Observer* observer);
  /// @}

  /// Those that are applied, then those that can be redone.
  const std::vector<Json>& edits() const { return m_edits; }
  int applied() const { return m_editor.position(); }
  CGAL::Reeb_quadrangulation::Recipe recipe() const;

  Layers layers();
  /// What the page shows besides geometry: charts, extrema, the size of the quads.
  Json facts() const;
  /// The frame of a chart's texture. Fails with `impossible_request` if there is no chart of that identity.
  Result<std::shared_ptr<const std::string>> chart(int id) const;

  /// The frame of how far surface and quads are from each other. Fails where there are no quads.
  Result<std::shared_ptr<const std::string>> deviation(const Observer* observer) const;

  const CGAL::Reeb_quadrangulation::Triangle_surface& surface() const { return m_editor.input(); }
  /// The quads with the valences that the layout predicts, or null while there are none.
  const CGAL::Reeb_quadrangulation::Stitched_mesh* quads() const { return m_quads ? &*m_quads : nullptr; }
  /// Fans of triangles, which fill the quads' holes at whole poles.
  const std::vector<CGAL::Reeb_quadrangulation::Pole_fan>& fans() const { return m_fans; }
  bool is_finished() const { return m_finished || !m_quads; }

private:
  Workpiece(CGAL::Reeb_quadrangulation::Editor editor, const CGAL::Reeb_quadrangulation::Point& origin,
            const CGAL::Reeb_quadrangulation::Finish_options& finish);
  void stitch();

  CGAL::Reeb_quadrangulation::Editor m_editor;
  CGAL::Reeb_quadrangulation::Finish_options m_finish;
  Design_drawing m_drawing; ///< of the design as the layers show it
  CGAL::Reeb_quadrangulation::Point m_origin;
  Layers m_surface; ///< the layer of the surface, which no edit changes
  Layers
      m_designed; ///< the layers that do not change when the quads are finished; empty if they are to be made
  std::optional<CGAL::Reeb_quadrangulation::Stitched_mesh> m_quads;
  std::vector<CGAL::Reeb_quadrangulation::Pole_fan> m_fans; ///< of `m_quads`
  CGAL::Reeb_quadrangulation::Quad_mesh m_stitched;         ///< the quads and fans before they were finished
  bool m_finished = false;
  std::vector<Json>
      m_edits; ///< the editor's, but for one that was taken back for good; made once, not for every state
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_WORKPIECE_H
