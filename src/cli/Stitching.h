// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_STITCHING_H
#define REEBQUAD_CLI_STITCHING_H

#include "Failure.h"

#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/stitch_patches.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace reebquad {

/// A patch of a file.
struct Read_patch {
  int file = 0;
  int number = 0; ///< in its file, from 1
  int quads = 0;
};

/// The quads of several files in one mesh, and of which file and patch they are.
struct Patch_files {
  CGAL::Reeb_quadrangulation::Quad_mesh mesh;
  std::vector<std::string> files;
  std::vector<Read_patch> patches;
  std::vector<int> patch_of_quad;
};

/// A `Failure` names the file, and of a face that is no quad its patch and place.
Patch_files read_patches(const std::vector<std::string>& files);
/// Of a mesh that is at hand already.
Patch_files patches_of(CGAL::Reeb_quadrangulation::Quad_mesh mesh, const std::string& file);

/// The value; or a `Failure` that names the file and the patch of the error's element.
CGAL::Reeb_quadrangulation::Stitched_patches
stitched_or_fail(CGAL::Reeb_quadrangulation::Result<CGAL::Reeb_quadrangulation::Stitched_patches> stitched,
                 const Patch_files& patches);

/// What was done, for the terminal and for reports.
std::string stitching_text(const CGAL::Reeb_quadrangulation::Stitched_patches& stitched);
nlohmann::ordered_json stitching_json(const CGAL::Reeb_quadrangulation::Stitched_patches& stitched);

/// Patches in colours that neighbours do not share.
CGAL::Reeb_quadrangulation::Scene patch_scene(const CGAL::Reeb_quadrangulation::Quad_mesh& mesh,
                                              const std::vector<int>& patch_of_quad);

} // namespace reebquad

#endif // REEBQUAD_CLI_STITCHING_H
