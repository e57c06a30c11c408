// SPDX-License-Identifier: GPL-3.0-or-later
// The whole run and the share of each stage at growing sizes, beside CHOLMOD on the same surface's Laplacian:
// JSON lines. Usage: bench_pipeline [shape [repetitions [triangles ...]]]. Seconds are CPU time; medians over
// the repetitions.
#include "keep_freed_memory.h"
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <string>

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

namespace {

double cpu_seconds() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

[[noreturn]] void fail(const Error& error) {
  std::cerr << error.message << '\n';
  std::exit(1);
}

// One analysis, factorization and solve of the Laplacian with one vertex eliminated: the unit in which runs
// are told.
double cholmod_seconds(const Triangle_surface& surface) {
  std::vector<char> is_fixed(surface.number_of_vertices(), 0);
  is_fixed[0] = 1;
  const double start = cpu_seconds();
  const Laplace_system system = assemble(surface, cotangent_weights(surface), is_fixed);
  Cholmod_solver solver;
  if (Result<void> done = solver.factorize(system.matrix); !done) fail(done.error());
  std::vector<double> x(system.matrix.size, 1.0);
  if (Result<void> done = solver.solve(x.data()); !done) fail(done.error());
  return cpu_seconds() - start;
}

// Order, critical points, contours and the Reeb graph of a design's field, with the charts cut out.
double layout_seconds(const Editor& editor) {
  const Triangle_surface& surface = editor.working_surface();
  Designed_field field;
  field.values = editor.design().field->values;
  for (const Design_extremum& e : editor.design().extrema)
    (e.is_maximum ? field.maxima : field.minima).push_back(e.vertex);
  const double start = cpu_seconds();
  const Result<Reeb_layout> layout = make_layout(surface, field);
  if (!layout) fail(layout.error());
  return cpu_seconds() - start;
}

void measure(const std::string& shape, int triangles, int repetitions) {
  const Result<Triangle_surface> surface = make_shape(shape, triangles);
  if (!surface) fail(surface.error());
  Quadrangulation_options options;
  options.threads = 1;
  options.prepare = true;
  std::vector<double> total, cholmod, layout;
  std::map<std::string, std::vector<double>> stages;
  std::size_t quads = 0;
  double peak = 0;
  for (int i = 0; i < repetitions; ++i) {
    const double start = cpu_seconds();
    const Result<Quadrangulation> result = quadrangulate(*surface, options);
    total.push_back(cpu_seconds() - start);
    if (!result) fail(result.error());
    quads = result->mesh.quads.size();
    for (const Stage_time& stage : result->stages) {
      stages[stage.name].push_back(stage.cpu_seconds);
      peak = std::max(peak, stage.peak_megabytes);
    }
    layout.push_back(layout_seconds(result->editor));
    cholmod.push_back(cholmod_seconds(*surface));
  }
  Json line;
  line["benchmark"] = "pipeline";
  line["shape"] = shape;
  line["triangles"] = surface->number_of_faces();
  line["quads"] = quads;
  line["run_seconds"] = median(total);
  line["cholmod_seconds"] = median(cholmod);
  line["run_over_cholmod"] = median(total) / median(cholmod);
  line["layout_seconds"] = median(layout);
  line["peak_megabytes"] = peak;
  for (const auto& [name, seconds] : stages) line["stages"][name] = median(seconds);
  std::cout << line.dump() << std::endl;
}

} // namespace

int main(int argc, char** argv) {
  internal::keep_freed_memory(); // as the program does
  const std::string shape = argc > 1 ? argv[1] : "genus-3";
  const int repetitions = argc > 2 ? std::max(1, std::atoi(argv[2])) : 3;
  std::vector<int> sizes;
  for (int i = 3; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {20000, 100000, 200000, 400000, 1000000};
  for (int triangles : sizes) measure(shape, triangles, repetitions);
}
