// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_PATCH_EDITS_H
#define REEBQUAD_CLI_PATCH_EDITS_H

#include <CGAL/Reeb_quadrangulation/Edit.h>
#include <CGAL/Reeb_quadrangulation/base_domain.h>

#include <map>
#include <string>

namespace reebquad {

/// An edit of a texture from "NAME x,y,z ... [at=F]"; a `Usage_error` says what is wrong with it.
CGAL::Reeb_quadrangulation::Edit parse_patch_edit(const std::string& text);

/// Edits of patches of a quad mesh by the edits of designs that are for one texture: edit_texture,
/// drag_vertices, relax_texture.
class Patch_edits {
public:
  /// Keeps a reference to the domain.
  Patch_edits(const CGAL::Reeb_quadrangulation::Quad_mesh& mesh,
              const CGAL::Reeb_quadrangulation::Base_domain& domain);

  /// A `Failure` begins with `called`, the name of the edit.
  void apply(const CGAL::Reeb_quadrangulation::Edit& edit, const std::string& called);

  const std::map<int, CGAL::Reeb_quadrangulation::Patch_texture>& textures() const { return m_textures; }

private:
  using Points = std::vector<CGAL::Reeb_quadrangulation::Surface_point>;
  using Places = std::vector<CGAL::Reeb_quadrangulation::Texture_place>;

  Places places(const Points& points, int& patch) const;
  CGAL::Reeb_quadrangulation::Result<CGAL::Reeb_quadrangulation::Texture_edit>
  texture_edit(const CGAL::Reeb_quadrangulation::Edit& edit, int& patch) const;

  const CGAL::Reeb_quadrangulation::Base_domain& m_domain;
  CGAL::Reeb_quadrangulation::Base_locator m_locator;
  std::vector<double> m_edge; ///< per patch: the mean length of its edges, which is 1 in its parameters
  std::map<int, CGAL::Reeb_quadrangulation::Patch_texture> m_textures;
};

} // namespace reebquad

#endif // REEBQUAD_CLI_PATCH_EDITS_H
