// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_PART_H
#define REEBQUAD_SESSION_PART_H

#include "session/Workpiece.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

namespace reebquad {
namespace studio {

/// One connected component of the file: its surface, the work on it, and what is measured of its quads.
class Part {
public:
  using Observer = CGAL::Reeb_quadrangulation::Observer;
  template <class T> using Result = CGAL::Reeb_quadrangulation::Result<T>;

  /// \pre `surface` is connected by `connect()`
  Part(CGAL::Reeb_quadrangulation::Triangle_surface surface, const CGAL::Reeb_quadrangulation::Point& origin);

  /// Prepares the surface for designs, where that was not done yet.
  Result<void> begin(Observer* observer);
  /// Does the edits of a recipe, with its options, in place of what was done so far; if one fails, that
  /// stays.
  Result<void> follow(const CGAL::Reeb_quadrangulation::Recipe& recipe, Observer& observer);
  /// The recipe that was followed last, without its edits; null if it has what every design has.
  const Json& base() const { return m_base; }
  Workpiece* work() const { return m_work.get(); }
  bool has_quads() const { return m_work && m_work->quads(); }

  /// To be called when the design has changed. It takes time linear in the quads only; the certificate, which
  /// also reads the surface, comes when the quads are finished.
  void measure();
  /// Notes how long the last edit took.
  void took(double milliseconds);
  /// Relaxes the quads, which edits leave undone so that they are quick, and certifies them.
  Result<void> finish(Observer& observer);
  bool is_finished() const { return !m_work || m_work->is_finished(); }
  /// With the slow checks, of distance and self-intersections, if `wholly`.
  void certify(bool wholly, const Observer* observer);

  const CGAL::Reeb_quadrangulation::Triangle_surface& surface() const {
    return m_work ? m_work->surface() : m_surface;
  }
  /// The quads with fans of triangles in pairs, which is what the certificate is about. \pre `has_quads()`
  CGAL::Reeb_quadrangulation::Stitched_mesh paired_quads() const;
  const std::optional<CGAL::Reeb_quadrangulation::Certificate>& certificate() const { return m_certificate; }
  const std::optional<CGAL::Reeb_quadrangulation::Mesh_statistics>& statistics() const {
    return m_statistics;
  }

  /// \name For the page
  /// @{
  /// Sizes and topology of the surface, and how many quads and edits there are.
  Json facts() const;
  Json history() const;
  /// How many extraordinary vertices the surface wants, and which there are.
  Json budget() const;
  /// @}

private:
  CGAL::Reeb_quadrangulation::Triangle_surface m_surface; ///< until it is begun
  CGAL::Reeb_quadrangulation::Point m_origin;
  Json m_facts;
  Json m_base = nullptr;
  std::unique_ptr<Workpiece> m_work;
  std::vector<double> m_milliseconds; ///< of each edit
  std::optional<CGAL::Reeb_quadrangulation::Certificate> m_certificate;
  std::optional<CGAL::Reeb_quadrangulation::Mesh_statistics> m_statistics;
};

using Parts = std::vector<std::unique_ptr<Part>>;

/// The quads and fans of all parts that have some, one after the other.
CGAL::Reeb_quadrangulation::Polygon_soup joined_polygons(const Parts& parts);

/// The layer "others": the surfaces of all parts but one. Points are relative to `origin`.
std::shared_ptr<const std::string> others_layer(const Parts& parts, std::size_t chosen,
                                                const CGAL::Reeb_quadrangulation::Point& origin);

/// The certificate and the statistics of all parts that have quads, as of one mesh.
struct Measured_parts {
  CGAL::Reeb_quadrangulation::Certificate certificate;
  CGAL::Reeb_quadrangulation::Mesh_statistics statistics;
};
Measured_parts measure_together(const Parts& parts, const Part::Observer& observer);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_PART_H
