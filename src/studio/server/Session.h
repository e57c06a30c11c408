// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STUDIO_SESSION_H
#define REEBQUAD_STUDIO_SESSION_H

#include "Store.h"
#include "Workpiece.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

namespace reebquad {
namespace studio {

/// One mesh and the work on it: what all pages that are open show. Used by the worker's thread only.
class Session {
public:
  using Observer = CGAL::Reeb_quadrangulation::Observer;

  explicit Session(const Folder& folder);

  /// \name Changes
  /// A failed one leaves everything as it was. Every change is saved before its function returns.
  /// @{
  Result<void> open_file(const std::string& name, Observer& observer);
  Result<void> open_upload(const std::string& name, const std::string& bytes, Observer& observer);
  /// Opens the mesh of the last session and repeats its edits.
  Result<void> restore(Observer& observer);
  void forget();
  /// Of the edits of one `drag` (a positive number that the page chose) only the last stays: each takes the place of the one
  /// before. `live` ones are not saved.
  Result<Json> edit(const Json& edit, Observer& observer, std::int64_t drag = 0, bool live = false);
  /// See `Workpiece`.
  Result<Json> preview(const Json& edit, Observer& observer) const;
  Result<Json> hints(Observer& observer) const;
  Result<void> undo();
  Result<void> redo();
  /// Undoes or redoes until `step` edits are applied.
  Result<void> go_to(int step);
  /// Relaxes the quads, which edits leave undone so that they are quick.
  Result<void> finish(Observer& observer);
  bool is_finished() const { return !m_work || m_work->is_finished(); }
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
  /// The quads in the format of that extension ("obj", "off", "ply", "vtk", "stl", "glb").
  Result<std::string> export_quads(const std::string& extension, Observer& observer);
  /// Certifies with all checks first; see `html_text()`.
  Result<std::string> html_report(Observer& observer);
  Result<std::string> recipe() const;

  const Folder& folder() const { return m_folder; }

private:
  Result<void> open(Saved_session origin, const std::string& bytes, Observer& observer);
  Result<void> step(bool forward);
  /// What follows every change: measures, saves.
  void changed(double milliseconds, const std::string& text, bool save = true);
  void measure();
  void certify_quads(bool wholly, const Observer* observer);
  Json budget() const;
  Json history() const;

  Folder m_folder;
  Store m_store;
  std::unique_ptr<Workpiece> m_work;
  Saved_session m_saved;
  Json m_file = nullptr;              ///< what is said about the mesh that is open
  std::vector<double> m_milliseconds; ///< of each edit
  Json m_last = nullptr;
  std::optional<CGAL::Reeb_quadrangulation::Certificate> m_certificate;
  std::optional<CGAL::Reeb_quadrangulation::Mesh_statistics> m_statistics;
  Layers m_layers;
  bool m_layers_are_stale = true;
  std::int64_t m_revision = 0;
  std::int64_t m_drag = 0; ///< that the last edit belongs to
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_STUDIO_SESSION_H
