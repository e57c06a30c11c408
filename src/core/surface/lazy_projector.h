// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SURFACE_LAZY_PROJECTOR_H
#define REEBQUAD_SURFACE_LAZY_PROJECTOR_H

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>

#include <mutex>
#include <optional>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The projector of a surface, made when it is first asked for: its tree takes longer to build than most
/// edits, and many sessions need none.
class Lazy_projector {
public:
  /// Keeps a reference.
  explicit Lazy_projector(const Triangle_surface& surface) : m_surface(surface) {}

  /// Thread-safe.
  const Surface_projector& operator*() const {
    std::call_once(m_once, [this] { m_projector.emplace(m_surface); });
    return *m_projector;
  }
  const Surface_projector* operator->() const { return &**this; }

private:
  const Triangle_surface& m_surface;
  mutable std::once_flag m_once;
  mutable std::optional<Surface_projector> m_projector;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_SURFACE_LAZY_PROJECTOR_H
