// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a mesh file, lists what is wrong with it, mends what can be mended, and tells what came out.
// Without an argument it makes itself a file: two tetrahedra whose faces do not share points, one face turned
// round.
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

static std::string sample() {
  const int corners[8][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3},
                             {4, 6, 5}, {4, 7, 5}, {4, 7, 6}, {5, 6, 7}};
  std::string points, faces;
  int n = 0;
  for (const auto& face : corners) {
    for (int v : face) {
      const bool x = v % 4 == 1, y = v % 4 == 2, z = v % 4 == 3;
      points += "v " + std::to_string(int(x) + 3 * (v / 4)) + ' ' + std::to_string(int(y)) + ' ' +
                std::to_string(int(z)) + '\n';
    }
    faces += "f " + std::to_string(n + 1) + ' ' + std::to_string(n + 2) + ' ' + std::to_string(n + 3) + '\n';
    n += 3;
  }
  return points + faces;
}

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "read_and_check.obj";
  if (argc < 2 && !write_file_atomically(path, sample())) return 1;
  std::vector<std::string> notes;
  const Result<Polygon_soup> soup = read_polygon_soup(path, largest_mesh_file, &notes);
  if (!soup) {
    std::cerr << soup.error().message << '\n';
    return 3;
  }
  for (const std::string& note : notes) std::cout << note << '\n';
  const Surface_check check = check_surface(*soup);
  std::cout << check.points << " points, " << check.faces << " faces, " << check.components.size()
            << " components\n";
  for (int k = 0; k < number_of_defect_kinds; ++k)
    if (check.count(Defect_kind(k)) > 0)
      std::cout << "  " << name(Defect_kind(k)) << ": " << check.count(Defect_kind(k)) << '\n';

  // Rims that lie nearer to each other than this are welded; by default a millionth of the diagonal.
  Mend_options options;
  options.weld = 1e-6 * (check.highest - check.lowest).norm();
  const Result<Mended_surface> mended = mend_surface(*soup, options);
  if (!mended) {
    std::cerr << mended.error().message << '\n';
    return 4;
  }
  for (const Mend& mend : mended->mends) std::cout << mend.text << '\n';
  for (const Mended_component& c : mended->components)
    std::cout << "a surface of " << c.surface.number_of_vertices() << " vertices and "
              << c.surface.number_of_faces() << " triangles, Euler characteristic "
              << euler_characteristic(c.surface) << '\n';
  for (const Error& error : mended->refused) std::cout << "refused: " << error.message << '\n';
  return 0;
}
