// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_DESIGN_OUTPUT_H
#define REEBQUAD_CLI_DESIGN_OUTPUT_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/mirror_check.h>
#include <CGAL/Reeb_quadrangulation/mirror_quads.h>
#include <CGAL/Reeb_quadrangulation/pole_fans.h>

#include <optional>
#include <string>
#include <vector>

namespace reebquad {

/// The finished quads of a design: of one with a mirror, those of both sides.
struct Design_quads {
  CGAL::Reeb_quadrangulation::Stitched_mesh quads;
  std::vector<CGAL::Reeb_quadrangulation::Pole_fan> fans;
  std::optional<CGAL::Reeb_quadrangulation::Mirror_report> mirror;
  std::vector<CGAL::Reeb_quadrangulation::Guide_outcome> guides;
};

/// What is told and shown of a design: certificate, statistics, report, pictures. Keeps references to its
/// arguments; `input` is what the quads stand for.
class Design_output {
public:
  Design_output(const CGAL::Reeb_quadrangulation::Editor& editor, const Design_quads& made,
                const CGAL::Reeb_quadrangulation::Triangle_surface& input);

  /// Whether the certificate passed and the quads equal their mirror image as far as that was asked for.
  bool passed() const;

  /// Of the quads; where the design asks for fans of triangles, of the quads with these in pairs.
  const CGAL::Reeb_quadrangulation::Certificate& certificate() const { return m_certificate; }
  /// The quads, and the triangles that the design asks for.
  CGAL::Reeb_quadrangulation::Polygon_soup polygons() const;
  std::string text() const;
  /// JSON, as doc/Reeb_quadrangulation/recipes.md describes it.
  std::string report(const std::string& input, const std::string& output) const;
  /// charts.png and quads.png into a folder; a `Failure` names what cannot be written.
  void write_pictures(const std::string& folder) const;

private:
  const CGAL::Reeb_quadrangulation::Editor& m_editor;
  const Design_quads& m_made;
  const CGAL::Reeb_quadrangulation::Stitched_mesh& m_quads;
  const std::vector<CGAL::Reeb_quadrangulation::Pole_fan>& m_fans;
  CGAL::Reeb_quadrangulation::Certificate m_certificate;
  CGAL::Reeb_quadrangulation::Mesh_statistics m_statistics;
  std::optional<CGAL::Reeb_quadrangulation::Mirror_check> m_mirror;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_DESIGN_OUTPUT_H
