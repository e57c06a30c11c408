// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes every file of a folder and certifies the result: one JSON line a file, then a summary.
// Usage: bench_robustness FOLDER [quads [scale]]. Exit code 1 unless every surface passed its certificate.
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

namespace {

struct Totals {
  int files = 0, passed = 0, strict = 0, closed = 0, closed_strict = 0, without_inverted = 0;
};

void append(const Quad_mesh& part, Quad_mesh& whole) {
  const int first = int(whole.points.size());
  whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
  for (const Quad& q : part.quads)
    whole.quads.push_back({q[0] + first, q[1] + first, q[2] + first, q[3] + first});
}

// Components are certified one by one: each is a surface of its own.
Json mesh_file(const std::string& path, int quads, double scale, Totals& totals) {
  Json line{{"benchmark", "robustness"}, {"file", std::filesystem::path(path).filename().string()}};
  ++totals.files;
  Result<Polygon_soup> soup = read_polygon_soup(path);
  if (!soup) return line["error"] = soup.error().message, line;
  for (Point& p : soup->points) p *= scale;
  const Result<Mended_surface> mended = mend_surface(*soup, {});
  if (!mended) return line["error"] = mended.error().message, line;
  bool passed = true, strict = true, closed = true;
  double cpu = 0;
  Quad_mesh whole;
  int triangles = 0;
  for (const Mended_component& component : mended->components) {
    Quadrangulation_options options;
    options.quads = std::max(1, quads / int(mended->components.size()));
    options.threads = 1;
    const double start = double(std::clock()) / CLOCKS_PER_SEC;
    const Result<Quadrangulation> result = quadrangulate(component.surface, options);
    cpu += double(std::clock()) / CLOCKS_PER_SEC - start;
    if (!result) return line["error"] = result.error().message, line;
    const Certificate certificate = certify({result->mesh, &component.surface, result->valences});
    passed = passed && certificate.passed;
    strict = strict && certificate.strictly_valid;
    closed = closed && boundary_loops(component.surface).empty();
    triangles += component.surface.number_of_faces();
    line["genus"].push_back(result->genus);
    line["target_met"].push_back(result->editor.design().counts.target_met);
    line["collapsed_charts"].push_back(result->collapsed_charts);
    append(result->mesh, whole);
  }
  const Mesh_statistics statistics = quad_statistics(whole);
  line["triangles"] = triangles;
  line["quads"] = whole.quads.size();
  line["passed"] = passed;
  line["strictly_valid"] = strict;
  line["inverted"] = statistics.inverted_quads;
  line["scaled_jacobian"] = statistics.scaled_jacobian.mean;
  line["worst_scaled_jacobian"] = statistics.scaled_jacobian.minimum;
  line["cpu_seconds"] = cpu;
  totals.passed += passed;
  totals.strict += strict;
  totals.closed += closed;
  totals.closed_strict += closed && strict;
  totals.without_inverted += statistics.inverted_quads == 0;
  return line;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: bench_robustness FOLDER [quads [scale]]\n";
    return 2;
  }
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".obj" || extension == ".off" || extension == ".ply")
      files.insert(entry.path().string());
  }
  Totals totals;
  for (const std::string& file : files)
    std::cout << mesh_file(file, argc > 2 ? std::atoi(argv[2]) : 3000, argc > 3 ? std::atof(argv[3]) : 1.0,
                           totals)
                     .dump()
              << std::endl;
  std::cout << Json{{"benchmark", "robustness summary"},
                    {"files", totals.files},
                    {"passed", totals.passed},
                    {"without_inverted_quads", totals.without_inverted},
                    {"strictly_valid", totals.strict},
                    {"closed", totals.closed},
                    {"closed_strictly_valid", totals.closed_strict}}
                   .dump()
            << std::endl;
  return totals.passed == totals.files ? 0 : 1;
}
