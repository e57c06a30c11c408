// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_STUDIO_DESIGN_H
#define REEBQUAD_STUDIO_DESIGN_H

#include "Layers.h"

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <memory>

namespace reebquad {
namespace studio {

/// A surface and the quad mesh that the user designs on it, by edits that can be undone. Used by one thread at a time.
class Design {
public:
  using Observer = CGAL::Reeb_quadrangulation::Observer;
  template <class T> using Result = CGAL::Reeb_quadrangulation::Result<T>;

  /// Nothing is designed yet. \pre `surface` is connected by `connect()`
  static Result<std::unique_ptr<Design>> create(CGAL::Reeb_quadrangulation::Triangle_surface surface,
                                                Observer* observer);
  virtual ~Design() = default;

  /// Applies an edit, given as JSON; returns what changed. A failed edit leaves everything as it was.
  virtual Result<Json> apply(const Json& edit, Observer* observer) = 0;
  virtual Result<void> undo(Observer* observer) = 0;
  virtual Result<void> redo(Observer* observer) = 0;

  /// The edits since the beginning, also those that are undone and can be redone, and how many of them are applied.
  virtual const std::vector<Json>& edits() const = 0;
  virtual int applied() const = 0;

  virtual Layers layers() const = 0;
  /// What the page shows besides geometry: "charts", "contours", "extrema", "counts".
  virtual Json facts() const = 0;
  /// The texture and the map of a chart. Fails with `impossible_request` if there is none of that number.
  virtual Result<std::shared_ptr<const std::string>> chart(int index) const = 0;

  /// The surface as it came in.
  virtual const CGAL::Reeb_quadrangulation::Triangle_surface& surface() const = 0;
  /// The quad mesh, or null while there is none.
  virtual const CGAL::Reeb_quadrangulation::Quad_mesh* quads() const = 0;
  /// Predicted from the layout: valence -> number of vertices inside.
  virtual const std::map<int, int>& predicted_valences() const = 0;
};

/// The middle of the bounding box of the points.
CGAL::Reeb_quadrangulation::Point middle(const CGAL::Reeb_quadrangulation::Triangle_surface& surface);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_STUDIO_DESIGN_H
