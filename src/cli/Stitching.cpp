// SPDX-License-Identifier: GPL-3.0-or-later
#include "Stitching.h"

#include "Input.h"

#include "base/place.h"

#include <algorithm>
#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

// Of a vertex, a patch that has it.
int patch_of(const Error& error, const Patch_files& patches) {
  if (error.index < 0) return -1;
  if (error.element == Element_kind::face) return patches.patch_of_quad[std::size_t(error.index)];
  if (error.element != Element_kind::vertex) return -1;
  for (std::size_t q = 0; q < patches.mesh.quads.size(); ++q) {
    const Quad& quad = patches.mesh.quads[q];
    if (std::find(quad.begin(), quad.end(), int(error.index)) != quad.end()) return patches.patch_of_quad[q];
  }
  return -1;
}

void append(Patch_files& all, const Quad_mesh& mesh, const std::string& file) {
  const int first = int(all.mesh.points.size()), first_patch = int(all.patches.size());
  const std::vector<int> patch = patches_of_quads(mesh);
  all.mesh.points.insert(all.mesh.points.end(), mesh.points.begin(), mesh.points.end());
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    Quad quad = mesh.quads[q];
    for (int& v : quad) v += first;
    all.mesh.quads.push_back(quad);
    const std::size_t p = std::size_t(first_patch + patch[q]);
    all.patch_of_quad.push_back(int(p));
    if (p >= all.patches.size()) all.patches.push_back({int(all.files.size()), patch[q] + 1, 0});
    ++all.patches[p].quads;
  }
  all.files.push_back(file);
}

// Of a face that is no quad, the place, so that it is found in a file of many patches.
void refuse_other_faces(const Polygon_soup& soup, const std::string& file) {
  for (int p = 0; p < soup.number_of_polygons(); ++p)
    if (soup.size_of_polygon(p) != 4)
      throw Failure(
          Exit_code::not_a_surface,
          file + ": face " + std::to_string(p) + ", at " +
              place(soup.points[std::size_t(soup.corner[std::size_t(soup.begin[std::size_t(p)])])]) +
              ", has " + std::to_string(soup.size_of_polygon(p)) +
              " corners; patches of quads alone are stitched");
}

} // namespace

Patch_files read_patches(const std::vector<std::string>& files) {
  Patch_files all;
  for (const std::string& file : files) {
    const Polygon_soup soup = read_soup(file);
    refuse_other_faces(soup, file);
    append(all, quads_of(soup, file), file);
  }
  return all;
}

Patch_files patches_of(Quad_mesh mesh, const std::string& file) {
  Patch_files all;
  append(all, mesh, file);
  return all;
}

Stitched_patches stitched_or_fail(Result<Stitched_patches> stitched, const Patch_files& patches) {
  if (stitched) return std::move(*stitched);
  const Error& error = stitched.error();
  const int p = patch_of(error, patches);
  std::string where = patches.files.front();
  if (p >= 0) {
    const Read_patch& patch = patches.patches[std::size_t(p)];
    where = patches.files[std::size_t(patch.file)] + ": patch " + std::to_string(patch.number) + " (" +
            std::to_string(patch.quads) + " quads)";
  } else
    for (std::size_t f = 1; f < patches.files.size(); ++f) where += ", " + patches.files[f];
  throw Failure(exit_code(error.code), where + ": " + error.message);
}

std::string stitching_text(const Stitched_patches& stitched) {
  std::ostringstream out;
  out << stitched.turned.size() << " patches, "
      << std::count(stitched.turned.begin(), stitched.turned.end(), 1) << " turned around\n"
      << stitched.greedy_merges + stitched.later_merges << " pairs of vertices merged, "
      << stitched.later_merges << " of them to close slits; moved by " << stitched.largest_step
      << " at most\n"
      << stitched.t_junctions << " T-junctions taken away by " << stitched.lines << " lines and "
      << stitched.templates << " templates: " << stitched.extraordinary.size() << " extraordinary vertices\n";
  return out.str();
}

nlohmann::ordered_json stitching_json(const Stitched_patches& stitched) {
  return {{"greedy_merges", stitched.greedy_merges}, {"later_merges", stitched.later_merges},
          {"t_junctions", stitched.t_junctions},     {"lines", stitched.lines},
          {"templates", stitched.templates},         {"boundary_ends", stitched.boundary_ends},
          {"extraordinary", stitched.extraordinary}, {"largest_step", stitched.largest_step}};
}

Scene patch_scene(const Quad_mesh& mesh, const std::vector<int>& patch_of_quad) {
  Triangle_surface halves;
  std::vector<int> region;
  halves.points = mesh.points;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const Quad& v = mesh.quads[q];
    halves.triangles.push_back({v[0], v[1], v[2]});
    halves.triangles.push_back({v[0], v[2], v[3]});
    region.insert(region.end(), 2, patch_of_quad[q]);
  }
  const Scene coloured = face_colour_scene(halves, region);
  Scene scene = quad_scene(mesh);
  scene.face_colours.clear();
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    scene.face_colours.push_back(coloured.face_colours[2 * q]);
  return scene;
}

} // namespace reebquad
