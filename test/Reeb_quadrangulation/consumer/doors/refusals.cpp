// SPDX-License-Identifier: GPL-3.0-or-later
// What makes no sense is refused with a sentence, and nothing is added to the output.
#include "torus.h"

#include <CGAL/Reeb_quadrangulation/face_graph.h>

#include <iostream>
#include <limits>

namespace RQ = CGAL::Reeb_quadrangulation;
namespace params = CGAL::Reeb_quadrangulation::parameters;

int main() {
  Mesh mesh = torus(), quads;
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  int refused = 0, asked = 0;
  const auto ask = [&](const auto& np) {
    const auto result = RQ::quadrangulate(mesh, quads, np);
    ++asked;
    refused += !result && result.error().code == RQ::Error_code::impossible_request;
    if (!result) std::cout << result.error().message << '\n';
  };
  ask(params::number_of_quads(0));
  ask(params::number_of_quads(-5));
  for (const double bad : {nan, infinite, -1.0, 0.0}) ask(params::edge_length(bad));
  ask(params::number_of_threads(-1));
  RQ::Quadrangulation_options options;
  options.features.feature_angle = nan;
  ask(params::options(options));
  auto field = mesh.add_property_map<Mesh::Vertex_index, double>("v:f", 0).first;
  field[Mesh::Vertex_index(3)] = nan;
  const auto graph = RQ::reeb_graph(mesh, field);
  ++asked;
  refused += !graph && graph.error().index == 3;
  return refused == asked && quads.number_of_faces() == 0 ? 0 : 1;
}
