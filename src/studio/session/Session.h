// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_SESSION_H
#define REEBQUAD_SESSION_SESSION_H

#include "session/Part.h"
#include "session/Store.h"

namespace reebquad {
namespace studio {

/// One mesh and the work on its parts, one of which is worked on: what all pages that are open show. Used by
/// the worker's thread only.
class Session {
public:
  using Observer = CGAL::Reeb_quadrangulation::Observer;

  explicit Session(const Folder& folder);

  /// \name Changes
  /// A failed one leaves everything as it was. Every change is saved before its function returns.
  /// @{
  /// Opening a mesh brings back what was done to it before, if there is a session of it.
  Result<void> open_file(const std::string& name, Observer& observer);
  Result<void> open_upload(const std::string& name, const std::string& bytes, Observer& observer);
  /// Does the edits of a recipe, in place of those that were done to the part that it is for.
  Result<void> open_recipe(const std::string& name, const std::string& text, Observer& observer);
  Result<void> open_recipe_file(const std::string& name, Observer& observer);
  /// Works on another connected component of the mesh, counted from 1; what was done to the others stays.
  Result<void> choose(std::int64_t component, Observer& observer);
  /// Opens the mesh of the session with that digest, or of the last one if it is empty, and repeats its
  /// edits.
  Result<void> restore(Observer& observer, const std::string& digest = "");
  /// Opens the mesh that was open last, with its edits, if there is one: what follows a crash.
  Result<void> resume(Observer& observer);
  void forget(const std::string& digest = "");
  /// Of the edits of one `drag` (a positive number that the page chose) only the last stays: each takes the
  /// place of the one before. `live` ones are not saved.
  Result<Json> edit(const Json& edit, Observer& observer, std::int64_t drag = 0, bool live = false);
  /// Takes back what a drag did so far, as if it had not been; nothing if something else was done since.
  void cancel_drag(std::int64_t drag);
  /// See `Workpiece`.
  Result<Json> preview(const Json& edit, Observer& observer) const;
  Result<Json> offer(const Json& edit, Observer& observer) const;
  Result<Json> hints(Observer& observer) const;
  Result<void> undo();
  Result<void> redo();
  /// Undoes or redoes until `step` edits are applied.
  Result<void> go_to(int step);
  /// Relaxes the quads, which edits leave undone so that they are quick.
  Result<void> finish(Observer& observer);
  bool is_finished() const { return !part() || part()->is_finished(); }
  /// Certifies with all checks, also distance and self-intersections.
  Result<void> certify(Observer& observer);
  /// @}

  /// Grows with every change of what is shown.
  std::int64_t revision() const { return m_revision; }
  /// Everything that the page shows besides geometry.
  Json state() const;
  /// The geometry; made anew after a change only.
  const Layers& layers();
  Result<std::shared_ptr<const std::string>> chart(int index) const;
  Result<std::shared_ptr<const std::string>> deviation(const Observer& observer) const;
  /// The quads of all components that have some, in the format of that extension ("obj", "off", "ply", "vtk",
  /// "stl", "glb").
  Result<std::string> export_quads(const std::string& extension, Observer& observer);
  /// Certifies with all checks first; see `html_text()`.
  Result<std::string> html_report(Observer& observer);
  /// Of the component that is worked on.
  Result<std::string> recipe() const;

  /// The sessions that can be brought back, the newest first: `name`, `edits`, `digest`, `saved`, `picture`.
  Json sessions() const;
  /// Keeps a small picture of the mesh that is open; see `Store`.
  Result<void> keep_picture(const std::string& picture) const;
  const Store& store() const { return m_store; }
  const Folder& folder() const { return m_folder; }
  /// Whether a path leads to the file of the mesh that is open.
  bool is_open_file(const std::string& path) const;

private:
  Result<void> begin(Saved_session origin, const std::string& bytes, Observer& observer);
  Result<void> open(Saved_session origin, const std::string& bytes, Observer& observer);
  Result<void> repeat_all(const Saved_session& saved, Observer& observer);
  Result<void> step(bool forward);
  /// What follows every change: measures, saves.
  void changed(double milliseconds, const std::string& text, bool save = true);
  void save();
  /// The component that is worked on, or null.
  Part* part() const { return m_parts.empty() ? nullptr : m_parts[m_part].get(); }
  Workpiece* work() const { return part() ? part()->work() : nullptr; }
  Result<void> repeat(const Saved_part& saved, Observer& observer);
  Result<void> finish_all(Observer& observer);

  Folder m_folder;
  Store m_store;
  Parts m_parts;          ///< the components of the mesh; empty while none is open
  std::size_t m_part = 0; ///< that is worked on
  Saved_session m_saved;
  std::string m_notice;  ///< about what is kept, until the first change
  bool m_keeps = true;   ///< saves what changes
  Json m_file = nullptr; ///< what is said about the mesh that is open
  Json m_last = nullptr;
  CGAL::Reeb_quadrangulation::Point m_centre =
      CGAL::Reeb_quadrangulation::Point::Zero(); ///< of the file: the origin of all layers
  Layers m_layers;
  const Part* m_others_of = nullptr; ///< the part that the layer of the others is without
  bool m_layers_are_stale = true;
  std::int64_t m_revision = 0;
  std::int64_t m_drag = 0; ///< that the last edit belongs to
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_SESSION_H
