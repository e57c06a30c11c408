// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_DESIGN_OUTPUT_H
#define REEBQUAD_CLI_DESIGN_OUTPUT_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <string>

namespace reebquad {

/// What is told and shown of a design: certificate, statistics, report, pictures.
class Design_output {
public:
  Design_output(const CGAL::Reeb_quadrangulation::Editor& editor,
                const CGAL::Reeb_quadrangulation::Stitched_mesh& quads);

  const CGAL::Reeb_quadrangulation::Certificate& certificate() const { return m_certificate; }
  std::string text() const;
  /// JSON, as doc/Reeb_quadrangulation/recipes.md describes it.
  std::string report(const std::string& input, const std::string& output) const;
  /// charts.png and quads.png into a folder; a `Failure` names what cannot be written.
  void write_pictures(const std::string& folder) const;

private:
  const CGAL::Reeb_quadrangulation::Editor& m_editor;
  const CGAL::Reeb_quadrangulation::Stitched_mesh& m_quads;
  CGAL::Reeb_quadrangulation::Certificate m_certificate;
  CGAL::Reeb_quadrangulation::Mesh_statistics m_statistics;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_DESIGN_OUTPUT_H
